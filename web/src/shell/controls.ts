// What is drawn and how: field, colours, range, layers, layout.

import type { Current } from "../view/current";
import type { Viewer } from "../view/viewer";
import type { RangeMode, ViewState } from "../logic/store";
import { slidesOf, slipAt } from "../logic/slides";
import { mapsFor } from "../logic/colour";
import { element, iconButton } from "./element";

type Flag = "mesh" | "outline" | "slip" | "surfaces" | "names";

export function fieldControls(current: Current): HTMLElement {
  const { store, report } = current;
  const field = element("select", { id: "field", onchange: () => store.set({ field: field.value }) },
    ...report.fieldNames().map((name) => element("option", { value: name }, current.fieldMeta(name)?.label ?? name)));
  const map = element("select", { id: "map", onchange: () => store.set({ map: map.value }) });
  const mode = element("select", { id: "range", onchange: () => chooseMode(current, mode.value as RangeMode) },
    element("option", { value: "run" }, "whole run"), element("option", { value: "frame" }, "this time"),
      element("option", { value: "fixed" }, "fixed"));
  const bound = (k: 0 | 1, label: string) => {
    const input = element("input", { type: "number", step: "any", class: "bound", "aria-label": label, onchange: () => {
      const fixed: [number, number] = [...store.state.fixed];
      if (Number.isFinite(input.valueAsNumber)) fixed[k] = input.valueAsNumber;
      store.set({ fixed });
    } });
    return input;
  };
  const [low, high] = [bound(0, "Lower end of the range"), bound(1, "Upper end of the range")];
  const log = toggle(current, "log", "log scale", "L");
  store.watch(["field"], (state) => {
    field.value = state.field;
    const meta = current.fieldMeta();
    map.replaceChildren(...mapsFor(meta?.kind ?? "sequential").map((m) =>
      element("option", { value: m.name }, m.label)));
    map.value = current.map().name;
    for (const control of [map, mode]) control.disabled = meta?.kind === "category";
    log.hidden = meta?.kind !== "sequential";
  });
  store.watch(["map"], () => (map.value = current.map().name));
  store.watch(["rangeMode", "fixed"], ({ rangeMode, fixed }) => {
    mode.value = rangeMode;
    low.hidden = high.hidden = rangeMode !== "fixed";
    [low.value, high.value] = fixed.map((value) => String(Number(value.toPrecision(4)))) as [string, string];
  });
  return element("div", { class: "controls" }, labelled("Colour by", field), labelled("Map", map),
    labelled("Range", mode), low, high, log);
}

/** A range that becomes fixed begins as the one on show. */
export function chooseMode(current: Current, rangeMode: RangeMode): void {
  const { lo, hi } = current.range();
  current.store.set(rangeMode === "fixed" ? { rangeMode, fixed: [lo, hi] } : { rangeMode });
}

function labelled(text: string, control: HTMLElement): HTMLElement {
  return element("label", {}, element("span", {}, text), control);
}

function toggle(current: Current, key: Flag | "log", text: string, letter: string): HTMLButtonElement {
  const { store } = current;
  const button = element("button",
    { type: "button", class: "toggle", title: `${text} (${letter})`,
    onclick: () => store.set({ [key]: !store.state[key] } as Partial<ViewState>) }, text);
  store.watch([key], (state) => button.setAttribute("aria-pressed", String(state[key])));
  return button;
}

export function layerControls(current: Current, viewer: Viewer): HTMLElement {
  const { store, report } = current;
  const runs = report.runs;
  const buttons = [toggle(current, "mesh", "mesh", "M"), toggle(current, "outline", "outline", "O")];
  if (runs.some((run) => slipAt(slidesOf(run.meta), Infinity))) buttons.push(toggle(current, "slip", "slip surface",
    "S"));
  if (runs.some((run) => run.histories.length > 0)) buttons.push(toggle(current, "names", "named points", "N"));
  if (runs.length > 1) buttons.push(toggle(current, "surfaces", "other surface", "D"));
  const size = element("input",
    { type: "range", min: 0.4, max: 2, step: 0.1, class: "point-size", "aria-label": "Size of the points",
    oninput: () => store.set({ pointScale: size.valueAsNumber }) });
  store.watch(["pointScale"], ({ pointScale }) => (size.value = String(pointScale)));
  return element("div", { class: "controls" }, element("span", { class: "caption" }, "Show"), ...buttons,
    element("label", {}, element("span", {}, "Points"), size),
      ...(runs.length > 1 ? [runChoice(current, viewer), layoutChoice(current)] : []));
}

function runChoice(current: Current, viewer: Viewer): HTMLElement {
  const { store, report } = current;
  if (report.runs.length < 3) return element("span", { hidden: true });
  return element("span", { class: "group" }, ...report.runs.map((_, k) => {
    const button = element("button", { type: "button", class: "toggle", onclick: () => {
      const shown = store.state.shown.map((on, other) => (other === k ? !on : on));
      if (shown.some(Boolean)) store.set({ shown });
    } }, viewer.labels[k]!);
    store.watch(["shown"], ({ shown }) => button.setAttribute("aria-pressed", String(shown[k])));
    return button;
  }));
}

function layoutChoice(current: Current): HTMLElement {
  const { store } = current;
  const select = element("select",
    { id: "layout", onchange: () => store.set({ layout: select.value as ViewState["layout"] }) },
    element("option", { value: "auto" }, "as fits"), element("option", { value: "columns" }, "side by side"),
      element("option", { value: "rows" }, "stacked"));
  store.watch(["layout"], ({ layout }) => (select.value = layout));
  return labelled("Views", select);
}

export function zoomButtons(current: Current, viewer: Viewer): HTMLElement {
  return element("div", { class: "zoom" },
    iconButton("plus", "Zoom in", "+", () => viewer.zoom(1.3)),
    iconButton("minus", "Zoom out", "−", () => viewer.zoom(1 / 1.3)),
    iconButton("fit", "Show all", "0", () => current.store.set({ camera: null })));
}
