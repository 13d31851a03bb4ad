// One run of the report: what its JSON says, and its arrays, each decoded when it is first asked for.

import type { AttachedMeta, FieldMeta, QuantisedMeta, RunMeta } from "./format";
import { Chunks } from "./chunks";
import { decodeFrames, distances, FULL, Quantised, valueOf } from "./quantised";
import { Table } from "./table";

export type Polyline = Float32Array; // x, y, x, y, ... [m]; NaN, NaN between polylines

/** Places that go each with a point shown. */
export interface Attached {
  points: Uint32Array; // GAP between two lines
  offsets: Float32Array; // dx, dy [m]
}

const LOAD_ROOM = 0.1; // of the height of the section, above it
const GAP = 0xffffffff;
const TORN = 6; // spacings of points between two places beyond which soil has come apart

export class Run {
  readonly fields = new Map<string, Quantised>();
  private readonly decoded = new Map<number, Promise<Uint16Array<ArrayBuffer>>>(); // by chunk: fields may share one
  x!: Quantised;
  y!: Quantised;
  ids!: Uint32Array;
  outline: Polyline = new Float32Array(0);
  edges: Float32Array = new Float32Array(0);
  private surfaces: Float32Array = new Float32Array(0);
  private water: Float32Array = new Float32Array(0);
  series: Table | null = null;
  histories: { name: string; x: number; y: number; table: Table }[] = [];
  layers: { soil: string; lines: Attached | null; middle: Attached | null }[] = [];
  loads: { name: string; frame: number; lines: Attached | null; table: Table }[] = [];
  /** Called when a field has been decoded. */
  readonly onField: (() => void)[] = [];

  constructor(
    readonly meta: RunMeta,
    readonly index: number,
    private readonly chunks: Chunks,
  ) {}

  /** All that the first picture and the charts need: everything but the fields. */
  async open(): Promise<void> {
    const { meta, chunks } = this;
    const { x, y } = meta.positions;
    [this.x, this.y] = await Promise.all([
      this.quantity(x),
      this.quantity(y),
    ]);
    this.ids = await chunks.numbers(meta.ids.chunk);
    if (meta.outline) this.outline = await chunks.floats(meta.outline.chunk);
    if (meta.mesh) this.edges = await chunks.floats(meta.mesh.edges.chunk);
    if (meta.surfaces) this.surfaces = await chunks.floats(meta.surfaces.chunk);
    if (meta.water) this.water = await chunks.floats(meta.water.chunk);
    if (meta.series) this.series = Table.of(meta.series, await chunks.floats(meta.series.chunk));
    for (const history of meta.histories) {
      const table = Table.of(history, await chunks.floats(history.chunk));
      this.histories.push({ name: history.name, x: history.x, y: history.y, table });
    }
    for (const { soil, lines, middle } of meta.layers)
      this.layers.push({ soil, lines: await this.readAttached(lines), middle: await this.readAttached(middle) });
    for (const load of meta.loads) {
      const table = Table.of(load, await chunks.floats(load.chunk));
      this.loads.push({ name: load.name, frame: load.frame, lines: await this.readAttached(load.lines), table });
    }
  }

  private async readAttached(meta: AttachedMeta | null): Promise<Attached | null> {
    if (!meta) return null;
    return { points: await this.chunks.numbers(meta.points), offsets: await this.chunks.floats(meta.offsets) };
  }

  /** Where attached places are in a frame: x, y, ...; NaN, NaN between lines and where the soil came apart. */
  places(frame: number, { points, offsets }: Attached): number[] {
    const places: number[] = [];
    const torn = TORN * this.meta.point_size;
    let [beforeX, beforeY] = [NaN, NaN];
    for (let k = 0; k < points.length; k++) {
      const point = points[k]!;
      const here = point !== GAP && this.present(frame, point);
      const [px, py] = here ? this.place(frame, point) : [NaN, NaN];
      const [x, y] = [px + offsets[2 * k]!, py + offsets[2 * k + 1]!];
      if (Math.hypot(x - beforeX, y - beforeY) > torn) places.push(NaN, NaN);
      places.push(x, y);
      [beforeX, beforeY] = [x, y];
    }
    return places;
  }

