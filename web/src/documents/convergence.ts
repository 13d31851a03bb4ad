// A case on several sizes of cells. Answers, orders, limits and sentences are those of the program. Over the size of
// the cells a line is a sequence; over time a line is a size, the smallest one full.

import type { ConvergenceMeta, MeshQuantity, MeshSequence, QuantityMeta, Tables } from "../data/documents";
import { fixed } from "../logic/numbers";
import { quantityLabel } from "../logic/quantities";
import { unitText } from "../logic/symbols";
import type { Store } from "../logic/store";
import { say, type TextKey } from "../logic/texts";
import { runColour } from "../view/theme";
import { cards, chart, list, notice, paragraph, section, share, styled, table, type Content,
  type Row } from "./document";
import { element } from "../shell/element";

const isWord = (value: number | string | null): value is string => typeof value === "string";
const valueText = ({ digits }: QuantityMeta, value: number | string | null) =>
  (isWord(value) ? value : fixed(value, digits, ""));
const hasValues = ({ values }: QuantityMeta) => values.some((value) => value !== null);

export function convergencePage(data: ConvergenceMeta, tables: Tables, store: Store): Content {
  const [first, ...others] = data.sequences;
  return {
    title: data.title || data.case_name,
    window: say("mesh_window", { title: data.title || data.case_name }),
    subtitle: say("mesh_subtitle", { case: data.case_name, tolerance: share(data.tolerance) }),
    foot: "mesh_foot",
    parts: [
      sequencePart(first!, tables, store),
      section(say("mesh_over_size"), sizeCharts(data.sequences, store)),
      ...others.map((sequence) => sequencePart(sequence, tables, store)),
      variantsPart(data),
      section(say("mesh_how"), ...(["mesh_how_change", "mesh_how_order", "mesh_how_limit", "mesh_how_none"] as const)
        .map((key) => paragraph(say(key), "muted"))),
    ],
  };
}

function sequencePart(sequence: MeshSequence, tables: Tables, store: Store): HTMLElement {
  const seen = sequence.quantities.filter(hasValues);
  return section(sequence.name === "as given" ? say("mesh_as_given") : sequence.name,
    paragraph(sequence.answer, "answer", "en"), notice(sequence.remarks),
    seen.length > 0 ? quantityTable(sequence, seen) : null,
    seen.length > 0 ? element("h3", {}, say("mesh_in_words")) : null,
    list(seen.map(({ sentence }) => sentence), "words"),
    element("h3", {}, say("over_time")), timeCharts(sequence, tables, store));
}

function quantityTable({ runs }: MeshSequence, quantities: MeshQuantity[]): HTMLElement {
  const heads = [say("quantity"), say("unit"), ...runs.map(({ cell }) => `${cell}\u00a0m`),
    ...(["change", "order", "limit", "error", "answer"] as const).map((what) => say(`mesh_${what}`))];
  return table(heads, quantities.map((q): Row => ({
    head: quantityLabel(q.name, q.label), name: q.answer,
    cells: [unitText(q.unit), ...q.values.map((value) => valueText(q, value)), share(q.relative_change),
      q.order_is_usable ? fixed(q.order, 2, "") : "–", valueText(q, q.limit), share(q.relative_error),
      say(`mesh_answer_${q.answer}` as TextKey)],
  })), "unit-second last-is-word");
}

/** Each quantity over the size of the cells, all sequences in one chart; its limit at no size with its error. */
function sizeCharts(sequences: MeshSequence[], store: Store): HTMLElement | null {
  return cards(sequences[0]!.quantities.map((first, number) => {
    if (sequences.some((s) => s.quantities[number]?.values.some(isWord))) return null;
    const lines = sequences.map((sequence, k) => {
      const values = sequence.quantities[number]?.values ?? [];
      const there = values.flatMap((value, r) => (value === null ? [] : [[sequence.runs[r]!.size, value as number]]))
        .sort((a, b) => a[0]! - b[0]!);
      return styled(k, { label: sequence.name === "as given" ? say("mesh_as_given") : sequence.name, marks: true,
        x: there.map(([size]) => size!), y: there.map(([, value]) => value!) });
    });
    const bars = sequences.flatMap(({ quantities }, k) => {
      const { limit, error } = quantities[number] ?? {};
      return typeof limit === "number" && typeof error === "number"
        ? [{ x: 0, y: limit, half: error, colour: (dark: boolean) => runColour(k, dark) }] : [];
    });
    return chart(store, { title: quantityLabel(first.name, first.label), xLabel: say("mesh_size_axis"),
      unit: unitText(first.unit), xFromZero: true, bars }, lines);
  }));
}

function timeCharts({ runs }: MeshSequence, tables: Tables, store: Store): HTMLElement | null {
  const solved = runs.flatMap((run) => {
    const rows = run.over_time && tables.get(run.over_time);
    return rows ? [{ cell: run.cell, rows }] : [];
  });
  const columns = solved[0]?.rows.columns.filter(({ name }) => name !== "time") ?? [];
  return cards(columns.map(({ name, label, unit }) => chart(store,
    { title: quantityLabel(name, label ?? name), xLabel: say("time_axis"), unit: unitText(unit) },
    solved.flatMap(({ cell, rows }, k) => {
      const [x, y] = [rows.column("time"), rows.column(name)];
      return x && y ? [styled(solved.length - 1 - k, { label: `${cell}\u00a0m`, x, y })] : [];
    }))));
}

/** All variants beside each other on the smallest cells that they have in common. */
function variantsPart({ variants, sequences }: ConvergenceMeta): HTMLElement | null {
  if (!variants) return null;
  const heads = [say("quantity"), say("unit"), ...sequences.map(({ name }) =>
    (name === "as given" ? say("mesh_as_given") : name)), say("mesh_range"), say("mesh_share")];
  return section(say("mesh_variants"), paragraph(variants.answer, "answer", "en"),
    table(heads, variants.quantities.map((q): Row => ({
      head: quantityLabel(q.name, q.label), name: q.matters ? "depends" : "same",
      cells: [unitText(q.unit), ...q.values.map((value) => valueText(q, value)), valueText(q, q.range),
        share(q.relative_range)],
    })), "unit-second"));
}
