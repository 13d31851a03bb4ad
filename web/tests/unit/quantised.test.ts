import { describe, expect, it } from "vitest";
import { decodeFrames, distances, Quantised, valueOf } from "../../src/data/quantised";
import { encodeFrames } from "../support/encode";

describe("frames of 16-bit numbers", () => {
  it("are changes from frame to frame less those of the point before, two bits each, and a list of what is more", () => {
    // Three points, two frames, by hand: q[0] = 258, 258, 65535; q[1] = 259, 258, 65535.
    // Changes 258, 258, -1, then 1, 0, 0; less those before: 258, 0, -259, then 1, -1, 0; folded: 516, 0, 517, 2, 1, 0.
    // Two bits, the first lowest: 3, 0, 3, 2 -> 0b10110011; 1, 0 -> 0b01. List: 513, 514, low bytes, then high bytes.
    const bytes = Uint8Array.from([0b10110011, 0b01, 1, 2, 2, 2]);
    expect([...decodeFrames(bytes, 2, 3, "frame")]).toEqual([258, 258, 65535, 259, 258, 65535]);
  });

  it("or the numbers themselves point by point: low bytes, then high bytes", () => {
    const bytes = Uint8Array.from([2, 1, 255, 4, 1, 0, 255, 0]);
    expect([...decodeFrames(bytes, 2, 2, "point")]).toEqual([258, 65535, 1, 4]);
  });

  it.each(["frame", "point"] as const)("come back as they were written by %s, for any numbers", (layout) => {
    const [frames, points] = [7, 13];
    let seed = 12345;
    const q = Uint16Array.from({ length: frames * points }, () => (seed = (seed * 1103515245 + 12345) % 2147483648) >> 8);
    expect([...decodeFrames(encodeFrames(q, frames, points, layout), frames, points, layout)]).toEqual([...q]);
  });

  it.each(["frame", "point"] as const)("by %s of another number of bytes are refused with the numbers", (layout) => {
    expect(() => decodeFrames(new Uint8Array(7), 2, 2, layout)).toThrow("2 frames of 2 points do not need 7 bytes");
  });
});

describe("distances", () => {
  it("are from the place in the first frame, and of a point without soil there is none", () => {
    const meta = { chunk: 0, lo: 10, hi: 10 + 65535 * 0.01, log: false, frames: 2, points: 2, static: false };
    const x = new Quantised(meta, Uint16Array.from([100, 5, 400, 65535]));
    const y = new Quantised({ ...meta, hi: 10 + 65535 * 0.02 }, Uint16Array.from([50, 5, 250, 65535]));
    const gone = { ...meta, chunk: null, lo: 0, hi: 65535 * 0.01 };
    const field = new Quantised(gone, distances(x, y, gone));
    expect([field.value(0, 0), field.value(0, 1)]).toEqual([0, 0]);
    expect(field.value(1, 0)).toBeCloseTo(5, 9); // 3 m and 4 m
    expect(field.value(1, 1)).toBeNaN();
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
    const meta = { chunk: 0, lo: 0, hi: 65535, log: false, frames: 3, points: 2, static: true };
    const field = new Quantised(meta, Uint16Array.from([3, 65535]));
    expect(field.value(2, 0)).toBe(3);
    expect(field.value(2, 1)).toBeNaN();
    expect([...field.frame(1)]).toEqual([3, 65535]);
  });
});