  get frames(): number {
    return this.meta.times.length;
  }

  get points(): number {
    return this.meta.n_shown;
  }

  fieldMeta(name: string): FieldMeta | null {
    return this.meta.fields.find((field) => field.name === name) ?? null;
  }

  /** The field, decoded at the first call; null if the run has none of that name. */
  async field(name: string): Promise<Quantised | null> {
    const meta = this.fieldMeta(name);
    if (!meta) return null;
    const there = this.fields.get(name);
    if (there) return there;
    const field = await this.quantity(meta.data);
    if (!this.fields.has(name)) {
      this.fields.set(name, field);
      for (const listener of this.onField) listener();
    }
    return this.fields.get(name)!;
  }

  private async quantity(meta: QuantisedMeta): Promise<Quantised> {
    if (meta.chunk === null) return new Quantised(meta, distances(this.x, this.y, meta));
    let q = this.decoded.get(meta.chunk);
    if (!q) {
      q = this.chunks.bytes(meta.chunk).then((bytes) =>
        decodeFrames(bytes, meta.static ? 1 : meta.frames, meta.points, meta.layout!));
      this.decoded.set(meta.chunk, q);
    }
    return new Quantised(meta, await q);
  }

  /** False for a point that left through an open side, and where its body is not placed yet or was removed. */
  present(frame: number, point: number): boolean {
    return this.x.frame(frame)[point] !== FULL || this.y.frame(frame)[point] !== FULL;
  }

  place(frame: number, point: number): [number, number] {
    return [this.x.value(frame, point), this.y.value(frame, point)];
  }

  /** Shown point with that id; -1 if it is not shown. */
  pointOfId(id: number): number {
    let low = 0;
    let high = this.ids.length - 1;
    while (low <= high) {
      const middle = (low + high) >> 1;
      const there = this.ids[middle]!;
      if (there === id) return middle;
      if (there < id) low = middle + 1;
      else high = middle - 1;
    }
    return -1;
  }

  /** Free surface of a frame as x, y, x, y, ... */
  surface(frame: number): Polyline {
    const offsets = this.meta.surfaces?.offsets;
    return offsets ? this.surfaces.subarray(2 * offsets[frame]!, 2 * offsets[frame + 1]!) : new Float32Array(0);
  }

  /** Phreatic line of a frame as x, y, x, y, ... */
  waterTable(frame: number): Polyline {
    const offsets = this.meta.water?.offsets;
    return offsets ? this.water.subarray(2 * offsets[frame]!, 2 * offsets[frame + 1]!) : new Float32Array(0);
  }

  /** Smallest box around all points of all frames and the initial outline: xmin, ymin, xmax, ymax [m]. */
  extent(): [number, number, number, number] {
    const { x, y } = this;
    let [x0, x1, y0, y1] = [FULL, 0, FULL, 0];
    for (let k = 0; k < x.q.length; k++) {
      const [qx, qy] = [x.q[k]!, y.q[k]!];
      if (qx === FULL && qy === FULL) continue;
      if (qx < x0) x0 = qx;
      if (qx > x1) x1 = qx;
      if (qy < y0) y0 = qy;
      if (qy > y1) y1 = qy;
    }
    const box: [number, number, number, number] =
      [valueOf(x.meta, x0), valueOf(y.meta, y0), valueOf(x.meta, x1), valueOf(y.meta, y1)];
    for (let k = 0; k + 1 < this.outline.length; k += 2) {
      const [px, py] = [this.outline[k]!, this.outline[k + 1]!];
      if (!Number.isFinite(px)) continue;
      [box[0], box[1], box[2], box[3]] =
        [Math.min(box[0], px), Math.min(box[1], py), Math.max(box[2], px), Math.max(box[3], py)];
    }
    if (this.loads.length > 0) box[3] += LOAD_ROOM * (box[3] - box[1]); // for their arrows
    return box;
  }
}
