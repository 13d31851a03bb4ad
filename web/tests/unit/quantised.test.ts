import { describe, expect, it } from "vitest";
import { decodeFrames, Quantised, valueOf } from "../../src/data/quantised";
import { encodeFrames } from "../support/encode";

describe("frames of 16-bit numbers", () => {
  it("are sums of differences modulo 65536: low bytes of all points, then high bytes", () => {
    // Two points, two frames, by hand: q[0] = 258, 65535; q[1] = 1, 4.
    // d[0] = q[0]: low 2, 255, high 1, 255. d[1] = 1 - 258 = -257 -> 65279 = 0xfeff; 4 - 65535 -> 5 = 0x0005.
    const bytes = Uint8Array.from([2, 255, 1, 255, 0xff, 5, 0xfe, 0]);
    expect([...decodeFrames(bytes, 2, 2)]).toEqual([258, 65535, 1, 4]);
  });

  it("come back as they were written, for any numbers", () => {
    const [frames, points] = [7, 13];
    let seed = 12345;
    const q = Uint16Array.from({ length: frames * points }, () => (seed = (seed * 1103515245 + 12345) % 2147483648) >> 8);
    expect([...decodeFrames(encodeFrames(q, frames, points), frames, points)]).toEqual([...q]);
  });

  it("of another number of bytes are refused with both numbers", () => {
    expect(() => decodeFrames(new Uint8Array(7), 2, 2)).toThrow("2 frames of 2 points need 8 bytes, but there are 7.");
  });
});

describe("a value", () => {
  it("is linear between lo and hi", () => {
    expect(valueOf({ lo: -2, hi: 8, log: false }, 0)).toBe(-2);
    expect(valueOf({ lo: -2, hi: 8, log: false }, 65535)).toBe(8);
    expect(valueOf({ lo: -2, hi: 8, log: false }, 13107)).toBeCloseTo(0, 12); // a fifth
  });

  it("is geometric between lo and hi if log", () => {
    expect(valueOf({ lo: 0.01, hi: 100, log: true }, 65535 / 4)).toBeCloseTo(0.1, 12);
  });

  it("is NaN at the last q, and the same in all frames if the quantity is static", () => {
    const meta = { chunk: 0, lo: 0, hi: 65535, log: false, frames: 3, points: 2, bits: 16 as const, static: true };
    const field = new Quantised(meta, Uint16Array.from([3, 65535]));
    expect(field.value(2, 0)).toBe(3);
    expect(field.value(2, 1)).toBeNaN();
    expect([...field.frame(1)]).toEqual([3, 65535]);
  });
});
