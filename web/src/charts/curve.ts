// Curves in a plane, as the path of a stress: x need not grow along them, which a chart over x needs. Drawn as SVG, so
// that they print sharp and follow the theme.

import { niceTicks, readableUnit, tickTexts, unitSuffix } from "../logic/numbers";
import { element } from "../shell/element";
import { DASHES } from "./chart";

export interface Curve {
  label: string;
  x: ArrayLike<number>;
  y: ArrayLike<number>;
  colour: string;
}

export interface CurveOptions {
  title: string;
  x: Axis;
  y: Axis;
}

export interface Axis {
  label: string;
  unit: string;
  log?: boolean; // by ten
}

const WIDTH = 460, HEIGHT = 270, RIGHT = 14, TOP = 8, BOTTOM = 44;
const TITLE = 24, CHARACTER = 6.6; // room left of the ticks, and of each character of theirs

/** An axis with its ticks; `at` gives the place of a value between 0 and 1. */
export interface Scale {
  at: (value: number) => number;
  ticks: { at: number; text: string }[];
  label: string;
}

export function scaleOf(values: number[], axis: Axis): Scale {
  const seen = values.filter((value) => Number.isFinite(value) && (!axis.log || value > 0));
  const size = seen.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  const { factor, unit } = readableUnit(axis.unit, size);
  const by = (value: number) => (axis.log ? Math.log10(value * factor) : value * factor);
  let low = Infinity, high = -Infinity;
  for (const value of seen) [low, high] = [Math.min(low, by(value)), Math.max(high, by(value))];
  if (!(low <= high)) [low, high] = [0, 1];
  const room = 0.04 * (high - low || Math.abs(high) || 1);
  if (axis.log || low !== 0) low -= room;
  high += room;
  const numbers = axis.log ? logTicks(low, high) : niceTicks(low, high, 6);
  const texts = tickTexts(numbers);
  const at = (value: number) => (by(value) - low) / (high - low);
  return { at, ticks: numbers.map((number, k) => ({ at: at(number / factor), text: texts[k]! })),
    label: `${axis.label}${unitSuffix(unit)}` };
}

/** 1, 2, 5, 10, ... between two powers of ten; round numbers where fewer than three of them lie there. */
function logTicks(low: number, high: number): number[] {
  const ticks: number[] = [];
  for (let decade = Math.floor(low); decade <= high; decade++)
    for (const digit of [1, 2, 5]) {
      const tick = digit * 10 ** decade;
      if (Math.log10(tick) >= low && Math.log10(tick) <= high) ticks.push(tick);
    }
  return ticks.length > 2 ? ticks : niceTicks(10 ** low, 10 ** high, 6).filter((tick) => tick > 0);
}

function svg(tag: string, attributes: Record<string, string | number>, text = ""): SVGElement {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  made.textContent = text;
  return made;
}

function line(curve: Curve, k: number, points: string): SVGElement {
  return svg("polyline", { points, fill: "none", stroke: curve.colour, "stroke-width": 1.7,
    "stroke-dasharray": DASHES[k % DASHES.length]!.join(" ") });
}

/** A figure like that of a Chart. */
export function drawCurves(options: CurveOptions, curves: Curve[]): HTMLElement {
  const [x, y] = [scaleOf(curves.flatMap((c) => Array.from(c.x)), options.x),
    scaleOf(curves.flatMap((c) => Array.from(c.y)), options.y)];
  const left = TITLE + CHARACTER * Math.max(...y.ticks.map(({ text }) => text.length));
  const across = (share: number) => left + share * (WIDTH - left - RIGHT);
  const up = (share: number) => HEIGHT - BOTTOM - share * (HEIGHT - TOP - BOTTOM);
  const root = svg("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": options.title,
    class: "curves" });
  for (const { at, text } of x.ticks)
    root.append(svg("line", { x1: across(at), x2: across(at), y1: up(0), y2: up(1), class: "grid" }),
      svg("text", { x: across(at), y: up(0) + 15, "text-anchor": "middle" }, text));
  for (const { at, text } of y.ticks)
    root.append(svg("line", { x1: across(0), x2: across(1), y1: up(at), y2: up(at), class: "grid" }),
      svg("text", { x: left - 6, y: up(at) + 4, "text-anchor": "end" }, text));
  root.append(svg("text", { x: across(0.5), y: HEIGHT - 8, "text-anchor": "middle" }, x.label),
    svg("text", { transform: `translate(12 ${up(0.5)}) rotate(-90)`, "text-anchor": "middle" }, y.label));
  curves.forEach((curve, k) => {
    const places: string[] = [];
    for (let i = 0; i < curve.x.length; i++) {
      const [px, py] = [across(x.at(curve.x[i]!)), up(y.at(curve.y[i]!))];
      if (Number.isFinite(px) && Number.isFinite(py)) places.push(`${px.toFixed(2)} ${py.toFixed(2)}`);
    }
    root.append(line(curve, k, places.join(" ")));
  });
  const legend = curves.map((curve, k) => {
    const sample = svg("svg", { viewBox: "0 0 26 4", "aria-hidden": "true" });
    sample.append(line(curve, k, "0 2 26 2"));
    return element("li", {}, sample, curve.label);
  });
  return element("figure", { class: "chart" }, element("figcaption", {}, options.title), root,
    element("ul", { class: "curve-legend" }, ...legend));
}
