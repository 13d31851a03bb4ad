// Numbers as text: a few significant digits, a prefix of the unit where it helps.

import { currentLanguage, decimalSign } from "./texts";

const SUPERSCRIPT = "⁰¹²³⁴⁵⁶⁷⁸⁹";
const THIN = "\u202f";

function exponentText(exponent: number): string {
  const digits = [...String(Math.abs(exponent))].map((d) => SUPERSCRIPT[Number(d)]).join("");
  return `10${exponent < 0 ? "⁻" : ""}${digits}`;
}

/** "13.39", "0.0021", "40 000", "1.2·10⁻⁵"; "–" for what is not known. */
export function numberText(value: number | null | undefined, digits = 4): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e7) {
    const [mantissa, exponent] = value.toExponential(Math.max(0, digits - 2)).split("e");
    return decimalSign(`${Number(mantissa)}·${exponentText(Number(exponent))}`.replace("-", "−"));
  }
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  const plain = Number(value.toFixed(decimals)).toString();
  const [whole, part] = plain.replace("-", "−").split(".");
  const grouped = whole!.replace(/\B(?=(\d{3})+(?!\d))/g, size >= 1e4 ? THIN : "");
  return part ? decimalSign(`${grouped}.${part}`) : grouped;
}

/** Rounded so that a step changes the last decimal by two at most. */
export function toSteps(value: number, step: number): number {
  return Number(value.toFixed(Math.min(12, Math.max(0, Math.round(-Math.log10(step))))));
}

/** Numbers beside each other, with as many digits as tell them apart. */
export function tickTexts(ticks: readonly number[]): string[] {
  for (let digits = 4; ; digits += 2) {
    const texts = ticks.map((tick) => numberText(tick, digits));
    if (digits >= 10 || new Set(texts).size === texts.length) return texts;
  }
}

export function withUnit(value: number | null | undefined, unit: string, digits = 4): string {
  const text = numberText(value, digits);
  return text === "–" || unit === "-" || unit === "" ? text : `${text}${unit === "%" ? THIN : "\u00a0"}${unit}`;
}

/** With so many decimals, and a unit as it is; "–" for what is not known. */
export function fixed(value: number | null | undefined, decimals: number, unit: string): string {
  if (typeof value !== "number" || !Number.isFinite(value)) return "–";
  return decimalSign(`${value.toFixed(decimals).replace("-", "−")}${unit}`);
}

export function metres(value: number | null | undefined): string {
  return fixed(value, 2, "\u00a0m");
}

/** Over NAP, as a Dutch page says it of a section of D-Stability: "NAP +9,25 m". Of others in metres. */
export function elevation(meta: { assumed?: unknown }, value: number | null | undefined): string {
  const text = metres(value);
  if (currentLanguage() !== "nl" || !meta.assumed || typeof value !== "number" || !Number.isFinite(value)) return text;
  return `NAP\u00a0${text.startsWith("−") ? "" : "+"}${text}`;
}

/** A place that is the edge of a column, with no more decimals than the edges have: "21 m". */
export function columnPlace(value: number | null | undefined, column: number | null | undefined): string {
  let decimals = 0;
  while (column && decimals < 2 && Math.abs(column - Number(column.toFixed(decimals))) > 1e-6 * column) decimals++;
  return fixed(value, column ? decimals : 2, "\u00a0m");
}

/** Of a share of one. */
export function percent(part: number | null | undefined): string {
  return fixed(typeof part === "number" ? 100 * part : null, 1, `${THIN}%`);
}

/** Of a share of one: "0.02 %", "3.1 %", "12 %". */
export function percentOf(part: number): string {
  const value = 100 * part;
  return value < 0.095 ? `${numberText(value, 1)}${THIN}%` : fixed(value, value < 9.95 ? 1 : 0, `${THIN}%`);
}

export function unitSuffix(unit: string): string {
  return unit === "-" || unit === "" ? "" : ` [${unit}]`;
}

/** Factor and unit in which values of that size read well: 120000 J/m -> 0.001, "kJ/m". */
export function readableUnit(unit: string, size: number): { factor: number; unit: string } {
  if (/^k(J|Pa|W|N)\b/.test(unit) && size >= 2e3) return { factor: 1e-3, unit: unit.replace("k", "M") };
  if (!/^(J|Pa|W|N)\b/.test(unit)) return { factor: 1, unit };
  if (size >= 2e6) return { factor: 1e-6, unit: `M${unit}` };
  if (size >= 2e3) return { factor: 1e-3, unit: `k${unit}` };
  return { factor: 1, unit };
}

/** Seconds with so many decimals that neighbouring frames differ. */
export function timeText(seconds: number, decimals: number): string {
  return decimalSign(`${seconds.toFixed(decimals)}\u00a0s`);
}

export function timeDecimals(times: readonly number[]): number {
  const step = times.length > 1 ? (times[times.length - 1]! - times[0]!) / (times.length - 1) : 1;
  return Math.min(6, Math.max(2, Math.ceil(-Math.log10(step || 1) + 0.3)));
}

export function durationText(seconds: number): string {
  if (seconds < 59.95) return `${numberText(seconds, 3)}\u00a0s`;
  const whole = Math.round(seconds);
  const minutes = Math.floor(whole / 60);
  if (minutes < 60) return `${minutes}\u00a0min ${whole - 60 * minutes}\u00a0s`;
  return `${Math.floor(minutes / 60)}\u00a0h ${minutes % 60}\u00a0min`;
}

/** A length of 1, 2 or 5 times a power of ten, the largest that is not longer than `most`. */
export function niceLength(most: number): number {
  const power = Math.pow(10, Math.floor(Math.log10(most)));
  const lead = most / power;
  return (lead >= 5 ? 5 : lead >= 2 ? 2 : 1) * power;
}

/** Ticks at nice places from lo to hi, about `count` of them. */
export function niceTicks(lo: number, hi: number, count: number): number[] {
  if (!(hi > lo)) return [lo];
  const step = niceLength(((hi - lo) / count) * 1.5);
  const first = Math.ceil(lo / step - 1e-9);
  const last = Math.floor(hi / step + 1e-9);
  return Array.from({ length: last - first + 1 }, (_, k) => Number(((first + k) * step).toPrecision(12)));
}
