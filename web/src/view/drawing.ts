// What all drawing on the canvas of a view shares: paths in metres, lines, words with a halo.

import type { Run } from "../data/run";
import type { Camera, Size } from "../logic/camera";
import { toScreen } from "../logic/camera";
import type { Current } from "./current";
import { FONT, type CanvasTheme } from "./theme";

export interface PanelOptions {
  camera: Camera;
  size: Size; // CSS pixels
  ratio: number;
  time: number;
  names: string[]; // of all runs
  label: string;
  note: string; // after the label, muted
  bare: boolean; // small pictures: no axes, names and notes
  top: number; // pixels above the section, for the head
}

export interface Drawing {
  context: CanvasRenderingContext2D;
  run: Run;
  current: Current;
  options: PanelOptions;
  theme: CanvasTheme;
  frame: number;
}

/** Of the frame on show, which may differ a little from the time asked for. */
export function timeOf({ run, frame }: Drawing): number {
  return run.meta.times[frame]!;
}

export function at({ options }: Drawing, x: number, y: number): [number, number] {
  return toScreen(options.camera, options.size, x, y);
}

/** x, y, x, y, ... [m]; NaN, NaN lifts the pen. */
export function path(drawing: Drawing, points: ArrayLike<number>): void {
  const { context } = drawing;
  context.beginPath();
  let down = false;
  for (let k = 0; k + 1 < points.length; k += 2) {
    if (!Number.isFinite(points[k]!)) {
      down = false;
      continue;
    }
    const [px, py] = at(drawing, points[k]!, points[k + 1]!);
    if (down) context.lineTo(px, py);
    else context.moveTo(px, py);
    down = true;
  }
}

export function line(context: CanvasRenderingContext2D, colour: string, width: number, dash: number[] = []): void {
  context.lineJoin = "round";
  context.lineCap = dash.length > 0 ? "butt" : "round";
  context.lineWidth = width;
  context.strokeStyle = colour;
  context.setLineDash(dash);
  context.stroke();
  context.setLineDash([]);
}

export function haloText(drawing: Drawing, text: string, x: number, y: number, colour: string): void {
  const { context, theme } = drawing;
  context.lineWidth = 3.5;
  context.lineJoin = "round";
  context.strokeStyle = theme.halo;
  context.strokeText(text, x, y);
  context.fillStyle = colour;
  context.fillText(text, x, y);
}

export function letters({ context }: Drawing, size: number, weight = 600): void {
  context.font = `${weight} ${size}px ${FONT}`;
  context.textAlign = "left";
  context.textBaseline = "middle";
}
