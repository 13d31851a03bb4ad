// What is drawn and how: field, colours, range, layers, layout.

import type { Current } from "../view/current";
import type { Viewer } from "../view/viewer";
import type { RangeMode, ViewState } from "../logic/store";
import { slidesOf, slipAt } from "../logic/slides";
import { say } from "../logic/texts";
import { mapLabel, mapsFor } from "../logic/colour";
import { fieldLabel } from "../view/colour_bar";
import type { Run } from "../data/run";
import { element, iconButton } from "./element";

type Flag = "mesh" | "layers" | "water" | "outline" | "slip" | "surfaces" | "names";

export function fieldControls(current: Current): HTMLElement {
  const { store, report } = current;
  const field = element("select", { id: "field", onchange: () => store.set({ field: field.value }) },
    ...report.fieldNames().map((name) => element("option", { value: name }, fieldLabel(current, name))));
  const map = element("select", { id: "map", onchange: () => store.set({ map: map.value }) });
  const mode = element("select", { id: "range", onchange: () => chooseMode(current, mode.value as RangeMode) },
    element("option", { value: "run" }, say("range_run")), element("option", { value: "frame" }, say("range_frame")),
      element("option", { value: "fixed" }, say("range_fixed")));
  const bound = (k: 0 | 1, label: string) => {
    const input = element("input", { type: "number", step: "any", class: "bound", "aria-label": label, onchange: () => {
      const fixed: [number, number] = [...store.state.fixed];
      if (Number.isFinite(input.valueAsNumber)) fixed[k] = input.valueAsNumber;
      store.set({ fixed });
    } });
    return input;
  };
  const [low, high] = [bound(0, say("range_low")), bound(1, say("range_high"))];
  const log = toggle(current, "log", say("log"), "L");
  store.watch(["field"], (state) => {
    field.value = state.field;
    const meta = current.fieldMeta();
    map.replaceChildren(...mapsFor(meta?.kind ?? "sequential").map((m) =>
      element("option", { value: m.name }, mapLabel(m))));
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
  return element("div", { class: "controls" }, labelled(say("colour_by"), field), labelled(say("map"), map),
    labelled(say("range"), mode), low, high, log);
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
  const buttons = [toggle(current, "mesh", say("mesh"), "M")];
  const add = (key: Flag, letter: string, wanted: (run: Run) => unknown) => {
    if (runs.some(wanted)) buttons.push(toggle(current, key, say(key), letter));
  };
  add("layers", "Y", (run) => run.layers.length > 0);
  add("water", "W", (run) => run.meta.water || run.loads.length > 0);
  add("outline", "O", () => true);
  add("slip", "S", (run) => slipAt(slidesOf(run.meta), Infinity) || run.meta.slip_planes.length > 0);
  add("names", "N", (run) => run.histories.length > 0);
  add("surfaces", "D", () => runs.length > 1);
  const size = element("input",
    { type: "range", min: 0.4, max: 2, step: 0.1, class: "point-size", "aria-label": say("point_size"),
    oninput: () => store.set({ pointScale: size.valueAsNumber }) });
  store.watch(["pointScale"], ({ pointScale }) => (size.value = String(pointScale)));
  return element("div", { class: "controls" }, element("span", { class: "caption" }, say("show")), ...buttons,
    element("label", {}, element("span", {}, say("points")), size),
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
    element("option", { value: "auto" }, say("as_fits")),
    element("option", { value: "columns" }, say("side_by_side")),
    element("option", { value: "rows" }, say("stacked")));
  store.watch(["layout"], ({ layout }) => (select.value = layout));
  return labelled(say("views"), select);
}

export function zoomButtons(current: Current, viewer: Viewer): HTMLElement {
  return element("div", { class: "zoom" },
    iconButton("plus", say("zoom_in"), "+", () => viewer.zoom(1.3)),
    iconButton("minus", say("zoom_out"), "−", () => viewer.zoom(1 / 1.3)),
    iconButton("fit", say("show_all"), "0", () => current.store.set({ camera: null })));
}
