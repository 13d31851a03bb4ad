// Events and outcomes of a sweep against the first key that takes numbers. Realisations that agree in all other keys
// are one line; of many lines a few are drawn, evenly from the first to the last. A result that hardly differs over the
// whole sweep is a sentence, and one that no realisation has is left out.

import type { StudyMeta, Tables } from "../data/documents";
import { numberText } from "../logic/numbers";
import type { Store } from "../logic/store";
import { unitText } from "../logic/symbols";
import { say } from "../logic/texts";
import { quantityLabel } from "../logic/quantities";
import { cards, chart, paragraph, section, styled, withUnitOf } from "./document";

const MOST_LINES = 6;
const SAME = 1e-4; // of a value; results that differ by less are called the same
const EVENTS = ["slide", "flood"] as const;
const CODES = ["state", "level", "coarse", ...EVENTS] as string[];

export interface SweepLines {
  names: string[]; // of all combinations of the other keys, as they come
  drawn: number[];
}

export function linesOf(words: string[][], key: number): SweepLines {
  const names = [...new Set(words.map((row) => othersOf(row, key)))];
  const n = Math.min(names.length, MOST_LINES);
  const step = (names.length - 1) / Math.max(n - 1, 1);
  return { names, drawn: Array.from({ length: n }, (_, k) => Math.floor(k * step + 1e-9)) };
}

const othersOf = (row: string[], key: number) => row.filter((_, i) => i !== key).join(", ");

export function sweepPart(data: StudyMeta, tables: Tables, store: Store): HTMLElement | null {
  const key = data.sweep.findIndex(({ numbers }) => numbers !== null);
  if (key < 0) return null; // the table says it all
  const swept = data.sweep[key]!;
  const [inputs, outcomes] = [tables.get(data.inputs)!, tables.get(data.outcomes)!];
  const words = data.words.map((row) => row.slice(data.row_labels.length));
  const lines = linesOf(words, key);
  // of texts the input is the place in the list
  const x = Array.from(inputs.at(key), (value) => (swept.of_numbers ? value : swept.numbers![value]!));
  const same: string[] = [];
  const made = [...EVENTS, ...outcomes.columns.map(({ name }) => name).filter((name) => !CODES.includes(name))]
    .map((name) => {
      const isEvent = CODES.includes(name);
      const label = isEvent ? say(`sweep_${name as "slide" | "flood"}`) : quantityLabel(name, outcomes.label(name));
      const state = outcomes.column("state")!;
      const y = Array.from(outcomes.column(name)!, (value, k) =>
        (name === "flood" && state[k] !== 0 ? NaN : value));
      const known = y.filter(Number.isFinite);
      if (known.length === 0) return null;
      const [low, high] = [Math.min(...known), Math.max(...known)];
      if (high - low <= SAME * Math.max(Math.abs(low), Math.abs(high))) {
        same.push(`${withUnitOf(label, outcomes.unit(name))} ${numberText(high)}`);
        return null;
      }
      const unit = unitText(outcomes.unit(name));
      return chart(store, { title: label, xLabel: withUnitOf(swept.key, swept.unit), unit },
        lines.drawn.map((number, k) => {
          const rows = words.flatMap((row, r) =>
            (othersOf(row, key) === lines.names[number] && Number.isFinite(y[r]) ? [r] : []))
            .sort((a, b) => x[a]! - x[b]!);
          return styled(k, { label: lines.names[number] || label, x: rows.map((r) => x[r]!), y: rows.map((r) => y[r]!),
            marks: true });
        }));
    });
  const others = data.sweep.filter((_, i) => i !== key).map((other) => other.key).join(", ");
  return section(say("sweep_over", { key: swept.key }), cards(made), paragraph([
    others === "" ? "" : say("sweep_lines", { keys: others }) + (lines.drawn.length < lines.names.length
      ? ` ${say("sweep_drawn", { n: lines.drawn.length, all: lines.names.length })}` : ""),
    same.length === 0 ? "" : say("sweep_same", { results: same.join(", ") }),
  ].filter(Boolean).join(" "), "muted"));
}
