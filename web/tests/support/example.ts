// A made-up slide of a column in two runs, for tests of the page and for work on it. No physics: blocks slide along a line.

import type { ReportMeta, RunMeta } from "../../src/data/format";
import { ChunkWriter } from "./encode";

const [WIDTH, HEIGHT, BASE] = [4, 4, 1]; // m
const FRAMES = 61;
const DURATION = 3; // s

interface Made {
  report: ReportMeta;
  chunks: string[];
}

/** `side` x `side` points per run. */
export function exampleReport(side = 40, runs = 2, writer = new ChunkWriter()): Made {
  const schemes = ["mpm_mixed", "mpm_gp", "standard_mpm"];
  const report: ReportMeta = {
    format: 2, terp: "0.1.0", written: "2026-01-02T10:00:00Z",
    runs: Array.from({ length: runs }, (_, k) => exampleRun(writer, side, k, schemes[k % 3]!)),
    comparison: runs < 2 ? null : {
      columns: ["example_mpm_mixed", "example_mpm_gp"],
      rows: [
        { label: "front at the end", unit: "m", values: [7.4, 6.2] },
        { label: "second slide begins", unit: "s", values: [null, 1.8] },
      ],
      text: ["MPM-GP keeps blocks whole that MPM-Mixed erases.", "The front stops 1.2 m shorter."],
    },
  };
  return { report, chunks: writer.texts };
}

