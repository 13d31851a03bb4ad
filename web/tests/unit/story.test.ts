// The words about a run, from its numbers.

import { afterEach, describe, expect, it } from "vitest";
import type { Run } from "../../src/data/run";
import { Table } from "../../src/data/table";
import { listChecks, listWarnings, tellStory } from "../../src/logic/story";
import { chooseLanguage } from "../../src/logic/texts";

afterEach(() => chooseLanguage("en"));

/** A run of 4 s that ends with a fifth of its largest kinetic energy, 1000 J/m. */
function sampleRun(events: object = {}, summary: object = {}, kinetic = [0, 1, 0.2]): Run {
  const columns = [{ name: "time", unit: "s" }, { name: "kinetic", unit: "kJ/m" }];
  return {
    meta: {
      finished: true, scheme: "mpm_gp", n_points: 500, times: [0, 4], warnings: {}, slip_planes: [],
      events: { facing: "right", front_x: 13.06, run_out: 5.07, moved_volume: 6.47, moved_fraction: 0.404, moved_distance: 0.1,
        remaining_crest: { x: 4.1, y: 1.96 }, slides: [], ...events },
      summary: { ...summary },
    },
    series: new Table(columns, 3, Float32Array.from([0, 1, 4, ...kinetic])),
  } as unknown as Run;
}

const slide = (begins: number, stops: number | null, more = {}) =>
  ({ begins, stops, crest_from: 8, crest_to: 6, kinetic_peak: 1000, facing: "right", ...more });
const plain = (texts: string[]) => texts.map((text) => text.replace(/[\u00a0\u202f]/g, " "));

