// Charts of what the program wrote over time: front and crest, energies, named points, free surfaces, time per pass.

import type { Report } from "../data/report";
import type { Current } from "../view/current";
import type { Run } from "../data/run";
import { Chart, DASHES, type Line } from "../charts/chart";
import { CATEGORIES, lineColour } from "../logic/colour";
import { runLabels, spoken } from "../logic/labels";
import { quantityLabel } from "../logic/quantities";
import { say } from "../logic/texts";
import type { Table } from "../data/table";
import { durationText, numberText } from "../logic/numbers";
import { heightsAt, places } from "../logic/surface";
import { runColour } from "../view/theme";
import { element } from "../shell/element";
import { heightCards } from "./profile";
import { coloured } from "./summary";


export function chartsSection(current: Current): HTMLElement {
  const { report } = current;
  const labels = runLabels(report.runs.map((run) => run.meta));
  const cards = [...heightCards(current), frontAndCrest(current, labels), kinetic(current, labels),
    surfaces(current, labels), ...energies(current, labels)];
  return element("section", { id: "charts", "aria-labelledby": "charts-title" },
    element("h2", { id: "charts-title" }, say("over_time")),
    element("p", { class: "muted no-print" }, say("charts_help")),
    element("div", { class: "cards" }, ...cards.filter((card) => card !== null)),
    histories(current, labels),
    passes(report, labels, current));
}

/** None if the column holds no number, as of a slope that is not there. */
function runLine(run: Run, label: string, column: string, dash?: number[]): Line | null {
  const [x, y] = [run.series?.column("time"), run.series?.column(column)];
  return x && y?.some((value) => Number.isFinite(value))
    ? { label, x, y, dash, colour: (dark) => runColour(run.index, dark) } : null;
}

/** The label of the program, in the language of the page. */
function columnLabel(table: Table, name: string): string {
  const label = table.label(name);
  return quantityLabel(name, label === name ? spoken(name) : label);
}

function present(lines: (Line | null)[]): Line[] {
  return lines.filter((line): line is Line => line !== null);
}

function card(chart: Chart, ...more: (HTMLElement | null)[]): HTMLElement {
  return element("article", { class: "card" }, ...more, chart.root);
}

function named(labels: string[], run: Run, what: string): string {
  return labels.length > 1 ? `${what}, ${labels[run.index]}` : what;
}

function frontAndCrest(current: Current, labels: string[]): HTMLElement | null {
  const lines = present(current.report.runs.flatMap((run) => [
    runLine(run, named(labels, run, say("front")), "front_x", DASHES[0]),
    runLine(run, named(labels, run, say("crest")), "crest_x", DASHES[1]),
    runLine(run, named(labels, run, say("front_left")), "front_left_x", DASHES[2]),
    runLine(run, named(labels, run, say("crest_left")), "crest_left_x", DASHES[3]),
  ]));
  if (lines.length === 0) return null;
  const chart = new Chart(current.store,
    { title: say("chart_front"), xLabel: say("time_axis"), yLabel: "x", unit: "m" });
  chart.show(lines);
  return card(chart);
}

function kinetic(current: Current, labels: string[]): HTMLElement | null {
  const column = (run: Run) => (run.series?.has("kinetic_nodal") ? "kinetic_nodal" : "kinetic");
  const several = (run: Run) => column(run) !== "kinetic";
  const lines = present(current.report.runs.flatMap((run) => [
    runLine(run, named(labels, run, say(several(run) ? "of_nodes" : "of_points")), column(run)),
    several(run) ? runLine(run, named(labels, run, say("of_points")), "kinetic", DASHES[1]) : null,
  ]));
  if (lines.length === 0) return null;
  const chart = new Chart(current.store,
    { title: say("chart_kinetic"), xLabel: say("time_axis"), unit: unitOf(current.report, column), fromZero: true });
  chart.show(lines);
  return card(chart);
}

function unitOf(report: Report, column: (run: Run) => string): string {
  for (const run of report.runs) if (run.series?.has(column(run))) return run.series.unit(column(run));
  return "-";
}

/** One chart of all energies per run. */
function energies(current: Current, labels: string[]): HTMLElement[] {
  return current.report.runs.flatMap((run) => {
    const { series } = run;
    if (!series) return [];
    const x = series.column("time");
    const columns = series.columns.filter(({ name, unit }) => /^[kM]?J/.test(unit) && name !== "kinetic_nodal"
      && series.column(name)!.some((v) => v !== 0));
    if (!x || columns.length === 0) return [];
    const lines = columns.map(({ name }, k): Line => ({
      label: columnLabel(series, name), x, y: series.column(name)!,
      colour: (dark) => lineColour(k, dark), dash: /^(numerical|unexplained)$/.test(name) ? [2, 3] : undefined,
    }));
    const title = `${say("chart_energy")}${labels.length > 1 ? `, ${labels[run.index]}` : ""}`;
    const chart = new Chart(current.store, { title, xLabel: say("time_axis"), unit: columns[0]!.unit });
    chart.show(lines);
    return [withClass("energy", card(chart))];
  });
}

function withClass(name: string, made: HTMLElement): HTMLElement {
  made.classList.add(name);
  return made;
}