function exampleRun(writer: ChunkWriter, side: number, k: number, scheme: string): RunMeta {
  const times = Array.from({ length: FRAMES }, (_, f) => (DURATION * f) / (FRAMES - 1));
  const n = side * side;
  const reach = 3.4 - 1.2 * k;
  const start = Array.from({ length: n }, (_, p) => [((p % side) + 0.5) * (WIDTH / side), BASE + (Math.floor(p / side) + 0.5) * (HEIGHT / side)] as const);
  const slipLine = (x: number) => BASE + 0.9 * (WIDTH - x) * 1.4;
  const share = (t: number) => 0.5 - 0.5 * Math.cos(Math.PI * Math.min(1, Math.max(0, (t - 0.2) / 1.6)));
  const above = ([x, y]: readonly [number, number]) => Math.max(0, y - slipLine(x)) / HEIGHT;
  const places = times.map((t) => start.map(([x, y]) => {
    const moves = above([x, y]) > 0 ? share(t) * (0.4 + above([x, y])) : 0;
    return [x + reach * moves, Math.max(BASE * 0.1, y - 1.9 * moves)] as const;
  }));
  const strain = times.map((t) => start.map(([x, y]) => share(t) * (2.5 * Math.exp(-(((y - slipLine(x)) / (k ? 0.12 : 0.35)) ** 2)) + 0.01)));
  const speed = times.map((_, f) => places[f]!.map(([x, y], p) => (f === 0 ? 0 : Math.hypot(x - places[f - 1]![p]![0], y - places[f - 1]![p]![1]) / (times[f]! - times[f - 1]!))));
  const gone = (f: number, p: number) => p === n - 1 && f > FRAMES / 2; // one point leaves
  const x = writer.quantity(places.map((row, f) => row.map((place, p) => (gone(f, p) ? null : place[0]))));
  const y = writer.quantity(places.map((row, f) => row.map((place, p) => (gone(f, p) ? null : place[1]))));
  const field = (name: string, label: string, unit: string, kind: "sequential" | "diverging" | "category", values: (number | null)[][], log = false) => {
    const data = writer.quantity(values, log);
    return { name, symbol: name, label, unit, kind, log, range: [data.lo, data.hi] as [number, number], precision: (data.hi - data.lo) / 65535, data };
  };
  const kinetic = speed.map((row) => row.reduce((sum, v) => sum + (0.5 * 2000 * v * v * WIDTH * HEIGHT) / n, 0));
  const front = places.map((row) => row.reduce((most, [px]) => Math.max(most, px), 0));
  const crest = times.map((t) => WIDTH - 1.6 * share(t));
  const name = `example_${scheme}`;
  const slip = { time: 1, points: Array.from({ length: 12 }, (_, i) => [0.9 + 0.28 * i, slipLine(0.9 + 0.28 * i)] as [number, number]) };
  return {
    name, title: "Example: a block slides off a column", scheme, case_path: "runs/example/case.toml", case_digits: "0123456789abcdef", case_toml: `# made up\n[mesh]\nsize = 0.25 # m\nname = "left # right"\n[[body]]\nmaterial = "clay"\n`,
    machine: "a machine, 2 processors", threads: 2, wall_seconds: 83.4, finished: true,
    n_points: n, n_shown: n, n_frames_in_run: FRAMES, times, position_precision: 1e-4,
    bounds: [0, 0, 8, 6], point_size: WIDTH / side, materials: [{ id: 0, name: "clay" }, { id: 1, name: "sand" }],
    positions: { x, y }, ids: { chunk: writer.numbers(start.map((_, p) => p)) },
    fields: [
      field("eps_eq_p", "equivalent plastic strain", "-", "sequential", strain),
      field("velocity", "velocity", "m/s", "sequential", speed.map((row) => row.map((v) => Math.max(v, 1e-4))), true),
      field("pressure", "mean stress", "kPa", "diverging", times.map(() => start.map(([, py], p) => (p === 0 ? null : -20 * (BASE + HEIGHT - py) + 10)))),
      field("material", "material", "-", "category", times.map(() => start.map(([, py]) => (py > 3 ? 1 : 0)))),
    ],
    mesh: meshOf(writer), outline: outlineOf(writer),
    surfaces: surfacesOf(writer, places), water: null, layers: [], loads: [], slip_planes: [],
    histories: ["A", "B", "C"].map((letter, h) => {
      const p = Math.floor(side * (side - 1) - side / (h + 2));
      const columns = [times, places.map((row) => row[p]![0]), places.map((row) => row[p]![1]), strain.map((row) => row[p]!)];
      return { name: letter, x: start[p]![0], y: start[p]![1], columns: [{ name: "time", unit: "s" }, { name: "x", unit: "m" }, { name: "y", unit: "m" }, { name: "eps_deviatoric", unit: "-" }], chunk: writer.floats(columns.flat()), rows: FRAMES };
    }),
    series: {
      columns: [{ name: "time", label: "time", unit: "s" }, { name: "front_x", unit: "m" }, { name: "crest_x", unit: "m" }, { name: "kinetic", unit: "J/m" }, { name: "plastic", unit: "J/m" }],
      chunk: writer.floats([times, front, crest, kinetic, times.map((t) => 9e4 * share(t))].flat()), rows: FRAMES,
    },
    passes: [{ name: "points to cells", seconds: 30.1 }, { name: "nodes", seconds: 4.2 }, { name: "stress", seconds: 41 }],
    events: {
      slides: [{ begins: 0.2, stops: 1.8, slip_surface: slip }, ...(k ? [{ begins: 1.8 }] : [])], moved_volume: 7.9, moved_fraction: 0.49,
      run_out: reach, front_x: front[FRAMES - 1]!, remaining_crest: { x: crest[FRAMES - 1]!, y: BASE + HEIGHT },
      moved_distance: 0.1, residual_height: BASE + (k ? 0.6 : 1.4),
      flood: { verdict: k ? "floods" : "damaged", residual_height: BASE + (k ? 0.6 : 1.4), freeboard: k ? -0.4 : 0.4,
        width_at_level: k ? 0 : 1.2, intact_width: k ? 0 : 0.7, first_time_damaged: 0.2, first_time_below: k ? 1.1 : null },
    },
    warnings: k ? {} : { en: ["Only an example </script> & <b>no</b> physics."],
      nl: ["Slechts een voorbeeld </script> & <b>geen</b> fysica."] },
    summary: { terp_version: "0.1.0", cells: 1024, steps: 3000, dt: 0.001, instructions: "avx2" },
  };
}

