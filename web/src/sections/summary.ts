// What happened, in words and numbers. Words and numbers come from the C++ program; nothing is worked out here.

import type { Report } from "../data/report";
import type { Run } from "../data/run";
import type { Store } from "../logic/store";
import { runLabels, schemeLabel } from "../logic/labels";
import { slidesOf } from "../logic/slides";
import { withUnit } from "../logic/numbers";
import { runColour } from "../view/theme";
import { element } from "../shell/element";

interface Fact {
  label: string;
  help: string;
  value: (run: Run) => string;
  time?: (run: Run) => number | null | undefined; // a click goes there
}

const STOPS = "when a tenth of its largest kinetic energy (of the nodes) is left; " +
  "overtaken: the next slide begins before that; not yet: it moves at the end";

const VERDICTS = { stands: "stands", damaged: "damaged, holds", floods: "floods" };

const FACTS: Fact[] = [
  { label: "Does it flood?", help: "whether the ground holds the water; water that would flow over is not simulated",
    value: ({ meta: { events } }) => events?.flood ? VERDICTS[events.flood.verdict] : "–",
    time: ({ meta: { events } }) => events?.flood?.first_time_below ?? events?.flood?.first_time_damaged },
  { label: "Highest ground that remains", help: "between river and land, wherever it stands",
    value: (run) => metres(run.meta.events?.residual_height) },
  { label: "Over the water", help: "freeboard that remains; negative: the ground is lower",
    value: (run) => metres(run.meta.events?.flood?.freeboard) },
  { label: "Width at the water level", help: "of the ground that remains",
    value: (run) => metres(run.meta.events?.flood?.width_at_level) },
  { label: "Intact of that", help: "with a plastic strain below the limit of the case",
    value: (run) => metres(run.meta.events?.flood?.intact_width) },
  { label: "First slide begins", help: "when the first block of soil starts to move", ...slideTime(0, "begins") },
  { label: "First slide stops", help: STOPS, ...slideTime(0, "stops") },
  { label: "Second slide begins", help: "when a further block follows", ...slideTime(1, "begins") },
  { label: "Second slide stops", help: STOPS, ...slideTime(1, "stops") },
  { label: "Run-out", value: runOut,
    help: "how far the front came from where it stood; without a free toe, beyond the toe of the slope" },
  { label: "Front at the end, x", help: "outermost soil; without a free toe, outermost soil that moved",
    value: (run) => metres(run.meta.events?.front_x) },
  { label: "First surface stands to x", help: "edge of the ground whose surface has not left its first height",
    value: (run) => metres(run.meta.events?.remaining_crest?.x) },
  { label: "Volume that moved", help: "per metre of thickness",
    value: (run) => fixed(run.meta.events?.moved_volume, 2, "\u00a0m²") },
  { label: "Share that moved", help: "of the volume of all soil",
    value: (run) => percent(run.meta.events?.moved_fraction) },
  { label: "Intact share of that", help: "plastic strain below 0.01: blocks that slid in one piece",
    value: (run) => percent(run.meta.events?.intact_fraction) },
];

/** A slide that is not there has no times; one that is there may not stop. */
function slideTime(k: number, what: "begins" | "stops"): Pick<Fact, "value" | "time"> {
  const slide = (run: Run) => slidesOf(run.meta)[k];
  return {
    time: (run) => slide(run)?.[what],
    value: (run) => {
      if (!run.meta.events) return "–";
      const time = slide(run)?.[what];
      if (typeof time === "number") return fixed(time, 2, "\u00a0s");
      if (time !== null) return what === "begins" ? "none" : "–";
      const next = slidesOf(run.meta)[k + 1]?.begins;
      return typeof next === "number" ? "overtaken" : "not yet";
    },
  };
}

/** The decimals of the program's own sentences. */
function fixed(value: number | null | undefined, decimals: number, unit: string): string {
  return typeof value === "number" ? `${value.toFixed(decimals).replace("-", "−")}${unit}` : "–";
}

function metres(value: number | null | undefined): string {
  return fixed(value, 2, "\u00a0m");
}

function percent(part: number | null | undefined): string {
  return typeof part === "number" ? fixed(100 * part, 1, "\u202f%") : "–";
}

function runOut(run: Run): string {
  const { events } = run.meta;
  return events?.free_toe === false && events.front_x === null ? "none" : metres(events?.run_out);
}