/** Free surfaces at the present time, and the second less the first. */
function surfaces(current: Current, labels: string[]): HTMLElement | null {
  const runs = current.report.runs.filter((run) => run.meta.surfaces);
  if (runs.length === 0) return null;
  let [low, high] = [0, 0];
  const all = runs.flatMap((run) => run.meta.times.map((_, f) => run.surface(f)));
  for (const line of all) for (let k = 1; k < line.length; k += 2) [low, high] =
    [Math.min(low, line[k]!), Math.max(high, line[k]!)];
  if (runs.length > 1) low = Math.min(low, -0.45 * high);
  const chart = new Chart(current.store,
    { title: say("chart_surface"), xLabel: "x [m]", yLabel: "y", unit: "m", overTime: false,
      yRange: [low, 1.05 * high] });
  let drawn = "";
  current.store.watch(["time"], ({ time }) => {
    const frames = runs.map((run) => current.frame(run, time)).join();
    if (frames === drawn) return;
    drawn = frames;
    const lines = runs.map((run) => run.surface(current.frame(run, time)));
    const x = places(lines);
    const heights = lines.map((line) => heightsAt(line, x));
    const shown = runs.map((run, k): Line =>
      ({ label: labels[run.index]!, x, y: heights[k]!, colour: (dark) => runColour(run.index, dark), width: 2 }));
    if (runs.length > 1) {
      const difference = x.map((_, k) =>
        (heights[1]![k] === null || heights[0]![k] === null ? null : heights[1]![k]! - heights[0]![k]!));
      shown.push({ label: `${labels[runs[1]!.index]} − ${labels[runs[0]!.index]}`, x, y: difference,
        colour: () => "#8a94a0", dash: [3, 3] });
    }
    chart.title = say(runs.length > 1 ? "chart_surfaces_at" : "chart_surface_at",
      { time: `${numberText(time, 3)}\u00a0s` });
    chart.show(shown);
  });
  return withClass("surfaces", card(chart));
}

/** Named points: one chart per run with the same scale, the quantity to be chosen. */
function histories(current: Current, labels: string[]): HTMLElement | null {
  const runs = current.report.runs.filter((run) => run.histories.length > 0);
  const first = runs[0]?.histories[0]?.table;
  if (!first) return null;
  const names = first.columns.map((column) => column.name).filter((name) => !["time", "id"].includes(name));
  const charts = runs.map((run) =>
    new Chart(current.store, { title: labels[run.index]!, xLabel: say("time_axis"), unit: "-", height: 260 }));
  const quantity = (name: string) => columnLabel(first, name);
  const select = element("select", { id: "history", onchange: () => show(select.value) },
    ...names.map((name) => element("option", { value: name }, quantity(name))));
  const show = (name: string) => {
    const lines = runs.map((run) => run.histories.flatMap((history, k): Line[] => {
      const [x, y] = [history.table.column("time"), history.table.column(name)];
      return x && y ? [{ label: history.name, x, y, colour: (dark) => lineColour(k, dark),
        dash: k >= CATEGORIES.length ? [4, 3] : undefined, width: 1.8 }] : [];
    }));
    const yRange = commonRange(lines.flat());
    charts.forEach((chart, k) => {
      chart.title = `${labels[runs[k]!.index]}: ${quantity(name)}`;
      chart.show(lines[k]!, { unit: first.unit(name), yRange, nameEnds: true });
    });
  };
  select.value = names.find((name) => name === "eps_deviatoric") ?? names.find((name) => name.startsWith("eps"))
    ?? names[0]!;
  show(select.value);
  return element("div", { class: "histories" },
    element("div", { class: "heading" }, element("h3", {}, say("named_points")),
      element("label", { class: "no-print" }, element("span", {}, say("quantity")), select)),
    element("div", { class: "cards" },
      ...charts.map((chart, k) =>
      element("article", { class: "card" }, coloured(chart.root, runs[k]!, current.store)))));
}

function commonRange(lines: Line[]): [number, number] {
  let [lo, hi] = [Infinity, -Infinity];
  for (const { y } of lines) {
    for (let k = 0; k < y.length; k++) {
      const value = y[k];
      if (value === null || value === undefined || !Number.isFinite(value)) continue;
      [lo, hi] = [Math.min(lo, value), Math.max(hi, value)];
    }
  }
  if (!(hi >= lo)) return [0, 1];
  const room = 0.04 * (hi - lo || Math.abs(hi) || 1);
  return [lo >= 0 && lo < 0.2 * hi ? 0 : lo - room, hi + room];
}

/** Where the wall time of each run went, as bars. */
function passes(report: Report, labels: string[], current: Current): HTMLElement | null {
  const runs = report.runs.filter((run) => run.meta.passes.length > 0);
  if (runs.length === 0) return null;
  const longest = Math.max(...runs.flatMap((run) => run.meta.passes.map((pass) => pass.seconds)));
  const cards = runs.map((run) => {
    const total = run.meta.passes.reduce((sum, pass) => sum + pass.seconds, 0);
    const rows = run.meta.passes.map(({ name, seconds }) => {
      const bar = element("div", { class: "bar" });
      bar.style.width = `${(100 * seconds) / longest}%`;
      return element("tr", {}, element("th", { scope: "row" }, quantityLabel(name, name)),
        element("td", { class: "bar-cell" }, bar),
        element("td", {}, durationText(seconds)), element("td", {}, `${Math.round((100 * seconds) / total)}\u202f%`));
    });
    return coloured(element("article", { class: "card" }, element("h4", {}, labels[run.index]!),
      element("table", { class: "bars" }, element("tbody", {}, ...rows))), run, current.store);
  });
  return element("div", { class: "passes" }, element("h3", {}, say("passes")),
    element("div", { class: "cards" }, ...cards));
}
