// The verdict on the water: what may be said of it, and what must be read with it.

import { afterEach, describe, expect, it } from "vitest";
import type { Flood } from "../../src/data/format";
import type { Run } from "../../src/data/run";
import { slidesBySlope } from "../../src/logic/slides";
import { columnPlace } from "../../src/logic/numbers";
import { chooseLanguage } from "../../src/logic/texts";
import { doubts, kindOf, stageWords } from "../../src/logic/verdict";
import { assumedOf, surenessOf } from "../../src/sections/how_sure";

afterEach(() => chooseLanguage("en"));

function runWith(verdict: string | null, finished: boolean, more: object = {}, summary: object = {}): Run {
  return { meta: { finished, times: [0, 4], events: { slides: [], flood: verdict === "no level" ? null : { verdict } },
    summary, ...more }, series: null } as unknown as Run;
}

describe("the verdict", () => {
  it("of a run that has not ended is none, unless it floods for good", () => {
    for (const verdict of ["stands", "damaged", null, "no level"]) expect(kindOf(runWith(verdict, false))).toBe("running");
    expect(kindOf(runWith("floods", false))).toBe("floods");
    expect(kindOf(runWith("stands", true))).toBe("stands");
    expect(kindOf(runWith("no level", true))).toBe("none");
    expect(kindOf(runWith("stands", true, { events: null }))).toBe("running");
  });

  it("says in which stage it came true", () => {
    const words = (damaged: string, below: string) =>
      stageWords({ stage_damaged: damaged, stage_below: below, stage: "flood" } as Flood);
    expect(words("daily", "daily")).toBe(" It began in stage “daily”, before “flood”.");
    expect(words("flood", "")).toBe(" It began in stage “flood”.");
    expect(words("", "flood")).toBe(" It began in stage “flood”.");
    expect(words("daily", "flood")).toBe(" The damage began in stage “daily”, the flood in “flood”.");
    expect(words("", "")).toBe("");
    expect(stageWords({} as Flood)).toBe(""); // of an older run
    expect(stageWords(null)).toBe("");
  });

  it("comes with what speaks against it", () => {
    expect(doubts(runWith("stands", true))).toEqual([]);
    const changed = runWith("stands", true);
    changed.meta.changed = { en: ["clay: S was 0.3 in the import, is 0.2 here.", "b"], nl: ["klei", "b"] };
    expect(doubts(changed)).toEqual([
      "Values of this case were changed since its import (2): they are listed below."]);
    changed.meta.changed = { en: [], nl: [] };
    expect(doubts(changed)).toEqual([]);
    const depends = (on: string[], not: string[]) =>
      doubts(runWith("stands", true, { depends: { turns_on: on, does_not_turn_on: not } }))[0];
    expect(depends(["k0", "cells"], ["S"])).toBe(
      "The outcome turns on: k0, cells. Each of these alone gives another one; S did not.");
    expect(depends(["k0"], [])).toBe("The outcome turns on: k0. Each of these alone gives another one.");
    expect(depends([], ["S"])).toBe("The outcome stays the same where one of these is changed: S.");
    expect(doubts(runWith("stands", true, { depends: { turns_on: [], does_not_turn_on: ["S"], not_varied: ["a", "b"] } })))
      .toEqual(["The outcome stays the same where one of these is changed: S. Not varied: a; b."]);
    const said = ["side", "rest", "margin", "energy"].map((id) => ({ id, en: `Of ${id}.`, nl: "", see: "" }));
    expect(doubts(runWith("damaged", true, {}, { findings: said }))).toEqual(["Of rest.", "Of side.", "Of margin."]);
    expect(doubts(runWith("still_moving", true, {}, { findings: said }))).toEqual(["Of side.", "Of margin."]);
  });
});

it("a strength on its way is named with the stage", () => {
  const flood = { stage_damaged: "release", stage_below: "", stage: "release", at_strength_damaged: 0.8234 } as never;
  expect(stageWords(flood)).toContain("Strengths were then divided by 0.82: that is about the factor of safety.");
});

it("ground near a flood has a verdict of its own, and soil that ravelled a note", () => {
  expect(kindOf(runWith("near", true))).toBe("near");
  expect(kindOf(runWith("near", false))).toBe("running");
  const flood = { verdict: "stands", ravelled_volume: 0.62, ravelled_depth: 0.7 };
  expect(doubts(runWith("stands", true, { events: { slides: [], flood } })).join(" ").replaceAll("\u00a0", " "))
    .toContain("Ravelled: 0.6 m², from at most 0.70 m below the ground.");
});

