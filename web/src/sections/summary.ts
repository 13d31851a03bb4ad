// What happened, in words and numbers. Words and numbers come from the C++ program; nothing is worked out here.

import type { Report } from "../data/report";
import type { Run } from "../data/run";
import type { Store } from "../logic/store";
import { runLabels, schemeLabel } from "../logic/labels";
import { withUnit } from "../logic/numbers";
import { runColour } from "../view/theme";
import { element } from "../shell/element";

interface Fact {
  label: string;
  help: string;
  value: (run: Run) => string;
  time?: (run: Run) => number | null | undefined; // a click goes there
}

const FACTS: Fact[] = [
  { label: "First slide begins", help: "when the first block of soil starts to move", value: (run) => seconds(run.meta.events?.first_slide?.begins), time: (run) => run.meta.events?.first_slide?.begins },
  { label: "First slide stops", help: "when it has come to rest", value: (run) => seconds(run.meta.events?.first_slide?.stops), time: (run) => run.meta.events?.first_slide?.stops },
  { label: "Second slide begins", help: "when a further block follows", value: (run) => seconds(run.meta.events?.second_slide?.begins, run.meta.events ? "none" : "–"), time: (run) => run.meta.events?.second_slide?.begins },
  { label: "Run-out", help: "how far the front came from where it stood", value: (run) => metres(run.meta.events?.run_out) },
  { label: "Front at the end", help: "largest x of the soil", value: (run) => metres(run.meta.events?.front_x, "x = ") },
  { label: "Crest that remains", help: "edge of the ground that still stands", value: (run) => metres(run.meta.events?.remaining_crest?.x, "x = ") },
  { label: "Volume that moved", help: "per metre of thickness, and its share of all soil", value: moved },
];

function seconds(value: number | null | undefined, otherwise = "–"): string {
  return typeof value === "number" ? withUnit(value, "s", 3) : otherwise;
}

function metres(value: number | null | undefined, before = ""): string {
  return typeof value === "number" ? `${before}${withUnit(Number(value.toFixed(2)), "m")}` : "–";
}

function moved(run: Run): string {
  const { moved_volume, moved_fraction } = run.meta.events ?? {};
  if (typeof moved_volume !== "number") return "–";
  const share = typeof moved_fraction === "number" ? ` (${Math.round(100 * moved_fraction)}\u202f%)` : "";
  return `${withUnit(moved_volume, "m²", 3)}${share}`;
}

export function summarySection(report: Report, store: Store): HTMLElement {
  const labels = runLabels(report.runs.map((run) => run.meta));
  const several = report.runs.length > 1;
  return element("aside", { class: "story", "aria-labelledby": "story-title" },
    element("h2", { id: "story-title" }, "What happened"),
    ...unfinished(report, labels),
    factTable(report, labels, store),
    report.runs.every((run) => !run.meta.events && run.meta.story.length === 0) ? element("p", { class: "muted" }, "This report was written without a search for events.") : null,
    several && report.comparison && report.comparison.text.length > 0 ? comparisonText(report) : null,
    ...report.runs.filter((run) => run.meta.story.length > 0).map((run) => storyOf(run, labels[run.index]!, several, store)),
    ...warnings(report, labels),
  );
}

function unfinished(report: Report, labels: string[]): HTMLElement[] {
  return report.runs.filter((run) => !run.meta.finished).map((run) => {
    const last = run.meta.times[run.meta.times.length - 1];
    return element("p", { class: "notice" }, `${labels[run.index]} has not reached its end: this is what it had written up to ${withUnit(last, "s", 3)}.`);
  });
}

function factTable(report: Report, labels: string[], store: Store): HTMLElement | null {
  const facts = FACTS.filter((fact) => report.runs.some((run) => fact.value(run) !== "–"));
  if (facts.length === 0) return null;
  const several = report.runs.length > 1;
  const head = element("tr", {}, element("td"), ...report.runs.map((run, k) => coloured(element("th", { scope: "col" }, labels[k]!), run, store)));
  const rows = facts.map((fact) => element("tr", {},
    element("th", { scope: "row", title: fact.help }, fact.label),
    ...report.runs.map((run) => {
      const time = fact.time?.(run);
      const text = fact.value(run);
      if (typeof time !== "number") return element("td", {}, text);
      return element("td", {}, element("button", { type: "button", class: "go", title: "Show this time", onclick: () => store.set({ time, playing: false }) }, text));
    })));
  return element("table", { class: "facts" }, several ? element("thead", {}, head) : null, element("tbody", {}, ...rows));
}

/** Marks an element with the colour of a run. */
export function coloured<T extends HTMLElement>(made: T, run: Run, store: Store): T {
  made.classList.add("of-run");
  store.watch(["dark"], ({ dark }) => made.style.setProperty("--run", runColour(run.index, dark)));
  return made;
}

function comparisonText(report: Report): HTMLElement {
  return element("div", { class: "difference" }, element("h3", {}, "The difference"), ...report.comparison!.text.map((text) => element("p", {}, text)));
}

function storyOf(run: Run, label: string, several: boolean, store: Store): HTMLElement {
  const title = several ? coloured(element("h3", {}, label), run, store) : element("h3", {}, `In words (${schemeLabel(run.meta.scheme)})`);
  return element("div", { class: "story-of" }, title, ...run.meta.story.map((text) => element("p", {}, text)));
}

function warnings(report: Report, labels: string[]): HTMLElement[] {
  const all = report.runs.flatMap((run) => [
    ...run.meta.warnings.map((text) => ({ run, text })),
    ...run.meta.checks.filter((check) => !check.passed).map((check) => ({ run, text: `Check not passed: ${check.name}, ${check.value}.` })),
  ]);
  if (all.length === 0) return [];
  const items = all.map(({ run, text }) => element("li", {}, report.runs.length > 1 ? element("b", {}, `${labels[run.index]}: `) : null, text));
  return [element("div", { class: "notice" }, element("h3", {}, all.length === 1 ? "A warning" : `${all.length} warnings`), element("ul", {}, ...items))];
}
