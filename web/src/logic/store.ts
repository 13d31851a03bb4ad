// What the reader has chosen, in one place. Listeners learn at once which keys changed, and may draw later.

import type { Camera } from "./camera";

export type RangeMode = "run" | "frame" | "fixed";

export interface Pin {
  run: number;
  point: number; // index among the shown points
}

export interface ViewState {
  time: number; // s
  playing: boolean;
  again: boolean; // begin again at the end
  speed: number; // s of the run per s of the viewer
  field: string;
  map: string;
  rangeMode: RangeMode;
  fixed: [number, number];
  log: boolean;
  mesh: boolean;
  layers: boolean; // outlines and names of soils
  water: boolean; // and loads
  outline: boolean;
  slip: boolean;
  surfaces: boolean;
  names: boolean;
  pointScale: number;
  profileX: number | null; // m, where the strength profile is taken
  camera: Camera | null; // null: fitted to all runs
  layout: "auto" | "rows" | "columns";
  hover: Pin | null;
  pin: Pin | null;
  shown: boolean[]; // runs that are shown
  dark: boolean;
  paper: boolean; // laid out for a print
}

/** Where nothing is chosen yet. */
export const PLAIN: ViewState = {
  time: 0, playing: false, again: false, speed: 1, field: "", map: "auto", rangeMode: "run", fixed: [0, 1], log: false,
  mesh: false, layers: true, water: true, outline: true, slip: true, surfaces: false, names: false, pointScale: 1,
  profileX: null, camera: null, layout: "auto", hover: null, pin: null, shown: [], dark: false, paper: false,
};

/** Pixels of a canvas per CSS pixel; on paper 240 per inch. */
export function pixelRatio({ paper }: ViewState): number {
  return paper ? 2.5 : window.devicePixelRatio || 1;
}

export type Listener = (state: ViewState, changed: Set<keyof ViewState>) => void;

export class Store {
  private readonly listeners: Listener[] = [];

  constructor(public state: ViewState) {}

  set(change: Partial<ViewState>): void {
    const keys = (Object.keys(change) as (keyof ViewState)[]).filter((key) => !Object.is(this.state[key], change[key]));
    if (keys.length === 0) return;
    this.state = { ...this.state, ...change };
    const changed = new Set(keys);
    for (const listener of this.listeners) listener(this.state, changed);
  }

  on(listener: Listener): void {
    this.listeners.push(listener);
  }

  /** Calls the listener now, and whenever one of the keys changes. */
  watch(keys: (keyof ViewState)[], listener: (state: ViewState) => void): void {
    this.on((state, changed) => {
      if (keys.some((key) => changed.has(key))) listener(state);
    });
    listener(this.state);
  }
}
