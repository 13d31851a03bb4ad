// What happened, in words and numbers. Words and numbers come from the C++ program; nothing is worked out here.

import type { Report } from "../data/report";
import type { Run } from "../data/run";
import type { Store } from "../logic/store";
import { runLabels, schemeLabel, withSoilName } from "../logic/labels";
import { slidesBySlope } from "../logic/slides";
import { columnPlace, fixed, metres, percent, withUnit } from "../logic/numbers";
import { listWarnings, tellStory, triggerWords } from "../logic/story";
import { hasWater, kindOf } from "../logic/verdict";
import { currentLanguage, say, type TextKey } from "../logic/texts";
import { runColour } from "../view/theme";
import { element } from "../shell/element";

interface Fact {
  name: string; // its texts are fact_NAME and fact_NAME_help
  help?: TextKey;
  value: (run: Run) => string;
  time?: (run: Run) => number | null | undefined; // a click goes there
}

const FACTS: Fact[] = [
  { name: "flood", value: (run) => {
    const kind = kindOf(run);
    return run.meta.events?.flood && kind !== "none" ? say(`fact_flood_${kind}`) +
      triggerWords(run.meta.events.flood.trigger) : "–";
  },
    time: ({ meta: { events } }) => events?.flood?.first_time_below ?? events?.flood?.first_time_damaged },
  { name: "height", value: (run) => metres(run.meta.events?.residual_height) },
  { name: "freeboard", value: (run) => metres(run.meta.events?.flood?.freeboard) },
  { name: "width", value: (run) => metres(run.meta.events?.flood?.width_at_level) },
  { name: "intact", value: (run) => metres(run.meta.events?.flood?.intact_width) },
  { name: "begins_1", ...slideTime(0, "begins") },
  { name: "stops_1", help: "fact_stops_help", ...slideTime(0, "stops") },
  { name: "begins_2", ...slideTime(1, "begins") },
  { name: "stops_2", help: "fact_stops_help", ...slideTime(1, "stops") },
  { name: "other", value: (run) => {
    const [other] = slidesBySlope(run.meta).other;
    return other ? fixed(other.begins, 2, "\u00a0s") : "–";
  }, time: (run) => slidesBySlope(run.meta).other[0]?.begins },
  { name: "run_out", value: runOut },
  { name: "front", value: (run) => metres(run.meta.events?.front_x) },
  { name: "crest", value: ({ meta }) => columnPlace(meta.events?.remaining_crest?.x, meta.cell) },
  { name: "moved", value: (run) => fixed(run.meta.events?.moved_volume, 2, "\u00a0m²") },
  { name: "share", value: (run) => percent(run.meta.events?.moved_fraction) },
  { name: "moved_intact", value: (run) => percent(run.meta.events?.intact_fraction) },
];

/** Of a dike they stand above as well: on paper once is enough. */
const ON_TILES = new Set(["flood", "height", "freeboard", "width", "intact", "begins_1"]);

/** A slide that is not there has no times; one that is there may not stop. */
function slideTime(k: number, what: "begins" | "stops"): Pick<Fact, "value" | "time"> {
  const slide = (run: Run) => slidesBySlope(run.meta).own[k];
  return {
    time: (run) => slide(run)?.[what],
    value: (run) => {
      if (!run.meta.events) return "–";
      const time = slide(run)?.[what];
      if (typeof time === "number") return fixed(time, 2, "\u00a0s");
      if (time !== null) return what === "begins" ? say("none") : "–";
      const next = slidesBySlope(run.meta).own[k + 1]?.begins;
      return typeof next === "number" ? say("overtaken") : say("not_yet");
    },
  };
}

function runOut(run: Run): string {
  const { events } = run.meta;
  return events?.free_toe === false && events.front_x === null ? say("none") : metres(events?.run_out);
}

