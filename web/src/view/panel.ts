// One run at one time on a 2D canvas: points and mesh from the renderer, lines and words on top. Screen, exports and
// the strip of pictures all draw with this.

import type { Run } from "../data/run";
import type { Current } from "./current";
import type { PointRenderer } from "./points";
import type { Camera, Padding, Size } from "../logic/camera";
import { toScreen, toWorld } from "../logic/camera";
import { niceLength, niceTicks, numberText, timeDecimals, timeText } from "../logic/numbers";
import { slidesOf, slipAt } from "../logic/slides";
import { sameBody } from "../logic/same_body";
import { canvasTheme, FONT, runColour, type CanvasTheme } from "./theme";

export const PADDING: Padding = { left: 40, right: 16, top: 38, bottom: 30 };

export interface PanelOptions {
  camera: Camera;
  size: Size; // CSS pixels
  ratio: number;
  time: number;
  names: string[]; // of all runs
  label: string;
  note: string; // after the label, muted
  bare: boolean; // small pictures: no axes, names and notes
}

interface Drawing {
  context: CanvasRenderingContext2D;
  run: Run;
  current: Current;
  options: PanelOptions;
  theme: CanvasTheme;
  frame: number;
}

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
  if (state.outline) fillWater(drawing); // soil covers what is not free
  if (renderer && !renderer.lost) {
    const { table, categories } = current.colours();
    renderer.draw(run, {
      camera: options.camera, size: options.size, ratio: options.ratio, frame,
      field: run.fields.get(state.field) ?? null,
      range: current.range(options.time), colours: table, categories,
      pointScale: state.pointScale, mesh: state.mesh, meshColour: theme.mesh,
    });
    context.imageSmoothingEnabled = false;
    context.drawImage(renderer.canvas, 0, 0, width, height);
    context.imageSmoothingEnabled = true;
  }
  if (state.outline) drawOutline(drawing);
  if (state.outline) drawWater(drawing);
  if (state.surfaces && !options.bare) drawOtherSurfaces(drawing);
  if (state.slip) drawSlip(drawing);
  if (!options.bare) {
    if (state.names) drawNames(drawing);
    drawMarks(drawing);
    drawAxes(drawing);
    drawScaleBar(drawing);
    drawHead(drawing);
    if (!run.fieldMeta(state.field)) missing(drawing);
  }
  context.restore();
}

function path(drawing: Drawing, points: ArrayLike<number>): void {
  const { context, options } = drawing;
  context.beginPath();
  let down = false;
  for (let k = 0; k + 1 < points.length; k += 2) {
    if (!Number.isFinite(points[k]!)) {
      down = false;
      continue;
    }
    const [px, py] = toScreen(options.camera, options.size, points[k]!, points[k + 1]!);
    if (down) context.lineTo(px, py);
    else context.moveTo(px, py);
    down = true;
  }
}

function drawOutline(drawing: Drawing): void {
  const { context, theme, run, options } = drawing;
  path(drawing, run.outline);
  context.setLineDash(options.bare ? [3, 3] : [6, 4]);
  context.lineWidth = options.bare ? 1 : 1.4;
  context.strokeStyle = theme.ghost;
  context.globalAlpha = 0.75;
  context.stroke();
  context.globalAlpha = 1;
  context.setLineDash([]);
}

/** From the phreatic line down to the lowest soil. */
function fillWater(drawing: Drawing): void {
  const { context, theme, run, current, options } = drawing;
  const table = run.waterTable(current.frame(run, options.time));
  if (table.length < 4) return;
  const lowest = run.meta.bounds[1];
  path(drawing, [...table, table[table.length - 2]!, lowest, table[0]!, lowest]);
  context.closePath();
  context.globalAlpha = 0.22;
  context.fillStyle = theme.water;
  context.fill();
  context.globalAlpha = 1;
}

