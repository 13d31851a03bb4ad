// One run at one time on a 2D canvas: points and mesh from the renderer, lines and words on top. Screen, exports and
// the strip of pictures all draw with this.

import type { Run } from "../data/run";
import type { Current } from "./current";
import type { PointRenderer } from "./points";
import type { Padding } from "../logic/camera";
import { toScreen, toWorld } from "../logic/camera";
import { niceLength, niceTicks, numberText, timeDecimals, timeText } from "../logic/numbers";
import { slidesOf, slipAt } from "../logic/slides";
import { sameBody } from "../logic/same_body";
import { planeText } from "../logic/story";
import { say } from "../logic/texts";
import { haloText, letters, line, path, timeOf, type Drawing, type PanelOptions } from "./drawing";
import { drawFloodLevel, drawLayers, drawLoads, drawProfilePlace, drawSlip, drawSlipPlanes, drawSoilNames, drawWater,
  fillWater, planeDash } from "./section";
import { canvasTheme, FONT, runColour } from "./theme";

export const PADDING: Padding = { left: 40, right: 16, top: 38, bottom: 30 };

const LIGHT_PAPER: [number, number, number] = [1, 1, 1];
const DARK_PAPER: [number, number, number] = [0.07, 0.09, 0.11];

export function drawPanel(context: CanvasRenderingContext2D, renderer: PointRenderer | null, run: Run, current: Current,
  options: PanelOptions): void {
  const { state } = current;
  const theme = canvasTheme(state.dark);
  const frame = current.frame(run, options.time);
  const drawing = { context, run, current, options, theme, frame };
  const { width, height } = options.size;
  context.save();
  context.beginPath();
  context.rect(0, 0, width, height);
  context.clip();
  context.fillStyle = theme.ground;
  context.fillRect(0, 0, width, height);
  if (state.water) fillWater(drawing); // soil covers what is not free
  if (renderer && !renderer.lost) {
    const { table, categories } = current.colours(run);
    renderer.draw(run, {
      camera: options.camera, size: options.size, ratio: options.ratio, frame,
      field: run.fields.get(state.field) ?? null,
      range: current.range(options.time), colours: table, categories,
      material: run.fields.get("material") ?? null, soils: current.soilColours(run),
      paper: state.dark ? DARK_PAPER : LIGHT_PAPER,
      pointScale: state.pointScale, mesh: state.mesh, meshColour: theme.mesh,
    });
    context.imageSmoothingEnabled = false;
    context.drawImage(renderer.canvas, 0, 0, width, height);
    context.imageSmoothingEnabled = true;
  }
  if (state.layers) drawLayers(drawing);
  if (state.outline) drawOutline(drawing);
  if (state.water) {
    drawWater(drawing);
    drawFloodLevel(drawing);
    drawLoads(drawing);
  }
  if (state.surfaces && !options.bare) drawOtherSurfaces(drawing);
  if (state.slip) {
    drawSlip(drawing);
    drawSlipPlanes(drawing);
  }
  if (!options.bare) {
    if (state.layers) drawSoilNames(drawing);
    drawProfilePlace(drawing);
    if (state.names) drawNames(drawing);
    drawMarks(drawing);
    drawAxes(drawing);
    drawScaleBar(drawing);
    drawHead(drawing);
    if (!run.fieldMeta(state.field)) missing(drawing);
  }
  context.restore();
}

/** Of a section of several soils, whose layers are drawn where they are now, the first ground; else all outlines. */
function drawOutline(drawing: Drawing): void {
  const { context, theme, run, options } = drawing;
  path(drawing, hasLayers(drawing) ? run.surface(0) : run.outline);
  context.globalAlpha = 0.75;
  line(context, theme.ghost, options.bare ? 1 : 1.4, options.bare ? [3, 3] : [6, 4]);
  context.globalAlpha = 1;
}

function hasLayers({ run, current }: Drawing): boolean {
  return current.state.layers && run.layers.length > 1;
}

function drawOtherSurfaces(drawing: Drawing): void {
  const { context, current, run, theme, options } = drawing;
  for (const other of current.shownRuns()) {
    if (other === run) continue;
    path(drawing, other.surface(current.frame(other, options.time)));
    line(context, theme.halo, 4);
    line(context, runColour(other.index, current.state.dark), 2);
  }
}

function drawNames(drawing: Drawing): void {
  const { context, run, options, theme } = drawing;
  const time = timeOf(drawing);
  context.font = `600 11px ${FONT}`;
  context.textBaseline = "middle";
  context.textAlign = "left";
  for (const history of run.histories) {
    const [times, xs, ys] = ["time", "x", "y"].map((name) => history.table.column(name));
    let [x, y] = [history.x, history.y];
    if (times && xs && ys && times.length > 0) {
      let k = 0;
      while (k + 1 < times.length && times[k + 1]! <= time + 1e-9) k++;
      [x, y] = [xs[k]!, ys[k]!];
    }
    const [px, py] = toScreen(options.camera, options.size, x, y);
    context.beginPath();
    context.arc(px, py, 3.5, 0, 2 * Math.PI);
    context.fillStyle = theme.ground;
    context.fill();
    line(context, theme.text, 1.5);
    haloText(drawing, history.name, px + 6, py - 6, theme.text);
  }
}

