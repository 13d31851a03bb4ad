// What happened in a run, in sentences: the numbers of summary.json and of the events, in the words of texts.ts.
// Nothing is worked out here.

import type { Flood, RunMeta, Slide, Trigger } from "../data/format";
import type { Run } from "../data/run";
import { schemeLabel, soilName, spoken } from "./labels";
import { columnPlace, fixed, metres, numberText, percent, withUnit } from "./numbers";
import { nextOf, slidesOf } from "./slides";
import { currentLanguage, ordinal, say, TEXTS, type TextKey } from "./texts";

const HARDLY_MOVED = 0.01; // share of the volume
const STILL_MOVING = 0.01; // kinetic energy at the end over its largest
// Limits of the warnings of the program, src/cli/run.cpp and simulation/softening_scales.cpp
const MUCH_UNEXPLAINED = 0.02; // of the energy from outside

interface StageOfSummary {
  name: string;
  start: number;
  end: number | null; // null: it runs
  at_rest?: boolean;
  fastest_node?: number | null;
  known_for?: number; // s; 0: the verdict did not end it
}

interface StrengthWater {
  material: string;
  parameter: string;
  stress: string;
  daily?: string | null;
}

const numberOf = (run: Pick<Run, "meta">, key: string): number => {
  const value = run.meta.summary[key];
  return typeof value === "number" ? value : 0;
};

/** Of a run of an older Terp: the error of its balance. */
const unexplainedOf = (run: Pick<Run, "meta">): number =>
  numberOf(run, "unexplained_energy" in run.meta.summary ? "unexplained_energy" : "energy_balance_error");

function listOf<T>(meta: RunMeta, key: string): T[] {
  const value = meta.summary[key];
  return Array.isArray(value) ? (value as T[]) : [];
}

export const seconds = (value: number | null | undefined): string => fixed(value, 2, "\u00a0s");

/** A share of one, in percent without decimals. */
const wholePercent = (part: number): string => `${(100 * part).toFixed(0)}\u202f%`;

/** Last and largest kinetic energy, of the nodes where the run has it. */
function kineticOf(run: Run): { last: number; largest: number } {
  const column = run.series?.column("kinetic_nodal") ?? run.series?.column("kinetic");
  if (!column || column.length === 0) return { last: 0, largest: 0 };
  return { last: column[column.length - 1]!, largest: column.reduce((most, value) => Math.max(most, value), 0) };
}

/** Time of the last row of the ledger, else of the last frame. */
export function lastTime(run: Run): number {
  const times = run.series?.column("time");
  return times && times.length > 0 ? times[times.length - 1]! : run.meta.times[run.meta.times.length - 1]!;
}

/** The crest before a slide: where it was drawn, else the edge of a column. */
export function crestFrom({ cell }: RunMeta, slide: Slide): string {
  return typeof slide.crest_edge === "number" ? metres(slide.crest_edge) : columnPlace(slide.crest_from, cell);
}

/** How sharply crests are seen: "(by columns of 1 m)". */
export function byColumns({ cell }: RunMeta): string {
  return cell ? say("by_columns", { column: withUnit(cell, "m", 2) }) : "";
}

/** Soil still moved where a stage ended, and later ones do not show what it would have done. */
export function movedBefore({ still_moves: moves, stage_moving: moving, stage }: Flood): boolean {
  return Boolean(moves && moving) && moving !== stage;
}

