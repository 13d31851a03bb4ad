// All views with title and colour bar on one canvas: the image and each picture of the video.

import type { Current } from "./current";
import type { Viewer } from "./viewer";
import { drawPanel } from "./panel";
import { BAR_HEIGHT, drawColourBar } from "./colour_bar";
import { canvasTheme, FONT } from "./theme";

const MARGIN = 14;
const TITLE = 34;
const GAP = 8;

export interface FigureSize {
  width: number;
  height: number;
}

export class Figure {
  constructor(
    private readonly current: Current,
    private readonly viewer: Viewer,
    private readonly title: string,
  ) {}

  private columns(): number {
    return getComputedStyle(this.viewer.root).gridTemplateColumns.split(" ").length;
  }

  /** In CSS pixels: as the views are on the page. */
  size(): FigureSize {
    const { width, height } = this.viewer.viewSize();
    const columns = this.columns();
    const rows = Math.ceil(this.current.shownRuns().length / columns);
    return {
      width: 2 * MARGIN + columns * width + (columns - 1) * GAP,
      height: MARGIN + TITLE + rows * height + (rows - 1) * GAP + BAR_HEIGHT + MARGIN,
    };
  }

  /** Draws the figure at `time` on a canvas, `ratio` pixels of it per CSS pixel. */
  draw(canvas: HTMLCanvasElement, time: number, ratio: number): void {
    const size = this.size();
    const [width, height] = [Math.round(size.width * ratio), Math.round(size.height * ratio)];
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    const context = canvas.getContext("2d")!;
    const theme = canvasTheme(this.current.state.dark);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = theme.ground;
    context.fillRect(0, 0, size.width, size.height);
    context.font = `600 16px ${FONT}`;
    context.fillStyle = theme.text;
    context.textBaseline = "middle";
    context.textAlign = "left";
    context.fillText(this.title, MARGIN, MARGIN + 11);
    const columns = this.columns();
    const view = this.viewer.viewSize();
    this.current.shownRuns().forEach((run, k) => {
      const x = MARGIN + (k % columns) * (view.width + GAP);
      const y = MARGIN + TITLE + Math.floor(k / columns) * (view.height + GAP);
      context.setTransform(ratio, 0, 0, ratio, Math.round(x * ratio), Math.round(y * ratio));
      drawPanel(context, this.viewer.renderer, run, this.current, {
        camera: this.viewer.camera(), size: view, ratio, time, names: this.viewer.labels,
          label: this.viewer.labels[run.index]!, note: run.meta.name, bare: false,
          top: this.viewer.padding(view.width).top,
      });
    });
    context.setTransform(ratio, 0, 0, ratio, MARGIN * ratio,
      Math.round((size.height - MARGIN - BAR_HEIGHT + 6) * ratio));
    drawColourBar(context, this.current, size.width - 2 * MARGIN, time);
  }
}

/** Offers bytes as a file. */
export function save(blob: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

export async function pngOf(figure: Figure, time: number): Promise<Blob> {
  const canvas = document.createElement("canvas");
  figure.draw(canvas, time, Math.max(2, window.devicePixelRatio || 1));
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) =>
      (blob ? resolve(blob) : reject(new Error("The browser could not make an image of this size."))), "image/png");
  });
}
