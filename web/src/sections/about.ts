// What was run, by which program, on which machine, and whether it may be trusted.

import type { Report } from "../data/report";
import type { Run } from "../data/run";
import { runLabels, schemeLabel } from "../logic/labels";
import { quantityLabel } from "../logic/quantities";
import { listChecks } from "../logic/story";
import { say } from "../logic/texts";
import { durationText, numberText, withUnit } from "../logic/numbers";
import type { Store } from "../logic/store";
import { element } from "../shell/element";
import { coloured } from "./summary";

export function aboutSection(report: Report, store: Store): HTMLElement {
  const labels = runLabels(report.runs.map((run) => run.meta));
  return element("section", { id: "about", "aria-labelledby": "about-title" },
    element("h2", { id: "about-title" }, say("the_runs")),
    element("div", { class: "cards" }, ...report.runs.map((run) => card(report, run, labels[run.index]!, store))));
}

function card(report: Report, run: Run, label: string, store: Store): HTMLElement {
  return element("article", { class: "card about-run" },
    coloured(element("h3", {}, label), run, store),
    element("p", { class: "muted" }, run.meta.title),
    facts(report, run),
    checks(run),
    caseFile(run));
}

const LONG = 200; // letters; such a fact is left out on the paper of a dike

function facts(report: Report, run: Run): HTMLElement {
  const { meta } = run;
  const summary = (key: string) => meta.summary[key];
  const rows: [string, string][] = [
    [say("about_run"), meta.name],
    [say("about_scheme"), schemeLabel(meta.scheme)],
    ["Terp", typeof summary("terp_version") === "string" ? String(summary("terp_version")) : report.meta.terp],
    [say("about_machine"), meta.machine],
    [say("about_threads"), [numberText(meta.threads), summary("instructions")].filter(Boolean).join(", ")],
    [say("about_solve"), durationText(meta.wall_seconds)],
    [say("about_points"), meta.n_shown === meta.n_points ? numberText(meta.n_points, 9)
      : say("of_which", { all: numberText(meta.n_points, 9), shown: numberText(meta.n_shown, 9) })],
    [say("about_cells"), typeof summary("cells") === "number" ? numberText(summary("cells") as number, 9) : ""],
    [say("about_steps"), typeof summary("steps") === "number"
      ? say("steps_of",
        { n: numberText(summary("steps") as number, 9), dt: withUnit(summary("dt") as number, "s", 3) }) : ""],
    [say("about_frames"), meta.times.length === meta.n_frames_in_run ? numberText(meta.n_frames_in_run)
      : say("of_which",
        { all: numberText(meta.n_frames_in_run), shown: numberText(meta.times.length) })],
    [say("about_places"), withUnit(meta.position_precision * 1000, "mm", 2)],
    [say("about_values"),
      meta.fields.filter((field) => field.kind !== "category").map((field) =>
      `${quantityLabel(field.name, field.label)} ${withUnit(field.precision, field.unit, 1)}`).join(", ")],
    [say("about_case"), meta.case_path && say("case_digits", { path: meta.case_path, digits: meta.case_digits })],
    [say("audit_left"), summary("points_left") ? String(summary("points_left")) : ""],
  ];
  return element("dl", { class: "pairs" },
    ...rows.filter(([, value]) => value).map(([name, value]) =>
      element("div", { class: value.length > LONG ? "long" : "" }, element("dt", {}, name), element("dd", {}, value))));
}

function checks(run: Run): HTMLElement {
  const rows = listChecks(run).map(({ name, value, passed }) => element("tr", { class: passed ? "passed" : "failed" },
    element("td", { class: "sign", "aria-hidden": "true" }, passed ? "✓" : "✗"),
    element("th", { scope: "row" }, name),
    element("td", {}, value),
    element("td", { class: "verdict" }, say(passed ? "passed" : "not_passed"))));
  return element("div", {}, element("h4", {}, say("checks")),
    element("table", { class: "checks" }, element("tbody", {}, ...rows)));
}

function caseFile(run: Run): HTMLElement {
  const text = run.meta.case_toml;
  const code = element("code");
  for (const part of text.split("\n")) code.append(tomlLine(part), "\n");
  const copy = element("button", { type: "button", class: "text-button", onclick: () => {
    void navigator.clipboard?.writeText(text).then(() => (copy.textContent = say("copied")),
      () => (copy.textContent = say("not_copied")));
  } }, say("copy"));
  return element("details", { class: "case" }, element("summary", {}, say("about_case")), copy,
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
