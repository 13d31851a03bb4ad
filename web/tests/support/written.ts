// A page that the C++ program wrote, opened without a browser; and its history.csv, which says the same in other words.

import { Report } from "../../src/data/report";
import type { Run } from "../../src/data/run";
import type { ReportMeta } from "../../src/data/format";

export async function reportIn(html: string): Promise<Report> {
  const json = /<script id="terp-report" type="application\/json">([^]*?)<\/script>/.exec(html)![1]!;
  const chunks = new Map([...html.matchAll(/data-chunk="(\d+)">([^<]*)</g)].map((match) => [Number(match[1]), match[2]!]));
  const report = new Report(JSON.parse(json) as ReportMeta, (k) => chunks.get(k) ?? null);
  await report.open();
  return report;
}

export type Row = Record<string, number | string>;

export function csv(text: string): Row[] {
  const [head, ...lines] = text.trim().split("\n").map((line) => line.split(","));
  return lines.map((cells) => Object.fromEntries(head!.map((name, k) => [name, name === "point" ? cells[k]! : Number(cells[k])])));
}

export interface Misfit {
  compared: number;
  worst: Record<string, number>; // largest difference over the step of rounding, per quantity
}

/** Decoded values against the rows of history.csv at the times of frames. Pa in the table, kPa on the page. */
export async function misfit(run: Run, history: Row[]): Promise<Misfit> {
  const worst: Record<string, number> = {};
  let compared = 0;
  const note = (name: string, difference: number, step: number) => (worst[name] = Math.max(worst[name] ?? 0, Math.abs(difference) / step));
  for (const row of history) {
    const frame = run.meta.times.findIndex((t) => Math.abs(t - Number(row.time)) < 1e-9);
    if (frame < 0) continue;
    const point = run.pointOfId(Number(row.id));
    const [x, y] = run.place(frame, point);
    note("x", x - Number(row.x), run.meta.position_precision);
    note("y", y - Number(row.y), run.meta.position_precision);
    for (const [name, factor] of [["eps_eq_p", 1], ["eps_deviatoric", 1], ["su", 1e-3], ["pressure", 1e-3]] as const) {
      const meta = run.fieldMeta(name);
      if (!meta) continue;
      note(name, (await run.field(name))!.value(frame, point) - factor * Number(row[name]), meta.precision);
    }
    compared++;
  }
  return { compared, worst };
}