describe("the story", () => {
  it("tells each slide, motion and crest", () => {
    expect(plain(tellStory(sampleRun({ slides: [slide(0.18, 2.16), slide(2.52, null)] })))).toEqual([
      "The first slide begins at 0.18 s: the crest retreats from x = 8.00 m to 6.00 m. At 2.16 s it has slowed to a tenth of its largest kinetic energy.",
      "The second slide begins at 2.52 s: the crest retreats from x = 8.00 m to 6.00 m. It still moves at 4.00 s, with 20 % of its largest kinetic energy.",
      "By 4.00 s, 6.47 m² of soil (40.4 % of the section) have moved by more than 0.1 m. The front has run out by 5.07 m, to x = 13.06 m.",
      "The initial ground still stands up to x = 4.10 m, y = 1.96 m.",
    ]);
  });

  it("says when a slide is overtaken by the next, and that soil still moves", () => {
    const texts = plain(tellStory(sampleRun({ slides: [slide(0.18, null), slide(2.52, 3)] })));
    expect(texts[0]).toContain("It has not slowed to a tenth of its largest kinetic energy when the next one begins.");
    expect(texts).toContain("At the end the soil still moves, with 20 % of its largest kinetic energy.");
    const other = plain(tellStory(sampleRun({ slides: [slide(0.18, null), slide(2.52, 3, { facing: "left" })] })));
    expect(other[0]).toContain("It still moves at 4.00 s, with 20 % of its largest kinetic energy."); // the other slope overtakes nothing
  });

  it("says where a slide enters the ground, and on whose side it is", () => {
    const entry = { x: 7.2, y: 2, zone: "upper_half" };
    const [text] = plain(tellStory(sampleRun({ slides: [slide(0.18, 2.16, { entry })], flood: { river: "left" } })));
    expect(text).toContain("begins at 0.18 s on the land's side: ");
    expect(text).toContain("Its slip surface enters the ground at x = 7.20 m, in the upper half of the inner slope.");
    const [left] = tellStory(sampleRun({ slides: [slide(0.18, 2.16, { facing: "left" })] }));
    expect(left).toContain(" on the slope to the left: ");
  });

  it("says how deep the slip surface goes, and where it ends", () => {
    const entry = { x: 7.2, y: 2, zone: "upper_half" };
    const told = (points: [number, number][]) => plain(tellStory(sampleRun({ slides: [slide(0.18, 2.16,
      { entry, slip_surface: { time: 1, points } })] })))[0];
    expect(told([[7.4, 1.8], [9, -1.25], [12, 0.1]])).toContain("It goes down to y = −1.25 m and ends at x = 12.00 m.");
    expect(told([[2, 0.1], [5, -0.5], [7, 1.9]])).toContain("It goes down to y = −0.50 m and ends at x = 2.00 m.");
  });

  it("says that soil holds, or only creeps", () => {
    expect(tellStory(sampleRun({ moved_fraction: 0 }))[0]).toBe("The soil holds: there is no slide.");
    expect(tellStory(sampleRun({ moved_fraction: 0.3 }))[0]).toBe("Soil moves, but the crest does not retreat as in a slide.");
  });

  it("of a run that was stopped says no more than that no slide came so far, and names the stage that runs", () => {
    const run = sampleRun({ moved_fraction: 0 }, { stages: [{ name: "daily", start: 0, end: 1, at_rest: true },
      { name: "flood", start: 1, end: null, at_rest: false, fastest_node: null }] });
    run.meta.finished = false;
    expect(plain(tellStory(run)).slice(0, 2)).toEqual([
      "Stages: daily from 0.00 s to 1.00 s, at rest; flood from 1.00 s on, not at its end.",
      "Up to 4.00 s there is no slide. The run has not reached its end."]);
  });

  it("gives the crest as it was drawn, then by the columns in which it is seen", () => {
    const run = sampleRun({ slides: [slide(0.18, 2.16, { crest_from: 8, crest_edge: 7.6 })] });
    run.meta.cell = 0.5;
    const texts = plain(tellStory(run));
    expect(texts[0]).toContain("from x = 7.60 m to 6.0 m (by columns of 0.5 m).");
    expect(texts).toContain("The initial ground still stands up to x = 4.1 m (by columns of 0.5 m), y = 1.96 m.");
  });

  it("says that no soil of the case softens", () => {
    const sentence = "No soil of this case softens: it keeps its strength at any strain.";
    const of = (summary: object) => tellStory(sampleRun({}, summary));
    expect(of({ softened_strain: null })).toContain(sentence);
    expect(of({ softened_strain: null, softened_fraction: [{ time: 4, fraction: 0 }] })).toContain(sentence);
    expect(of({ softened_strain: 0.06 })).not.toContain(sentence);
  });

  it("does not say of soil of a library that it keeps its strength", () => {
    const unknown = "It is not known how much of the soil has softened: of a law of the user's own the case does not " +
      "say what softening leaves.";
    const of = (summary: object) => tellStory(sampleRun({}, { softened_strain: null, ...summary })).join(" ");
    expect(of({ softened_fraction: [] })).toContain(unknown);
    expect(of({ softened_fraction: [] })).not.toContain("No soil");
    const known = of({ softened_fraction: [{ time: 4, fraction: 0 }], lowest_library_strength: 7e3 });
    expect(known).not.toContain("soften");
  });

  it("of a run that goes on waits for its summary", () => {
    const run = sampleRun();
    run.meta.events = null;
    expect(plain(tellStory(run))).toEqual(["The run has come to 4.00 s. What happened is told when it ends or is stopped."]);
    expect(listChecks(run)).toEqual([{ name: "The run reached its end", value: "no", passed: false }]);
  });

  it("says that the toe is not free, and how far soil came", () => {
    const of = (more: object) => plain(tellStory(sampleRun({ free_toe: false, ...more })))[1];
    expect(of({})).toMatch(/its toe is not free: what moved reaches x = 13.06 m, 5.07 m beyond the toe of the slope\.$/);
    expect(of({ front_x: null })).toMatch(/its toe is not free: no soil has come out of the slope\.$/);
    expect(of({ facing: null })).toMatch(/The section has no slope: there is no front and no crest\.$/);
  });

  it("tells of stages, of softening and of the water of strengths", () => {
    const summary = {
      stages: [{ name: "daily", start: 0, end: 4.25, at_rest: true }, { name: "flood", start: 4.25, end: 44, at_rest: false, fastest_node: 0.0125 }],
      strength_water: [{ material: "clay", parameter: "su_peak", stress: "flood", daily: "start" },
        { material: "peat", parameter: "su_peak", stress: "flood", daily: "start" }, { material: "sand", parameter: "cohesion", stress: "start" }],
      softened_fraction: [{ time: 4, fraction: 0.417 }], points_eps_eq_p_fell: 16, points_su_rose: 14,
    };
    const texts = plain(tellStory(sampleRun({ intact_fraction: 0.248 }, summary)));
    expect(texts).toContain("Stages: daily from 0.00 s to 4.25 s, at rest; flood from 4.25 s to 44.00 s, not at rest (the fastest node: 0.013 m/s).");
    const known = (more: object) => plain(tellStory(sampleRun({}, { stages: [{ name: "", start: 0, end: 9, fastest_node: null, known_for: 1.75, ...more }] }))).join(" ");
    expect(known({})).toContain("Stages: the run from 0.00 s to 9.00 s: the answer is known, what remains of the ground has not changed for 1.75 s.");
    expect(known({ at_rest: true })).toContain("Stages: the run from 0.00 s to 9.00 s: the answer is known, hardly any ground moved for 1.75 s.");
    expect(texts).toContain("Strength of clay; peat: the undrained strength S_u follows from the vertical effective stress in the water of the situation “flood”, and from the yield stress of the water at the start.");
    expect(texts).toContain("Strength of sand: cohesion follows from the vertical effective stress in the water at the start.");
    expect(texts).toContain("41.7 % of the soil has lost more than half of what softening takes from its strength.");
    expect(texts).toContain("Of the soil that moved, 24.8 % is intact: its plastic strain is below 0.01.");
    expect(texts.some((text) => /^At 16 of 500 points the plastic strain fell at some time and strength came back\./.test(text))).toBe(true);
  });

  it("names the slip planes of other methods", () => {
    const run = sampleRun();
    run.meta.slip_planes = [{ name: "D-Stability", method: "Bishop", factor_of_safety: 1.046, points: [[0, 1], [1, 0]] },
      { name: "sketch", method: "", factor_of_safety: null, points: [[0, 1], [1, 0]] }];
    expect(tellStory(run)).toContain("Slip planes of other methods are drawn over it: D-Stability: Bishop, F = 1.046; sketch. Each belongs to the strengths and the water of its own calculation, which need not be those of this run.");
  });

  it("is told in Dutch too, without a word of English", () => {
    chooseLanguage("nl");
    const texts = plain(tellStory(sampleRun({ slides: [slide(0.18, 2.16)] })));
    expect(texts[0]).toBe("De eerste afschuiving begint op 0,18 s: de kruin gaat terug van x = 8,00 m naar 6,00 m. Op 2,16 s is zij vertraagd tot een tiende van haar grootste kinetische energie.");
    expect(texts.join(" ")).not.toMatch(/\b(the|of|slide|soil|water level)\b/i);
  });
});

