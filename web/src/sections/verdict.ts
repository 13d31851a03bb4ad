// The verdict on the water, in the words and numbers of a dike engineer: what happened first, where, what remains.

import type { Report } from "../data/report";
import type { RunMeta, Slide, Trigger } from "../data/format";
import type { Run } from "../data/run";
import { runLabels } from "../logic/labels";
import { columnPlace, elevation, fixed, metres, withUnit } from "../logic/numbers";
import { slidesBySlope } from "../logic/slides";
import { byColumns, crestFrom, exitOf, lastTime, movedBefore, seconds, sideOf, triggerWords,
  zoneText } from "../logic/story";
import type { Store } from "../logic/store";
import { doubts, hasWater, kindOf, stageWords, type Kind } from "../logic/verdict";
import { say, type TextKey } from "../logic/texts";
import { element } from "../shell/element";
import { coloured } from "./summary";

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
  const kind = kindOf(run);
  const trigger = events?.flood?.trigger;
  const notes = [events?.flood ? say("not_simulated") : "", ...doubts(run)].filter(Boolean);
  return element("article", { class: `card verdict ${kind}` },
    element("div", { class: "verdict-head" }, name,
      element("h2", { class: "verdict-word" }, say(`verdict_${kind}`), triggerWords(trigger)),
      element("p", {}, beforeTrigger(trigger), sentence(run, kind), stageWords(events?.flood)),
      ...notes.map((note) => element("p", { class: "verdict-note" }, note))),
    events ? element("dl", { class: "tiles" }, ...tilesOf(run).map((tile) => tileElement(tile, store))) : null);
}

function beforeTrigger(trigger: Trigger | null | undefined): string {
  return trigger?.before ? `${say(`before_trigger_${trigger.before}`)} ` : "";
}

function sentence(run: Run, kind: Kind): string {
  const { events } = run.meta;
  const time = seconds(lastTime(run));
  if (!events) return say("running_text", { time });
  const { flood } = events;
  const values = { height: elevation(run.meta, flood?.residual_height), freeboard: metres(flood?.freeboard),
    level: elevation(run.meta, flood?.water_level) };
  if (kind === "running") {
    if (!flood) return say("so_far_none_text", { time });
    const from = flood.first_time_damaged;
    return from === null ? say("so_far_text", { time })
      : say("so_far_damaged_text", { ...values, time, from: seconds(from) });
  }
  if (!flood) return say("no_verdict_text");
  if (kind === "stands") return say("stands_text", values);
  if (kind === "damaged") return say("damaged_text", { ...values, time: seconds(flood.first_time_damaged) });
  if (kind === "still_moving")
    return say(movedBefore(flood) ? "moved_before_text" : "still_moving_text", { ...values,
      stage: flood.stage_moving ?? "", soil: flood.fastest_soil ?? "", x: metres(flood.fastest_x),
      y: metres(flood.fastest_y), speed: withUnit(flood.fastest_node ?? NaN, "m/s", 2) });
  if (kind === "near")
    return say("near_text", { ...values, time: seconds(flood.first_time_below), by: metres(flood.below_by),
      lasting: seconds(flood.below_for ?? null) });
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
  const { own, other } = slidesBySlope(meta);
  const [first] = own;
  const until = say(meta.finished ? "until_end" : "until_now", { time: seconds(lastTime(run)) });
  const exit = first ? exitOf(first) : null;
  const slideTiles: Tile[] = first ? [
    { label: "tile_slide", value: seconds(first.begins), notes: [sideOf(meta, first), stageAt(run, first.begins)],
      time: first.begins },
    { label: "tile_entry", value: first.entry ? `x = ${metres(first.entry.x)}` : say("unknown"),
      notes: [first.entry ? zoneText(meta, first) : first.slip_surface?.points.length ? "" : say("no_slip")],
      time: first.begins },
    ...(exit ? [{ label: "tile_exit" as const, value: `x = ${metres(exit.x)}`,
      notes: [say("exit_depth", { low: metres(exit.low) })], time: first.begins }] : []),
    { label: "tile_retrogression",
      value: own.length > 1 ? say("further_slides", { n: own.length - 1 }) : say("no_further"),
      notes: [crestBack(meta, own), own.length > 1 ? "" : until,
        other.length > 0 ? say("other_slope_slides", { n: other.length }) : ""], time: own[1]?.begins },
  ] : [{ label: "tile_slide", value: say("none"), notes: [until] }];
  const { flood } = events;
  const before = run.series?.column("residual_height")?.[0] ?? NaN;
  const remains: Tile[] = typeof events.residual_height !== "number" ? [] : [
    { label: "tile_crest", value: elevation(meta, events.residual_height),
      notes: [Number.isFinite(before) ? say("crest_was", { height: elevation(meta, before) }) : ""] },
  ];
  if (flood) remains.push(
    { label: "tile_freeboard", value: metres(flood.freeboard),
      notes: [say("water_at", { level: elevation(meta, flood.water_level) })], time: flood.first_time_below },
    { label: "tile_width", value: metres(flood.width_at_level),
      notes: [say("intact_of", { width: fixed(flood.intact_width, 2, "\u00a0m") })] });
  const profile = flood?.profile;
  if (profile) remains.push({ label: "tile_profile", value: say(profile.x === null ? "fits_not" : "fits"),
    notes: [say("profile_of", { width: fixed(profile.width, 1, "\u00a0m"), slope: fixed(profile.slope, 1, "") }),
      profile.x === null ? "" : `x = ${metres(profile.x)}`] });
  return [...slideTiles, ...remains];
}

function crestBack(meta: RunMeta, own: Slide[]): string {
  const last = own[own.length - 1]!;
  const places = { from: crestFrom(meta, own[0]!), to: columnPlace(last.crest_to, meta.cell) };
  return `${say("crest_back", places)} ${byColumns(meta)}`;
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
