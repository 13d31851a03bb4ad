// Undrained strength against elevation along a vertical, at the start and now, for the first run that has it. The
// reader chooses the vertical: by a slider, a named point, or a click on the section.

import type { Current } from "../view/current";
import type { Run } from "../data/run";
import type { Quantised } from "../data/quantised";
import { pixelRatio } from "../logic/store";
import { metres, niceTicks, numberText, timeDecimals, timeText, unitSuffix } from "../logic/numbers";
import { say } from "../logic/texts";
import { canvasTheme, FONT, runColour } from "../view/theme";
import { element } from "../shell/element";
import { hasWater } from "../logic/verdict";

const [HEIGHT, ON_PAPER] = [250, 185]; // CSS pixels of the drawing
const MARGIN = { left: 46, right: 14, top: 10, bottom: 34 };
const BAND = 14; // width of the soils beside the axis
const REACH = 1.5; // spacings of points on either side of the vertical

export interface Sample {
  y: number; // m
  value: number; // NaN: soil without S_u
  material: number;
}

/** Points near the vertical in a frame, from the lowest up. */
export function samplesAt(run: Run, frame: number, x: number, field: Quantised, material: Quantised | null): Sample[] {
  const reach = REACH * run.meta.point_size;
  const samples: Sample[] = [];
  for (let p = 0; p < run.points; p++) {
    if (!run.present(frame, p)) continue;
    const [px, py] = run.place(frame, p);
    if (Math.abs(px - x) > reach) continue;
    samples.push({ y: py, value: field.value(frame, p), material: Math.round(material?.value(frame, p) ?? 0) });
  }
  return samples.sort((a, b) => a.y - b.y);
}

/** Mean of the samples in layers of one spacing; NaN where there is none. */
export function layered(samples: Sample[], spacing: number): { y: number; value: number }[] {
  const layers = new Map<number, { sum: number; n: number }>();
  for (const { y, value } of samples) {
    if (!Number.isFinite(value)) continue;
    const k = Math.floor(y / spacing);
    const layer = layers.get(k) ?? { sum: 0, n: 0 };
    layers.set(k, { sum: layer.sum + value, n: layer.n + 1 });
  }
  const keys = [...layers.keys()].sort((a, b) => a - b);
  return keys.flatMap((k, i) => {
    const { sum, n } = layers.get(k)!;
    const here = { y: (k + 0.5) * spacing, value: sum / n };
    return i > 0 && k - keys[i - 1]! > 2 ? [{ y: (k - 0.5) * spacing, value: NaN }, here] : [here];
  });
}

/** The top of the ground before: where the profile is taken first. */
function crestOf(run: Run): number {
  const ground = run.surface(0);
  let top = 1;
  for (let k = 1; k < ground.length; k += 2) if (ground[k]! > ground[top]!) top = k;
  const level = ground[top]! - 0.02 * (ground[top]! - run.meta.bounds[1]);
  let [first, last] = [top, top];
  while (first >= 3 && ground[first - 2]! >= level) first -= 2;
  while (last + 2 < ground.length && ground[last + 2]! >= level) last += 2;
  return ground.length > 1 ? (ground[first - 1]! + ground[last - 1]!) / 2 : 0;
}

export function strengthCard(current: Current): HTMLElement | null {
  const run = current.report.runs.find((one) => hasWater(one) && one.fieldMeta("su"));
  if (!run) return null;
  const { store } = current;
  if (store.state.profileX === null) store.set({ profileX: crestOf(run) });
  const [x0, , x1] = run.meta.bounds;
  const title = element("h3");
  const canvas = element("canvas", { role: "img" });
  const slider = element("input", { type: "range", min: x0, max: x1, step: "any", class: "profile-x",
    "aria-label": say("strength_x"), oninput: () => store.set({ profileX: slider.valueAsNumber }) });
  const places = run.histories.map(({ name, x }) => element("button", { type: "button", class: "text-button",
    onclick: () => store.set({ profileX: x }) }, name));
  const root = element("article", { class: "card strength" }, title,
    element("div", { class: "controls no-print" }, slider, ...places), canvas,
    element("p", { class: "muted small" }, say("strength_help", { reach: metres(REACH * run.meta.point_size) })));
  const draw = () => {
    const x = store.state.profileX!;
    title.textContent = say("strength_title", { x: metres(x) });
    slider.value = String(x);
    slider.setAttribute("aria-valuetext", metres(x));
    canvas.setAttribute("aria-label", title.textContent);
    drawProfile(canvas, current, run, x);
  };
  store.watch(["profileX", "time", "dark", "paper"], draw);
  store.on(({ pin }, changed) => {
    if (!changed.has("pin") || !pin || current.report.runs[pin.run] !== run) return;
    store.set({ profileX: run.place(current.frame(run), pin.point)[0] });
  });
  run.onField.push(draw);
  void run.field("su");
  new ResizeObserver(draw).observe(root);
  return root;
}

