// Prints: paper is white and narrow. The page is laid out as it will lie on the sheet before its canvases are drawn, so
// that they are drawn at the size that they have there; afterwards all is as it was. Case files stay folded.

import type { Store } from "../logic/store";
import type { Viewer } from "../view/viewer";

const WIDTH = 182; // mm, of A4 without the margins of style.css
const HEIGHT = 269; // the same
const SHEETS = 2; // of a dike
const WASTE = 14; // mm of both sheets that stay empty, as pictures and paragraphs are not cut
/** How a dike is brought onto them, a step at a time: height of a view at most [mm], size of the words. */
const STEPS = [[60, 1], [56, 1], [52, 1], [52, 0.97], [52, 0.94], [52, 0.91], [46, 0.91], [42, 0.91], [42, 0.88],
  [42, 0.84], [42, 0.8], [42, 0.76]] as const;
const PX_PER_MM = 96 / 25.4;

/** The style for paper holds on the screen too. */
function layOut(paper: boolean, wide: boolean): void {
  for (const sheet of document.styleSheets)
    for (const rule of sheet.cssRules) {
      if (!(rule instanceof CSSMediaRule)) continue;
      const { media } = rule;
      if (media.mediaText === (paper ? "print" : "all")) media.mediaText = paper ? "all" : "print";
    }
  document.body.style.width = paper ? `${wide ? HEIGHT : WIDTH}mm` : "";
}

/** Brings a dike onto its sheets: with lower views, and smaller words. */
function fit(viewer: Viewer, draw: () => void): void {
  for (const [high, size] of STEPS) {
    if (document.documentElement.scrollHeight / PX_PER_MM < SHEETS * HEIGHT - WASTE) return;
    viewer.root.style.setProperty("--paper-height", String(high));
    document.body.style.setProperty("zoom", String(size));
    document.body.style.width = `${WIDTH / size}mm`;
    draw();
  }
}

function unfit(viewer: Viewer): void {
  viewer.root.style.removeProperty("--paper-height");
  document.body.style.removeProperty("zoom");
}

/** The section as it was drawn, in the colours of its soils: on paper it stands above the view. */
function drawBefore(store: Store, viewer: Viewer, before: HTMLCanvasElement): void {
  const { time, field, log, rangeMode, slip } = store.state;
  store.set({ time: 0, field: "material", slip: false });
  viewer.drawOnPaper();
  const view = viewer.root.querySelector("canvas")!;
  [before.width, before.height] = [view.width, view.height];
  before.getContext("2d")!.drawImage(view, 0, 0);
  store.set({ time, field, slip });
  store.set({ log, rangeMode });
}

/** viewer: null of a page without views. wide: the sheet lies on its long side. */
export function printOnPaper(store: Store, viewer: Viewer | null, before: HTMLCanvasElement | null = null,
  wide = false): void {
  let dark = false;
  window.addEventListener("beforeprint", () => {
    dark = store.state.dark;
    layOut(true, wide);
    store.set({ dark: false, playing: false, paper: true });
    const draw = () => {
      if (before && viewer) drawBefore(store, viewer, before);
      viewer?.drawOnPaper();
    };
    draw();
    if (before && viewer) fit(viewer, draw);
  });
  window.addEventListener("afterprint", () => {
    if (viewer) unfit(viewer);
    layOut(false, wide);
    store.set({ dark, paper: false });
    viewer?.arrange();
  });
}
