// How runs are called on the page: by scheme where that tells them apart, else by name.

import type { RunMeta } from "../data/format";
import { decimalSign, say, TEXTS, type TextKey } from "./texts";

const SCHEMES: Record<string, string> = { mpm_gp: "MPM-GP", mpm_mixed: "MPM-Mixed", standard_mpm: "standard MPM" };

export function schemeLabel(scheme: string): string {
  return SCHEMES[scheme] ?? scheme;
}

/** Short and different for each run. */
export function runLabels(runs: readonly Pick<RunMeta, "name" | "scheme">[]): string[] {
  const different = (texts: string[]) => new Set(texts).size === texts.length;
  const schemes = runs.map((run) => schemeLabel(run.scheme));
  if (different(schemes)) return schemes;
  const names = runs.map((run) => run.name);
  if (different(names)) return names;
  return names.map((name, k) => `${name} (${k + 1})`);
}

/** What low and high values of a field say about the soil; empty for fields that the page does not know. */
export function fieldHelp(name: string): string {
  const key = `help_${name}`;
  return key in TEXTS ? say(key as TextKey) : "";
}

/** "sand_below" -> "sand, below water": the import cuts soils that differ above and below the phreatic line there. */
export function soilName(name: string): string {
  const [, soil, side] = /^(.+)_(below|above)$/.exec(name) ?? [];
  return side ? `${spoken(soil!)}, ${say(`soil_${side}` as TextKey)}` : spoken(name);
}

/** Sentences that begin with a soil as the case names it: "sand_below: ..." */
export function withSoilName(sentence: string, materials: readonly { name: string }[]): string {
  const of = materials.find(({ name }) => sentence.startsWith(`${name}: `));
  const text = of ? soilName(of.name) + sentence.slice(of.name.length) : sentence;
  return text.replace(/\d\.\d/g, decimalSign);
}

/** "front_x" -> "front x", for names that the writer gave no label. */
export function spoken(name: string): string {
  return name.replaceAll("_", " ");
}
