// The views of all shown runs: their arrangement, drawing when something changed, zoom, pan, pointing and pinning.

import type { Run } from "../data/run";
import type { Current } from "./current";
import { PointRenderer } from "./points";
import { drawPanel, keyHeight, PADDING } from "./panel";
import { Tip } from "./tip";
import { bestColumns, fit, pan, toWorld, union, zoomAt } from "../logic/camera";
import type { Box, Camera, Padding, Size } from "../logic/camera";
import { nearestPoint } from "../logic/nearest";
import { runLabels } from "../logic/labels";
import { pixelRatio } from "../logic/store";
import { say } from "../logic/texts";
import { element } from "../shell/element";

interface View {
  run: Run;
  canvas: HTMLCanvasElement;
}

const LOW = 0.4; // of the window's height: what the views of a wide section get, with room to zoom in,
const LOW_MOST = 320; // but no more than this [px]: in a high window they would show mostly air
const LEAST = 190; // height of a view in three rows and more [px]; the page is then longer than the screen
const GAP = 8; // CSS pixels between views
const PER_MM = 96 / 25.4; // CSS pixels

export class Viewer {
  readonly root = element("div", { class: "views" });
  readonly renderer: PointRenderer | null;
  readonly trouble: string | null = null;
  readonly labels: string[];
  private readonly views: View[];
  private readonly tip: Tip;
  private readonly box: Box;
  private size: Size = { width: 1, height: 1 };
  private asked = false;
  private drawnFrames = "";
  /** Called after each drawing; for the counter of frames. */
  onDrawn: () => void = () => undefined;

  constructor(private readonly current: Current) {
    const { report, store } = current;
    this.labels = runLabels(report.runs.map((run) => run.meta));
    this.box = union(report.runs.map((run) => run.extent()));
    try {
      this.renderer = new PointRenderer(() => location.reload());
    } catch (error) {
      this.renderer = null;
      this.trouble = (error as Error).message;
    }
    this.tip = new Tip(current);
    this.views = report.runs.map((run) => ({ run, canvas: this.makeCanvas(run) }));
    this.root.append(...this.views.map((view) => view.canvas), this.tip.root);
    store.on((_, changed) => {
      if (changed.has("shown") || changed.has("layout")) this.arrange();
      const onlyTime = [...changed].every((key) => key === "time" || key === "playing");
      if (!onlyTime || this.drawnFrames !== this.frames()) this.ask();
    });
    for (const run of report.runs) run.onField.push(() => this.ask());
    new ResizeObserver(() => requestAnimationFrame(() => this.arrange())).observe(this.root);
  }

  private makeCanvas(run: Run): HTMLCanvasElement {
    const canvas = element("canvas", {
      class: "view", tabindex: 0, role: "img",
      "aria-label": say("view_of", { run: this.labels[run.index]! }),
    });
    this.listen(canvas, run);
    return canvas;
  }

  /** Sizes of the canvases: as many columns as show most, unless the reader chose. */
  arrange(): void {
    const { layout, shown, paper } = this.current.state;
    if (paper) return; // drawOnPaper has arranged them
    const visible = this.views.filter((view) => shown[view.run.index]);
    for (const view of this.views) view.canvas.hidden = !visible.includes(view);
    const area = this.room(visible.length);
    if (visible.length === 0 || area.width === 0) return;
    const columns = layout === "rows" ? 1 : layout === "columns" ? visible.length
      : bestColumns(visible.length, this.box, area, this.padding(area.width));
    const rows = Math.ceil(visible.length / columns);
    this.root.style.gridTemplateColumns = `repeat(${columns}, minmax(0, 1fr))`;
    this.size = {
      width: Math.floor((area.width - GAP * (columns - 1)) / columns),
      height: Math.max(120, Math.floor((area.height - GAP * (rows - 1)) / rows)),
    };
    const ratio = window.devicePixelRatio || 1;
    for (const { canvas } of visible) {
      canvas.width = Math.round(this.size.width * ratio);
      canvas.height = Math.round(this.size.height * ratio);
      canvas.style.height = `${this.size.height}px`;
    }
    this.ask();
  }

  /**
   * Width and height for the views: as high as the style allows, of three rows and more high enough to see, but not
   * higher than the soil needs.
   */
  private room(views: number): Size {
    const stage = this.root.parentElement;
    if (!stage) return { width: 0, height: 0 };
    stage.style.setProperty("--enough", "none");
    stage.style.setProperty("--least", "0px");
    const [width, height] = [this.root.clientWidth, this.root.clientHeight];
    const { layout } = this.current.state;
    const columns = layout === "rows" ? 1 : layout === "columns" ? views
      : bestColumns(views, this.box, { width, height }, this.padding(width));
    const rows = Math.ceil(views / columns);
    const scale = (width / columns - GAP - PADDING.left - PADDING.right) / (this.box[2] - this.box[0]);
    if (rows > 2 && !document.fullscreenElement) stage.style.setProperty("--least", `${LEAST * rows}px`);
    const { top, bottom } = this.padding(width / columns - GAP);
    const enough = rows * (1.15 * scale * (this.box[3] - this.box[1]) + top + bottom + GAP);
    const most = Math.round(Math.max(Math.min(LOW * window.innerHeight, LOW_MOST), enough));
    stage.style.setProperty("--enough", document.fullscreenElement ? "none" : `${most}px`);
    return { width, height: this.root.clientHeight };
  }