it("retrogression is of the slope that slid first", () => {
  const slide = (facing: string, begins: number) => ({ facing, begins });
  const slides = [slide("right", 1), slide("left", 2), slide("right", 3), slide("left", 4)];
  const { own, other } = slidesBySlope({ events: { slides } } as never);
  expect(own.map(({ begins }) => begins)).toEqual([1, 3]);
  expect(other.map(({ begins }) => begins)).toEqual([2, 4]);
  expect(slidesBySlope({ events: null })).toEqual({ own: [], other: [] });
});

it("edges of columns have no more decimals than the columns", () => {
  const text = (x: number, column: number | null) => columnPlace(x, column).replace("\u00a0", " ");
  expect(text(21, 1)).toBe("21 m");
  expect(text(21.5, 0.5)).toBe("21.5 m");
  expect(text(21.75, 0.25)).toBe("21.75 m");
  expect(text(21.123, 0.123)).toBe("21.12 m");
  expect(text(21, null)).toBe("21.00 m");
  expect(columnPlace(null, 1)).toBe("–");
});

describe("how sure the verdict is", () => {
  const stability = (mesh: object | null) => ({ factor_of_safety: 1.052, uncertainty: 0.013, stable_at: 1.04,
    failed_at: 1.07, mesh });
  const rows = (more: object, verdict = "stands") => surenessOf(runWith(verdict, true, more)).map(
    ({ name, value, tone }) => [name, value.replace(/[\u00a0\u202f]/g, " "), tone]);

  it("asks for the factor and for what decides where nobody looked for them", () => {
    expect(rows({})).toEqual([["Verdict", "Stands", "good"], ["Factor of safety", "not looked for", "unknown"],
      ["The verdict turns on", "not looked for", "unknown"]]);
    expect(rows({}, "near")[0]![2]).toBe("warn");
  });

  it("has the factor, the cells over the depth and the range of the mesh", () => {
    const mesh = { cell: 0.5, cells_over_depth: 7.5, largest_error: 0.17, extrapolated: null };
    expect(rows({ stability: stability(mesh) }).slice(1, 4)).toEqual([
      ["Factor of safety", "1.05 ± 0.01", "warn"],
      ["Cells over the depth of the slide", "7.5 of 0.50 m", "warn"],
      ["What the mesh does to the factor", "too large, by up to 17 %", "warn"]]);
    const measured = { ...mesh, cells_over_depth: 12, extrapolated: { factor: 1, low: 0.97, high: 1.04 } };
    expect(rows({ stability: stability(measured) }).slice(2, 4)).toEqual([
      ["Cells over the depth of the slide", "12.0 of 0.50 m", "good"],
      ["What the mesh does to the factor", "0.97 to 1.04", "good"]]);
    expect(rows({ stability: stability(null) }).length).toBe(3);
  });

  it("says what decides, in Dutch too", () => {
    const depends = { turns_on: ["k0"], does_not_turn_on: ["S"] };
    expect(rows({ depends })[2]).toEqual(["The verdict turns on", "k0", "warn"]);
    chooseLanguage("nl");
    expect(rows({ depends: { turns_on: [], does_not_turn_on: ["S"] } })[2])
      .toEqual(["Het oordeel hangt af van", "niets van wat is gevarieerd", "good"]);
  });

  it("names the way to change each thing that the import assumed", () => {
    const en = ["clay: stiffness, Poisson's ratio and K0 are defaults of clay.",
      "Under the border, a film of 2 m has the strength of that border. --no-film leaves it out.", "Something else."];
    const meta = { assumed: { en, nl: ["klei: stijfheid", "glijlaag", "iets anders"] }, materials: [] } as never;
    expect(assumedOf(meta).map(({ how }) => how)).toEqual(["terp import --soil-defaults FILE", "terp import --no-film",
      "case.toml, or the file itself"]);
    chooseLanguage("nl");
    expect(assumedOf(meta).map(({ text, how }) => [text, how])[0])
      .toEqual(["klei: stijfheid", "terp import --soil-defaults BESTAND"]);
  });
});