/** The numbers and, of a single run, the words: two parts, so that a wide page has them side by side. */
export function summarySection(report: Report, store: Store): HTMLElement[] {
  const labels = runLabels(report.runs.map((run) => run.meta));
  const several = report.runs.length > 1;
  const numbers = element("aside", { class: "story numbers-part", "aria-labelledby": "story-title" },
    element("h2", { id: "story-title" }, say("what_happened")),
    ...unfinished(report, labels),
    factTable(report, labels, store),
    report.runs.every((run) => !run.meta.events && !run.meta.summary.format)
      ? element("p", { class: "muted" }, say("no_events")) : null,
    several && report.comparison && report.comparison.text.length > 0 ? comparisonText(report) : null);
  return several ? [numbers] : [numbers, ...report.runs.map(storyOf)];
}

function unfinished(report: Report, labels: string[]): HTMLElement[] {
  return report.runs.filter((run) => !run.meta.finished).map((run) => {
    const last = run.meta.times[run.meta.times.length - 1];
    return element("p", { class: "notice" },
      say("unfinished", { run: labels[run.index]!, time: withUnit(last, "s", 3) }));
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
  const rows = facts.map((fact) => element("tr", { class: ON_TILES.has(fact.name) ? "on-tiles" : "" },
    element("th", { scope: "row", title: say(fact.help ?? `fact_${fact.name}_help` as TextKey) },
      say(`fact_${fact.name}` as TextKey)),
    ...report.runs.map((run) => {
      const time = fact.time?.(run);
      const text = fact.value(run);
      if (typeof time !== "number") return element("td", {}, text);
      return element("td", {},
        element("button", { type: "button", class: "go", title: say("show_this_time"),
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
  return element("div", { class: "difference" }, element("h3", {}, say("difference")),
    ...report.comparison!.text.map((text) => element("p", {}, text)));
}

function storyOf(run: Run): HTMLElement {
  return element("section", { class: "story story-of" },
    element("h3", {}, say("in_words_of", { scheme: schemeLabel(run.meta.scheme) })),
    ...tellStory(run).map((text) => element("p", {}, text)), warnings(run), changed(run), assumed(run));
}

/** The stories of several runs, side by side. */
export function storiesSection(report: Report, store: Store): HTMLElement | null {
  if (report.runs.length < 2) return null;
  const labels = runLabels(report.runs.map((run) => run.meta));
  return element("section", { id: "stories", "aria-labelledby": "stories-title" },
    element("h2", { id: "stories-title" }, say("run_by_run")),
    element("div", { class: "cards" }, ...report.runs.map((run) => element("article", { class: "card story-of" },
      coloured(element("h3", {}, labels[run.index]!), run, store),
        ...tellStory(run).map((text) => element("p", {}, text)), warnings(run), changed(run), assumed(run)))));
}

/** Warnings of a run, and checks that it did not pass. */
function warnings(run: Run): HTMLElement | null {
  const texts = listWarnings(run);
  if (texts.length === 0) return null;
  return element("div", { class: "notice" },
    element("h4", {}, texts.length === 1 ? say("a_warning") : say("warnings", { n: texts.length })),
    element("ul", {}, ...texts.map((text) => element("li", {}, text))));
}

/** In what an imported section is not that of its file any more. */
function changed(run: Run): HTMLElement | null {
  const texts = run.meta.changed?.[currentLanguage()] ?? [];
  if (texts.length === 0) return null;
  return element("div", { class: "notice changed" },
    element("h4", {}, say("changed", { n: texts.length })),
    element("ul", {}, ...texts.map((text) => element("li", {}, withSoilName(text, run.meta.materials)))));
}

/** What is not in the file of an imported section: folded, as it is long. With water it stands under how sure. */
function assumed(run: Run): HTMLElement | null {
  if (hasWater(run)) return null;
  const texts = run.meta.assumed?.[currentLanguage()] ?? [];
  if (texts.length === 0) return null;
  return element("details", { class: "assumed" },
    element("summary", {}, say("assumed", { n: texts.length })),
    element("ul", {}, ...texts.map((text) => element("li", {}, withSoilName(text, run.meta.materials)))));
}