/** Rings around the pinned point and the point under the pointer, also in the runs that have a point of the same id. */
function drawMarks(drawing: Drawing): void {
  const { context, run, current, options, theme, frame } = drawing;
  for (const [mark, colour] of [[current.state.hover, theme.text], [current.state.pin, theme.slip]] as const) {
    if (!mark) continue;
    const of = current.report.runs[mark.run]!;
    const point = of === run ? mark.point : sameBody(of, run) ? run.pointOfId(of.ids[mark.point]!) : -1;
    if (point < 0 || !run.present(frame, point)) continue;
    const [px, py] = toScreen(options.camera, options.size, ...run.place(frame, point));
    context.beginPath();
    context.arc(px, py, 6.5, 0, 2 * Math.PI);
    line(context, theme.halo, 5);
    line(context, colour, of === run ? 2.5 : 1.5);
  }
}

function drawAxes(drawing: Drawing): void {
  const { context, options, theme } = drawing;
  const { width, height } = options.size;
  const [x0, y1] = toWorld(options.camera, options.size, PADDING.left - 8, options.top);
  const [x1, y0] = toWorld(options.camera, options.size, width - PADDING.right, height - PADDING.bottom + 8);
  const [left, bottom] = [PADDING.left - 8, height - PADDING.bottom + 8];
  context.fillStyle = theme.ground;
  context.fillRect(0, 0, left, height);
  context.fillRect(0, bottom, width, height - bottom);
  context.fillRect(0, 0, width, options.top - 8);
  context.strokeStyle = theme.frame;
  context.lineWidth = 1;
  context.strokeRect(left + 0.5, options.top - 7.5, width - left - 8, bottom - options.top + 7);
  context.fillStyle = theme.ground;
  context.fillRect(width - 7, 0, 7, height);
  context.font = `11px ${FONT}`;
  context.fillStyle = theme.muted;
  context.textAlign = "center";
  context.textBaseline = "top";
  const xTicks = niceTicks(x0, x1, Math.max(2, width / 90));
  for (const x of xTicks) {
    const [px] = toScreen(options.camera, options.size, x, 0);
    if (px > width - 24) continue;
    tick(context, px, bottom, px, bottom + 4, theme.frame);
    context.fillText(numberText(x), px, bottom + 6);
  }
  context.textAlign = "right";
  context.fillText("m", width - 9, bottom + 6);
  context.textBaseline = "middle";
  for (const y of niceTicks(y0, y1, Math.max(2, height / 50))) {
    const [, py] = toScreen(options.camera, options.size, 0, y);
    if (py < options.top - 4 || py > bottom - 2) continue;
    tick(context, left - 4, py, left, py, theme.frame);
    context.fillText(numberText(y), left - 7, py);
  }
}

function tick(context: CanvasRenderingContext2D, x0: number, y0: number, x1: number, y1: number, colour: string): void {
  context.beginPath();
  context.moveTo(x0, y0);
  context.lineTo(x1, y1);
  context.strokeStyle = colour;
  context.stroke();
}

function drawScaleBar(drawing: Drawing): void {
  const { context, options, theme } = drawing;
  const length = niceLength(Math.min(140, options.size.width / 5) / options.camera.scale);
  const width = length * options.camera.scale;
  const [x1, y] = [options.size.width - PADDING.right - 6, options.top + 12];
  context.globalAlpha = 0.85; // a plate: soil of any colour may lie below
  context.fillStyle = theme.ground;
  context.fillRect(x1 - width - 8, y - 9, width + 16, 31);
  context.globalAlpha = 1;
  context.beginPath();
  context.moveTo(x1 - width, y - 4);
  context.lineTo(x1 - width, y);
  context.lineTo(x1, y);
  context.lineTo(x1, y - 4);
  line(context, theme.text, 2);
  context.font = `600 12px ${FONT}`;
  context.textAlign = "center";
  context.textBaseline = "top";
  haloText(drawing, `${numberText(length)}\u00a0m`, x1 - width / 2, y + 4, theme.text);
}

function drawHead(drawing: Drawing): void {
  const { context, run, options, theme, current } = drawing;
  const colour = runColour(run.index, current.state.dark);
  context.textBaseline = "middle";
  context.textAlign = "left";
  context.fillStyle = colour;
  context.fillRect(PADDING.left - 8, 9, 4, 14);
  context.font = `600 14px ${FONT}`;
  context.fillStyle = theme.text;
  context.fillText(options.label, PADDING.left + 2, 16);
  const stamp = `t = ${timeText(timeOf(drawing), timeDecimals(run.meta.times))}`;
  context.textAlign = "right";
  context.fillText(stamp, options.size.width - 9, 16);
  drawKey(drawing, stamp);
}

