// What remains of the dike: the ground before, after each slide and at the end; its height and width against time.

import type { Current } from "../view/current";
import type { Run } from "../data/run";
import { Chart, type Line } from "../charts/chart";
import { runLabels } from "../logic/labels";
import { timeDecimals, timeText } from "../logic/numbers";
import { nextOf, slidesOf } from "../logic/slides";
import { ordinal, say } from "../logic/texts";
import { canvasTheme, runColour } from "../view/theme";
import { element } from "../shell/element";
import { hasWater } from "../logic/verdict";

const MOST_SLIDES = 4; // drawn; of more the last ones
const DASH = [7, 4];

/** The ground of each run with water: before, after each slide, at the end. */
export function profileCards(current: Current): HTMLElement[] {
  const { runs } = current.report;
  return runs.filter((run) => hasWater(run) && run.meta.surfaces && run.meta.times.length > 1).map((run) =>
    profile(current, run, nameOf(current, run)));
}

/** Height and width that remain against time, of each run with water. */
export function heightCards(current: Current): HTMLElement[] {
  return current.report.runs.filter(hasWater).map((run) => heights(current, run, nameOf(current, run)))
    .filter((card) => card !== null);
}

function nameOf({ report }: Current, run: Run): string {
  return report.runs.length > 1 ? `, ${runLabels(report.runs.map(({ meta }) => meta))[run.index]}` : "";
}

export interface Ground {
  frame: number;
  label: string;
}

/** Which frames to draw: before, after each slide, at the end; a frame twice has one line. */
export function groundsOf(run: Run, frameOf: (time: number) => number): Ground[] {
  const { times } = run.meta;
  const decimals = timeDecimals(times);
  const slides = slidesOf(run.meta);
  const last = times.length - 1;
  const after = slides.map((slide, k) => {
    const time = slide.stops ?? nextOf(slides, k)?.begins ?? times[last]!;
    const frame = frameOf(time);
    return { frame, label: say("profile_after", { ordinal: ordinal(k), time: timeText(time, decimals) }) };
  }).filter(({ frame }) => frame > 0 && frame < last);
  return [{ frame: 0, label: say("profile_before") }, ...after.slice(-MOST_SLIDES),
    { frame: last, label: say("profile_end", { time: timeText(times[last]!, decimals) }) }];
}

function profile(current: Current, run: Run, name: string): HTMLElement {
  const chart = new Chart(current.store,
    { title: `${say("profile_title")}${name}`, xLabel: "x [m]", yLabel: "y", unit: "m", overTime: false, height: 250 });
  const grounds = groundsOf(run, (time) => current.frame(run, time));
  const line = ({ frame, label }: Ground, k: number): Line => {
    const ground = run.surface(frame);
    const n = ground.length / 2;
    const part = grounds.length > 1 ? k / (grounds.length - 1) : 1;
    return { label, x: Array.from({ length: n }, (_, i) => ground[2 * i]!),
      y: Array.from({ length: n }, (_, i) => ground[2 * i + 1]!), width: 1.4 + 1.2 * part,
      dash: k === 0 ? DASH : undefined,
      colour: (dark) => shade(run.index, part, dark) };
  };
  const lines = grounds.map(line);
  const level = run.meta.events?.flood?.water_level;
  const [x0, , x1] = run.meta.bounds;
  if (typeof level === "number") lines.push({ label: say("profile_level"), x: [x0, x1], y: [level, level],
    colour: (dark) => canvasTheme(dark).level, dash: [2, 4] });
  chart.show(lines);
  return element("article", { class: "card profile" }, chart.root);
}

/** From grey before to the colour of the run at the end. */
function shade(index: number, part: number, dark: boolean): string {
  return part === 0 ? canvasTheme(dark).muted
    : `color-mix(in srgb, ${runColour(index, dark)} ${Math.round(35 + 65 * part)}%, ${dark ? "#39434e" : "#cfd6dd"})`;
}

function heights(current: Current, run: Run, name: string): HTMLElement | null {
  const time = run.series?.column("time");
  const known = (column: string) => {
    const values = run.series?.column(column);
    return values?.some((value) => Number.isFinite(value)) ? values : null;
  };
  const [height, width] = [known("residual_height"), known("width_at_level")];
  if (!time || !height) return null;
  const colour = (dark: boolean) => runColour(run.index, dark);
  const lines: Line[] = [{ label: say("height_line"), x: time, y: height, colour, width: 2.2 }];
  const level = run.meta.events?.flood?.water_level;
  if (typeof level === "number") lines.push({ label: say("profile_level"), x: [time[0]!, time[time.length - 1]!],
    y: [level, level], colour: (dark) => canvasTheme(dark).level, dash: [2, 4] });
  if (width) lines.push({ label: say("width_line"), x: time, y: width, colour, dash: DASH });
  const chart = new Chart(current.store,
    { title: `${say("height_title")}${name}`, xLabel: say("time_axis"), unit: "m", fromZero: true });
  chart.show(lines);
  return element("article", { class: "card heights" }, chart.root);
}
