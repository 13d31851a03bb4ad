// The JSON of pages that show no single run, as the C++ program writes it: docs/report_format.md and docs/formats.md.

import type { Flood, TableMeta } from "./format";
import type { Chunks } from "./chunks";
import { Table } from "./table";

/** What a page holds: of runs it is a ReportMeta, of the others `data`. */
export interface DocumentMeta {
  format: number;
  kind?: "run" | "study" | "reach" | "convergence" | "element";
  terp: string;
  written: string;
  language?: string;
  data: unknown;
}

/** Sentences of the program are in English. */
export interface QuantityMeta {
  name: string;
  label: string;
  unit: string;
  digits: number;
  values: (number | string | null)[]; // of each run, or of each sequence
}

export interface MeshQuantity extends QuantityMeta {
  answer: "none" | "same" | "settled" | "unresolved" | "tends" | "depends" | "some_sizes";
  sentence: string;
  relative_change: number | null;
  order: number | null;
  order_is_usable: boolean;
  limit: number | null;
  error: number | null;
  relative_error: number | null;
}

export interface MeshSequence {
  name: string;
  answer: string;
  remarks: string[];
  runs: { cell: number; size: number; folder: string; solved: boolean; fault: string; over_time?: TableMeta }[];
  quantities: MeshQuantity[];
}

export interface ConvergenceMeta {
  case_name: string;
  title: string;
  tolerance: number;
  sequences: MeshSequence[];
  variants: {
    answer: string;
    quantities: (QuantityMeta & { range: number | null; relative_range: number | null; matters: boolean })[];
  } | null;
}

export interface ElementMeta {
  title: string;
  elements: { material: string; law: string; fault: string; rows: TableMeta }[];
}

export interface ReachSection {
  name: string; // of its folder
  title: string;
  state: "solved" | "refused" | "failed" | "not finished";
  fault: string;
  trigger: string; // why there is none, if one was asked for
  has_report: boolean;
  factor: number | null;
  uncertainty: number | null;
  stored_text: string;
  stored_text_nl: string;
  hints: string[];
  hints_nl: string[];
  moves: boolean; // at the end, so that the verdict may change
  moved_before_trigger: boolean;
  flood: Flood | null;
  residual_height: number | null;
  seconds: number;
  ground: [number, number | null, number | null][]; // x, at the start, at the end [m]
}

export interface ReachMeta {
  sections: ReachSection[];
}

/** How often an event happened. */
export interface EventMeta {
  probability: number | null;
  low: number | null;
  high: number | null;
  happened: number;
  solved: number;
  failed: number; // of which it is not known
  beta?: number | null; // null: infinite
}

export interface Integral {
  probability: number;
  straight: [number, number];
  never_falling: [number, number] | null;
}

export interface Method {
  probability: number | null;
  at_most: number | null;
  beta: number | null;
  cov: number | null;
  design_values: { key: string; value: number; unit: string }[];
  influence: number[];
}

/** An event of the failure path, given the one before it. */
export interface PathEvent extends Omit<EventMeta, "solved" | "failed"> {
  of: number;
  unknown: number;
  event: string;
  given: string; // empty: of all realisations
  name: Record<"en" | "nl", string>;
  given_name: Record<"en" | "nl", string>;
}

export type Place = [n: number, p: number | null, low: number | null, high: number | null];

export interface StudyMeta {
  title: string;
  case: string;
  samples?: number; // of a page of what would be drawn; only `inputs` and `fields` are there then
  fields?: { key: string; across: number; box: [[number, number], [number, number]]; pictures: TableMeta }[];
  event: { volume: number; displacement: number; of_flood: boolean };
  estimator: string;
  realisations: number;
  solved: number;
  slid_as_drawn: number;
  failed: number;
  confidence: number;
  slide: EventMeta | null;
  flood: EventMeta | null;
  flood_after_slide: EventMeta | null;
  method?: Method | null;
  judges_flood?: boolean; // of a load
  levels?: { level: number; slide: EventMeta; flood: EventMeta; flood_after_slide: EventMeta;
    failure_path?: PathEvent[] }[];
  failure_path?: PathEvent[]; // empty: realisations do not count alike, or each level has its own
  slide_over_levels?: Integral | null;
  flood_over_levels?: Integral | null;
  of_load?: { name: string; unit: string; levels: number[]; distribution: [number, number][]; is_water_level: boolean };
  flood_after_slide_over_level?: Place[]; // by the ground that slides leave: level [m], P, bounds
  growth?: { slide: Place[]; flood: Place[] };
  sweep: { key: string; unit: string; of_numbers: boolean; numbers: number[] | null }[];
  sensitivities: { with_slide: number | null; with_height: number | null }[];
  remarks: string[];
  inputs: TableMeta; // of the realisations whose rows are shown; a column `field` is the mean of one over its trend
  row_labels: string[];
  words: string[][]; // of the same rows: what `row_labels` names, then the values of a sweep
  faults_of: Record<string, string>;
  outcomes: TableMeta; // of all realisations
}

/** Tables of a document, decoded. */
export type Tables = Map<TableMeta, Table>;

/** Decodes all tables that stand in the data. */
export async function readTables(data: unknown, chunks: Chunks, tables: Tables = new Map()): Promise<Tables> {
  if (data === null || typeof data !== "object") return tables;
  const meta = data as TableMeta;
  if (Array.isArray(meta.columns) && typeof meta.chunk === "number")
    return tables.set(meta, Table.of(meta, await chunks.floats(meta.chunk)));
  for (const value of Object.values(data)) await readTables(value, chunks, tables);
  return tables;
}
