// What makes a picture of points a section of the ground: layers and their names, water, the level to hold back, loads,
// slip surfaces of the run and of other methods.

import type { Run } from "../data/run";
import { soilName, spoken } from "../logic/labels";
import { metres, numberText, withUnit } from "../logic/numbers";
import { slidesOf, slipAt } from "../logic/slides";
import { heightAt } from "../logic/surface";
import { say } from "../logic/texts";
import { at, haloText, letters, line, path, timeOf, type Drawing } from "./drawing";

const SLIT = 3; // spacings of points below the surface from which on gaps are filled
const LINE = 13; // pixels between names
const NARROW = 520; // pixels of a view in which the level has no name
const SCALE_BAR = 190; // pixels at the right end of a view that the bar of lengths takes
const FOOT = 34; // pixels at the foot of a view that names keep free
const ROOM = 44; // pixels at the left end of a view that names keep free

/** Outlines of all soils, where they are now. */
export function drawLayers(drawing: Drawing): void {
  const { context, theme, run, frame, options } = drawing;
  for (const { lines } of run.layers) {
    if (!lines) continue;
    path(drawing, run.places(frame, lines));
    context.globalAlpha = 0.7;
    line(context, theme.layer, options.bare ? 0.7 : 1.1);
    context.globalAlpha = 1;
  }
}

export function drawSoilNames(drawing: Drawing): void {
  const { context, theme, run, frame, options } = drawing;
  if (run.layers.length < 2) return;
  letters(drawing, 12);
  const taken: Box[] = [];
  const unnamed: string[] = [];
  for (const { soil, middle } of run.layers) {
    const [x, y] = middle ? run.places(frame, middle) : [NaN, NaN];
    const [px, py] = at(drawing, x!, y!);
    const text = soilName(soil);
    const width = context.measureText(text).width;
    const { width: wide, height } = options.size;
    if (middle && !(px >= 0 && px <= wide && py >= options.top && py <= height)) continue; // out of view, or has left
    const left = middle && py <= height - FOOT ? freePlace(taken, px - width / 2, py, width, wide) : null;
    if (left === null) {
      unnamed.push(soil);
      continue;
    }
    taken.push({ left, right: left + width, y: py });
    haloText(drawing, text, left, py, theme.text);
  }
  legend(drawing, unnamed);
}

interface Box { left: number; right: number; y: number }

/** Where a name covers no other: as near to its place as it can be along its layer; null: nowhere in the view. */
export function freePlace(taken: readonly Box[], wanted: number, y: number, width: number,
  view: number): number | null {
  for (const step of [0, 1, -1, 2, -2, 3, -3]) {
    const left = Math.max(ROOM, wanted) + step * (width + LINE);
    const covers = taken.some((other) =>
      Math.abs(other.y - y) < LINE && left < other.right && left + width > other.left);
    if (!covers && left >= ROOM && left + width <= view - 4) return left;
  }
  return null;
}

/** Soils for whose names the section has no room, with their colours, at its foot. */
function legend(drawing: Drawing, soils: readonly string[]): void {
  const { context, theme, run, options } = drawing;
  let left = ROOM;
  const y = options.size.height - FOOT + 4;
  for (const soil of soils) {
    const material = run.meta.materials.find((of) => (of.soil ?? of.name) === soil);
    context.fillStyle = material?.color ?? "#c7c7c7";
    context.fillRect(left, y - 5, 10, 10);
    haloText(drawing, soilName(soil), left + 14, y, theme.text);
    left += 14 + context.measureText(soilName(soil)).width + LINE;
  }
}

/** From the phreatic line down to the lowest soil; soil is drawn over it. In slits between points no water shows. */
export function fillWater(drawing: Drawing): void {
  const { context, theme, run, frame } = drawing;
  const table = run.waterTable(frame);
  if (table.length < 4) return;
  const lowest = run.meta.bounds[1];
  path(drawing, [...table, table[table.length - 2]!, lowest, table[0]!, lowest]);
  context.closePath();
  context.globalAlpha = 0.3;
  context.fillStyle = theme.water;
  context.fill();
  context.globalAlpha = 1;
  const ground = run.surface(frame);
  if (ground.length < 4) return;
  const below = SLIT * run.meta.point_size; // a surface over columns lies partly above the soil
  const edge = Array.from(ground, (value, k) => (k % 2 === 1 ? value - below : value));
  path(drawing, [...edge, edge[edge.length - 2]!, lowest, edge[0]!, lowest]);
  context.closePath();
  context.fillStyle = theme.slit;
  context.fill();
}

/** The phreatic line, with the sign of a free surface where it stands above the ground. */
export function drawWater(drawing: Drawing): void {
  const { context, theme, run, frame, options } = drawing;
  const table = run.waterTable(frame);
  if (table.length < 4) return;
  path(drawing, table);
  line(context, theme.water, options.bare ? 1 : 2, options.bare ? [5, 3] : [10, 5]);
  if (options.bare) return;
  const free = freeWater(run, frame);
  if (!free) return;
  const [px, py] = at(drawing, ...free);
  context.beginPath();
  context.moveTo(px - 6, py - 10);
  context.lineTo(px + 6, py - 10);
  context.lineTo(px, py);
  context.closePath();
  context.fillStyle = theme.water;
  context.fill();
  letters(drawing, 11);
  haloText(drawing, metres(free[1]), px + 10, py - 8, theme.water);
}

