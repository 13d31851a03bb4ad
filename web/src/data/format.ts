// The JSON of a report, format 2, as src/page of the C++ program writes it. SI units, unless a `unit` says otherwise.

/** Numbers frame by frame, each from that of the frame and of the point before; or point by point, as they are. */
export type Layout = "frame" | "point";

/** A quantity per frame and point, 16 bits each; see data/quantised.ts. */
export interface QuantisedMeta {
  chunk: number | null; // null: the distance of a point from its place in the first frame
  layout?: Layout; // of the bytes of the chunk
  lo: number;
  hi: number;
  log: boolean;
  frames: number;
  points: number;
  static: boolean;
}

export type FieldKind = "sequential" | "diverging" | "category";

export interface FieldMeta {
  name: string;
  symbol: string;
  label: string;
  unit: string;
  kind: FieldKind;
  log: boolean;
  range: [number, number];
  precision: number;
  data: QuantisedMeta;
}

export interface ColumnMeta {
  name: string;
  label?: string;
  unit: string;
}

/** float32, column by column. */
export interface TableMeta {
  columns: ColumnMeta[];
  chunk: number;
  rows: number;
}

export interface HistoryMeta extends TableMeta {
  name: string;
  x: number;
  y: number;
}

export interface Place {
  x: number | null;
  y: number | null;
}

export interface Slide {
  facing?: "right" | "left"; // of the slope that slides
  stage?: string; // in which it began; empty: of none
  begins: number | null;
  stops?: number | null;
  crest_from?: number | null; // the edge of a column, as crest_to
  crest_edge?: number | null; // of the first slide of a slope: the corner of the drawing that this edge stands for
  crest_to?: number | null;
  kinetic_peak?: number | null; // J/m
  entry?: EntryPoint | null;
  slip_surface?: SlipSurface | null;
}

/** Upper end of a slip surface, on the ground of t = 0. */
export interface EntryPoint {
  x: number;
  y: number;
  zone: "beyond_crest" | "crest" | "upper_half" | "lower_half"; // of the slope that slides
}

export interface SlipSurface {
  time: number | null;
  points: [number, number][];
}

/** What was done to make the section fail: the verdict is not that of the section as it is. */
export interface Trigger {
  stage: string; // with which it began
  at_strength: number; // by which strengths were divided
  river: number | null; // m, to which it was brought
  before: "stands" | "damaged" | "near" | "floods" | null; // null: it acts in the whole run
}

export interface Flood {
  verdict: "stands" | "damaged" | "still_moving" | "near" | "floods" | null; // null: not ended, and no flood so far
  water_level?: number | null; // m
  river?: "left" | "right" | null; // end of the section
  residual_height: number | null; // m, of the highest ground at the end
  freeboard: number | null; // m, of it over the water
  width_at_level: number | null; // m
  intact_width: number | null; // m, of that
  first_time_damaged: number | null; // s
  first_time_below: number | null; // s
  below_for?: number | null; // s, without a break, the last time
  below_by?: number | null; // m, at most in that time
  at_strength_damaged?: number | null; // at the first times, where the ramp of a stage changes it
  at_strength_below?: number | null;
  ravelled_volume?: number | null; // m^2, that moved from above the least depth
  ravelled_depth?: number | null; // m
  stage_damaged?: string; // in which it became so; empty: of none
  stage_below?: string;
  stage?: string; // the last one, to whose end the numbers belong
  fastest_node?: number | null; // m/s, at the end or where stage_moving ended
  fastest_x?: number | null; // m, where soil moves fastest at the end
  fastest_y?: number | null;
  fastest_soil?: string;
  still_moves?: boolean; // so fast that the verdict may change
  stage_moving?: string; // at the end of which it did; empty: of none
  profile?: { width: number; slope: number; x: number | null } | null; // x: null: it fits nowhere
  margin?: number | null; // m, over what floods, where it is so small that the verdict is not sure
  trigger?: Trigger | null; // null: the verdict is that of the section as it is
}

export interface Stage {
  name: string; // empty: the run has no stages and ended at rest
  start: number;
  end: number | null; // null: it runs
}

