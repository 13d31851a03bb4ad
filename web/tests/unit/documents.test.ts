// The pages of a study, a reach and a sequence of meshes: what they count, and what they say.

import { afterEach, describe, expect, it } from "vitest";
import { Chunks } from "../../src/data/chunks";
import { readTables, type StudyMeta, type Tables } from "../../src/data/documents";
import { answerOf as answerOfCurve } from "../../src/documents/fragility";
import { countsOf, verdictWords } from "../../src/documents/reach";
import { answerOf } from "../../src/documents/study";
import { linesOf } from "../../src/documents/sweep";
import { percentOf, tickTexts } from "../../src/logic/numbers";
import { classesOf, kindsAt, medianOf, outcomesOf } from "../../src/logic/realisations";
import { chooseLanguage } from "../../src/logic/texts";
import { event, exampleCurve, exampleReach, exampleStudy, sectionOf, type MadeDocument } from "../support/documents";
import type { ReachMeta } from "../../src/data/documents";

afterEach(() => chooseLanguage("en"));

async function opened({ document, chunks }: MadeDocument): Promise<{ data: StudyMeta; tables: Tables }> {
  const data = document.data as StudyMeta;
  return { data, tables: await readTables(data, new Chunks((k) => chunks[k] ?? null)) };
}

describe("a study", () => {
  it("finds all tables in its data", async () => {
    const { data, tables } = await opened(exampleStudy());
    expect(tables.size).toBe(2);
    expect(tables.get(data.inputs)!.column("material.clay.su_peak")![4]).toBe(9004);
  });

  it("says what P is, with its bounds, and what the residual strength is worth", () => {
    const data = exampleStudy().document.data as StudyMeta;
    expect(answerOf(data)).toBe("The land floods with probability 0.17; with 95 % confidence it lies between 0.085 and 0.26. " +
      "Of 1 of 60 realisations it is not known. They are no random sample, as it is mostly weak soil that a run fails with, so the estimate may be too low: " +
      "use the bounds, in which each counts as both. A slide happens with probability 0.34. " +
      "Of 100 slides 50 flood the land (25 to 76): that is what the residual strength is worth.");
    data.flood_after_slide = { ...event(0, 20), probability: null, low: 0, high: 1 };
    expect(answerOf(data)).toContain("How many of 100 slides flood the land is not known: 0 to 100.");
    data.estimator = "sobol";
    expect(answerOf(data)).toContain("as far as independent realisations would say, with 95 % confidence");
    chooseLanguage("nl");
    expect(answerOf(data)).toMatch(/^Het land overstroomt met kans 0,17; voor zover onafhankelijke realisaties/);
    data.flood = { ...event(0, 1), probability: null, solved: 0, failed: 0 };
    expect(answerOf(data)).toBe("Er is nog geen realisatie berekend.");
  });

  it("counts the realisations by kind, the most frequent first, with one to be opened", async () => {
    const { data, tables } = await opened(exampleStudy());
    const kinds = kindsAt(tables.get(data.outcomes)!, 0);
    expect(kinds.map(({ name, n }) => [name, n])).toEqual([["stands, and holds the water", 39],
      ["slides more than once, and holds the water", 10], ["slides, and the land floods", 10], ["failed", 1]]);
    expect(kinds.reduce((sum, { share }) => sum + share, 0)).toBeCloseTo(1);
    expect(kinds[2]).toMatchObject({ volume: 40, height: 3, example: 30 });
    expect(kinds[3]!.volume).toBeNaN();
    expect([medianOf([3, 1, 2]), medianOf([4, 1, 2, 3]), medianOf([])]).toEqual([2, 3, NaN]);
  });

  it("counts each level of a load by itself", async () => {
    const { data, tables } = await opened(exampleCurve());
    const outcomes = tables.get(data.outcomes)!;
    expect(kindsAt(outcomes, 0).map(({ name, n, share }) => [name, n, share])).toEqual([["stands, and holds the water", 20, 1]]);
    expect(kindsAt(outcomes, 2).map(({ name, n }) => [name, n])).toEqual([["slides beside the crest, and holds the water", 10],
      ["slides beside the crest, and the land floods", 10]]);
    expect(outcomesOf(data, outcomes, "residual_height").map(({ name, values }) => [name, values.length])).toEqual([["0.4\u00a0m", 20], ["0.8\u00a0m", 20], ["1.6\u00a0m", 20]]);
  });

  it("leaves coarse realisations out", async () => {
    const { data, tables } = await opened(exampleStudy());
    const outcomes = tables.get(data.outcomes)!;
    outcomes.column("coarse")!.fill(1, 10);
    expect(kindsAt(outcomes, 0).reduce((sum, { n }) => sum + n, 0)).toBe(10);
    expect(outcomesOf(data, outcomes, "slide_volume")[0]!.values).toHaveLength(9);
  });

  it("has classes of one size that hold all values", () => {
    const values = Array.from({ length: 27 }, (_, k) => k);
    const { edges, counts } = classesOf([{ name: "a", values }, { name: "b", values: [26, 26] }])!;
    expect(edges).toHaveLength(7); // twice the cube root of 27
    expect([edges[0], edges[6]]).toEqual([0, 26]);
    expect(counts[0]!.reduce((a, b) => a + b)).toBe(27);
    expect(counts[1]).toEqual([0, 0, 0, 0, 0, 2, 0]);
    expect(classesOf([{ name: "", values: [1] }])).toBeNull();
    expect(classesOf([{ name: "", values: [1, 1] }])!.edges[1]).toBe(2);
  });
});

