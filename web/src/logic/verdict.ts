// What is said of the water, and what must be read with it.

import type { Run } from "../data/run";
import { metres } from "./numbers";
import { restDoubt, sideDoubts } from "./story";
import { say } from "./texts";

export type Kind = "running" | "none" | "stands" | "damaged" | "floods";

/** A run that has not ended has a verdict only where that is for good. */
export function kindOf({ meta: { events, finished } }: Run): Kind {
  const verdict = events?.flood?.verdict;
  if (verdict === "floods") return verdict;
  return finished && events ? (verdict ?? "none") : "running";
}

/** What the verdict must not be read without. */
export function doubts(run: Run): string[] {
  const { water_in_gap: depth } = run.meta;
  const holds = run.meta.events?.flood && kindOf(run) !== "floods";
  return [...restDoubt(run), ...sideDoubts(run), depth && holds ? say("note_gap", { depth: metres(depth) }) : ""]
    .filter(Boolean);
}
