// The report of this page: its JSON, and its runs.

import type { Comparison, ReportMeta } from "./format";
import { Chunks, type ChunkText } from "./chunks";
import { Run } from "./run";

export const FORMAT = 2;

/** What a run may leave out. */
const ABSENT = { mesh: null, outline: null, surfaces: null, water: null, layers: [], loads: [], slip_planes: [],
  histories: [], series: null, passes: [], events: null, warnings: {}, summary: {}, case_path: "", case_digits: "" };

export class Report {
  readonly runs: Run[];
  readonly comparison: Comparison | null;

  constructor(
    readonly meta: ReportMeta,
    text: ChunkText,
  ) {
    if (meta.format !== FORMAT) {
      throw new Error(`This page reads reports of format ${FORMAT}, but the data in it has format ${meta.format}. ` +
        "Write the report anew with one version of Terp.");
    }
    const chunks = new Chunks(text);
    this.runs = meta.runs.map((run, index) => new Run({ ...ABSENT, ...run }, index, chunks));
    this.comparison = meta.comparison;
  }

  async open(): Promise<void> {
    for (const run of this.runs) await run.open();
  }

  /** Names of the fields that any run has, in the order of the first. */
  fieldNames(): string[] {
    return [...new Set(this.runs.flatMap((run) => run.meta.fields.map((field) => field.name)))];
  }
}
