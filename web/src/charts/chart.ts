// A chart over time with zoom, linked to the views: a line at the present time, a click goes to that time, all charts
// share the pointer. uPlot draws.

import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { pixelRatio, type Store } from "../logic/store";
import { canvasTheme, FONT } from "../view/theme";
import { numberText, readableUnit, tickTexts, unitSuffix } from "../logic/numbers";
import { say } from "../logic/texts";
import { element } from "../shell/element";

export interface Line {
  label: string;
  x: ArrayLike<number>;
  y: ArrayLike<number | null>;
  colour: (dark: boolean) => string;
  dash?: number[];
  width?: number;
  marks?: boolean; // at each point
  steps?: boolean; // a value holds up to the next x
}

/** A value with the range in which it lies, upright beside the lines. */
export interface Bar {
  x: number;
  y: number;
  half: number; // of the range
  colour: (dark: boolean) => string;
}

export interface ChartOptions {
  title: string;
  xLabel: string;
  unit: string;
  yLabel?: string; // before the unit
  height?: number;
  overTime?: boolean; // the x axis is the time of the run
  yRange?: [number, number]; // fixed; otherwise from the data
  fromZero?: boolean;
  nameEnds?: boolean; // each line's label at its right end
  xFromZero?: boolean;
  bars?: Bar[];
}

/** Distinct patterns of lines, for those of one colour. */
export const DASHES = [[], [7, 4], [2, 3], [9, 3, 2, 3]];

/** The nearest that the legend has. */
function borderOf(dash: number[] | undefined): string {
  return !dash || dash.length === 0 ? "solid" : dash.length === 2 && dash[0]! < 3 ? "dotted" : "dashed";
}

const SYNC = uPlot.sync("terp");

export class Chart {
  readonly root: HTMLElement;
  private readonly holder = element("div", { class: "plot" });
  private readonly now = element("div", { class: "now-line" });
  private plot: uPlot | null = null;
  private lines: Line[] = [];
  private options: ChartOptions;
  private zoomed = false;

  constructor(
    private readonly store: Store,
    options: ChartOptions,
  ) {
    this.options = { overTime: true, ...options };
    this.root = element("figure", { class: "chart" }, element("figcaption", {}, options.title), this.holder);
    new ResizeObserver(() => this.resize()).observe(this.holder);
    if (this.options.overTime) store.on((_, changed) => changed.has("time") && this.placeNow());
    store.on((_, changed) => (changed.has("dark") || changed.has("paper")) && this.build());
  }

  set title(text: string) {
    this.root.querySelector("figcaption")!.textContent = text;
  }

  show(lines: Line[], change: Partial<ChartOptions> = {}): void {
    const same = this.plot !== null && Object.keys(change).length === 0 && lines.length === this.lines.length;
    this.lines = lines;
    this.options = { ...this.options, ...change };
    if (same) this.plot!.setData(this.data(), !this.zoomed);
    else this.build();
  }

  private scaled(): { factor: number; unit: string } {
    let size = 0;
    for (const { y } of this.lines) for (let k = 0; k < y.length; k++) if (Math.abs(y[k] ?? 0) > size)
      size = Math.abs(y[k]!);
    return readableUnit(this.options.unit, Number.isFinite(size) ? size : 0);
  }

  private data(): uPlot.AlignedData {
    const { factor } = this.scaled();
    const scaled = (v: number | null) => (v === null || !Number.isFinite(v) ? null : v * factor);
    const tables = this.lines.map(({ x, y }) => [Array.from(x), Array.from(y, scaled)] as uPlot.AlignedData);
    return tables.length > 0 ? uPlot.join(tables, tables.map((table) => table.map(() => 0 as uPlot.JoinNullMode)))
      : [[], []];
  }

  private build(): void {
    this.plot?.destroy();
    this.plot = null;
    this.zoomed = false;
    if (this.lines.length === 0 || this.holder.clientWidth === 0) return;
    this.plot = new uPlot(this.settings(), this.data(), this.holder);
    this.placeNow();
    this.plot.over.setAttribute("aria-hidden", "true");
    this.holder.setAttribute("role", "img");
    this.holder.setAttribute("aria-label",
      say("chart_of_against", { title: this.options.title, lines: this.lines.map((line) => line.label).join(", "),
        axis: this.options.xLabel }));
  }

