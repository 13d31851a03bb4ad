// What was run, by which program, on which machine, and whether it may be trusted.

import type { Report } from "../data/report";
import type { Run } from "../data/run";
import { runLabels, schemeLabel, spoken } from "../logic/labels";
import { durationText, numberText, withUnit } from "../logic/numbers";
import type { Store } from "../logic/store";
import { element } from "../shell/element";
import { coloured } from "./summary";

export function aboutSection(report: Report, store: Store): HTMLElement {
  const labels = runLabels(report.runs.map((run) => run.meta));
  return element("section", { id: "about", "aria-labelledby": "about-title" },
    element("h2", { id: "about-title" }, "The runs"),
    element("div", { class: "cards" }, ...report.runs.map((run) => card(report, run, labels[run.index]!, store))));
}

function card(report: Report, run: Run, label: string, store: Store): HTMLElement {
  return element("article", { class: "card about-run" },
    coloured(element("h3", {}, label), run, store),
    element("p", { class: "muted" }, run.meta.title),
    facts(report, run),
    checks(run),
    audit(run),
    caseFile(run));
}

function facts(report: Report, run: Run): HTMLElement {
  const { meta } = run;
  const summary = (key: string) => meta.summary[key];
  const rows: [string, string][] = [
    ["Run", meta.name],
    ["Scheme", schemeLabel(meta.scheme)],
    ["Terp", typeof summary("terp_version") === "string" ? String(summary("terp_version")) : report.meta.terp],
    ["Machine", meta.machine],
    ["Threads", [numberText(meta.threads), summary("instructions")].filter(Boolean).join(", ")],
    ["Time to solve", durationText(meta.wall_seconds)],
    ["Material points", meta.n_shown === meta.n_points ? numberText(meta.n_points, 9)
      : `${numberText(meta.n_points, 9)}, of which ${numberText(meta.n_shown, 9)} are shown`],
    ["Cells", typeof summary("cells") === "number" ? numberText(summary("cells") as number, 9) : ""],
    ["Time steps", typeof summary("steps") === "number"
      ? `${numberText(summary("steps") as number, 9)} of ${withUnit(summary("dt") as number, "s", 3)}` : ""],
    ["Frames", meta.times.length === meta.n_frames_in_run ? numberText(meta.n_frames_in_run)
      : `${numberText(meta.n_frames_in_run)}, of which ${numberText(meta.times.length)} are shown`],
    ["Places rounded to", withUnit(meta.position_precision * 1000, "mm", 2)],
    ["Values rounded to",
      meta.fields.filter((field) => field.kind !== "category").map((field) =>
      `${field.label} ${withUnit(field.precision, field.unit, 1)}`).join(", ")],
  ];
  return element("dl", { class: "pairs" },
    ...rows.filter(([, value]) => value).flatMap(([name, value]) =>
    [element("dt", {}, name), element("dd", {}, value)]));
}

function checks(run: Run): HTMLElement | null {
  if (run.meta.checks.length === 0) return null;
  const rows = run.meta.checks.map(({ name, value, passed }) => element("tr", { class: passed ? "passed" : "failed" },
    element("td", { class: "sign", "aria-hidden": "true" }, passed ? "✓" : "✗"),
    element("th", { scope: "row" }, name),
    element("td", {}, value),
    element("td", { class: "verdict" }, passed ? "passed" : "not passed")));
  return element("div", {}, element("h4", {}, "Checks"),
    element("table", { class: "checks" }, element("tbody", {}, ...rows)));
}

/** What the program watched at every row of the ledger, in words. */
const AUDIT: Record<string, string> = {
  points: "Points watched",
  points_eps_eq_p_fell: "Whose plastic strain ever fell",
  points_su_rose: "Whose strength ever rose",
  energy_balance_error: "Energy not accounted for",
  clamped_points: "Put back at a wall",
  points_left: "Left through open sides",
};

function audit(run: Run): HTMLElement | null {
  const entries = Object.entries(run.meta.audit ?? {}).filter(([, value]) => typeof value !== "object");
  if (entries.length === 0) return null;
  const text = (name: string, value: unknown) =>
    (typeof value !== "number" ? String(value) : name.endsWith("_error") ? `${numberText(100 * value, 2)}\u202f%`
    : numberText(value, 9));
  const pairs = entries.flatMap(([name, value]) =>
    [element("dt", {}, AUDIT[name] ?? spoken(name)), element("dd", {}, text(name, value))]);
  return element("div", {}, element("h4", {}, "Audit of the history"), element("dl", { class: "pairs" }, ...pairs));
}

function caseFile(run: Run): HTMLElement {
  const text = run.meta.case_toml;
  const code = element("code");
  for (const part of text.split("\n")) code.append(tomlLine(part), "\n");
  const copy = element("button", { type: "button", class: "text-button", onclick: () => {
    void navigator.clipboard?.writeText(text).then(() => (copy.textContent = "Copied"),
      () => (copy.textContent = "Could not copy"));
  } }, "Copy");
  return element("details", { class: "case" }, element("summary", {}, "Case file"), copy,
    element("pre", { tabindex: 0 }, code));
}

/** Comments, tables and keys of TOML apart. */
function tomlLine(text: string): Node {
  if (/^\s*#/.test(text)) return element("span", { class: "comment" }, text);
  if (/^\s*\[/.test(text)) return element("span", { class: "table-name" }, text);
  const match = /^([^=#]*=)((?:[^"#]|"[^"]*")*)(#.*)?$/.exec(text);
  if (!match) return document.createTextNode(text);
  return element("span", {}, element("span", { class: "key" }, match[1]!), match[2]!,
    match[3] ? element("span", { class: "comment" }, match[3]) : null);
}
