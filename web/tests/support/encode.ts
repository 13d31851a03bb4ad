// The writer's half of the codec, for tests alone: what src/report does in C++.

import { gzipSync } from "node:zlib";
import type { Layout, QuantisedMeta } from "../../src/data/format";
import { FULL } from "../../src/data/quantised";

/** q of all frames, shape [frames, points], as the bytes of a chunk before gzip. */
export function encodeFrames(q: Uint16Array, frames: number, points: number, layout: Layout): Uint8Array {
  if (layout === "point") return numbers(Array.from(q, (_, k) => q[(k % frames) * points + Math.floor(k / frames)]!));
  const packed = new Uint8Array(Math.ceil((frames * points) / 4));
  const list: number[] = [];
  const change = (k: number) => q[k]! - (k < points ? 0 : q[k - points]!);
  q.forEach((_, k) => {
    const d = ((change(k) - (k % points === 0 ? 0 : change(k - 1))) << 16) >> 16;
    const folded = d < 0 ? -2 * d - 1 : 2 * d;
    packed[k >> 2]! |= Math.min(3, folded) << (2 * (k % 4));
    if (folded >= 3) list.push(folded - 3);
  });
  return Uint8Array.from([...packed, ...numbers(list)]);
}

/** Low bytes, then high bytes. */
function numbers(values: number[]): Uint8Array {
  return Uint8Array.from([...values.map((v) => v & 0xff), ...values.map((v) => v >> 8)]);
}

export class ChunkWriter {
  readonly texts: string[] = [];

  add(bytes: Uint8Array): number {
    this.texts.push(gzipSync(bytes).toString("base64"));
    return this.texts.length - 1;
  }

  floats(values: ArrayLike<number>): number {
    return this.words(new Uint32Array(Float32Array.from(values).buffer));
  }

  numbers(values: ArrayLike<number>): number {
    return this.words(Uint32Array.from(values));
  }

  private words(words: Uint32Array): number {
    const changes = words.map((word, k) => word - (k === 0 ? 0 : words[k - 1]!));
    return this.add(Uint8Array.from([0, 8, 16, 24].flatMap((shift) => Array.from(changes, (d) => (d >>> shift) & 0xff))));
  }

  /** values[f][p]; null: absent, 65535 in the file. */
  quantity(values: (number | null)[][], log = false): QuantisedMeta {
    const [frames, points] = [values.length, values[0]!.length];
    let [lo, hi] = [Infinity, -Infinity];
    for (const row of values) for (const v of row) if (v !== null) [lo, hi] = [Math.min(lo, v), Math.max(hi, v)];
    if (log) lo = Math.max(lo, 1e-6 * hi);
    hi = hi > lo ? hi + 2e-5 * (hi - lo) : lo + 1;
    const q = new Uint16Array(frames * points);
    values.forEach((row, f) => row.forEach((v, p) => {
      const part = v === null ? 1 : log ? Math.log(Math.max(v, lo) / lo) / Math.log(hi / lo) : (v - lo) / (hi - lo);
      q[f * points + p] = Math.round(part * FULL);
    }));
    const layout = frames % 2 ? "frame" : "point";
    return { chunk: this.add(encodeFrames(q, frames, points, layout)), layout, lo, hi, log, frames, points, static: false };
  }
}

export const PLACE = "<!--terp-data-->";

/** The template with the data in its place. */
export function fillTemplate(template: string, json: unknown, chunks: string[]): string {
  const data = `<script id="terp-report" type="application/json">${JSON.stringify(json).replaceAll("</", "<\\/")}</script>`;
  const scripts = chunks.map((text, k) => `<script type="application/octet-stream" data-chunk="${k}">${text}</script>`);
  const at = template.indexOf(PLACE);
  if (at < 0 || template.indexOf(PLACE, at + 1) >= 0) throw new Error("The template must hold the place of the data once.");
  return template.slice(0, at) + [data, ...scripts].join("\n") + template.slice(at + PLACE.length);
}
