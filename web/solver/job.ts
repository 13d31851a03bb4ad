// The words of `terp` for what the user chose.

import type { Source } from "./source";
import type { Call } from "./worker";

export interface Choices {
  scenario: number; // from 1; 0: none
  stage: number;
  cell: number | null; // [m]; null: that of the case or section
  strength: "deterministic" | "mean" | "design";
  trigger: "none" | "water" | "strength";
  at_strength: number | null;
  least_depth: number | null; // [m]
  verdict: boolean;
  factor: boolean;
}

export const NO_CHOICES: Choices = { scenario: 0, stage: 0, cell: null, strength: "deterministic", trigger: "none",
  at_strength: null, least_depth: null, verdict: true, factor: false };

export const PICTURE = "section.svg";
export const REPORT = "report.html";

export const isStix = (source: Source) => /\.stix$/i.test(source.path);
export const casePath = (source: Source) => (source.kind === "case" ? source.path : "case/case.toml");

const option = (name: string, value: string | number | null) => (value === null || value === 0 ? [] : [name, String(value)]);

function place(source: Source, choices: Choices): string[] {
  return isStix(source) ? [...option("--scenario", choices.scenario), ...option("--stage", choices.stage)] : [];
}

function changes(source: Source, choices: Choices): string[] {
  return [
    ...(source.kind === "case" && choices.cell ? ["--set", `mesh.cell=${choices.cell}`] : []),
    ...(choices.at_strength && choices.at_strength !== 1 ? ["--set", `at_strength=${choices.at_strength}`] : []),
  ];
}

export function listing(source: Source): Call[] {
  return [{ words: ["import", source.path, "--json"] }];
}

/** To the case, its numbers and its picture. */
export function check(source: Source, choices: Choices): Call[] {
  const imported = ["import", source.path, "-o", "case", "--force", ...place(source, choices), ...option("--cell", choices.cell),
    ...(isStix(source) ? ["--strength", choices.strength, ...(choices.trigger === "none" ? [] : ["--trigger", choices.trigger])] : [])];
  return [
    ...(source.kind === "section" ? [{ words: imported }] : []),
    { words: ["check", casePath(source), "--json", "--picture", PICTURE, ...changes(source, choices)] },
  ];
}

/** What follows a run, however that ended. */
function results(source: Source, choices: Choices, language: string): Call[] {
  const stix = ["export", "run", "--stix", "after.stix", "--template", source.path, ...place(source, choices)];
  return [
    { words: ["report", "run", "-o", REPORT, "--language", language], always: true },
    { words: ["export", "run", "--dxf", "after.dxf", "--profile", "after.csv"], always: true },
    ...(isStix(source) ? [{ words: stix, always: true }] : []),
  ];
}

export function run(source: Source, choices: Choices, language: string): Call[] {
  return [{ words: ["run", casePath(source), "-o", "run", "--force", ...changes(source, choices)] }, ...results(source, choices, language)];
}

export function resume(source: Source, choices: Choices, language: string): Call[] {
  return [{ words: ["resume", "run"] }, ...results(source, choices, language)];
}

export function stability(source: Source, choices: Choices): Call[] {
  return [{ words: ["stability", casePath(source), "-o", "stability", "--force", ...option("--least-depth", choices.least_depth),
    ...changes(source, choices)] }];
}