  private settings(): uPlot.Options {
    const { dark } = this.store.state;
    const theme = canvasTheme(dark);
    const { unit } = this.scaled();
    const s = this.sharpness();
    const font = `${11 * s}px ${FONT}`;
    const axis: uPlot.Axis = {
      stroke: theme.muted, font, labelFont: font, labelSize: 18 * s,
      grid: { stroke: theme.frame, width: 0.5 * s }, ticks: { stroke: theme.frame, width: s, size: 4 * s }, gap: 4 * s,
      space: (_, axisIdx) => (axisIdx === 0 ? 50 : 30) * s,
    };
    const text = (_: uPlot, v: number | null) => (v === null || v === undefined ? "" : numberText(v, 4));
    return {
      width: this.holder.clientWidth * s,
      height: this.height() * s,
      padding: [8 * s, (this.options.nameEnds ? this.longestName() + 10 : 12) * s, 0, 0],
      scales: { x: { time: false, range: this.rangeX() },
        y: { range: this.options.yRange ? () => this.options.yRange! : this.rangeY() } },
      axes: [
        { ...axis, label: this.options.xLabel, size: 26 * s, values: (_, ticks) => tickTexts(ticks) },
        { ...axis, label: `${this.options.yLabel ?? ""}${unitSuffix(unit)}`.trim(),
          size: (_, values) => (14 + 6.4 * Math.max(2, ...(values ?? []).map((v) => v.length))) * s,
          values: (_, ticks) => tickTexts(ticks) },
      ],
      series: [
        { label: this.options.xLabel.replace(/ \[.*/, ""), value: text },
        ...this.lines.map((line) => ({
          label: line.label, stroke: line.colour(dark), width: (line.width ?? 1.6) * s,
            dash: line.dash?.map((part) => part * s), spanGaps: true,
            points: { show: line.marks ?? false, size: 7 * s, fill: theme.ground }, value: text,
            paths: line.steps ? uPlot.paths.stepped!({ align: 1 }) : undefined,
        })),
      ],
      cursor: { sync: this.options.overTime ? { key: SYNC.key, setSeries: false, scales: ["x", null] } : undefined,
        drag: { x: true, y: false }, focus: { prox: 16 }, points: { size: 6 } },
      focus: { alpha: 0.35 },
      legend: { live: true, markers: { width: 2, dash: (_, k) => borderOf(this.lines[k - 1]?.dash) } },
      hooks: { draw: [(plot) => this.drawNames(plot), (plot) => this.drawBars(plot), () => this.placeNow()],
        ready: [(plot) => this.listen(plot)],
        setScale: [(plot, key) => key === "x" && this.noteZoom(plot)] },
    };
  }

  /** Width of the longest label [CSS pixels]. */
  private longestName(): number {
    const context = document.createElement("canvas").getContext("2d")!;
    context.font = `600 11px ${FONT}`;
    return Math.max(0, ...this.lines.map(({ label }) => context.measureText(label).width));
  }

  private rangeY(): uPlot.Range.Function {
    return (_, lo, hi) => {
      if (lo === null || hi === null || !Number.isFinite(lo) || !Number.isFinite(hi)) return [0, 1];
      const { factor } = this.scaled();
      const ends = (this.options.bars ?? []).map(({ y, half }) => [factor * (y - half), factor * (y + half)] as const);
      const low = Math.min(this.options.fromZero ? 0 : lo, lo, ...ends.map(([end]) => end));
      const high = Math.max(hi, ...ends.map(([, end]) => end));
      const room = 0.05 * (high - low || Math.abs(high) || 1);
      return [low === 0 ? 0 : low - room, high + room];
    };
  }

  /** Where points are marked, room for the marks at both ends. */
  private rangeX(): uPlot.Range.Function | undefined {
    const { xFromZero } = this.options;
    if (!xFromZero && !this.lines.some((line) => line.marks)) return undefined;
    return (_, lo, hi) => {
      const low = xFromZero ? Math.min(0, lo) : lo;
      const room = 0.03 * (hi - low || Math.abs(hi) || 1);
      return [low - room, hi + room];
    };
  }

  private drawBars(plot: uPlot): void {
    const { factor } = this.scaled();
    const { ctx } = plot;
    const ratio = devicePixelRatio * this.sharpness();
    ctx.save();
    ctx.lineWidth = 1.5 * ratio;
    for (const { x, y, half, colour } of this.options.bars ?? []) {
      ctx.strokeStyle = colour(this.store.state.dark);
      const at = plot.valToPos(x, "x", true);
      const [low, middle, high] = [y - half, y, y + half].map((value) => plot.valToPos(factor * value, "y", true)) as
        [number, number, number];
      ctx.beginPath();
      ctx.moveTo(at, low);
      ctx.lineTo(at, high);
      for (const end of [low, high]) {
        ctx.moveTo(at - 4 * ratio, end);
        ctx.lineTo(at + 4 * ratio, end);
      }
      ctx.moveTo(at + 3.5 * ratio, middle);
      ctx.arc(at, middle, 3.5 * ratio, 0, 2 * Math.PI);
      ctx.stroke();
    }
    ctx.restore();
  }

  /** On paper a chart is drawn larger than it is shown. */
  private sharpness(): number {
    return this.store.state.paper ? pixelRatio(this.store.state) / (window.devicePixelRatio || 1) : 1;
  }

  private height(): number {
    const height = this.options.height ?? 220;
    return this.store.state.paper ? 0.8 * height : height;
  }

  /** The line at the present time: an element, as moving it is cheap beside drawing the chart anew. */
  private placeNow(): void {
    const { plot } = this;
    if (!plot || !this.options.overTime) return;
    const x = plot.valToPos(this.store.state.time, "x");
    this.now.hidden = !(x >= 0 && x <= plot.over.clientWidth);
    this.now.style.transform = `translateX(${x}px)`;
  }

  /** Labels right of the last values, pushed apart where they would overlap. */
  private drawNames(plot: uPlot): void {
    if (!this.options.nameEnds) return;
    const { left, top, width, height } = plot.bbox;
    const ratio = devicePixelRatio * this.sharpness();
    const names = this.lines.map((line, k) => {
      const y = plot.data[k + 1]!;
      let last = y.length - 1;
      while (last > 0 && (y[last] === null || y[last] === undefined
        || plot.data[0][last]! > plot.scales.x!.max!)) last--;
      return { line, y: plot.valToPos(y[last] ?? 0, "y", true) };
    });
    names.sort((a, b) => a.y - b.y);
    const step = 11 * ratio;
    names.forEach((name, k) => (name.y = Math.max(name.y, k === 0 ? top : names[k - 1]!.y + step)));
    for (let k = names.length - 1, below = top + height + step / 2; k >= 0; k--) 
      below = names[k]!.y = Math.min(names[k]!.y, below - (k === names.length - 1 ? 0 : step));
    const context = plot.ctx;
    context.save();
    context.font = `600 ${11 * ratio}px ${FONT}`;
    context.textBaseline = "middle";
    context.textAlign = "left";
    for (const { line, y } of names) {
      context.fillStyle = line.colour(this.store.state.dark);
      context.fillText(line.label, left + width + 5 * ratio, y);
    }
    context.restore();
  }

  private listen(plot: uPlot): void {
    if (!this.options.overTime) return;
    plot.over.append(this.now);
    this.placeNow();
    let down: [number, number] | null = null;
    plot.over.addEventListener("mousedown", (event) => (down = [event.clientX, event.clientY]));
    plot.over.addEventListener("mouseup", (event) => {
      const still = down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4;
      const time = plot.posToVal(event.offsetX, "x");
      if (still && event.detail < 2 && Number.isFinite(time)) this.store.set({ time, playing: false });
    });
  }

  private noteZoom(plot: uPlot): void {
    const x = plot.data[0];
    const { min, max } = plot.scales.x!;
    this.zoomed = x.length > 1 && (min! > x[0]! || max! < x[x.length - 1]!);
  }

  private resize(): void {
    const width = this.holder.clientWidth;
    if (width === 0) return;
    if (!this.plot) this.build();
    else if (!this.store.state.paper && this.plot.width !== width) this.plot.setSize({ width, height: this.height() });
  }
}
