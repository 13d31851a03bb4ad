// What the chosen field, range and time mean for each run: the one place where views, colour bar and exports ask.

import type { Report } from "../data/report";
import type { Run } from "../data/run";
import type { FieldMeta } from "../data/format";
import type { Store, ViewState } from "../logic/store";
import { categoryTable, mapNamed, mapsFor, preferredMap, symmetric, table, validRange, type ColourMap,
  type Range } from "../logic/colour";
import { FULL, NONE, valueOf } from "../data/quantised";
import { frameAt } from "../logic/time";

export class Current {
  private readonly tables = new Map<string, Uint8Array>();

  constructor(
    readonly report: Report,
    readonly store: Store,
  ) {}

  get state(): ViewState {
    return this.store.state;
  }

  shownRuns(): Run[] {
    return this.report.runs.filter((_, k) => this.state.shown[k]);
  }

  frame(run: Run, time = this.state.time): number {
    return frameAt(run.meta.times, time);
  }

  /** Of the first run that has the field. */
  fieldMeta(name = this.state.field): FieldMeta | null {
    for (const run of this.report.runs) {
      const meta = run.fieldMeta(name);
      if (meta) return meta;
    }
    return null;
  }

  /** The chosen map, or the first that suits the field. */
  map(): ColourMap {
    const kind = this.fieldMeta()?.kind ?? "sequential";
    const chosen = mapNamed(this.state.map === "auto" ? preferredMap(this.state.field) : this.state.map);
    return chosen.kind === kind || kind === "category" ? chosen : mapsFor(kind)[0]!;
  }

  colours(run: Run): { table: Uint8Array; categories: number } {
    if (this.fieldMeta()?.kind === "category") return { table: this.soilColours(run), categories: 256 };
    const map = this.map();
    return { table: this.kept(map.name, () => table(map)), categories: 0 };
  }

  /** Of the materials of a run. */
  soilColours(run: Run): Uint8Array {
    return this.kept(`soils ${run.index}`, () => categoryTable(run.meta.materials.map(({ color }) => color)));
  }

  private kept(name: string, make: () => Uint8Array): Uint8Array {
    const made = this.tables.get(name) ?? make();
    this.tables.set(name, made);
    return made;
  }

  /** Range of the colour bar, the same for all runs. */
  range(time = this.state.time): Range {
    const { rangeMode, fixed, log } = this.state;
    let range: Range;
    if (rangeMode === "fixed") range = { lo: fixed[0], hi: fixed[1], log };
    else if (rangeMode === "frame") range = { ...this.rangeOfFrame(time), log };
    else range = { ...this.rangeOfRuns(), log };
    const diverging = this.fieldMeta()?.kind === "diverging" && rangeMode !== "fixed";
    return validRange(diverging ? symmetric(range) : range);
  }

  private rangeOfRuns(): { lo: number; hi: number } {
    const ranges = this.shownRuns().flatMap((run) => run.fieldMeta(this.state.field)?.range ?? []);
    return { lo: Math.min(...ranges), hi: Math.max(...ranges) };
  }

  private rangeOfFrame(time: number): { lo: number; hi: number } {
    let [lo, hi] = [Infinity, -Infinity];
    for (const run of this.shownRuns()) {
      const field = run.fields.get(this.state.field);
      if (!field) continue;
      const f = this.frame(run, time);
      const [q, qx, qy] = [field.frame(f), run.x.frame(f), run.y.frame(f)];
      let [least, most] = [FULL, 0];
      for (let p = 0; p < q.length; p++) {
        if (q[p] === NONE || (qx[p] === FULL && qy[p] === FULL)) continue;
        if (q[p]! < least) least = q[p]!;
        if (q[p]! > most) most = q[p]!;
      }
      if (least > most) continue;
      lo = Math.min(lo, valueOf(field.meta, least));
      hi = Math.max(hi, valueOf(field.meta, most));
    }
    return { lo, hi };
  }
}