interface Axes {
  context: CanvasRenderingContext2D;
  px: (value: number) => number;
  py: (y: number) => number;
}

function drawProfile(canvas: HTMLCanvasElement, current: Current, run: Run, x: number): void {
  const width = canvas.clientWidth;
  const [field, material] = [run.fields.get("su"), run.fields.get("material") ?? null];
  if (width === 0 || !field) return;
  const height = current.state.paper ? ON_PAPER : HEIGHT;
  canvas.style.height = `${height}px`;
  const ratio = Math.max(2, pixelRatio(current.state));
  [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
  const context = canvas.getContext("2d")!;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  const theme = canvasTheme(current.state.dark);
  const frame = current.frame(run);
  const [before, now] = [samplesAt(run, 0, x, field, material), samplesAt(run, frame, x, field, material)];
  const values = [...before, ...now].map(({ value }) => value).filter(Number.isFinite);
  context.font = `11px ${FONT}`;
  context.fillStyle = theme.muted;
  if (values.length === 0) return context.fillText(say("strength_none"), MARGIN.left, height / 2);
  const ys = [...before, ...now].map(({ y }) => y);
  const [low, high] = [Math.min(...ys), Math.max(...ys)];
  const most = 1.1 * Math.max(...values);
  const left = MARGIN.left + BAND + 2;
  const axes: Axes = { context, px: (value) => left + ((width - left - MARGIN.right) * value) / most,
    py: (y) => height - MARGIN.bottom - ((height - MARGIN.bottom - MARGIN.top) * (y - low)) / (high - low || 1) };
  drawGrid(axes, theme, most, [low, high], unitSuffix(run.fieldMeta("su")!.unit));
  drawSoils(axes, run, now);
  const spacing = run.meta.point_size;
  drawLine(axes, layered(before, spacing), theme.muted, 1.6, [5, 3]);
  drawLine(axes, layered(now, spacing), runColour(run.index, current.state.dark), 2.4, []);
  const time = timeText(run.meta.times[frame]!, timeDecimals(run.meta.times));
  drawKey(axes, width, [[say("strength_before"), theme.muted],
    [say("strength_now", { time }), runColour(run.index, current.state.dark)]]);
}

function drawGrid({ context, px, py }: Axes, theme: ReturnType<typeof canvasTheme>, most: number,
  [low, high]: [number, number], unit: string): void {
  context.strokeStyle = theme.frame;
  context.lineWidth = 0.6;
  context.textAlign = "center";
  context.textBaseline = "top";
  for (const value of niceTicks(0, most, 5)) {
    segment(context, px(value), py(low), px(value), py(high));
    context.fillText(numberText(value), px(value), py(low) + 5);
  }
  context.fillText(`S_u${unit}`.replace("S_u", "Sᵤ"), (px(0) + px(most)) / 2, py(low) + 19);
  context.textAlign = "right";
  context.textBaseline = "middle";
  for (const y of niceTicks(low, high, 6)) {
    segment(context, px(0), py(y), px(most), py(y));
    context.fillText(numberText(y), px(0) - BAND - 6, py(y));
  }
}

function segment(context: CanvasRenderingContext2D, x0: number, y0: number, x1: number, y1: number): void {
  context.beginPath();
  context.moveTo(x0, y0);
  context.lineTo(x1, y1);
  context.stroke();
}

/** The soils along the vertical now, in their colours. */
function drawSoils({ context, px, py }: Axes, run: Run, samples: Sample[]): void {
  const half = run.meta.point_size / 2;
  for (const { y, material } of samples) {
    context.fillStyle = run.meta.materials[material]?.color ?? "#c7c7c7";
    context.fillRect(px(0) - BAND - 1, py(y + half), BAND, py(y - half) - py(y + half) + 0.5);
  }
}

function drawLine({ context, px, py }: Axes, line: { y: number; value: number }[], colour: string, width: number,
  dash: number[]): void {
  context.beginPath();
  let down = false;
  for (const { y, value } of line) {
    if (!Number.isFinite(value)) down = false;
    else if (down) context.lineTo(px(value), py(y));
    else context.moveTo(px(value), py(y)), (down = true);
  }
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.setLineDash(dash);
  context.stroke();
  context.setLineDash([]);
}

function drawKey({ context }: Axes, width: number, entries: [string, string][]): void {
  context.font = `600 11px ${FONT}`;
  context.textAlign = "right";
  context.textBaseline = "top";
  entries.forEach(([text, colour], k) => {
    context.fillStyle = colour;
    context.fillText(text, width - MARGIN.right - 4, MARGIN.top + 4 + 15 * k);
  });
}