  ask(): void {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      this.draw();
    });
  }

  camera(): Camera {
    return this.current.state.camera ?? this.fitted(this.size);
  }

  /** About the section in a view of that width: the rows of slip planes stand above it. */
  padding(width: number): Padding {
    const rows = this.current.shownRuns().map((run) =>
      keyHeight(run, this.current, { names: this.labels, label: this.labels[run.index]!, note: run.meta.name }, width));
    return { ...PADDING, top: PADDING.top + Math.max(0, ...rows) };
  }

  fitted(size: Size, padding = this.padding(size.width)): Camera {
    return fit(this.box, size, padding);
  }

  /** What all runs ever fill [m]. */
  extent(): Box {
    return this.box;
  }

  viewSize(): Size {
    return this.size;
  }

  private frames(): string {
    return this.current.shownRuns().map((run) => this.current.frame(run)).join();
  }

  draw(): void {
    this.drawnFrames = this.frames();
    const ratio = pixelRatio(this.current.state);
    const { top } = this.padding(this.size.width);
    for (const { run, canvas } of this.views) {
      if (canvas.hidden) continue;
      const context = canvas.getContext("2d")!;
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
      drawPanel(context, this.renderer, run, this.current, {
        camera: this.camera(), size: this.size, ratio, time: this.current.state.time,
        names: this.labels, label: this.labels[run.index]!, note: run.meta.name, bare: false,
        top,
      });
    }
    this.tip.update();
    this.onDrawn();
  }

  /** All views, one below the other, at the size that they have on a sheet. */
  drawOnPaper(): void {
    const width = this.root.clientWidth;
    const full = (width - PADDING.left - PADDING.right) / (this.box[2] - this.box[0]);
    const { top, bottom } = this.padding(width);
    const enough = 1.06 * full * (this.box[3] - this.box[1]) + top + bottom;
    const most = parseFloat(getComputedStyle(this.root).getPropertyValue("--paper-height")) * PER_MM;
    const high = most + Math.max(0, top - PADDING.top); // names of many slip planes take nothing from the section
    this.size = { width, height: Math.round(Math.min(enough, high)) };
    const ratio = pixelRatio(this.current.state);
    for (const { canvas } of this.views) {
      canvas.width = Math.round(this.size.width * ratio);
      canvas.height = Math.round(this.size.height * ratio);
      canvas.style.height = `${this.size.height}px`;
    }
    this.draw();
  }

  zoom(factor: number, px = this.size.width / 2, py = this.size.height / 2): void {
    this.current.store.set({ camera: zoomAt(this.camera(), this.size, px, py, factor) });
  }

  move(dx: number, dy: number): void {
    this.current.store.set({ camera: pan(this.camera(), dx, dy) });
  }

  private listen(canvas: HTMLCanvasElement, run: Run): void {
    const pointers = new Map<number, [number, number]>();
    let moved = 0;
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, [event.offsetX, event.offsetY]);
      moved = 0;
    });
    canvas.addEventListener("pointermove", (event) => {
      const before = pointers.get(event.pointerId);
      if (!before) return this.hover(run, event);
      const now: [number, number] = [event.offsetX, event.offsetY];
      if (pointers.size === 2) this.pinch(pointers, event.pointerId, now);
      else this.move(now[0] - before[0], now[1] - before[1]);
      moved += Math.abs(now[0] - before[0]) + Math.abs(now[1] - before[1]);
      pointers.set(event.pointerId, now);
    });
    const up = (event: PointerEvent) => {
      if (pointers.delete(event.pointerId) && moved < 5 && event.type === "pointerup") this.click(run, event);
    };
    canvas.addEventListener("pointerup", up);
    canvas.addEventListener("pointercancel", up);
    canvas.addEventListener("pointerleave", () => this.current.store.set({ hover: null }));
    canvas.addEventListener("dblclick", () => this.current.store.set({ camera: null }));
    canvas.addEventListener("wheel", (event) => this.wheel(canvas, event), { passive: false });
  }

  /** The wheel zooms in a view that has the focus, or with Ctrl; otherwise it scrolls the page as everywhere. */
  private wheel(canvas: HTMLCanvasElement, event: WheelEvent): void {
    if (!event.ctrlKey && document.activeElement !== canvas) return;
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    this.zoom(Math.exp(-Math.max(-120, Math.min(120, event.deltaY * lines)) * (event.ctrlKey ? 0.006 : 0.0025)),
      event.offsetX, event.offsetY);
  }

  private pinch(pointers: Map<number, [number, number]>, id: number, now: [number, number]): void {
    const still = [...pointers].find(([other]) => other !== id)![1];
    const before = pointers.get(id)!;
    const distance = (p: [number, number]) => Math.hypot(p[0] - still[0], p[1] - still[1]);
    this.zoom(distance(now) / Math.max(1, distance(before)), (now[0] + still[0]) / 2, (now[1] + still[1]) / 2);
  }

  private pick(run: Run, event: PointerEvent): number {
    const camera = this.camera();
    const [x, y] = toWorld(camera, this.size, event.offsetX, event.offsetY);
    return nearestPoint(run, this.current.frame(run), x, y, Math.max(run.meta.point_size, 10 / camera.scale));
  }

  private hover(run: Run, event: PointerEvent): void {
    const point = this.pick(run, event);
    this.tip.at(event.clientX, event.clientY);
    const { hover } = this.current.state;
    if (hover && hover.run === run.index && hover.point === point) return this.tip.update();
    this.current.store.set({ hover: point < 0 ? null : { run: run.index, point } });
  }

  private click(run: Run, event: PointerEvent): void {
    const point = this.pick(run, event);
    this.current.store.set({ pin: point < 0 ? null : { run: run.index, point } });
  }
}
