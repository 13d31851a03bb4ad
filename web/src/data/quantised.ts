// A quantity per frame and point in 16 bits. Bytes of frame f: n low bytes, then n high bytes, of d[f], where d[0] =
// q[0] and d[f] = (q[f] - q[f-1]) mod 65536. Value: lo + (hi - lo) q / 65535, or lo (hi/lo)^(q/65535) if `log`. The
// last q means "no value": in a field that a material does not have, and in all of a point of which there is no soil.
// The other half of this codec is the C++ writer; tests/unit/cpp_codec.test.ts holds bytes that it wrote.

import type { QuantisedMeta } from "./format";

export const FULL = 65535;

/** q of all frames, shape [frames, points]. */
export function decodeFrames(bytes: Uint8Array, frames: number, points: number): Uint16Array<ArrayBuffer> {
  if (bytes.length !== 2 * frames * points) {
    throw new Error(
      `${frames} frames of ${points} points need ${2 * frames * points} bytes, but there are ${bytes.length}.`);
  }
  const q = new Uint16Array(frames * points);
  for (let f = 0; f < frames; f++) {
    const low = 2 * f * points;
    const high = low + points;
    const now = f * points;
    if (f === 0) {
      for (let p = 0; p < points; p++) q[p] = bytes[low + p]! | (bytes[high + p]! << 8);
    } else {
      const before = now - points;
      for (let p = 0; p < points; p++) q[now + p] = q[before + p]! + (bytes[low + p]! | (bytes[high + p]! << 8));
    }
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