/** A place on free water: in the middle of the stretch at an end of the section where it stands above the ground. */
function freeWater(run: Run, frame: number): [number, number] | null {
  const table = run.waterTable(frame);
  const ground = run.surface(frame);
  const n = ground.length / 2;
  const above = (k: number) => heightAt(table, ground[2 * k]!) > ground[2 * k + 1]! + 0.1;
  for (const [first, step] of [[0, 1], [n - 1, -1]] as const) {
    let k = first;
    while (k >= 0 && k < n && above(k)) k += step;
    if (Math.abs(k - first) < 2) continue;
    const x = (ground[2 * first]! + ground[2 * (k - step)]!) / 2;
    return [x, heightAt(table, x)];
  }
  return null;
}

/** The water that the ground shall hold back, right across the section. */
export function drawFloodLevel(drawing: Drawing): void {
  const { context, theme, run, options } = drawing;
  const level = run.meta.events?.flood?.water_level;
  if (typeof level !== "number") return;
  const [x0, , x1] = run.meta.bounds;
  path(drawing, [x0, level, x1, level]);
  line(context, theme.level, options.bare ? 0.8 : 1.3, [2, 4]);
  if (options.bare || options.size.width < NARROW) return;
  letters(drawing, 11);
  const text = say("water_level", { level: metres(level) });
  const [px, py] = at(drawing, x1, level);
  const right = Math.min(px, options.size.width - SCALE_BAR);
  haloText(drawing, text, right - context.measureText(text).width - 4, py - 8, theme.level);
}

/** Arrows down on the ground that carries a load, its pressure above them. */
export function drawLoads(drawing: Drawing): void {
  const { context, theme, run, frame, options } = drawing;
  for (const load of run.loads) {
    const pressure = frame < load.frame ? 0 : pressureAt(load.table.column("time"), load.table.column("pressure"),
      timeOf(drawing));
    if (!load.lines || !(pressure > 0)) continue;
    const ground = run.places(frame, load.lines);
    const size = options.bare ? 7 : 16;
    let [left, right, top, last] = [Infinity, -Infinity, Infinity, -Infinity];
    for (let k = 0; k + 1 < ground.length; k += 2) {
      if (!Number.isFinite(ground[k]!)) continue;
      const [px, py] = at(drawing, ground[k]!, ground[k + 1]!);
      [left, right, top] = [Math.min(left, px), Math.max(right, px), Math.min(top, py)];
      if (Math.abs(px - last) < size / 2) continue;
      last = px;
      arrow(context, px, py, size);
    }
    if (!(right > left)) continue;
    line(context, theme.load, options.bare ? 1 : 1.4);
    if (options.bare) continue;
    letters(drawing, 11);
    const text = `${spoken(load.name)} ${withUnit(pressure, load.table.unit("pressure"), 3)}`;
    const middle = (left + right - context.measureText(text).width) / 2;
    haloText(drawing, text, middle, Math.max(top - size - 9, options.top), theme.load);
  }

  function arrow(on: CanvasRenderingContext2D, px: number, py: number, size: number): void {
    on.beginPath();
    on.moveTo(px, py - size);
    on.lineTo(px, py - 1);
    on.moveTo(px - size / 5, py - 1 - size / 4);
    on.lineTo(px, py - 1);
    on.lineTo(px + size / 5, py - 1 - size / 4);
    line(on, theme.load, options.bare ? 0.8 : 1.2);
  }
}

function pressureAt(times: Float32Array | null, pressures: Float32Array | null, time: number): number {
  if (!times || !pressures || times.length === 0) return 0;
  let k = 0;
  while (k + 1 < times.length && times[k + 1]! <= time + 1e-6) k++;
  return pressures[k]!;
}

export function drawSlip(drawing: Drawing): void {
  const { context, run, theme, options } = drawing;
  const slip = slipAt(slidesOf(run.meta), timeOf(drawing));
  const acting = slip?.phase === "acting";
  if (!slip || (!acting && options.bare)) return;
  path(drawing, slip.surface.points.flat());
  const dash = acting ? [] : [3, 6]; // with an edge: it lies on soil of its own colour
  line(context, theme.slipEdge, options.bare ? 3 : acting ? 5 : 4, dash);
  line(context, theme.slip, options.bare || !acting ? 1.5 : 2.5, dash);
}

/** Slip planes of other methods; the key at the head of the view names them. */
export function drawSlipPlanes(drawing: Drawing): void {
  const { context, run, theme, options } = drawing;
  run.meta.slip_planes.forEach(({ points }, k) => {
    path(drawing, points.flat());
    if (!options.bare) line(context, theme.slipEdge, 4);
    line(context, theme.plane, options.bare ? 1 : 2, planeDash(k));
  });
}

export function planeDash(k: number): number[] {
  return DASHES[k % DASHES.length]!;
}

const DASHES = [[9, 3, 2, 3], [4, 3], [12, 4]];

/** Where the strength profile is taken. */
export function drawProfilePlace(drawing: Drawing): void {
  const { context, theme, run, current, options } = drawing;
  const { profileX } = current.state;
  if (profileX === null) return;
  const [, y0, , y1] = run.meta.bounds;
  path(drawing, [profileX, y0, profileX, y1]);
  line(context, theme.text, 1, [1, 4]);
  letters(drawing, 11);
  const [px] = at(drawing, profileX, y0);
  haloText(drawing, `x = ${numberText(profileX, 4)}`, px + 4, options.size.height - 40, theme.text);
}
