// The verdict on the water, in the words and numbers of a dike engineer: what happened first, where, what remains.

import type { Report } from "../data/report";
import type { Run } from "../data/run";
import { runLabels } from "../logic/labels";
import { fixed, metres } from "../logic/numbers";
import { slidesOf } from "../logic/slides";
import { lastTime, seconds, sideOf, zoneText } from "../logic/story";
import type { Store } from "../logic/store";
import { say, type TextKey } from "../logic/texts";
import { element } from "../shell/element";
import { coloured } from "./summary";

/** A run that water is asked of: with a verdict, or with a phreatic line. */
export function hasWater(run: Run): boolean {
  return run.meta.water !== null || Boolean(run.meta.events?.flood);
}

export function verdictSection(report: Report, store: Store): HTMLElement | null {
  const runs = report.runs.filter(hasWater);
  if (runs.length === 0) return null;
  const labels = runLabels(report.runs.map((run) => run.meta));
  const kind = runs.length > 1 ? "verdicts many" : "verdicts";
  return element("section", { id: "verdict", class: kind, "aria-label": say("verdict") },
    ...runs.map((run) => {
      const name = report.runs.length > 1
        ? coloured(element("p", { class: "verdict-run" }, labels[run.index]!), run, store) : null;
      return verdictOf(run, name, store);
    }));
}

function verdictOf(run: Run, name: HTMLElement | null, store: Store): HTMLElement {
  const { events } = run.meta;
  const flood = events?.flood;
  const kind = !events ? "running" : (flood?.verdict ?? "none");
  return element("article", { class: `card verdict ${kind}` },
    element("div", { class: "verdict-head" }, name,
      element("p", { class: "verdict-word" }, say(`verdict_${kind}`)),
      element("p", {}, sentence(run), flood ? ` ${say("not_simulated")}` : "")),
    events ? element("dl", { class: "tiles" }, ...tilesOf(run).map((tile) => tileElement(tile, store))) : null);
}

function sentence(run: Run): string {
  const { events } = run.meta;
  if (!events) return say("running_text", { time: seconds(lastTime(run)) });
  const { flood } = events;
  if (!flood) return say("no_verdict_text");
  const values = { height: metres(flood.residual_height), freeboard: metres(flood.freeboard),
    level: metres(flood.water_level) };
  if (flood.verdict === "stands") return say("stands_text", values);
  if (flood.verdict === "damaged")
    return say("damaged_text", { ...values, time: seconds(flood.first_time_damaged) });
  const below = flood.freeboard ?? 0;
  return say(below < 0 ? "floods_below_text" : "floods_text",
    { ...values, below: metres(-below), time: seconds(flood.first_time_below) });
}

interface Tile {
  label: TextKey;
  value: string;
  notes: string[];
  time?: number | null; // a click goes there
}

function tilesOf(run: Run): Tile[] {
  const { meta } = run;
  const events = meta.events!;
  const slides = slidesOf(meta);
  const [first] = slides;
  const until = say("until_end", { time: seconds(lastTime(run)) });
  const slideTiles: Tile[] = first ? [
    { label: "tile_slide", value: seconds(first.begins), notes: [sideOf(meta, first), stageAt(run, first.begins)],
      time: first.begins },
    { label: "tile_entry", value: first.entry ? `x = ${metres(first.entry.x)}` : say("unknown"),
      notes: [first.entry ? zoneText(meta, first) : say("no_slip")], time: first.slip_surface?.time },
    { label: "tile_retrogression",
      value: slides.length > 1 ? say("further_slides", { n: slides.length - 1 }) : say("no_further"),
      notes: [say("crest_back", { from: metres(first.crest_from), to: metres(slides[slides.length - 1]!.crest_to) }),
        slides.length > 1 ? "" : until], time: slides[1]?.begins },
  ] : [{ label: "tile_slide", value: say("none"), notes: [until] }];
  const { flood } = events;
  const before = run.series?.column("residual_height")?.[0] ?? NaN;
  const remains: Tile[] = typeof events.residual_height !== "number" ? [] : [
    { label: "tile_crest", value: metres(events.residual_height),
      notes: [Number.isFinite(before) ? say("crest_was", { height: metres(before) }) : ""] },
  ];
  if (flood) remains.push(
    { label: "tile_freeboard", value: metres(flood.freeboard),
      notes: [say("water_at", { level: metres(flood.water_level) })], time: flood.first_time_below },
    { label: "tile_width", value: metres(flood.width_at_level),
      notes: [say("intact_of", { width: fixed(flood.intact_width, 2, "\u00a0m") })] });
  return [...slideTiles, ...remains];
}

/** How long after the stage began in which it falls; empty without stages. */
function stageAt(run: Run, time: number | null): string {
  const stages = (run.meta.events?.stages ?? []).filter(({ name }) => name !== "");
  const stage = [...stages].reverse().find(({ start }) => time !== null && start <= time);
  return stage ? say("in_stage", { time: seconds(time! - stage.start), stage: stage.name }) : "";
}

function tileElement({ label, value, notes, time }: Tile, store: Store): HTMLElement {
  const shown = typeof time === "number"
    ? element("button", { type: "button", class: "go", title: say("show_this_time"),
      onclick: () => store.set({ time, playing: false }) }, value) : value;
  return element("div", { class: "tile" }, element("dt", {}, say(label)),
    element("dd", {}, element("b", {}, shown), ...notes.filter(Boolean).map((note) => element("span", {}, note))));
}
