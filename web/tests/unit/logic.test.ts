import { describe, expect, it } from "vitest";
import { advance, allTimes, frameAt, speeds, stepTime } from "../../src/logic/time";
import { bestColumns, fit, pan, toScreen, toWorld, zoomAt } from "../../src/logic/camera";
import { barTicks, categoryTable, CATEGORIES, mapNamed, placeOnBar, rgb, symmetric, table, validRange } from "../../src/logic/colour";
import { slipAt } from "../../src/logic/slides";
import { durationText, niceLength, niceTicks, numberText, readableUnit, timeDecimals, toSteps, withUnit } from "../../src/logic/numbers";
import { heightsAt, places } from "../../src/logic/surface";
import { runLabels } from "../../src/logic/labels";
import { Store } from "../../src/logic/store";

describe("time", () => {
  const times = [0, 0.1, 0.2, 0.5];
  it("shows the nearest frame, the earlier of two equally near", () => {
    expect([-1, 0, 0.04, 0.06, 0.3, 0.36, 9].map((t) => frameAt(times, t))).toEqual([0, 0, 0, 1, 2, 3, 3]);
    expect(frameAt([0, 1, 2], 0.5)).toBe(0);
    expect(frameAt([3], 7)).toBe(0);
  });
  it("steps from frame to frame and stops at the ends", () => {
    expect(stepTime(times, 0.1, 1)).toBe(0.2);
    expect(stepTime(times, 0.1, -1)).toBe(0);
    expect(stepTime(times, 0, -1)).toBe(0);
    expect(stepTime(times, 0.2, 1e9)).toBe(0.5);
  });
  it("of several runs is one list, with times that differ by round-off only once", () => {
    expect(allTimes([[0, 0.1, 0.2], [0, 0.1 + 1e-9, 0.15, 0.2]])).toEqual([0, 0.1, 0.15, 0.2]);
  });
  it("advances with the speed, ends at the end or begins again", () => {
    expect(advance(1, 0.5, 2, [0, 4], false)).toEqual({ time: 2, ended: false });
    expect(advance(3.9, 0.5, 2, [0, 4], false)).toEqual({ time: 4, ended: true });
    expect(advance(3.9, 0.5, 2, [0.5, 4], true)).toEqual({ time: 0.5, ended: false });
  });
  it("offers a speed with which a run takes about ten seconds", () => {
    expect(speeds(4).start).toBe(0.5);
    expect(speeds(100).start).toBe(10);
    expect(speeds(4).all).toContain(1);
  });
});

describe("the camera", () => {
  const size = { width: 400, height: 200 };
  const pad = { left: 20, right: 0, top: 0, bottom: 10 };
  it("fits a box between the paddings", () => {
    const camera = fit([0, 0, 10, 2], size, pad);
    expect(toScreen(camera, size, 0, 1)[0]).toBeCloseTo(20, 9);
    expect(toScreen(camera, size, 10, 1)[0]).toBeCloseTo(400, 9);
    expect(toScreen(camera, size, 5, 1)[1]).toBeCloseTo(95, 9); // middle of 0...190
  });
  it("brings a place to the screen and back, y upwards", () => {
    const camera = { x: 3, y: 1, scale: 50 };
    expect(toScreen(camera, size, 4, 2)).toEqual([250, 50]);
    expect(toWorld(camera, size, 250, 50)).toEqual([4, 2]);
  });
  it("keeps the place under the pointer when it zooms", () => {
    const camera = { x: 3, y: 1, scale: 50 };
    const there = toWorld(camera, size, 90, 30);
    const zoomed = zoomAt(camera, size, 90, 30, 1.7);
    expect(zoomed.scale).toBeCloseTo(85, 9);
    expect(toWorld(zoomed, size, 90, 30)[0]).toBeCloseTo(there[0], 9);
    expect(toWorld(zoomed, size, 90, 30)[1]).toBeCloseTo(there[1], 9);
  });
  it("pans with the pointer", () => {
    const camera = pan({ x: 3, y: 1, scale: 50 }, 10, 20);
    expect(camera.x).toBeCloseTo(2.8, 12);
    expect(camera.y).toBeCloseTo(1.4, 12);
  });
  it("puts long runs one above the other and tall ones side by side", () => {
    const none = { left: 0, right: 0, top: 0, bottom: 0 };
    expect(bestColumns(2, [0, 0, 13, 2], { width: 900, height: 400 }, none)).toBe(1);
    expect(bestColumns(2, [0, 0, 2, 3], { width: 900, height: 400 }, none)).toBe(2);
  });
});