/** What the program says against the numbers of a run. id: of one kind alone. */
export function findingsOf({ meta }: Run, id?: string): string[] {
  return listOf<{ id: string; en: string; nl: string }>(meta, "findings").filter((finding) => !id || finding.id === id)
    .map((finding) => finding[currentLanguage()].replace(/`([^`]*)`/g, "“$1”"));
}

/** "on the land's side"; empty where all slides go to the right and no river says more. */
export function sideOf(meta: RunMeta, slide: Slide): string {
  const river = meta.events?.flood?.river;
  if (river) return say(slide.facing === river ? "side_river" : "side_land");
  if (slidesOf(meta).every(({ facing }) => facing !== "left")) return "";
  return say(slide.facing === "left" ? "side_left" : "side_right");
}

/** On which part of the dike a slide enters the ground. */
export function zoneText(meta: RunMeta, slide: Slide): string {
  if (!slide.entry) return "";
  const river = meta.events?.flood?.river;
  const [slope, other] = !river ? ["slope", "other_slope"] as const
    : slide.facing === river ? ["outer_slope", "inner_slope"] as const : ["inner_slope", "outer_slope"] as const;
  return say(`zone_${slide.entry.zone}`, { slope: say(slope), other: say(other), toe: say(`toe_of_${slope}`) });
}

function tellStages(meta: RunMeta): string[] {
  const stages = listOf<StageOfSummary>(meta, "stages").filter(({ name, known_for: known }) => name !== "" || known);
  if (stages.length === 0) return [];
  const texts = stages.map(({ name, start, end, at_rest: rest, fastest_node: fastest, known_for: known }) => {
    const values = { name: name || say("stage_of_all"), start: seconds(start), end: seconds(end) };
    if (end === null) return say("stage_runs", values);
    if (known) return say(rest ? "stage_known_rest" : "stage_known", { ...values, known: seconds(known) });
    if (rest) return say("stage_rest", values);
    return typeof fastest === "number" ? say("stage_moving", { ...values, speed: withUnit(fastest, "m/s", 2) })
      : say("stage_plain", values);
  });
  return [say("story_stages", { stages: texts.join("; ") })];
}

function endOfSlide(run: Run, slides: Slide[], k: number): string {
  const { stops, kinetic_peak: peak } = slides[k]!;
  if (typeof stops === "number") return say("story_stopped", { time: seconds(stops) });
  if (nextOf(slides, k)) return say("story_overtaken");
  const { last } = kineticOf(run);
  if (!peak) return "";
  const factor = run.series?.unit("kinetic") === "kJ/m" ? 1e3 : 1; // the peak is in J/m
  return say("story_goes_on", { time: seconds(lastTime(run)), percent: wholePercent((factor * last) / peak) });
}

function tellSlides(run: Run): string[] {
  const { meta } = run;
  const slides = slidesOf(meta);
  if (slides.length === 0) {
    if ((meta.events?.moved_fraction ?? 0) >= HARDLY_MOVED) return [say("story_creeps")];
    return [say(meta.finished ? "story_holds" : "story_holds_so_far", { time: seconds(lastTime(run)) })];
  }
  return slides.map((slide, k) => {
    const side = sideOf(meta, slide);
    const { entry } = slide;
    return [say("story_slide", { ordinal: ordinal(k), time: seconds(slide.begins), side: side && ` ${side}`,
      from: crestFrom(meta, slide), to: columnPlace(slide.crest_to, meta.cell), column: spaced(byColumns(meta)) }),
    entry ? say("story_entry", { x: metres(entry.x), zone: zoneText(meta, slide) }) : "",
    entry ? reachText(slide) : "",
    endOfSlide(run, slides, k)].filter(Boolean).join(" ");
  });
}

/** Where the slip surface ends, away from its entry, and how deep it goes; null: nobody knows. */
export function exitOf({ entry, slip_surface: surface }: Slide): { x: number; low: number } | null {
  if (!entry || !surface || surface.points.length < 2) return null;
  const [first, last] = [surface.points[0]!, surface.points[surface.points.length - 1]!];
  const end = Math.abs(first[0] - entry.x) > Math.abs(last[0] - entry.x) ? first : last;
  return { x: end[0], low: Math.min(...surface.points.map(([, y]) => y)) };
}

function reachText(slide: Slide): string {
  const exit = exitOf(slide);
  return exit ? say("story_reach", { low: metres(exit.low), x: metres(exit.x) }) : "";
}

function spaced(text: string): string {
  return text && ` ${text}`;
}

/** How far the front came, or why there is none. */
function frontText(meta: RunMeta): string {
  const events = meta.events!;
  if (!events.facing) return say("story_no_slope");
  const known = typeof events.front_x === "number" && typeof events.run_out === "number";
  if (events.free_toe !== false)
    return known ? say("story_front", { distance: metres(events.run_out), x: metres(events.front_x) })
      : say("story_no_soil");
  if (!known) return say("story_toe_none");
  const where = events.run_out! > 0 ? say("beyond_toe", { distance: metres(events.run_out) }) : say("not_beyond_toe");
  return say("story_toe", { x: metres(events.front_x), where });
}

function tellMotion(run: Run): string[] {
  const { meta } = run;
  const events = meta.events!;
  const slides = slidesOf(meta);
  const moved = say("story_moved",
    { time: seconds(lastTime(run)), volume: fixed(events.moved_volume, 2, "\u00a0m²"),
      percent: percent(events.moved_fraction), distance: withUnit(events.moved_distance, "m", 2) });
  const texts = [`${moved} ${frontText(meta)}`];
  if (typeof events.intact_fraction === "number" && (events.moved_fraction ?? 0) > HARDLY_MOVED)
    texts.push(say("story_intact", { percent: percent(events.intact_fraction) }));
  const { x, y } = events.remaining_crest ?? {};
  if (typeof x === "number" && typeof y === "number") texts.push(say("story_crest",
    { x: columnPlace(x, meta.cell), y: metres(y), column: spaced(byColumns(meta)) }));
  else if (typeof x !== "number" && slides.length > 0) texts.push(say("story_no_crest"));
  if (typeof events.residual_height === "number")
    texts.push(say("story_height", { height: metres(events.residual_height) }));
  const last = slides[slides.length - 1];
  const stages = listOf<StageOfSummary>(meta, "stages");
  const end = stages[stages.length - 1];
  const atRest = end?.at_rest === true || (end?.known_for ?? 0) > 0;
  const kinetic = kineticOf(run);
  const told = last !== undefined && typeof last.stops !== "number";
  if (!told && !atRest && kinetic.last > STILL_MOVING * kinetic.largest)
    texts.push(say("story_still", { percent: wholePercent(kinetic.last / kinetic.largest) }));
  return texts;
}

/** The list is empty if there is soil of a library of which nobody said what softening leaves. */
function tellSoftening(meta: RunMeta): string[] {
  const softened = meta.summary.softened_fraction as { fraction: number }[] | undefined;
  if (softened?.length === 0) return [say("story_softening_unknown")];
  const share = softened?.[softened.length - 1]?.fraction ?? 0;
  if (share > 0) return [say("story_softened", { percent: percent(share) })];
  const bySoilOfLibrary = typeof meta.summary.lowest_library_strength === "number";
  return meta.summary.softened_strain === null && !bySoilOfLibrary ? [say("story_no_softening")] : [];
}

function tellStrength(meta: RunMeta): string[] {
  const texts = tellSoftening(meta);
  const water = (name: string) => (name === "start" ? say("water_start") : say("water_situation", { name }));
  const groups = new Map<string, { of: StrengthWater; soils: string[] }>();
  for (const of of listOf<StrengthWater>(meta, "strength_water")) {
    const key = [of.parameter, of.stress, of.daily ?? ""].join("\n");
    const group = groups.get(key) ?? { of, soils: [] };
    group.soils.push(soilName(of.material));
    groups.set(key, group);
  }
  for (const { of, soils } of groups.values()) {
    const key = `of_${of.parameter}`;
    const parameter = key in TEXTS ? say(key as TextKey) : spoken(of.parameter);
    const values = { soils: soils.join("; "), parameter, water: water(of.stress) };
    texts.push(of.daily ? say("story_strength_daily", { ...values, daily: water(of.daily) })
      : say("story_strength", values));
  }
  return texts;
}

function tellHistory(run: Run): string[] {
  const fell = numberOf(run, "points_eps_eq_p_fell");
  if (fell === 0) return [];
  const values = { n: fell, all: run.meta.n_points, scheme: schemeLabel(run.meta.scheme) };
  return [say(numberOf(run, "points_su_rose") > 0 ? "story_fell_back" : "story_fell", values)];
}

function tellPlanes({ slip_planes: planes }: RunMeta): string[] {
  return planes.length === 0 ? [] : [say("story_planes", { planes: planes.map(planeText).join("; ") })];
}

/** "UpliftVanParticleSwarm" -> "Uplift-Van": the method, without the search for its plane. */
function methodText(method: string): string {
  const known = ["Bishop", "Spencer", "UpliftVan"].find((name) => method.startsWith(name));
  return known === "UpliftVan" ? "Uplift-Van" : (known ?? method);
}

/** "Design values: Bishop, F = 1.05" */
export function planeText(plane: RunMeta["slip_planes"][number]): string {
  const factor = plane.factor_of_safety === null ? "" : `F = ${numberText(plane.factor_of_safety, 4)}`;
  const details = [methodText(plane.method), factor].filter(Boolean).join(", ");
  return details ? `${plane.name}: ${details}` : plane.name;
}

/** Sentences for a person who sees the run for the first time. */
export function tellStory(run: Run): string[] {
  if (!run.meta.events) return [say("story_running", { time: seconds(lastTime(run)) })];
  return [...tellStages(run.meta), ...tellSlides(run), ...tellMotion(run), ...tellStrength(run.meta),
    ...tellHistory(run), ...tellPlanes(run.meta)];
}

export interface Check {
  name: string;
  value: string;
  passed: boolean;
}

export function listChecks(run: Run): Check[] {
  const { meta } = run;
  if (!meta.events) return [{ name: say("check_end"), value: say("no"), passed: false }]; // the rest is not known yet
  const error = unexplainedOf(run);
  const count = (key: TextKey, column: string): Check =>
    ({ name: say(key), value: String(numberOf(run, column)), passed: numberOf(run, column) === 0 });
  const strainIsKnown = meta.summary.max_eps_eq_p !== null; // not of a library that does not say which variable it is
  return [
    { name: say("check_end"), value: say(meta.finished ? "yes" : "no"), passed: meta.finished },
    { name: say("check_energy"), value: withUnit(100 * error, "%", 2), passed: error <= MUCH_UNEXPLAINED },
    count("check_clamped", "clamped_points"),
    ...(strainIsKnown ? [count("check_fell", "points_eps_eq_p_fell")] : []),
    count("check_rose", "points_su_rose"),
  ];
}

/** What the reader must know before trusting the numbers, of the program and of the numbers themselves. */
export function listWarnings(run: Run): string[] {
  const { meta } = run;
  const warnings = meta.finished ? [] : [say("warn_unfinished", { time: withUnit(lastTime(run), "s", 3) })];
  if (meta.events) warnings.push(...findingsOf(run));
  const told = new Set([say("check_end"), say("check_energy"), say("check_clamped")]);
  const failed = listChecks(run).filter((check) => !check.passed && !told.has(check.name));
  return [...warnings, ...(meta.warnings[currentLanguage()] ?? []), ...(meta.doubts?.[currentLanguage()] ?? []),
    ...failed.map(({ name, value }) => say("warn_check", { name, value }))];
}

/** ", after strengths were divided by 1.12": a verdict under a trigger never stands without it. */
export function triggerWords(trigger: Trigger | null | undefined): string {
  if (!trigger) return "";
  const parts = [trigger.at_strength !== 1 ? say("trigger_strength", { factor: numberText(trigger.at_strength) }) : "",
    typeof trigger.river === "number" ? say("trigger_river", { level: metres(trigger.river) }) : ""].filter(Boolean);
  const what = parts.length > 0 ? parts.join(say("trigger_and")) : say("trigger_stage", { stage: trigger.stage });
  return `, ${say("trigger_after", { what })}`;
}