/** The first of the runs above with what only a dike has. */
export function exampleDike(side = 40): Made {
  const writer = new ChunkWriter();
  const { runs: [run], ...rest } = exampleReport(side, 1, writer).report;
  const last = side * side - side; // the first point of the top row
  const top = Array.from({ length: side / 2 }, (_, k) => last + k);
  const attached = (points: number[]) => ({ points: writer.numbers(points), offsets: writer.floats(points.flatMap(() => [0, 0])), count: points.length });
  const strength = run!.fields[0]!;
  const flat = (level: number) => Array.from({ length: FRAMES }, () => [0, level, 8, level]).flat();
  Object.assign(run!, {
    materials: [{ id: 0, name: "clay", soil: "clay", color: "#a3c293" }, { id: 1, name: "sand", soil: "sand", color: "#ead592" }],
    fields: [...run!.fields.slice(0, 1), { ...strength, name: "su", label: "undrained shear strength", unit: "kPa" },
      { ...strength, name: "su_ratio", label: "strength left of the first" }, ...run!.fields.slice(1)],
    water: { chunk: writer.floats(flat(5.6)), offsets: Array.from({ length: FRAMES + 1 }, (_, f) => 2 * f) },
    layers: [{ soil: "clay", lines: attached(Array.from({ length: side }, (_, k) => k)), middle: attached([side / 2]) },
      { soil: "sand", lines: attached(top), middle: attached([last]) }],
    loads: [{ name: "traffic", frame: 0, lines: attached(top), columns: [{ name: "time", unit: "s" }, { name: "pressure", unit: "kPa" }],
      chunk: writer.floats([0, DURATION, 13, 13]), rows: 2 }],
    slip_planes: [{ name: "D-Stability", method: "Bishop", factor_of_safety: 1.05, points: [[1, 5], [3, 2], [5, 1]] }],
  });
  const events = run!.events!;
  Object.assign(events.slides![0]!, { entry: { x: 2, y: 5, zone: "crest" }, crest_from: 4, crest_to: 3, facing: "right", kinetic_peak: 1e4 });
  Object.assign(events, { facing: "right" });
  Object.assign(events.flood!, { water_level: 5.6, river: "left" });
  Object.assign(run!.summary, { format: 1, softened_strain: 0.06, stages: [{ name: "daily", start: 0, end: 3, at_rest: true }] });
  return { report: { ...rest, runs: [run!] }, chunks: writer.texts };
}

function meshOf(writer: ChunkWriter): RunMeta["mesh"] {
  const edges: number[] = [];
  for (let k = 0; k <= 32; k++) edges.push(k / 4, 0, k / 4, 6);
  for (let k = 0; k <= 24; k++) edges.push(0, k / 4, 8, k / 4);
  return { edges: { chunk: writer.floats(edges), count: edges.length / 4 } };
}

function outlineOf(writer: ChunkWriter): RunMeta["outline"] {
  const line = [0, BASE, WIDTH, BASE, WIDTH, BASE + HEIGHT, 0, BASE + HEIGHT, 0, BASE, NaN, NaN];
  return { chunk: writer.floats(line), count: line.length / 2 };
}

function surfacesOf(writer: ChunkWriter, places: (readonly [number, number])[][]): RunMeta["surfaces"] {
  const offsets = [0];
  const all: number[] = [];
  for (const row of places) {
    const top = new Map<number, number>();
    for (const [x, y] of row) top.set(Math.floor(x * 4), Math.max(top.get(Math.floor(x * 4)) ?? -Infinity, y));
    for (const [column, y] of [...top].sort((a, b) => a[0] - b[0])) all.push((column + 0.5) / 4, y);
    offsets.push(all.length / 2);
  }
  return { chunk: writer.floats(all), offsets };
}