describe("colours", () => {
  it("are at the ends of the bar outside the range", () => {
    expect(placeOnBar(-1, { lo: 0, hi: 2, log: false })).toBe(0);
    expect(placeOnBar(0.5, { lo: 0, hi: 2, log: false })).toBe(0.25);
    expect(placeOnBar(9, { lo: 0, hi: 2, log: false })).toBe(1);
    expect(placeOnBar(0.1, { lo: 0.001, hi: 10, log: true })).toBeCloseTo(0.5, 12);
    expect(placeOnBar(0, { lo: 0.001, hi: 10, log: true })).toBe(0);
  });
  it("need a range that can be drawn", () => {
    expect(validRange({ lo: 2, hi: 1, log: false })).toEqual({ lo: 1, hi: 2, log: false });
    expect(validRange({ lo: 3, hi: 3, log: false })).toEqual({ lo: 1.5, hi: 4.5, log: false });
    expect(validRange({ lo: 0, hi: 2, log: true })).toEqual({ lo: 0.002, hi: 2, log: true });
    expect(validRange({ lo: Infinity, hi: -Infinity, log: false })).toEqual({ lo: 0, hi: 1, log: false });
  });
  it("of a diverging field have zero in the middle", () => {
    expect(symmetric({ lo: -3, hi: 5, log: false })).toEqual({ lo: -5, hi: 5, log: false });
  });
  it("of a map grow lighter from dark to bright without a turn (viridis, cividis)", () => {
    for (const name of ["viridis", "cividis", "magma", "grey"]) {
      const bytes = table(mapNamed(name));
      const light = Array.from({ length: 256 }, (_, k) => 0.21 * bytes[4 * k]! + 0.72 * bytes[4 * k + 1]! + 0.07 * bytes[4 * k + 2]!);
      light.forEach((value, k) => k > 0 && expect(value, `${name} at ${k}`).toBeGreaterThan(light[k - 1]! - 1.5));
      expect(light[255]! - light[0]!, name).toBeGreaterThan(150);
    }
  });
  it("of materials are those of the list", () => {
    expect([...categoryTable().slice(4, 7)]).toEqual(rgb(CATEGORIES[1]!));
  });
  it("have ticks at nice values", () => {
    expect(barTicks({ lo: 0, hi: 2, log: false }, niceTicks).map((tick) => tick.text)).toEqual(["0", "0.5", "1", "1.5", "2"]);
    expect(barTicks({ lo: 0.002, hi: 0.1, log: true }, niceTicks).map((tick) => tick.text)).toEqual(["0.002", "0.005", "0.01", "0.02", "0.05", "0.1"]);
  });
});

