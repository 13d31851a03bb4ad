// Element tests: q over p, q over the deviator strain, the volume over the pressure, and the stress of shear, of each
// material a line.

import type { ElementMeta, Tables } from "../data/documents";
import type { Table } from "../data/table";
import type { Store } from "../logic/store";
import { say, type TextKey } from "../logic/texts";
import { cards, chart, notice, section, styled, type Content } from "./document";

interface Picture {
  title: TextKey;
  x: string;
  xLabel: TextKey;
  y: string;
  unit: string;
  by?: (value: number) => number; // of x
}

const KPA = (value: number) => value / 1e3;
const LOG = (value: number) => (value > 0 ? Math.log10(value / 1e3) : NaN);
const PICTURES: Picture[] = [
  { title: "element_path", x: "mean_pressure", xLabel: "element_p", y: "deviator", unit: "Pa", by: KPA },
  { title: "element_deviator", x: "deviator_strain", xLabel: "element_strain", y: "deviator", unit: "Pa" },
  { title: "element_void_ratio", x: "mean_pressure", xLabel: "element_log_p", y: "void_ratio", unit: "-", by: LOG },
  { title: "element_volume_over_p", x: "mean_pressure", xLabel: "element_log_p", y: "volume_strain", unit: "-", by: LOG },
  { title: "element_volume", x: "deviator_strain", xLabel: "element_strain", y: "volume_strain", unit: "-" },
  { title: "element_water", x: "deviator_strain", xLabel: "element_strain", y: "pore_pressure", unit: "Pa" },
  { title: "element_shear", x: "strain_xy", xLabel: "element_shear_strain", y: "stress_xy", unit: "Pa" },
];

/** Whether there is anything to see: a column that stays where it began is none. */
function moves(rows: Table, name: string): boolean {
  const values = rows.column(name);
  return values !== undefined && values !== null && Array.from(values).some((v) => Number.isFinite(v) && v !== values[0]);
}

export function elementPage(data: ElementMeta, tables: Tables, store: Store): Content {
  const elements = data.elements.map((element) => ({ ...element, rows: tables.get(element.rows)! }));
  const made = PICTURES.map(({ title, x, xLabel, y, unit, by }) => chart(store,
    { title: say(title), xLabel: say(xLabel), unit },
    elements.flatMap(({ material, rows }, k) => {
      if (!moves(rows, y) || !moves(rows, x) || (y === "volume_strain" && by && rows.column("void_ratio"))) return [];
      return [styled(k, { label: material, x: Array.from(rows.column(x)!, by ?? ((v) => v)), y: rows.column(y)! })];
    })));
  return {
    title: data.title,
    window: data.title,
    subtitle: elements.map(({ material, law }) => `${material}: ${law}`).join(", "),
    foot: "element_foot",
    parts: [
      notice(elements.filter(({ fault }) => fault !== "").map(({ material, fault }) => `${material}: ${fault}`)),
      section(say("element_pictures"), cards(made)),
    ],
  };
}
