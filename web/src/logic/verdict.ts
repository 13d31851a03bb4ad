// What is said of the water, and what must be read with it.

import type { Flood } from "../data/format";
import type { Run } from "../data/run";
import { fixed, metres } from "./numbers";
import { findingsOf } from "./story";
import { currentLanguage, say } from "./texts";

export type Kind = "running" | "none" | "stands" | "damaged" | "still_moving" | "near" | "floods";

/** A run that water is asked of: with a verdict, or with a phreatic line. */
export function hasWater(run: Run): boolean {
  return run.meta.water !== null || Boolean(run.meta.events?.flood);
}

/** A run that has not ended has a verdict only where it floods so far. */
export function kindOf({ meta: { events, finished } }: Run): Kind {
  const verdict = events?.flood?.verdict;
  if (verdict === "floods") return verdict;
  return finished && events ? (verdict ?? "none") : "running";
}

/** What the verdict must not be read without. */
export function doubts(run: Run): string[] {
  const changed = run.meta.changed?.[currentLanguage()]?.length ?? 0;
  const unsaid = kindOf(run) === "still_moving" ? [] : findingsOf(run, "rest"); // the verdict says so itself
  return [turnsOn(run), ...unsaid, ...findingsOf(run, "side"), changed > 0 ? say("note_changed", { n: changed }) : "",
    ravelled(run), ...findingsOf(run, "margin")].filter(Boolean);
}

function ravelled({ meta: { events } }: Run): string {
  const { ravelled_volume: volume, ravelled_depth: depth } = events?.flood ?? {};
  return volume ? say("note_ravelled", { volume: fixed(volume, 1, "\u00a0m²"), depth: metres(depth) }) : "";
}

/** What the outcome turns on, of the inputs that were changed one at a time. */
function turnsOn({ meta: { depends } }: Run): string {
  if (!depends) return "";
  const { turns_on: turns, does_not_turn_on: others, not_varied: left = [] } = depends;
  const values = { inputs: turns.join(", "), others: others.join(", ") };
  const text = turns.length === 0 ? "turns_on_nothing" : others.length > 0 ? "turns_on" : "turns_on_all";
  return say(text, values) + (left.length > 0 ? ` ${say("not_varied", { inputs: left.join("; ") })}` : "");
}

/** In which stage the ground came down: a slide in daily water is no flood of the river. */
export function stageWords(flood: Flood | null | undefined): string {
  const { stage_damaged: damaged, stage_below: below, stage: last } = flood ?? {};
  const began = damaged || below;
  if (!began) return "";
  const factor = flood?.at_strength_damaged ?? flood?.at_strength_below;
  const strength = typeof factor === "number" ? ` ${say("at_strength", { factor: fixed(factor, 2, "") })}` : "";
  if (below && below !== began) return ` ${say("began_in_two_stages", { damaged: began, below })}${strength}`;
  return ` ${began === last || !last ? say("began_in_stage", { stage: began })
    : say("began_before_stage", { stage: began, last })}${strength}`;
}