export function summarySection(report: Report, store: Store): HTMLElement {
  const labels = runLabels(report.runs.map((run) => run.meta));
  const several = report.runs.length > 1;
  return element("aside", { class: "story", "aria-labelledby": "story-title" },
    element("h2", { id: "story-title" }, "What happened"),
    ...unfinished(report, labels),
    factTable(report, labels, store),
    report.runs.every((run) => !run.meta.events && run.meta.story.length === 0)
      ? element("p", { class: "muted" }, "This report was written without a search for events.") : null,
    several && report.comparison && report.comparison.text.length > 0 ? comparisonText(report) : null,
    ...(several ? [] : report.runs.map(storyOf)),
  );
}

function unfinished(report: Report, labels: string[]): HTMLElement[] {
  return report.runs.filter((run) => !run.meta.finished).map((run) => {
    const last = run.meta.times[run.meta.times.length - 1];
    return element("p", { class: "notice" },
      `${labels[run.index]} has not reached its end: this is what it had written up to ${withUnit(last, "s", 3)}.`);
  });
}

function factTable(report: Report, labels: string[], store: Store): HTMLElement | null {
  const facts = FACTS.filter((fact) => report.runs.some((run) => fact.value(run) !== "–"));
  if (facts.length === 0) return null;
  const several = report.runs.length > 1;
  // a long name may break there
  const head = element("tr", {}, element("td"),
    ...report.runs.map((run, k) =>
    coloured(element("th", { scope: "col" }, labels[k]!.replaceAll("_", "_\u200b")), run, store)));
  const rows = facts.map((fact) => element("tr", {},
    element("th", { scope: "row", title: fact.help }, fact.label),
    ...report.runs.map((run) => {
      const time = fact.time?.(run);
      const text = fact.value(run);
      if (typeof time !== "number") return element("td", {}, text);
      return element("td", {},
        element("button", { type: "button", class: "go", title: "Show this time",
        onclick: () => store.set({ time, playing: false }) }, text));
    })));
  const table = element("table", { class: report.runs.length > 2 ? "facts many" : "facts" },
    several ? element("thead", {}, head) : null, element("tbody", {}, ...rows));
  return element("div", { class: "scroll" }, table);
}

/** Marks an element with the colour of a run. */
export function coloured<T extends HTMLElement>(made: T, run: Run, store: Store): T {
  made.classList.add("of-run");
  store.watch(["dark"], ({ dark }) => made.style.setProperty("--run", runColour(run.index, dark)));
  return made;
}

function comparisonText(report: Report): HTMLElement {
  return element("div", { class: "difference" }, element("h3", {}, "The difference"),
    ...report.comparison!.text.map((text) => element("p", {}, text)));
}

function storyOf(run: Run): HTMLElement {
  return element("div", { class: "story-of" }, element("h3", {}, `In words (${schemeLabel(run.meta.scheme)})`),
    ...run.meta.story.map((text) => element("p", {}, text)), warnings(run));
}

/** The stories of several runs, side by side. */
export function storiesSection(report: Report, store: Store): HTMLElement | null {
  const told = report.runs.filter((run) => run.meta.story.length + run.meta.warnings.length > 0);
  if (report.runs.length < 2 || told.length === 0) return null;
  const labels = runLabels(report.runs.map((run) => run.meta));
  return element("section", { id: "stories", "aria-labelledby": "stories-title" },
    element("h2", { id: "stories-title" }, "Run by run"),
    element("div", { class: "cards" }, ...told.map((run) => element("article", { class: "card story-of" },
      coloured(element("h3", {}, labels[run.index]!), run, store),
        ...run.meta.story.map((text) => element("p", {}, text)), warnings(run)))));
}

/** Warnings of a run, and checks that it did not pass. */
function warnings(run: Run): HTMLElement | null {
  const texts = [...run.meta.warnings,
    ...run.meta.checks.filter((check) => !check.passed).map((check) =>
    `Check not passed: ${check.name}: ${check.value}.`)];
  if (texts.length === 0) return null;
  return element("div", { class: "notice" },
    element("h4", {}, texts.length === 1 ? "A warning" : `${texts.length} warnings`),
    element("ul", {}, ...texts.map((text) => element("li", {}, text))));
}
