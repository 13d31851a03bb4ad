// The slides of a run as the program found them, and which of their slip surfaces to show at a time.

import type { RunMeta, Slide, SlipSurface } from "../data/format";

export function slidesOf(meta: Pick<RunMeta, "events">): Slide[] {
  return meta.events?.slides ?? [];
}

/** The slides of the slope that slid first, and those of the other slope: these are no retrogression. */
export function slidesBySlope(meta: Pick<RunMeta, "events">): { own: Slide[]; other: Slide[] } {
  const slides = slidesOf(meta);
  const own = slides.filter(({ facing }) => facing === slides[0]!.facing);
  return { own, other: slides.filter((slide) => !own.includes(slide)) };
}

/** The next slide of the same slope. */
export function nextOf(slides: readonly Slide[], k: number): Slide | undefined {
  return slides.slice(k + 1).find(({ facing }) => facing === slides[k]!.facing);
}

export interface ShownSlip {
  surface: SlipSurface;
  time: number;
  // it lies where the soil was at its time; after the slide that soil has moved on
  phase: "to come" | "acting" | "past";
}

/** The slip surface of the last slide that had formed one by time t; before the first, that one as yet to come. */
export function slipAt(slides: readonly Slide[], t: number): ShownSlip | null {
  let found: ShownSlip | null = null;
  slides.forEach(({ slip_surface: surface, stops }, k) => {
    if (!surface || surface.time === null || surface.points.length < 2) return;
    const ends = stops ?? nextOf(slides, k)?.begins ?? Infinity;
    const phase = surface.time > t + 1e-9 ? "to come" : t > ends + 1e-9 ? "past" : "acting";
    if (!found || phase !== "to come") found = { surface, time: surface.time, phase };
  });
  return found;
}
