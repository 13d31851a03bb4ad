// How sure the verdict is: what stands beside it of other runs and of the import. Only what the program found: a row
// that nobody looked for is not there, but for the two that an engineer must ask, the factor and what decides.

import type { RunMeta, Stability } from "../data/format";
import type { Report } from "../data/report";
import type { Run } from "../data/run";
import { runLabels, withSoilName } from "../logic/labels";
import { fixed, metres, numberText } from "../logic/numbers";
import type { Store } from "../logic/store";
import { currentLanguage, say } from "../logic/texts";
import { doubts, hasWater, kindOf } from "../logic/verdict";
import { element } from "../shell/element";
import { coloured } from "./summary";

export interface Sureness {
  name: string;
  value: string;
  note: string;
  tone: "good" | "warn" | "unknown";
}

const FEWEST_CELLS = 5; // over the depth of what moves: with fewer the cells are too large to say
const ENOUGH_CELLS = 10;

/** Rows of the panel, in the order in which an engineer asks. */
export function surenessOf(run: Run): Sureness[] {
  const { meta } = run;
  return [verdictRow(run), factorRow(meta.stability), ...meshRows(meta.stability), dependsRow(meta)];
}

function verdictRow(run: Run): Sureness {
  const kind = kindOf(run);
  const unsure = ["near", "still_moving", "running", "none"].includes(kind) || doubts(run).length > 0;
  return { name: say("sure_verdict"), value: say(`verdict_${kind}`),
    note: kind === "near" ? say("sure_near") : unsure ? say("sure_doubts", { n: doubts(run).length }) : "",
    tone: unsure ? "warn" : "good" };
}

function factorRow(stability: Stability | null | undefined): Sureness {
  const factor = stability?.factor_of_safety;
  if (typeof factor !== "number")
    return { name: say("sure_factor"), value: say("sure_not_looked_for"), note: say("sure_factor_how"),
      tone: "unknown" };
  const { uncertainty } = stability!;
  return { name: say("sure_factor"),
    value: fixed(factor, 2, "") + (uncertainty === null ? "" : ` ± ${fixed(uncertainty, 2, "")}`),
    note: say("sure_factor_is"), tone: factor < 1.1 ? "warn" : "good" };
}

/** Of the search for the factor: how finely what moves is resolved, and what the cells add. */
function meshRows(stability: Stability | null | undefined): Sureness[] {
  const mesh = stability?.mesh;
  if (!mesh) return [];
  const cells = mesh.cells_over_depth;
  const rows: Sureness[] = [{ name: say("sure_cells"), value: say("sure_cells_of",
    { n: fixed(cells, 1, ""), cell: metres(mesh.cell) }), note: cells < FEWEST_CELLS ? say("sure_cells_few") : "",
    tone: cells < ENOUGH_CELLS ? "warn" : "good" }];
  const found = mesh.extrapolated;
  if (found) rows.push({ name: say("sure_mesh"), value: say("low_to_high",
    { low: fixed(found.low, 2, ""), high: fixed(found.high, 2, "") }), note: say("sure_mesh_measured"), tone: "good" });
  else if (typeof mesh.largest_error === "number")
    rows.push({ name: say("sure_mesh"), note: say("sure_mesh_how"), tone: "warn",
      value: say("sure_mesh_up_to", { percent: numberText(100 * mesh.largest_error, 2) }) });
  return rows;
}

function dependsRow({ depends }: RunMeta): Sureness {
  const name = say("sure_turns_on");
  if (!depends) return { name, value: say("sure_not_looked_for"), note: say("sure_depends_how"), tone: "unknown" };
  const { turns_on: inputs, does_not_turn_on: others } = depends;
  return { name, value: inputs.length > 0 ? inputs.join(", ") : say("sure_nothing"),
    note: others.length > 0 ? say("sure_not_on", { others: others.join(", ") }) : "",
    tone: inputs.length > 0 ? "warn" : "good" };
}

/** What the import assumed, each with how to change it. */
export function assumedOf(meta: RunMeta): { text: string; how: string }[] {
  return (meta.assumed?.[currentLanguage()] ?? []).map((text, k) => {
    const english = meta.assumed?.en?.[k] ?? text;
    const change = WAYS.find(([words]) => words.test(english));
    return { text: withSoilName(text, meta.materials), how: change ? say(change[1]) : say("change_case") };
  });
}

const WAYS = [[/defaults? of/i, "change_defaults"], [/film/, "change_film"], [/outer metre|face/, "change_face"],
  [/river/i, "change_river"], [/grid of yield stresses|cells/, "change_cell"], [/s_u is at least/, "change_least"],
  [/reduced to/, "change_reduced"], [/held/, "change_held"]] as const satisfies
  readonly (readonly [RegExp, Parameters<typeof say>[0]])[];

export function howSureSection(report: Report, store: Store): HTMLElement | null {
  const runs = report.runs.filter(hasWater);
  if (runs.length === 0) return null;
  const labels = runLabels(report.runs.map((run) => run.meta));
  return element("section", { id: "how-sure", "aria-labelledby": "how-sure-title" },
    element("h2", { id: "how-sure-title" }, say("how_sure")),
    element("div", { class: "cards" }, ...runs.map((run) => element("article", { class: "card how-sure" },
      report.runs.length > 1 ? coloured(element("h3", {}, labels[run.index]!), run, store) : null,
      element("dl", { class: "pairs" }, ...surenessOf(run).map(({ name, value, note, tone }) =>
        element("div", { class: `sure ${tone}` }, element("dt", {}, name),
          element("dd", {}, element("b", {}, value), note ? element("span", {}, ` ${note}`) : null)))),
      assumedPart(run)))));
}

function assumedPart({ meta }: Run): HTMLElement | null {
  const rows = assumedOf(meta);
  if (rows.length === 0) return null;
  return element("details", { class: "assumed" }, element("summary", {}, say("assumed", { n: rows.length })),
    element("table", {}, element("thead", {}, element("tr", {}, element("th", {}, say("assumed_what")),
      element("th", {}, say("assumed_how")))),
    element("tbody", {}, ...rows.map(({ text, how }) => element("tr", {}, element("td", {}, text),
      element("td", {}, how))))));
}