describe("numbers as text", () => {
  it("have no more decimals than their steps", () => {
    expect([[1.23456, 0.01], [1.23456, 0.02], [1.23456, 0.005], [-0.06, 0.2], [1234.5, 100], [0.00123, 1e-9]]
      .map(([v, step]) => toSteps(v!, step!))).toEqual([1.23, 1.23, 1.23, -0.1, 1235, 0.00123]);
  });

  it("have a few digits, groups and powers", () => {
    expect([13.392, 0.00213, 40000, 1234.56, -0.5, 0, 1.234e-5, NaN].map((v) => numberText(v))).toEqual(["13.39", "0.00213", "40\u202f000", "1235", "−0.5", "0", "1.23·10⁻⁵", "–"]);
    expect(numberText(2500000, 9)).toBe("2\u202f500\u202f000");
    expect(withUnit(null, "m")).toBe("–");
    expect(withUnit(0.3, "-")).toBe("0.3");
    expect(withUnit(0.3, "m")).toBe("0.3\u00a0m");
  });
  it("take a prefix where it helps", () => {
    expect(readableUnit("J/m", 120000)).toEqual({ factor: 1e-3, unit: "kJ/m" });
    expect(readableUnit("kJ/m", 12)).toEqual({ factor: 1, unit: "kJ/m" });
    expect(readableUnit("kJ/m", 12000)).toEqual({ factor: 1e-3, unit: "MJ/m" });
    expect(readableUnit("m", 12000)).toEqual({ factor: 1, unit: "m" });
  });
  it("of times tell neighbouring frames apart", () => {
    expect(timeDecimals([0, 0.05, 0.1])).toBe(2);
    expect(timeDecimals([0, 0.001, 0.002])).toBe(4);
  });
  it("of long times have minutes and hours", () => {
    expect(durationText(83.4)).toBe("1\u00a0min 23\u00a0s");
    expect(durationText(119.8)).toBe("2\u00a0min 0\u00a0s");
    expect(durationText(7300)).toBe("2\u00a0h 1\u00a0min");
  });
  it("of scale bars are 1, 2 or 5", () => {
    expect([0.7, 1, 3, 49, 70].map(niceLength)).toEqual([0.5, 1, 2, 20, 50]);
  });
});

describe("free surfaces", () => {
  const line = Float32Array.from([0, 2, 2, 4, 3, 0]);
  it("have heights between their places and none outside", () => {
    expect(heightsAt(line, [-1, 0, 1, 2, 2.5, 3, 4])).toEqual([null, 2, 3, 4, 2, 0, null]);
  });
  it("have places in common", () => {
    expect(places([line, Float32Array.from([1, 0, 2, 0])])).toEqual([0, 1, 2, 3]);
  });
});

describe("runs", () => {
  it("are called by scheme where that tells them apart, else by name", () => {
    expect(runLabels([{ name: "a", scheme: "mpm_gp" }, { name: "b", scheme: "mpm_mixed" }])).toEqual(["MPM-GP", "MPM-Mixed"]);
    expect(runLabels([{ name: "a", scheme: "mpm_gp" }, { name: "b", scheme: "mpm_gp" }])).toEqual(["a", "b"]);
    expect(runLabels([{ name: "a", scheme: "mpm_gp" }, { name: "a", scheme: "mpm_gp" }])).toEqual(["a (1)", "a (2)"]);
  });
});

describe("the store", () => {
  it("tells listeners what changed, and nothing if nothing did", () => {
    const store = new Store({ time: 0, field: "a" } as never);
    const told: string[] = [];
    store.on((_, changed) => told.push([...changed].join()));
    store.set({ time: 1 });
    store.set({ time: 1 });
    store.set({ time: 2, field: "b" });
    expect(told).toEqual(["time", "time,field"]);
  });
});

describe("slip surfaces", () => {
  const surface = (time: number) => ({ time, points: [[0, 1], [1, 0]] as [number, number][] });
  const slides = [{ begins: 0.2, stops: 2.0, slip_surface: surface(0.7) }, { begins: 2.5, stops: null, slip_surface: surface(3.2) }];

  it("act from the time at which they formed until their slide stops, and are past after that", () => {
    const at = (t: number) => {
      const shown = slipAt(slides, t);
      return [shown?.time, shown?.phase];
    };
    expect(at(0.1)).toEqual([0.7, "to come"]);
    expect(at(0.7)).toEqual([0.7, "acting"]);
    expect(at(2.0)).toEqual([0.7, "acting"]);
    expect(at(2.1)).toEqual([0.7, "past"]);
    expect(at(3.1)).toEqual([0.7, "past"]);
    expect(at(4.0)).toEqual([3.2, "acting"]);
  });

  it("of a slide that never stops end when the next begins", () => {
    expect(slipAt([{ ...slides[0]!, stops: null }, slides[1]!], 2.6)?.phase).toBe("past");
    expect(slipAt([], 1)).toBeNull();
  });
});
