// Realisations of a study by kind and by class of an outcome.

import type { StudyMeta } from "../data/documents";
import type { Table } from "../data/table";
import { numberText } from "./numbers";
import { say, type TextKey } from "./texts";

const [FAILED, NOT_RUN, AS_DRAWN] = [1, 2, 3]; // of the column `state`; 0: solved
const MOST_CLASSES = 40;

/** An outcome of a part of the realisations; name: in the legend. */
export interface Group {
  name: string;
  values: number[];
}

/** Numbers of the realisations at a level of the load; of two levels of cells those of the fine one. */
function countedAt(outcomes: Table, level: number): number[] {
  const [levels, coarse] = [outcomes.column("level")!, outcomes.column("coarse")!];
  return Array.from({ length: outcomes.rows }, (_, k) => k).filter((k) => levels[k] === level && coarse[k] === 0);
}

/** By the levels of the load. Realisations that are not solved have no outcome. */
export function outcomesOf({ of_load }: Pick<StudyMeta, "of_load">, outcomes: Table, name: string): Group[] {
  const values = outcomes.column(name)!;
  return (of_load?.levels ?? [0]).map((level, number) => ({
    name: of_load ? `${numberText(level)}\u00a0${of_load.unit === "-" ? "" : of_load.unit}`.trim() : "",
    values: countedAt(outcomes, number).map((k) => values[k]!).filter(Number.isFinite),
  }));
}

export interface Classes {
  edges: number[]; // of the classes, one more than there are
  counts: number[][]; // of each group, with a zero at the last edge
}

/** Classes of one size for all groups, as many as the rule of Rice says; null with fewer than two values. */
export function classesOf(groups: Group[]): Classes | null {
  const most = Math.max(0, ...groups.map(({ values }) => values.length));
  if (most < 2) return null;
  const all = groups.flatMap(({ values }) => values);
  const [low, high] = [all.reduce((a, b) => Math.min(a, b)), all.reduce((a, b) => Math.max(a, b))];
  const n = Math.floor(Math.min(Math.max(2 * Math.cbrt(most), 5), MOST_CLASSES));
  const size = high > low ? (high - low) / n : 1;
  const counts = groups.map(({ values }) => {
    const of = new Array<number>(n + 1).fill(0);
    for (const value of values) of[Math.min(n - 1, Math.max(0, Math.floor((value - low) / size)))]!++;
    return of;
  });
  return { edges: Array.from({ length: n + 1 }, (_, k) => low + k * size), counts };
}

export interface Kind {
  name: string;
  n: number;
  share: number; // of those at the level
  volume: number; // median of what slid [m²]; NaN: of none
  height: number; // median of what remains [m]
  example: number; // the realisation with the median volume
}

function nameOfKind(outcomes: Table, k: number): string {
  const of = (name: string) => outcomes.column(name)![k]!;
  const state = of("state");
  if (state === NOT_RUN) return say("kind_not_run");
  if (state === FAILED) return say("kind_failed");
  if (state === AS_DRAWN) return say("kind_as_drawn");
  const flood = of("flood");
  const slides = of("slides"); // of the crest
  const word: TextKey = of("slide") === 0 ? (flood === 1 ? "kind_no_slide" : "kind_stands")
    : slides > 1 ? "kind_more_slides" : slides === 0 ? "kind_beside" : "kind_slides";
  return say(word) + (Number.isNaN(flood) ? "" : `, ${say(flood === 1 ? "kind_floods" : "kind_holds")}`);
}

/** The value in the middle; of an even number the upper one, so that it is one of them. */
export function medianOf(values: number[]): number {
  return [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)] ?? NaN;
}

/** The realisations of each kind at a level of the load, the most frequent kind first. */
export function kindsAt(outcomes: Table, level: number): Kind[] {
  const numbers = countedAt(outcomes, level);
  const kinds = new Map<string, number[]>();
  for (const k of numbers) {
    const name = nameOfKind(outcomes, k);
    const members = kinds.get(name);
    if (members) members.push(k);
    else kinds.set(name, [k]);
  }
  const known = (members: number[], name: string) =>
    members.map((k) => outcomes.column(name)![k]!).filter(Number.isFinite);
  return [...kinds].map(([name, members]) => {
    const volume = medianOf(known(members, "slide_volume"));
    const example = members.find((k) => outcomes.column("slide_volume")![k] === volume) ?? members[0]!;
    return { name, n: members.length, share: members.length / numbers.length, volume,
      height: medianOf(known(members, "residual_height")), example };
  }).sort((a, b) => b.n - a.n || a.name.localeCompare(b.name));
}
