// From a value to a colour. Maps are safe for the colour-blind; the tables come from d3-scale-chromatic.

import { interpolateBrBG, interpolateCividis, interpolateMagma, interpolateOrRd, interpolatePuOr, interpolateRdBu,
  interpolateViridis } from "d3-scale-chromatic";
import type { FieldKind } from "../data/format";
import { numberText } from "./numbers";
import { say, TEXTS, type TextKey } from "./texts";

export interface ColourMap {
  name: string;
  kind: FieldKind;
  at: (t: number) => string; // 0...1 -> CSS colour
}

export const MAPS: ColourMap[] = [
  { name: "viridis", kind: "sequential", at: interpolateViridis },
  { name: "cividis", kind: "sequential", at: interpolateCividis },
  { name: "magma", kind: "sequential", at: interpolateMagma },
  { name: "loss", kind: "sequential", at: (t) => interpolateOrRd(1 - t) },
  { name: "grey", kind: "sequential",
    at: (t) => `rgb(${[0, 1, 2].map(() => Math.round(40 + 200 * t)).join(",")})` },
  { name: "RdBu", kind: "diverging", at: (t) => interpolateRdBu(1 - t) },
  { name: "PuOr", kind: "diverging", at: (t) => interpolatePuOr(1 - t) },
  { name: "BrBG", kind: "diverging", at: interpolateBrBG },
];

/** Okabe and Ito's colours for categories (materials, lines), without black and yellow, which vanish on a ground. */
export const CATEGORIES = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#8c6d1f", "#7f7f7f"];

const ON_DARK = ["#56a8e0", "#f0b84a", "#2fc79a", "#e79bc6", "#a5dbf7", "#ff8a4d", "#cdb25a", "#b5b5b5"];

/** Colour of the k-th of several lines. */
export function lineColour(k: number, dark: boolean): string {
  return (dark ? ON_DARK : CATEGORIES)[k % CATEGORIES.length]!;
}

/** The map that suits a field best: of what is left of the strength one in which sound soil is pale. */
export function preferredMap(field: string): string {
  return field === "su_ratio" ? "loss" : "viridis";
}

export function mapLabel({ name }: ColourMap): string {
  const key = `map_${name}`;
  return key in TEXTS ? say(key as TextKey) : name;
}

export function mapNamed(name: string): ColourMap {
  return MAPS.find((map) => map.name === name) ?? MAPS[0]!;
}

export function mapsFor(kind: FieldKind): ColourMap[] {
  return MAPS.filter((map) => map.kind === kind);
}

export interface Range {
  lo: number;
  hi: number;
  log: boolean;
}

/** Range that can be drawn: lo < hi, and for a logarithmic one lo > 0. */
export function validRange(range: Range): Range {
  let { lo, hi } = range;
  if (!Number.isFinite(lo) || !Number.isFinite(hi)) [lo, hi] = [0, 1];
  if (lo > hi) [lo, hi] = [hi, lo];
  if (range.log) {
    if (!(hi > 0)) hi = 1;
    if (!(lo > 0)) lo = hi / 1e3;
    return { lo: lo < hi ? lo : hi / 10, hi, log: true };
  }
  if (lo === hi) [lo, hi] = [lo - 0.5 * (Math.abs(lo) || 1), hi + 0.5 * (Math.abs(hi) || 1)];
  return { lo, hi, log: false };
}

/** The same range with zero in the middle, for diverging maps. */
export function symmetric(range: Range): Range {
  const most = Math.max(Math.abs(range.lo), Math.abs(range.hi)) || 1;
  return { lo: -most, hi: most, log: false };
}

/** Place of a value on the colour bar, 0...1. The vertex shader of view/points.ts computes the same. */
export function placeOnBar(value: number, range: Range): number {
  const t = range.log ? Math.log(Math.max(value, 1e-30) / range.lo) / Math.log(range.hi / range.lo)
    : (value - range.lo) / (range.hi - range.lo);
  return Math.min(1, Math.max(0, t));
}

export interface Tick {
  at: number;
  text: string;
}

/** Ticks of a colour bar: its ends and nice values between. */
export function barTicks(range: Range, nice: (lo: number, hi: number, count: number) => number[]): Tick[] {
  const values = range.log ? decades(range.lo, range.hi) : nice(range.lo, range.hi, 5);
  return values.map((value) => ({ at: placeOnBar(value, range), text: numberText(value, 3) }));
}

function decades(lo: number, hi: number): number[] {
  const few = Math.log10(hi / lo) < 3.5;
  const values: number[] = [];
  for (let e = Math.floor(Math.log10(lo)); e <= Math.ceil(Math.log10(hi)); e++) {
    for (const lead of few ? [1, 2, 5] : [1]) {
      const value = lead * Math.pow(10, e);
      if (value >= lo * (1 - 1e-9) && value <= hi * (1 + 1e-9)) values.push(Number(value.toPrecision(6)));
    }
  }
  return values;
}

/** 256 colours as RGBA bytes for the texture of the points. */
export function table(map: ColourMap, size = 256): Uint8Array {
  const bytes = new Uint8Array(4 * size);
  for (let k = 0; k < size; k++) bytes.set([...rgb(map.at(k / (size - 1))), 255], 4 * k);
  return bytes;
}

/** Colours of categories by number; those that the writer gave no colour have one of ours. */
export function categoryTable(given: readonly (string | undefined)[] = [], size = 256): Uint8Array {
  const bytes = new Uint8Array(4 * size);
  for (let k = 0; k < size; k++) bytes.set([...rgb(categoryColour(given, k)), 255], 4 * k);
  return bytes;
}

export function categoryColour(given: readonly (string | undefined)[], k: number): string {
  return given[k] ?? CATEGORIES[k % CATEGORIES.length]!;
}

/** "#rrggbb" or "rgb(r, g, b)" -> three bytes. */
export function rgb(colour: string): [number, number, number] {
  if (colour.startsWith("#")) return [1, 3, 5].map((k) => parseInt(colour.slice(k, k + 2), 16)) as
    [number, number, number];
  return colour.match(/\d+/g)!.slice(0, 3).map(Number) as [number, number, number];
}
