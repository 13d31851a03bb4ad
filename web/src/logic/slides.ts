// The slides of a run as the program found them, and which of their slip surfaces to show at a time.

import type { RunMeta, Slide, SlipSurface } from "../data/format";

export function slidesOf(meta: Pick<RunMeta, "events">): Slide[] {
  const { events } = meta;
  if (!events) return [];
  if (events.slides) return events.slides;
  return [
    events.first_slide && { ...events.first_slide,
      slip_surface: events.first_slide.slip_surface ?? events.slip_surface },
    events.second_slide,
  ].filter((slide): slide is Slide => Boolean(slide));
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
    const ends = stops ?? slides[k + 1]?.begins ?? Infinity;
    const phase = surface.time > t + 1e-9 ? "to come" : t > ends + 1e-9 ? "past" : "acting";
    if (!found || phase !== "to come") found = { surface, time: surface.time, phase };
  });
  return found;
}
