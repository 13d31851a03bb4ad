// Prints: paper is white and narrow. The page is laid out as it will lie on the sheet before its canvases are drawn, so
// that they are drawn at the size that they have there; afterwards all is as it was. Case files stay folded.

import type { Store } from "../logic/store";
import type { Viewer } from "../view/viewer";

const WIDTH = "182mm"; // of A4 without the margins of style.css

/** The style for paper holds on the screen too. */
function layOut(paper: boolean): void {
  for (const sheet of document.styleSheets)
    for (const rule of sheet.cssRules) {
      if (!(rule instanceof CSSMediaRule)) continue;
      const { media } = rule;
      if (media.mediaText === (paper ? "print" : "all")) media.mediaText = paper ? "all" : "print";
    }
  document.body.style.width = paper ? WIDTH : "";
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

export function printOnPaper(store: Store, viewer: Viewer, before: HTMLCanvasElement | null): void {
  let dark = false;
  window.addEventListener("beforeprint", () => {
    dark = store.state.dark;
    layOut(true);
    store.set({ dark: false, playing: false, paper: true });
    if (before) drawBefore(store, viewer, before);
    viewer.drawOnPaper();
  });
  window.addEventListener("afterprint", () => {
    layOut(false);
    store.set({ dark, paper: false });
    viewer.arrange();
  });
}