function drawWater(drawing: Drawing): void {
  const { context, theme, run, current, options } = drawing;
  path(drawing, run.waterTable(current.frame(run, options.time)));
  context.setLineDash(options.bare ? [5, 3] : [10, 5]);
  context.lineWidth = options.bare ? 1 : 2;
  context.strokeStyle = theme.water;
  context.stroke();
  context.setLineDash([]);
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

function line(context: CanvasRenderingContext2D, colour: string, width: number): void {
  context.lineJoin = "round";
  context.lineCap = "round";
  context.lineWidth = width;
  context.strokeStyle = colour;
  context.stroke();
}

function drawSlip(drawing: Drawing): void {
  const { context, run, theme, options } = drawing;
  const slip = slipAt(slidesOf(run.meta), timeOf(drawing));
  const acting = slip?.phase === "acting";
  if (!slip || (!acting && options.bare)) return;
  path(drawing, slip.surface.points.flat());
  if (acting) line(context, theme.slipEdge, options.bare ? 3 : 5);
  else context.setLineDash([3, 6]);
  line(context, theme.slip, options.bare || !acting ? 1.5 : 2.5);
  context.setLineDash([]);
}

/** Of the frame on show, which may differ a little from the time asked for. */
function timeOf({ run, frame }: Drawing): number {
  return run.meta.times[frame]!;
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

function haloText(drawing: Drawing, text: string, x: number, y: number, colour: string): void {
  const { context, theme } = drawing;
  context.lineWidth = 3.5;
  context.lineJoin = "round";
  context.strokeStyle = theme.halo;
  context.strokeText(text, x, y);
  context.fillStyle = colour;
  context.fillText(text, x, y);
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
  const [x0, y1] = toWorld(options.camera, options.size, PADDING.left - 8, PADDING.top);
  const [x1, y0] = toWorld(options.camera, options.size, width - PADDING.right, height - PADDING.bottom + 8);
  const [left, bottom] = [PADDING.left - 8, height - PADDING.bottom + 8];
  context.fillStyle = theme.ground;
  context.fillRect(0, 0, left, height);
  context.fillRect(0, bottom, width, height - bottom);
  context.fillRect(0, 0, width, PADDING.top - 8);
  context.strokeStyle = theme.frame;
  context.lineWidth = 1;
  context.strokeRect(left + 0.5, PADDING.top - 7.5, width - left - 8, bottom - PADDING.top + 7);
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
    if (py < PADDING.top - 4 || py > bottom - 2) continue;
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
  const [x1, y] = [options.size.width - PADDING.right - 6, PADDING.top + 12];
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
  const used = PADDING.left + 2 + context.measureText(options.label).width;
  const decimals = timeDecimals(run.meta.times);
  const stamp = `t = ${timeText(timeOf(drawing), decimals)}`;
  context.textAlign = "right";
  context.fillText(stamp, options.size.width - 9, 16);
  drawKey(drawing, used + 16, options.size.width - 30 - context.measureText(stamp).width, decimals);
}

/**
 * What the lines mean, between name and time, as far as there is room; at the end, if there is still, the run's name.
 */
function drawKey(drawing: Drawing, from: number, to: number, decimals: number): void {
  const { context, run, current, theme, options } = drawing;
  const { state } = current;
  const slip = state.slip ? slipAt(slidesOf(run.meta), timeOf(drawing)) : null;
  const others = state.surfaces ? current.shownRuns().filter((other) => other !== run) : [];
  const entries = [
    ...others.map((other) =>
      ({ text: `surface of ${options.names[other.index]}`, colour: runColour(other.index, state.dark),
      dash: [] as number[] })),
    slip && {
      text: `slip surface of ${timeText(slip.time, decimals)}${slip.phase === "acting" ? "" : `, ${slip.phase}`}`,
      colour: theme.slip, dash: slip.phase === "acting" ? [] : [2, 4] },
    state.outline && { text: "initial outline", colour: theme.ghost, dash: [4, 3] },
    state.outline && run.meta.water && { text: "phreatic line", colour: theme.water, dash: [8, 4] },
    options.note !== options.label && { text: options.note, colour: "", dash: [] },
  ];
  context.font = `12px ${FONT}`;
  context.textAlign = "left";
  let x = from;
  for (const entry of entries) {
    if (!entry) continue;
    const width = context.measureText(entry.text).width + (entry.colour ? 24 : 0);
    if (x + width > to) continue;
    if (entry.colour) {
      context.beginPath();
      context.moveTo(x, 16);
      context.lineTo(x + 18, 16);
      context.setLineDash(entry.dash);
      line(context, entry.colour, 2);
      context.setLineDash([]);
    }
    context.fillStyle = theme.muted;
    context.fillText(entry.text, x + (entry.colour ? 24 : 0), 16.5);
    x += width + 18;
  }
}

function missing(drawing: Drawing): void {
  const { context, options, theme } = drawing;
  context.font = `13px ${FONT}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillStyle = theme.muted;
  context.fillText("This run was written without that field.", options.size.width / 2, options.size.height / 2);
}
