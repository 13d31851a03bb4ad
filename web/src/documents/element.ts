// Element tests: the path of the stress, stress over strain and volume over pressure, of each material a curve.

import { drawCurves, type Axis } from "../charts/curve";
import type { ElementMeta, Tables } from "../data/documents";
import type { Table } from "../data/table";
import type { Store } from "../logic/store";
import { say, type TextKey } from "../logic/texts";
import { element } from "../shell/element";
import { runColour } from "../view/theme";
import { cards, notice, section, type Content } from "./document";

interface Picture {
  title: TextKey;
  x: string;
  y: string;
  log?: boolean; // of x
}

const PICTURES: Picture[] = [
  { title: "element_path", x: "mean_pressure", y: "deviator" },
  { title: "element_deviator", x: "deviator_strain", y: "deviator" },
  { title: "element_void_ratio", x: "mean_pressure", y: "void_ratio", log: true },
  { title: "element_volume_over_p", x: "mean_pressure", y: "volume_strain", log: true },
  { title: "element_volume", x: "deviator_strain", y: "volume_strain" },
  { title: "element_water", x: "deviator_strain", y: "pore_pressure" },
  { title: "element_shear", x: "strain_xy", y: "stress_xy" },
];
const LABELS: Record<string, TextKey> = {
  mean_pressure: "element_p", deviator: "element_q", deviator_strain: "element_strain", void_ratio: "element_e",
  volume_strain: "element_volume_strain", pore_pressure: "element_u", strain_xy: "element_shear_strain",
  stress_xy: "element_tau",
};
const LEAST = 1e-9; // change, over the size or over 1, that is no round-off

/** Whether there is anything to see: a column that stays where it began is none. */
function moves(rows: Table, name: string): boolean {
  const values = rows.column(name);
  return values !== null && values.some((value) => Math.abs(value - values[0]!) > LEAST * Math.max(1, Math.abs(value)));
}

export function elementPage(data: ElementMeta, tables: Tables, store: Store): Content {
  const elements = data.elements.map((one) => ({ ...one, rows: tables.get(one.rows)! }));
  const has_e = elements.some(({ rows }) => rows.has("void_ratio"));
  const axis = (name: string, log = false): Axis =>
    ({ label: say(LABELS[name]!), unit: elements[0]!.rows.unit(name), log });
  const pictures = PICTURES.filter(({ title }) => title !== "element_volume_over_p" || !has_e);
  const made = pictures.map(({ title, x, y, log }) => {
    const shown = elements.map((one, k) => ({ ...one, k })).filter(({ rows }) => moves(rows, x) && moves(rows, y));
    if (shown.length === 0) return null;
    const draw = (dark: boolean) => drawCurves({ title: say(title), x: axis(x, log), y: axis(y) },
      shown.map(({ material, rows, k }) =>
        ({ label: material, x: rows.column(x)!, y: rows.column(y)!, colour: runColour(k, dark) })));
    const card = element("article", { class: "card" }, draw(store.state.dark));
    store.on((state, changed) => changed.has("dark") && card.replaceChildren(draw(state.dark)));
    return card;
  });
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
