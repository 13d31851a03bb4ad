// Made-up documents in the form in which the program writes them: a study, a sweep, a curve, a reach, meshes.

import type { ConvergenceMeta, DocumentMeta, ElementMeta, EventMeta, MeshQuantity, ReachMeta, ReachSection, StudyMeta } from "../../src/data/documents";
import type { Flood, TableMeta } from "../../src/data/format";
import { ChunkWriter } from "./encode";

export interface MadeDocument {
  document: DocumentMeta;
  chunks: string[];
}

type Columns = Record<string, ArrayLike<number>>;

function tableOf(writer: ChunkWriter, columns: Columns, units: Record<string, string> = {}): TableMeta {
  const names = Object.keys(columns);
  return { columns: names.map((name) => ({ name, label: name, unit: units[name] ?? "-" })), rows: columns[names[0]!]!.length,
    chunk: writer.floats(names.flatMap((name) => Array.from(columns[name]!))) };
}

const made = (kind: DocumentMeta["kind"], data: unknown, writer: ChunkWriter, language = "en"): MadeDocument =>
  ({ document: { format: 2, kind, terp: "0", written: "2026-01-02T03:04:05Z", language, data }, chunks: writer.texts });

export const event = (happened: number, solved: number, failed = 0): EventMeta =>
  ({ probability: happened / solved, low: 0.5 * happened / solved, high: Math.min(1, 1.5 * happened / solved + 0.01), happened, solved, failed, beta: 1 });

/** Every third slides, every sixth floods; of one nothing is known. */
export function exampleStudy(change: (data: StudyMeta, writer: ChunkWriter) => void = () => undefined, n = 60): MadeDocument {
  const writer = new ChunkWriter();
  const of = (f: (k: number) => number) => Array.from({ length: n }, (_, k) => (k === 1 ? NaN : f(k)));
  const data: StudyMeta = {
    title: "A <dike>", case: "dike.toml", event: { volume: 1, displacement: 0.5, of_flood: false }, estimator: "monte_carlo",
    realisations: n, solved: n - 1, slid_as_drawn: 0, failed: 1, confidence: 0.95,
    slide: event(20, n - 1, 1), flood: event(10, n - 1, 1), flood_after_slide: event(10, 20),
    growth: { slide: [[20, 0.3, 0.1, 0.5], [60, 0.34, 0.2, 0.45]], flood: [[20, 0.2, 0.1, 0.4], [60, 0.17, 0.1, 0.3]] },
    sweep: [], sensitivities: [{ with_slide: -0.82, with_height: 0.75 }, { with_slide: 0.1, with_height: null }],
    remarks: ["Failed realisations count in both bounds."],
    failure_path: [{ ...event(20, n - 1, 1), of: n - 1, unknown: 1, event: "first_slide", given: "", name: { en: "first slide", nl: "eerste afschuiving" },
      given_name: { en: "all realisations", nl: "alle realisaties" } }],
    inputs: tableOf(writer, { "material.clay.su_peak": Array.from({ length: n }, (_, k) => (k % 3 === 0 ? 4000 + k : 9000 + k)), "material.clay.eta": new Array(n).fill(5) }, { "material.clay.su_peak": "Pa" }),
    row_labels: [], words: Array.from({ length: n }, () => []), faults_of: { 1: "stopped itself: no number" },
    outcomes: tableOf(writer, {
      state: Array.from({ length: n }, (_, k) => (k === 1 ? 1 : 0)), slide: of((k) => (k % 3 === 0 ? 1 : 0)), flood: of((k) => (k % 6 === 0 ? 1 : 0)),
      level: new Array(n).fill(0), coarse: new Array(n).fill(0), slide_volume: of((k) => (k % 3 === 0 ? 10 + k : 0)),
      residual_height: of((k) => (k % 3 === 0 ? 3 : 5)), slides: of((k) => (k % 3 === 0 ? 1 + (k % 2) : 0)), first_slide_time: of((k) => k), flood_time: of(() => NaN),
    }, { slide_volume: "m^2", residual_height: "m" }),
  };
  change(data, writer);
  return made("study", data, writer);
}

