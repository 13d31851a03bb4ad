// A quantity per frame and point in 16 bits, q. Value: lo + (hi - lo) q / 65535, or lo (hi/lo)^(q/65535) if `log`. The
// last q means "no value": in a field that a material does not have, and in all of a point of which there is no soil.
// How the q lie in the bytes: docs/report_format.md. The other half of this codec is the C++ writer;
// tests/unit/cpp_codec.test.ts holds bytes that it wrote.

import type { Layout, QuantisedMeta } from "./format";

export const FULL = 65535;

const LISTED = 3; // of two bits: the number stands in the list

/** q of all frames, shape [frames, points]. */
export function decodeFrames(bytes: Uint8Array, frames: number, points: number,
  layout: Layout): Uint16Array<ArrayBuffer> {
  const packed = layout === "frame" ? Math.ceil((frames * points) / 4) : 0;
  const n = (bytes.length - packed) / 2; // numbers of 16 bits: low bytes, then high bytes
  const listed = (k: number) => bytes[packed + k]! | (bytes[packed + n + k]! << 8);
  const q = new Uint16Array(frames * points);
  let next = 0;
  if (layout === "point") {
    for (let p = 0; p < points; p++) for (let f = 0; f < frames; f++) q[f * points + p] = listed(next++);
  } else {
    for (let k = 0, change = 0; k < q.length; k++) {
      if (k % points === 0) change = 0;
      const bits = (bytes[k >> 2]! >> (2 * (k & 3))) & 3;
      const folded = bits === LISTED ? LISTED + listed(next++) : bits;
      change += (folded >> 1) ^ -(folded & 1);
      q[k] = (k < points ? 0 : q[k - points]!) + change;
    }
  }
  if (next !== n)
    throw new Error(`${frames} frames of ${points} points do not need ${bytes.length} bytes: the data is damaged.`);
  return q;
}

/** How far points are from where they are in the first frame, which has all that there ever are. */
export function distances(x: Quantised, y: Quantised, meta: QuantisedMeta): Uint16Array<ArrayBuffer> {
  const q = new Uint16Array(meta.frames * meta.points);
  const step = (of: Quantised) => (of.meta.hi - of.meta.lo) / (meta.hi - meta.lo);
  const [sx, sy] = [step(x), step(y)];
  for (let k = 0; k < q.length; k++) {
    const p = k % meta.points;
    const isThere = x.q[k] !== FULL || y.q[k] !== FULL;
    q[k] = isThere ? Math.round(Math.hypot(sx * (x.q[k]! - x.q[p]!), sy * (y.q[k]! - y.q[p]!))) : NONE;
  }
  return q;
}

export const NONE = FULL;

export function valueOf(meta: Pick<QuantisedMeta, "lo" | "hi" | "log">, q: number): number {
  const part = q / FULL;
  return meta.log ? meta.lo * Math.pow(meta.hi / meta.lo, part) : meta.lo + (meta.hi - meta.lo) * part;
}

/** One quantity of one run. */
export class Quantised {
  constructor(
    readonly meta: QuantisedMeta,
    readonly q: Uint16Array<ArrayBuffer>,
  ) {}

  /** q of one frame, shape [points]; a view, not a copy. */
  frame(f: number): Uint16Array<ArrayBuffer> {
    const start = this.meta.static ? 0 : f * this.meta.points;
    return this.q.subarray(start, start + this.meta.points);
  }

  /** NaN where there is none. */
  value(f: number, p: number): number {
    const q = this.q[(this.meta.static ? 0 : f * this.meta.points) + p]!;
    return q === NONE ? NaN : valueOf(this.meta, q);
  }
}
