// Colours of what is drawn on a canvas, light and dark; those of the rest are in style.css.

export interface CanvasTheme {
  ground: string;
  frame: string;
  text: string;
  muted: string;
  ghost: string;
  water: string;
  slit: string; // between points of a section with water
  layer: string; // outlines of soils
  level: string; // the water to hold back
  load: string;
  plane: string; // slip planes of other methods
  slip: string;
  slipEdge: string;
  halo: string;
  mesh: [number, number, number, number];
}

export const LIGHT: CanvasTheme = {
  ground: "#ffffff",
  frame: "#cfd6dd",
  text: "#18212b",
  muted: "#5a6673",
  ghost: "#3c4854",
  water: "#1668c4",
  slit: "#b5a392",
  layer: "#4a3b28",
  level: "#0b3f86",
  load: "#7a2e00",
  plane: "#6a1b9a",
  slip: "#e8175d",
  slipEdge: "rgba(255,255,255,0.9)",
  halo: "rgba(255,255,255,0.85)",
  mesh: [0.76, 0.79, 0.82, 1],
};

export const DARK: CanvasTheme = {
  ground: "#12171d",
  frame: "#39434e",
  text: "#e8edf2",
  muted: "#9aa7b4",
  ghost: "#c6d0da",
  water: "#5aa9ff",
  slit: "#5d5246",
  layer: "#d8c8ae",
  level: "#9cc9ff",
  load: "#ffb27a",
  plane: "#d39bff",
  slip: "#ff5c93",
  slipEdge: "rgba(0,0,0,0.8)",
  halo: "rgba(12,16,20,0.8)",
  mesh: [0.2, 0.235, 0.27, 1],
};

const RUN_LIGHT = ["#0067a5", "#c14f00", "#007a58", "#a8467f", "#6b5b00"];
const RUN_DARK = ["#56b4e9", "#ff9d4d", "#2fc79a", "#e79bc6", "#e5d24a"];

/** Colour of a run in marks, charts and tables. */
export function runColour(index: number, dark: boolean): string {
  const colours = dark ? RUN_DARK : RUN_LIGHT;
  return colours[index % colours.length]!;
}

export function canvasTheme(dark: boolean): CanvasTheme {
  return dark ? DARK : LIGHT;
}

export const FONT = `"Segoe UI", system-ui, -apple-system, "Helvetica Neue", "Noto Sans", ` +
  `"Liberation Sans", Arial, sans-serif`;
