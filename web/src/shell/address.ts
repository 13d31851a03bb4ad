// What the reader looks at, in the address behind "#": survives a reload of the page (of a run under way, say) and can
// be sent along.

import type { Store, ViewState } from "../logic/store";

type Kept = Partial<Pick<ViewState,
  "time" | "field" | "map" | "rangeMode" | "fixed" | "log" | "mesh" | "layers" | "water" | "outline" | "slip" |
  "surfaces" |
  "names" | "camera" | "profileX">>;

const FLAGS = ["log", "mesh", "layers", "water", "outline", "slip", "surfaces", "names"] as const;

/** language: the one that the reader chose; null: none. */
export function toHash(state: ViewState, language: string | null = null): string {
  const parts = new URLSearchParams({ t: state.time.toPrecision(6), field: state.field, map: state.map,
    range: state.rangeMode });
  if (state.rangeMode === "fixed") parts.set("fixed", state.fixed.join("_"));
  if (state.camera) parts.set("camera",
    [state.camera.x, state.camera.y, state.camera.scale].map((v) => Number(v.toPrecision(6))).join("_"));
  if (state.profileX !== null) parts.set("x", String(Number(state.profileX.toPrecision(6))));
  if (language) parts.set("lang", language);
  parts.set("show", FLAGS.filter((flag) => state[flag]).join("_"));
  return `#${parts.toString()}`;
}

/** Only what can be understood; the rest stays as it was. */
export function fromHash(hash: string, fields: readonly string[], span: [number, number]): Kept {
  const parts = new URLSearchParams(hash.replace(/^#/, ""));
  const kept: Kept = {};
  const time = Number(parts.get("t") ?? NaN);
  if (Number.isFinite(time)) kept.time = Math.min(span[1], Math.max(span[0], time));
  const field = parts.get("field");
  if (field && fields.includes(field)) kept.field = field;
  const map = parts.get("map");
  if (map) kept.map = map;
  const range = parts.get("range");
  if (range === "run" || range === "frame" || range === "fixed") kept.rangeMode = range;
  const numbers = (key: string) => (parts.get(key) ?? "").split("_").map(Number);
  const fixed = numbers("fixed");
  if (fixed.length === 2 && fixed.every(Number.isFinite)) kept.fixed = fixed as [number, number];
  else if (kept.rangeMode === "fixed") delete kept.rangeMode;
  const [x, y, scale, ...more] = numbers("camera");
  if (more.length === 0 && [x, y, scale].every(Number.isFinite) && scale! > 0) kept.camera = { x: x!, y: y!,
    scale: scale! };
  const profile = Number(parts.get("x") ?? NaN);
  if (Number.isFinite(profile)) kept.profileX = profile;
  const show = parts.get("show");
  if (show !== null) for (const flag of FLAGS) kept[flag] = show.split("_").includes(flag);
  return kept;
}

/** The language that the reader chose; null: none. */
export function languageIn(hash: string): string | null {
  return new URLSearchParams(hash.replace(/^#/, "")).get("lang");
}

/** Opens the page anew in another language, with what is on show; store: null where nothing can be chosen. */
export function openIn(store: Store | null, language: string): void {
  history.replaceState(null, "", store ? toHash(store.state, language) : `#lang=${language}`);
  location.reload();
}

/** Takes what the address says, then keeps it up to date while nothing plays. */
export function keepInAddress(store: Store, fields: readonly string[], span: [number, number]): void {
  const { field, ...rest } = fromHash(location.hash, fields, span);
  if (field) store.set({ field }); // sets range and scale of its own, which the rest may change
  store.set(rest);
  let waiting = 0;
  store.on(() => {
    clearTimeout(waiting);
    waiting = window.setTimeout(() => !store.state.playing && history.replaceState(null, "",
      toHash(store.state, languageIn(location.hash))), 300);
  });
}