export interface Events {
  stages?: Stage[]; // those that have ended, and the one that runs
  slides?: Slide[];
  moved_volume?: number | null;
  moved_distance?: number | null; // m, from which on soil counts as moved
  moved_fraction?: number | null;
  intact_fraction?: number | null; // of the volume that moved
  facing?: "right" | "left" | null; // of the slope that front, crest and run-out are of
  // false: the soil fills the mesh to its side; the front is of what moved, the run-out beyond the toe of the slope
  free_toe?: boolean;
  run_out?: number | null;
  front_x?: number | null;
  remaining_crest?: Place | null;
  residual_height?: number | null;
  flood?: Flood | null;
  [name: string]: unknown;
}

/** Places that go each with a point: numbers of points (uint32, 2^32 - 1 between two lines), offsets dx, dy [m]. */
export interface AttachedMeta {
  points: number; // chunk
  offsets: number; // chunk
  count: number;
}

export interface LayerMeta {
  soil: string;
  lines: AttachedMeta | null; // outlines of its bodies
  middle: AttachedMeta | null; // one place, for its name
}

/** A stretch of ground that carries a load from a frame on, and its rows of loads.csv. */
export interface LoadMeta extends TableMeta {
  name: string;
  frame: number;
  lines: AttachedMeta | null;
}

/** Of another method, to be drawn over the slip surface. */
export interface SlipPlane {
  name: string;
  method: string;
  factor_of_safety: number | null;
  points: [number, number][];
}

export interface RunMeta {
  name: string;
  title: string;
  scheme: string;
  case_toml: string;
  case_path: string;
  case_digits: string; // checksum of the case file
  machine: string;
  threads: number;
  wall_seconds: number;
  finished: boolean;
  n_points: number;
  n_shown: number;
  n_frames_in_run: number;
  times: number[];
  position_precision: number;
  bounds: [number, number, number, number];
  point_size: number;
  cell?: number | null; // typical size, the width of the columns in which crests are seen [m]
  materials: { id: number; name: string; soil?: string; color?: string }[];
  positions: { x: QuantisedMeta; y: QuantisedMeta };
  ids: { chunk: number };
  fields: FieldMeta[];
  mesh: { edges: { chunk: number; count: number } } | null;
  outline: { chunk: number; count: number } | null;
  surfaces: { chunk: number; offsets: number[] } | null;
  water: { chunk: number; offsets: number[] } | null;
  layers: LayerMeta[];
  loads: LoadMeta[];
  slip_planes: SlipPlane[];
  histories: HistoryMeta[];
  series: TableMeta | null;
  passes: { name: string; seconds: number }[];
  events: Events | null;
  warnings: Record<string, string[]>; // of the writer, by language; the rest follows from the summary
  assumed?: Record<string, string[]>; // by language: what the import of the section took that its file does not say
  doubts?: Record<string, string[]>; // the same of what speaks against the section
  changed?: Record<string, string[]>; // the same of what changed in it since the import
  // inputs that were changed one at a time, and those that could not be
  depends?: { turns_on: string[]; does_not_turn_on: string[]; not_varied?: string[] } | null;
  stability?: Stability | null; // of the same case, found beside the run
  summary: Record<string, unknown>;
}

/** The factor of safety of a case, and what its cells do to it. */
export interface Stability {
  factor_of_safety: number | null;
  uncertainty: number | null;
  stable_at: number | null;
  failed_at: number | null;
  mesh: {
    cell: number;
    cells_over_depth: number;
    largest_error: number | null; // share by which the mesh made the factor too large, at most
    extrapolated: { factor: number; low: number; high: number; is_extrapolated?: boolean } | null;
  } | null;
}

export interface Comparison {
  columns: string[];
  rows: { label: string; unit: string; digits?: number; values: (number | string | null)[] }[];
  text: string[];
}

export interface ReportMeta {
  format: number;
  terp: string;
  written: string;
  language?: string; // to begin with
  runs: RunMeta[];
  comparison: Comparison | null;
}
