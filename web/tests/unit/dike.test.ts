// What is drawn of a dike: lines that go with points, grounds of the residual profile, strength along a vertical.

import { afterEach, describe, expect, it } from "vitest";
import { FULL, NONE, Quantised } from "../../src/data/quantised";
import { Report } from "../../src/data/report";
import type { Run } from "../../src/data/run";
import { chooseLanguage } from "../../src/logic/texts";
import { categoryTable, preferredMap } from "../../src/logic/colour";
import { soilName, withSoilName } from "../../src/logic/labels";
import { planeText } from "../../src/logic/story";
import { freePlace } from "../../src/view/section";
import { groundsOf } from "../../src/sections/profile";
import { layered, samplesAt } from "../../src/sections/strength";
import { exampleDike } from "../support/example";

afterEach(() => chooseLanguage("en"));

async function dike(): Promise<Run> {
  const { report, chunks } = exampleDike(20);
  const made = new Report(report, (k) => chunks[k] ?? null);
  await made.open();
  return made.runs[0]!;
}

describe("lines that go with points", () => {
  it("are where their points are, in each frame", async () => {
    const run = await dike();
    const { lines } = run.layers[1]!; // the top row
    for (const frame of [0, 30]) {
      const places = run.places(frame, lines!);
      const [x, y] = run.place(frame, lines!.points[0]!);
      expect([places[0], places[1]]).toEqual([x, y]);
    }
  });

  it("end where the soil came apart, where a point has left, and between two lines", async () => {
    const run = await dike();
    const offsets = new Float32Array(6);
    const breaks = (points: number[], frame = 0) =>
      run.places(frame, { points: Uint32Array.from(points), offsets }).filter((v) => Number.isNaN(v)).length;
    expect(breaks([0, 1, 2])).toBe(0);
    expect(breaks([0, 1, 19])).toBe(2); // 3.6 m on, spacing 0.2 m
    expect(breaks([0, 0xffffffff, 1])).toBe(2);
    expect(breaks([399, 398], 60)).toBe(2); // the last point leaves
  });
});

describe("names of soils", () => {
  it("say in words what the import cut along the phreatic line", () => {
    expect(soilName("sand_with_clay_below")).toBe("sand with clay, below water");
    expect(soilName("peat_deep")).toBe("peat deep");
    chooseLanguage("nl");
    expect(soilName("zand_above")).toBe("zand, boven water");
    expect(withSoilName("zand_above: K0 is 0.5.", [{ name: "zand" }, { name: "zand_above" }]))
      .toBe("zand, boven water: K0 is 0,5.");
    expect(withSoilName("Load ul_1: no spread.", [{ name: "load" }])).toBe("Load ul_1: no spread.");
  });

  it("are moved along their layer where another is, and have no place only where the view is full", () => {
    const taken = [{ left: 100, right: 180, y: 50 }];
    expect(freePlace(taken, 120, 90, 60, 600)).toBe(120); // another height
    expect(freePlace(taken, 120, 52, 60, 600)).toBe(193); // to the right of it
    expect(freePlace([...taken, { left: 180, right: 600, y: 50 }], 320, 52, 50, 600)).toBeNull();
    expect(freePlace(taken, -500, 52, 40, 600)).toBe(44); // the layer goes on beyond the view
  });
});

describe("the residual profile", () => {
  it("has the ground before, after each slide and at the end, no frame twice", async () => {
    const run = await dike();
    run.meta.events!.slides = [{ begins: 0.2, stops: 1.01 }, { begins: 1.5, stops: null }] as never;
    const frameOf = (time: number) => Math.round(time * 20); // of 0.05 s
    expect(groundsOf(run, frameOf).map(({ frame }) => frame)).toEqual([0, 20, 60]); // the second lasts to the end
    chooseLanguage("nl");
    expect(groundsOf(run, frameOf)[1]!.label).toBe("na de eerste afschuiving, 1,01\u00a0s");
  });
});

describe("the strength along a vertical", () => {
  it("takes the points near it, from the lowest up", async () => {
    const run = await dike();
    const field = (await run.field("su"))!;
    const samples = samplesAt(run, 0, 2, field, (await run.field("material"))!);
    expect(samples.length).toBe(40); // two columns of 20 points; the next lie 0.3 m away, as far as the reach
    for (let k = 1; k < samples.length; k++) expect(samples[k]!.y).toBeGreaterThanOrEqual(samples[k - 1]!.y);
    expect(samples[0]!.material).toBe(0);
    expect(samples[samples.length - 1]!.material).toBe(1);
  });

  it("has the soil of its frame: a body may come after the first one", async () => {
    const run = await dike();
    const [field, material] = [(await run.field("su"))!, (await run.field("material"))!];
    const soil = { ...material.meta, lo: 0, hi: FULL, static: false };
    const q = Uint16Array.from(material.q, (_, k) => (k < run.points ? NONE : 1));
    for (const { material: number } of samplesAt(run, 1, 2, field, new Quantised(soil, q))) expect(number).toBe(1);
  });

  it("is the mean of each layer, with a gap where no soil has a strength", () => {
    const at = (y: number, value: number) => ({ y, value, material: 0 });
    expect(layered([at(0.1, 2), at(0.9, 4), at(1.5, NaN), at(5.5, 8)], 1)).toEqual(
      [{ y: 0.5, value: 3 }, { y: 4.5, value: NaN }, { y: 5.5, value: 8 }]);
  });
});

it("colours soils as the writer says, and what is left of the strength from white to red", () => {
  expect([...categoryTable(["#010203"]).slice(0, 4)]).toEqual([1, 2, 3, 255]);
  expect([...categoryTable(["#010203"]).slice(4, 7)]).toEqual([230, 159, 0]); // the second has a colour of ours
  expect([preferredMap("su_ratio"), preferredMap("su")]).toEqual(["loss", "viridis"]);
});

it("names a slip plane by what is known of it", () => {
  const plane = { name: "a", method: "Bishop", factor_of_safety: 1.5, points: [] };
  expect(planeText(plane)).toBe("a: Bishop, F = 1.5");
  expect(planeText({ ...plane, factor_of_safety: null })).toBe("a: Bishop");
  expect(planeText({ ...plane, method: "" })).toBe("a: F = 1.5");
  expect(planeText({ ...plane, method: "", factor_of_safety: null })).toBe("a");
  const methods = ["BishopBruteForce", "SpencerGenetic", "UpliftVanParticleSwarm", "Janbu"];
  expect(methods.map((method) => planeText({ ...plane, method, factor_of_safety: null }))).toEqual(
    ["a: Bishop", "a: Spencer", "a: Uplift-Van", "a: Janbu"]);
});
