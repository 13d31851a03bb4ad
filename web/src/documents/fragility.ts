// The fragility curve of a study. A level without any realisation is left out of the charts. The answer has three
// forms: no distribution of the load, levels of which nothing is known, and a probability over all levels. The last one
// gives two pairs of bounds, since the curve between its levels is an assumption; the second needs a curve that rises.

import type { EventMeta, StudyMeta } from "../data/documents";
import { numberText } from "../logic/numbers";
import type { Store } from "../logic/store";
import { say, type TextKey } from "../logic/texts";
import { cards, chart, paragraph, probability, section, styled, table, withUnitOf, type Row } from "./document";
import { confidenceOf, missingWords, range, slideWords } from "./study";

type EventName = "slide" | "flood" | "flood_after_slide";

export function fragilityPart(data: StudyMeta, store: Store): HTMLElement {
  const load = data.of_load!;
  const axis = withUnitOf(load.name, load.unit);
  const options = { xLabel: axis, unit: "-", yLabel: say("study_probability_axis"), fromZero: true };
  const curve = (name: TextKey, event: EventName, k: number) => {
    const there = data.levels!.filter(({ [event]: e }) => e.solved + e.failed > 0);
    const line = (label: string, part: "probability" | "low" | "high", dash: number[]) => styled(k, { label, dash,
      marks: part === "probability", x: there.map(({ level }) => level), y: there.map((at) => at[event][part]) });
    return [line(say(name), "probability", []), line(`${say(name)}: ${say("study_lower")}`, "low", [2, 3]),
      line(`${say(name)}: ${say("study_upper")}`, "high", [2, 3])];
  };
  return section(say("fragility"), paragraph(answerOf(data), "answer"),
    cards([
      chart(store, { ...options, title: say("fragility_curve") }, [...curve("fragility_slide", "slide", 0),
        ...(data.judges_flood ? curve("fragility_flood", "flood", 1) : [])]),
      data.judges_flood ? chart(store, { ...options, title: say("fragility_among_slides") },
        curve("fragility_after_slide", "flood_after_slide", 2)) : null,
      chart(store, { ...options, title: say("fragility_load"), yLabel: say("fragility_not_exceeded") },
        [styled(3, { label: say("fragility_load"), dash: [], x: load.distribution.map(([h]) => h),
          y: load.distribution.map(([, p]) => p) })]),
    ]),
    levelTable(data, axis),
    paragraph([
      say("fragility_events", { slide: slideWords(data), flood: say("study_flood_words") }),
      data.judges_flood ? say("fragility_worth") : "", say("fragility_help"),
      say(load.is_water_level ? "fragility_files_water" : "fragility_files"),
    ].filter(Boolean).join(" "), "muted"));
}

function levelTable(data: StudyMeta, axis: string): HTMLElement {
  const bounds = say("study_bounds", { confidence: confidenceOf(data) });
  const cells = ({ probability: p, low, high }: EventMeta) => [probability(p), p === null ? "–" : range(low, high)];
  const beta = ({ probability: p, beta: value }: EventMeta) =>
    (p === null ? "–" : p === 0 ? "∞" : p === 1 ? "−∞" : numberText(value, 3));
  return table([axis, "P(I|h)", bounds, "β", "P(F|h)", bounds, "β", "P(F|I, h)", bounds],
    data.levels!.map(({ level, slide, flood, flood_after_slide }): Row => ({ head: numberText(level),
      cells: [...cells(slide), beta(slide), ...cells(flood), beta(flood), ...cells(flood_after_slide)] })));
}

const between = ([low, high]: [number, number]) =>
  say("low_and_high", { low: probability(low, 2), high: probability(high, 2) });

/** P over all levels, in sentences. */
export function answerOf(data: StudyMeta): string {
  const load = data.of_load!;
  const integral = data.judges_flood ? data.flood_over_levels : data.slide_over_levels;
  const events = data.levels!.map((at) => (data.judges_flood ? at.flood : at.slide));
  const missing = missingWords({ failed: events.reduce((sum, e) => sum + e.failed, 0),
    solved: events.reduce((sum, e) => sum + e.solved, 0) });
  const of = { what: say(data.judges_flood ? "study_floods" : "study_slides"), load: load.name,
    confidence: confidenceOf(data) };
  if (!integral)
    return `${say("fragility_below", of)} ${say(load.distribution.length > 0 ? "fragility_needs_levels"
      : "fragility_needs_load")}${missing}`;
  const straight = between(integral.straight);
  const rising = integral.never_falling;
  return [say("fragility_over", { ...of, p: probability(integral.probability, 2) }),
    rising ? say("fragility_bounds_both", { ...of, straight, rising: between(rising) })
      : say("fragility_bounds_falls", { ...of, straight }),
    data.judges_flood ? say("study_slide_too", { p: probability(data.slide_over_levels!.probability, 2) }) : "",
  ].filter(Boolean).join(" ") + missing;
}