describe("a curve", () => {
  it("has an answer for each of its three forms", () => {
    const data = exampleCurve().document.data as StudyMeta;
    expect(answerOfCurve(data)).toMatch(/^The land floods with probability 0\.03, over the distribution of the water\. .*; it falls from one level .* A slide happens with probability 0\.12\.$/);
    data.judges_flood = false;
    expect(answerOfCurve(data)).toContain("lies between 0.1 and 0.2 if the curve is straight between its levels and level beyond them, and between 0.05 and 0.4 if it is only known to rise.");
    data.slide_over_levels = null;
    expect(answerOfCurve(data)).toContain("each level needs realisations");
    data.of_load!.distribution = [];
    expect(answerOfCurve(data)).toContain("give the distribution of the load in [fragility]");
  });
});

describe("a sweep", () => {
  it("draws a few of many lines, evenly from the first to the last, in the order of the study", () => {
    const words = ["mpm_gp", "mpm_mixed"].flatMap((scheme) => ["6", "7"].flatMap((su) => ["5", "6", "7", "8"].map((eta) => [scheme, su, eta])));
    const { names, drawn } = linesOf(words, 1);
    expect(names).toHaveLength(8);
    expect(drawn.map((k) => names[k])).toEqual(["mpm_gp, 5", "mpm_gp, 6", "mpm_gp, 7", "mpm_mixed, 5", "mpm_mixed, 6", "mpm_mixed, 8"]);
    expect(linesOf([["1"], ["2"]], 0)).toEqual({ names: [""], drawn: [0] });
  });
});

describe("a reach", () => {
  const { sections } = exampleReach().document.data as ReachMeta;

  it("counts its verdicts", () => {
    expect(countsOf(sections)).toBe("Solved: 3 of 4 sections. Stands: 2; damaged, holds the water: 0; still moving: 0; floods briefly or by little: 0; floods: 1; no verdict on the water: 0; no result: 1. Not at rest at the end: 1.");
    expect(countsOf([sectionOf("x", "stands", { flood: null })])).toContain("no verdict on the water: 1; no result: 0.");
  });

  it("says a trigger in the verdict itself, and what it was before", () => {
    expect(verdictWords(sections[1]!)).toEqual({ verdict: "Floods, after strengths were divided by 1.12 and the river was brought to 3.50\u00a0m", before: "As it is, the section stands." });
    const moved = sectionOf("x", "floods", { moved_before_trigger: true });
    moved.flood!.trigger = { stage: "weaker_soil", at_strength: 1, river: null, before: null };
    expect(verdictWords(moved)).toEqual({ verdict: "Floods, after the stage “weaker_soil”", before: "As it is: no verdict, as it had not come to rest." });
    chooseLanguage("nl");
    expect(verdictWords(sections[1]!).verdict).toBe("Loopt over, na een opgelegde trigger: sterktes gedeeld door 1,12 en buitenwaterstand 3,50\u00a0m");
    expect(verdictWords(sections[3]!).verdict).toBe("Geweigerd");
  });
});

it("gives the numbers of an axis the digits that tell them apart", () => {
  expect(tickTexts([0, 0.5, 1])).toEqual(["0", "0.5", "1"]);
  expect(tickTexts([1.9991, 1.9992, 1.9993])).toEqual(["1.9991", "1.9992", "1.9993"]);
});

it("rounds a share as it is read", () => {
  expect([0.0634, 0.3, 0.0001].map(percentOf)).toEqual(["6.3\u202f%", "30\u202f%", "0.01\u202f%"]);
});