const SLIP_TEXT = { acting: "slip_at", "to come": "slip_to_come", past: "slip_past" } as const;

const KEY_LINE = 16; // pixels between two rows of the key

/** What the lines mean; the run's name comes last. */
function keyEntries({ run, current, theme, options }: Key, time: number): KeyEntry[] {
  const { state } = current;
  const slip = state.slip ? slipAt(slidesOf(run.meta), time) : null;
  const decimals = timeDecimals(run.meta.times);
  const others = state.surfaces ? current.shownRuns().filter((other) => other !== run) : [];
  const entries: (KeyEntry | false | null | undefined)[] = [
    ...others.map((other) =>
      ({ text: say("surface_of", { run: options.names[other.index]! }), colour: runColour(other.index, state.dark),
      dash: [] as number[] })),
    slip && { text: say(SLIP_TEXT[slip.phase], { time: timeText(slip.time, decimals) }),
      colour: theme.slip, dash: slip.phase === "acting" ? [] : [2, 4] },
    ...(state.slip ? run.meta.slip_planes : []).map((plane, k) =>
      ({ text: planeText(plane), colour: theme.plane, dash: planeDash(k), plane: true })),
    state.outline && { text: say(state.layers && run.layers.length > 1 ? "initial_ground" : "initial_outline"),
      colour: theme.ghost, dash: [4, 3] },
    state.water && run.meta.water && { text: say("phreatic_line"), colour: theme.water, dash: [8, 4] },
    options.note !== options.label && { text: options.note, colour: "", dash: [] },
  ];
  return entries.filter((entry): entry is KeyEntry => !!entry);
}

/** Where the entries go: between name and time as far as there is room; slip planes also in rows below. */
export function keyPlaces(context: CanvasRenderingContext2D, entries: KeyEntry[], head: [number, number],
  width: number): { entry: KeyEntry; x: number; row: number }[] {
  context.font = `400 12px ${FONT}`;
  const placed: { entry: KeyEntry; x: number; row: number }[] = [];
  let [x, low, row] = [head[0], PADDING.left, 1];
  for (const entry of entries) {
    const wide = context.measureText(entry.text).width + (entry.colour ? 24 : 0);
    if (x + wide <= head[1]) {
      placed.push({ entry, x, row: 0 });
      x += wide + 18;
    } else if (entry.plane) {
      if (low > PADDING.left && low + wide > width - 16) [low, row] = [PADDING.left, row + 1];
      placed.push({ entry, x: low, row });
      low += wide + 18;
    }
  }
  return placed;
}

/** Left and right end of what is free between name and time. */
function headRoom(context: CanvasRenderingContext2D, label: string, stamp: string, width: number): [number, number] {
  context.font = `600 14px ${FONT}`;
  return [PADDING.left + 18 + context.measureText(label).width, width - 30 - context.measureText(stamp).width];
}

/** The most that the key of a run takes below the head of a view of that width, at any time [px]. */
export function keyHeight(run: Run, current: Current, options: Pick<PanelOptions, "label" | "note" | "names">,
  width: number): number {
  const context = document.createElement("canvas").getContext("2d");
  if (!context || run.meta.slip_planes.length === 0) return 0;
  const key = { run, current, theme: canvasTheme(false), options };
  const { times } = run.meta;
  const slips = slidesOf(run.meta).map(({ slip_surface: surface }) => surface?.time ?? times[0]!);
  const rows = [times[0]!, ...slips, times[times.length - 1]!].map((time) => {
    const stamp = `t = ${timeText(time, timeDecimals(run.meta.times))}`;
    const places = keyPlaces(context, keyEntries(key, time), headRoom(context, options.label, stamp, width), width);
    return Math.max(0, ...places.map(({ row }) => row));
  });
  return KEY_LINE * Math.max(...rows);
}

function drawKey(drawing: Drawing, stamp: string): void {
  const { context, options } = drawing;
  const entries = keyEntries(drawing, timeOf(drawing));
  const head = headRoom(context, options.label, stamp, options.size.width);
  const places = keyPlaces(context, entries, head, options.size.width);
  letters(drawing, 12, 400);
  for (const { entry, x, row } of places) keyEntry(drawing, entry, x, 16 + row * KEY_LINE);
}

type Key = Pick<Drawing, "run" | "current" | "theme"> & { options: Pick<PanelOptions, "label" | "note" | "names"> };

interface KeyEntry {
  text: string;
  colour: string;
  dash: number[];
  plane?: boolean; // a slip plane of another method, which is always named
}

function keyEntry({ context, theme }: Drawing, { text, colour, dash }: KeyEntry, x: number, y: number): void {
  if (colour) {
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(x + 18, y);
    line(context, colour, 2, dash);
  }
  context.fillStyle = theme.muted;
  context.fillText(text, x + (colour ? 24 : 0), y + 0.5);
}

function missing(drawing: Drawing): void {
  const { context, options, theme } = drawing;
  context.font = `13px ${FONT}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillStyle = theme.muted;
  context.fillText(say("no_field"), options.size.width / 2, options.size.height / 2);
}
