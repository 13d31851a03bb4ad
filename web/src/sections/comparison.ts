// The table that `terp compare` prints, and nothing that it does not.

import type { Report } from "../data/report";
import { runLabels } from "../logic/labels";
import { symbolic, unitText } from "../logic/symbols";
import { numberText } from "../logic/numbers";
import type { Store } from "../logic/store";
import { say } from "../logic/texts";
import { element } from "../shell/element";
import { coloured } from "./summary";

export function comparisonSection(report: Report, store: Store): HTMLElement | null {
  const { comparison } = report;
  if (!comparison || comparison.rows.length === 0) return null;
  const labels = runLabels(report.runs.map((run) => run.meta));
  const heads = () => comparison.columns.map((name, k) => {
    const run = report.runs.find((r) => r.meta.name === name) ?? report.runs[k];
    const head = element("th", { scope: "col" }, run ? labels[run.index]! : name);
    return run ? coloured(head, run, store) : head;
  });
  const rows = comparison.rows.map(({ label, unit, digits, values }) => element("tr", {},
    element("th", { scope: "row" },
      ...symbolic(label).flatMap(({ text, index }) => [text, index ? element("sub", {}, index) : null])),
    ...values.map((value) => element("td", {}, typeof value === "string" ? value : fixedText(value, digits))),
    element("td", { class: "unit" }, unitText(unit))));
  const half = rows.length > 12 ? Math.ceil(rows.length / 2) : rows.length;
  const table = (part: HTMLElement[]) => element("div", { class: "scroll" }, element("table", { class: "numbers" },
    element("thead", {}, element("tr", {}, element("td"), ...heads(), element("td", { class: "unit" }, say("unit")))),
    element("tbody", {}, ...part)));
  return element("section", { id: "comparison", "aria-labelledby": "comparison-title" },
    element("h2", { id: "comparison-title" }, say("comparison")),
    element("div", { class: "halves" }, table(rows.slice(0, half)),
      half < rows.length ? table(rows.slice(half)) : null));
}

function fixedText(value: number | null, digits: number | undefined): string {
  if (value === null || digits === undefined || !Number.isFinite(value)) return numberText(value, 4);
  return Number.isInteger(value) && digits === 0 ? numberText(value, 12) : value.toFixed(digits).replace("-", "−");
}