export function exampleCurve(): MadeDocument {
  return exampleStudy((data, writer) => {
    const levels = [0.4, 0.8, 1.6];
    const slides = [0, 2, 8];
    Object.assign(data, {
      slide: null, flood: null, flood_after_slide: null, growth: undefined, judges_flood: true,
      levels: levels.map((level, k) => ({ level, slide: { ...event(slides[k]!, 20), beta: k === 0 ? null : 1.2 - k }, flood: event(k, 20), flood_after_slide: k === 0 ? { ...event(0, 1), probability: null, solved: 0 } : event(k, slides[k]!) })),
      of_load: { name: "water", unit: "m", levels, distribution: [[0, 0.1], [1, 0.6], [2, 0.95]], is_water_level: true },
      slide_over_levels: { probability: 0.12, straight: [0.1, 0.2], never_falling: [0.05, 0.4] }, flood_over_levels: { probability: 0.03, straight: [0.01, 0.08], never_falling: null },
      outcomes: tableOf(writer, { state: new Array(60).fill(0), slide: Array.from({ length: 60 }, (_, k) => (k % 3 === 2 ? 1 : 0)), flood: Array.from({ length: 60 }, (_, k) => (k % 6 === 2 ? 1 : 0)),
        level: Array.from({ length: 60 }, (_, k) => k % 3), coarse: new Array(60).fill(0), slide_volume: Array.from({ length: 60 }, (_, k) => k % 3), residual_height: Array.from({ length: 60 }, (_, k) => 5 - k % 3 - 0.01 * k),
        slides: new Array(60).fill(0), first_slide_time: new Array(60).fill(NaN), flood_time: new Array(60).fill(NaN) }),
    } satisfies Partial<StudyMeta>);
  });
}

/** Two schemes, eight values of one number and four strengths, given with units. */
export function exampleSweep(): MadeDocument {
  const rows = ["mpm_gp", "mpm_mixed"].flatMap((scheme, s) => ["6 kPa", "7 kPa", "13 kPa"].flatMap((su, k) => [5, 6, 7, 8].map((eta) => ({ s, k, eta, words: [scheme, su, String(eta)] }))));
  return exampleStudy((data, writer) => {
    const n = rows.length;
    Object.assign(data, {
      estimator: "sweep", realisations: n, slide: null, flood: null, flood_after_slide: null, growth: undefined, faults_of: {}, words: rows.map(({ words }) => words),
      sweep: [{ key: "scheme", unit: "-", of_numbers: false, numbers: null }, { key: "material.clay.su_peak", unit: "Pa", of_numbers: false, numbers: [6e3, 7e3, 13e3] },
        { key: "material.clay.eta", unit: "-", of_numbers: true, numbers: [5, 6, 7, 8] }],
      inputs: tableOf(writer, { scheme: rows.map(({ s }) => s), "material.clay.su_peak": rows.map(({ k }) => k), "material.clay.eta": rows.map(({ eta }) => eta) }),
      outcomes: tableOf(writer, { state: new Array(n).fill(0), slide: rows.map(({ k }) => (k === 0 ? 1 : 0)), flood: new Array(n).fill(NaN), level: new Array(n).fill(0), coarse: new Array(n).fill(0),
        slide_volume: rows.map(({ s, k, eta }) => 10 - 3 * k + s + 0.1 * eta), residual_height: new Array(n).fill(1), slides: new Array(n).fill(0), first_slide_time: new Array(n).fill(NaN), flood_time: new Array(n).fill(NaN) },
      { slide_volume: "m^2", residual_height: "m" }),
    } satisfies Partial<StudyMeta>);
  });
}

export function exampleSamples(): MadeDocument {
  return exampleStudy((data, writer) => Object.assign(data, { samples: 60, fields: [{ key: "material.clay.su_peak", across: 30, box: [[0, 0], [20, 5]],
    pictures: tableOf(writer, { 0: Array.from({ length: 360 }, (_, k) => 2 ** Math.sin(k / 7)), 1: Array.from({ length: 360 }, (_, k) => 2 ** Math.cos(k / 5)) }) }] } satisfies Partial<StudyMeta>));
}

export function sectionOf(name: string, verdict: NonNullable<Flood["verdict"]>, change: Partial<ReachSection> = {}): ReachSection {
  return {
    name, title: "High & low", state: "solved", fault: "", trigger: "", has_report: true, factor: 1.11, uncertainty: 0.01, stored_text: "Bishop 1.004", stored_text_nl: "Bishop 1,004",
    hints: [], hints_nl: [], moves: false, moved_before_trigger: false, residual_height: 3.5, seconds: 61.4,
    flood: { verdict, water_level: 4, residual_height: 3.5, freeboard: -0.5, width_at_level: 2, intact_width: 1, first_time_damaged: null, first_time_below: null },
    ground: [[0, 1, 1], [5, 5, 3.5], [10, 1, 2]], ...change,
  };
}