describe("warnings and checks", () => {
  it("are none for a good run", () => {
    expect(listWarnings(sampleRun())).toEqual([]);
    for (const check of listChecks(sampleRun())) expect(check.passed).toBe(true);
  });

  it("say nothing of a plastic strain that is not known", () => {
    const names = (summary: object) => listChecks(sampleRun({}, summary)).map(({ name }) => name).join(" ");
    expect(names({ max_eps_eq_p: null })).not.toMatch(/plastic strain/i);
    expect(names({ max_eps_eq_p: 0.3 })).toMatch(/plastic strain/i);
  });

  it("name what is not as it should be, each once", () => {
    const run = sampleRun({}, { unexplained_energy: 0.06, clamped_points: 3, points_su_rose: 2,
      findings: [{ id: "energy", en: "Nothing explains 6 %.", nl: "", see: "" }] });
    run.meta.finished = false;
    run.meta.warnings = { en: ["A frame is missing."], nl: ["Een beeld ontbreekt."] };
    expect(plain(listWarnings(run))).toEqual(["The run has not reached its end: the last row of its ledger is at 4 s.",
      "Nothing explains 6 %.", "A frame is missing.", "Check not passed: Points whose strength ever rose: 2."]);
  });

  it("say what speaks against an import in the language of the page", () => {
    const run = sampleRun();
    run.meta.doubts = { en: ["A layer is missing."], nl: ["Een laag ontbreekt."] };
    expect(listWarnings(run)).toContain("A layer is missing.");
    chooseLanguage("nl");
    expect(listWarnings(run)).toContain("Een laag ontbreekt.");
    expect(listWarnings(run)).not.toContain("A layer is missing.");
  });

  it("repeat what the program says against the run, in the language of the page", () => {
    const run = sampleRun({}, { findings: [{ id: "side", en: "Soil came to the side `right`.", nl: "Grond bereikte de rand `right`.", see: "docs" }] });
    expect(listWarnings(run)).toEqual(["Soil came to the side “right”."]);
    chooseLanguage("nl");
    expect(listWarnings(run)).toEqual(["Grond bereikte de rand “right”."]);
  });
});
