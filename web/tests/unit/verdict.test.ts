// The verdict on the water: what may be said of it, and what must be read with it.

import { afterEach, describe, expect, it } from "vitest";
import type { Flood } from "../../src/data/format";
import type { Run } from "../../src/data/run";
import { slidesBySlope } from "../../src/logic/slides";
import { columnPlace } from "../../src/logic/numbers";
import { chooseLanguage } from "../../src/logic/texts";
import { doubts, kindOf, stageWords } from "../../src/logic/verdict";

afterEach(() => chooseLanguage("en"));

function runWith(verdict: string | null, finished: boolean, more: object = {}, summary: object = {}): Run {
  return { meta: { finished, times: [0, 4], events: { slides: [], flood: verdict === "no level" ? null : { verdict } },
    summary, ...more }, series: null } as unknown as Run;
}
const plain = (texts: string[]) => texts.map((text) => text.replace(/[\u00a0\u202f]/g, " "));

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
    const summary = { stages: [{ name: "daily", start: 0, end: 1, at_rest: false, fastest_node: 0.5 },
      { name: "flood", start: 1, end: 4, at_rest: false, fastest_node: 0.025 }],
    reached_sides: [{ side: "right", time: 3, rose: false }, { side: "left", time: 2, rose: true }] };
    expect(plain(doubts(runWith("damaged", true, {}, summary)))).toEqual([
      "The soil had not come to rest at the end: its fastest node moved with 0.025 m/s.",
      "Soil came to the side “right” of the mesh at 3.00 s, which acts on it from then on.",
      "Soil rose at the side “left” of the mesh by 2.00 s, which holds it back.",
    ]);
    expect(doubts(runWith("floods", true))).toEqual([]);
    const close = { events: { slides: [], flood: { verdict: "damaged", margin: 0.05 } } };
    expect(plain(doubts(runWith("damaged", true, close)))).toEqual([
      "The ground that remains is only 0.05 m higher than holds the water: finer cells may decide."]);
    const rest = (last: object) => doubts(runWith("stands", true, {}, { stages: [{ name: "a", start: 0, end: 1, ...last }] }));
    expect(rest({ at_rest: true, fastest_node: 1e-4 })).toEqual([]);
    expect(plain(doubts(runWith("stands", true,
      { events: { slides: [], flood: { verdict: "stands", fastest_node: 0.5, still_moves: true } } })))).toEqual([
      "The soil had not come to rest at the end: its fastest node moved with 0.5 m/s."]);
    expect(plain(doubts(runWith("damaged", true, { events: { slides: [], flood: { verdict: "damaged", fastest_node: 0.5,
      still_moves: true, stage_moving: "high", stage: "after" } } })))).toEqual([
      "The soil had not come to rest at the end of stage “high”: its fastest node moved with 0.5 m/s."]);
    expect(doubts(runWith("still_moving", true, {}, { stages: [{ name: "a", start: 0, end: 1, at_rest: false,
      fastest_node: 0.5 }] }))).toEqual([]);
    expect(rest({ at_rest: false, fastest_node: null })).toEqual([]); // it was not to end at rest
    expect(rest({ end: null, at_rest: false, fastest_node: null })).toEqual([]); // it runs
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