export function exampleReach(language = "en"): MadeDocument {
  const slid = sectionOf("b", "floods", { hints: ["in doubt since the import: the river"], hints_nl: ["twijfel bij het inlezen: de rivier"] });
  slid.flood!.trigger = { stage: "weaker_soil", at_strength: 1.12, river: 3.5, before: "stands" };
  const data: ReachMeta = { sections: [sectionOf("a dike", "stands"), slid, sectionOf("c", "stands", { moves: true, hints: ["not at rest at the end (0.021 m/s): the verdict may change"], hints_nl: ["aan het eind niet in rust (0,021 m/s): het oordeel kan veranderen"] }),
    sectionOf("d", "stands", { state: "refused", fault: "it is <no> zip file\nTry another.", flood: null, factor: null, stored_text: "", stored_text_nl: "", has_report: false, residual_height: null, ground: [] })] };
  return made("reach", data, new ChunkWriter(), language);
}

const quantity = (name: string, label: string, unit: string, values: (number | string | null)[], change: Partial<MeshQuantity> = {}): MeshQuantity =>
  ({ name, label, unit, digits: 2, values, answer: "same", sentence: `${label}: a sentence`, relative_change: 0, order: null, order_is_usable: false, limit: null, error: null, relative_error: null, ...change });

export function exampleConvergence(): MadeDocument {
  const writer = new ChunkWriter();
  const sequence = (name: string, shift: number): ConvergenceMeta["sequences"][number] => ({
    name, answer: "Tends to a limit: front at the end.", remarks: ["Cells of 0.05 m: no result: step 3"],
    runs: [0.4, 0.2, 0.1, 0.05].map((cell) => ({ cell, size: cell, folder: `cell_${cell}`, solved: cell > 0.05, fault: cell > 0.05 ? "" : "step 3", ...(cell > 0.05 ? { over_time: tableOf(writer, {
      time: [0, 0.5, 1], front_x: [8, 10, 12 - cell], kinetic: [0, 5e4, 1e3] }, { time: "s", front_x: "m", kinetic: "J/m" }) } : {}) })),
    quantities: [quantity("front_x", "front at the end", "m", [11 + shift, 11.5 + shift, 11.75 + shift, null], { answer: "tends", relative_change: 0.063, order: 1, order_is_usable: true, limit: 12 + shift, error: 0.31, relative_error: 0.078 }),
      quantity("facing", "side that slides", "-", ["right", "right", "right", null])],
  });
  const sequences = [sequence("as given", 0), sequence("mesh.turn=45", 0.4)];
  const data: ConvergenceMeta = { case_name: "column", title: "<column>", tolerance: 0.02, sequences, variants: { answer: "On cells of 0.1 m, as given and with 1 variant: the front differs.",
    quantities: [{ name: "front_x", label: "front at the end", unit: "m", digits: 2, values: [11.75, 12.15], range: 0.4, relative_range: 0.1, matters: true }] } };
  return made("convergence", data, writer);
}

/** Two soils, of which one stops; the pressure of both goes there and back. */
export function exampleElement(): MadeDocument {
  const writer = new ChunkWriter();
  const rows = (size: number) => {
    const steps = Array.from({ length: 11 }, (_, k) => k / 10);
    return tableOf(writer, { mean_pressure: steps.map((s) => 1e5 * (1 + size * s * (1 - s))), deviator: steps.map((s) => 5e4 * size * s),
      deviator_strain: steps, volume_strain: steps.map((s) => -0.01 * size * s), pore_pressure: steps.map(() => 0), strain_xy: steps.map(() => 0),
      stress_xy: steps.map(() => 0) }, { mean_pressure: "Pa", deviator: "Pa", pore_pressure: "Pa", stress_xy: "Pa" });
  };
  const data: ElementMeta = { title: "triaxial test, drained", elements: [{ material: "<sand>", law: "mohr_coulomb", fault: "", rows: rows(1) },
    { material: "clay", law: "modified_cam_clay", fault: "no strain leads there", rows: rows(0.5) }] };
  return made("element", data, writer);
}

export const EXAMPLES: Record<string, () => MadeDocument> = {
  study: exampleStudy, curve: exampleCurve, sweep: exampleSweep, samples: exampleSamples, reach: exampleReach, convergence: exampleConvergence,
  element: exampleElement,
};
