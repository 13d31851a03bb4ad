// A study of many runs: its probabilities, what became of the realisations, what matters, the realisations themselves.
// Estimates, bounds and remarks are those of the program; here realisations are counted by kind and by class. Of two
// levels of cells only fine realisations count, as P is theirs; levels of a load are never counted together.

import type { ChartOptions, Line } from "../charts/chart";
import type { EventMeta, Place, StudyMeta, Tables } from "../data/documents";
import type { ColumnMeta } from "../data/format";
import type { Table } from "../data/table";
import { mapNamed } from "../logic/colour";
import { fixed, numberText } from "../logic/numbers";
import { classesOf, kindsAt, outcomesOf, type Group } from "../logic/realisations";
import { pixelRatio, type Store } from "../logic/store";
import { currentLanguage, say, type TextKey } from "../logic/texts";
import { element } from "../shell/element";
import { cards, chart, notice, paragraph, probability, section, styled, table, withUnitOf, type Content,
  type Row } from "./document";
import { fragilityPart } from "./fragility";
import { sweepPart } from "./sweep";

const MOST_ROWS = 500; // of the table; results.csv has all
const OF_POINTS = ["latin_hypercube", "sobol"];

export function studyPage(data: StudyMeta, tables: Tables, store: Store): Content {
  if (data.samples !== undefined) return samplesPage(data, tables, store);
  const outcomes = tables.get(data.outcomes)!;
  return {
    title: data.title, window: say("study_window", { title: data.title }), foot: "study_foot",
    subtitle: say("study_subtitle", { n: data.realisations, case: data.case, counts: countsOf(data) }),
    parts: [
      notice(data.remarks),
      ...(data.estimator === "sweep" ? [sweepPart(data, tables, store)]
        : data.method !== undefined ? [methodPart(data)]
        : [data.levels ? fragilityPart(data, store) : probabilitiesPart(data),
          section(say(data.levels ? "study_remains" : "study_how_sure"), cards([
            heightChart(data, store), ...growthCharts(data, store),
            histogram(store, say("study_highest"), say("study_height_axis"),
              outcomesOf(data, outcomes, "residual_height")),
            histogram(store, say("study_volume"), say("study_volume_axis"), outcomesOf(data, outcomes, "slide_volume")),
          ]), data.flood_after_slide_over_level?.length ? paragraph(say("study_over_level_help"), "muted") : null,
          data.growth ? paragraph(say("study_growth_help"), "muted") : null),
          pathPart(data), kindsPart(data, outcomes), sensitivityPart(data)]),
      realisationsPart(data, tables.get(data.inputs)!, outcomes),
    ],
  };
}

function countsOf({ solved, slid_as_drawn, failed }: StudyMeta): string {
  return say("study_solved", { n: solved }) + (slid_as_drawn > 0 ? `, ${say("study_as_drawn", { n: slid_as_drawn })}`
    : "") + `, ${say("study_failed", { n: failed })}`;
}

export const range = (low: number | null, high: number | null) =>
  say("low_to_high", { low: probability(low), high: probability(high) });
export const confidenceOf = (data: StudyMeta) => numberText(100 * data.confidence);
export const slideWords = ({ event }: StudyMeta) =>
  say("study_slide_words", { volume: numberText(event.volume), distance: numberText(event.displacement) });

/** What to think of an estimate of which some realisations are missing; empty where none is. */
export function missingWords({ failed, solved }: Pick<EventMeta, "failed" | "solved">): string {
  return failed > 0 ? ` ${say("study_missing", { n: failed, all: solved + failed })}` : "";
}

/** What P is, in sentences. */
export function answerOf(data: StudyMeta): string {
  const event = (data.flood ?? data.slide)!;
  const of = { what: say(data.flood ? "study_floods" : "study_slides"), confidence: confidenceOf(data),
    low: probability(event.low, 2), high: probability(event.high, 2), p: probability(event.probability, 2) };
  if (event.probability === null)
    return event.solved + event.failed === 0 ? say("study_none") : say("study_not_known", of);
  const ofPoints = OF_POINTS.includes(data.estimator);
  return say(ofPoints ? "study_answer_points" : "study_answer", of) + missingWords(event) + (data.flood
    && data.slide!.probability !== null ? ` ${say("study_slide_too", { p: probability(data.slide!.probability, 2) })}` +
      worthOf(data) : "");
}

/** How many of the slides end in a flood; empty where nothing slid. */
function worthOf({ slide, flood_after_slide: event }: StudyMeta): string {
  if (!event || slide!.happened === 0) return "";
  const whole = (p: number | null) => numberText(Math.round(100 * (p ?? 0)));
  const of = { low: whole(event.low), high: whole(event.high), n: whole(event.probability) };
  return ` ${say(event.probability === null ? "study_worth_not_known" : "study_worth", of)}`;
}

function probabilitiesPart(data: StudyMeta): HTMLElement {
  const ofPoints = OF_POINTS.includes(data.estimator);
  const row = (name: string, event: EventMeta, meaning: string): Row => ({
    head: name,
    cells: [probability(event.probability), event.solved + event.failed === 0 ? "–" : range(event.low, event.high),
      say(data.estimator === "multilevel" ? "study_of_pairs" : "study_of", { n: event.happened, all: event.solved }) +
        (event.failed > 0 ? `, ${say("study_unknown", { n: event.failed })}` : ""), meaning],
  });
  const bounds = say(ofPoints ? "study_bounds_points" : "study_bounds", { confidence: confidenceOf(data) });
  return section(say("study_probabilities"), paragraph(answerOf(data), "answer"),
    table(["", say("study_estimate"), bounds, say("study_realisations"), say("study_meaning")], [
      row("P(I)", data.slide!, slideWords(data)),
      ...(data.flood ? [row("P(F)", data.flood, say("study_flood_words")),
        row("P(F|I)", data.flood_after_slide!, say("study_both_words"))] : []),
    ], "last-is-word"),
    paragraph(`${say("study_what_p_is")} ${say(ofPoints ? "study_clopper_points" : "study_clopper")}`, "muted"));
}

/** Of a method that chooses its realisations. */
function methodPart(data: StudyMeta): HTMLElement | null {
  const { method } = data;
  if (!method) return null;
  const name = data.event.of_flood ? "P(F)" : "P(I)";
  const event = data.event.of_flood ? data.flood : data.slide;
  const known = method.probability !== null;
  const answer = !known ? say("method_not_hit", { name }) + (method.at_most !== null && method.at_most < 1
    ? ` ${say("method_at_most", { p: probability(method.at_most, 2) })}` : "")
    : `${name} = ${probability(method.probability)}, β ${numberText(method.beta, 4)}` +
      (method.cov !== null && event && event.low !== null ? `; ${say("method_roughly",
        { cov: numberText(method.cov, 2), range: range(event.low, event.high), confidence: confidenceOf(data) })}`
        : "") + ".";
  const words = data.event.of_flood ? say("study_flood_words") : slideWords(data);
  const rows = method.design_values.map(({ key, value, unit }, k): Row => ({
    head: key,
    cells: [`${numberText(value, 5)} ${unit === "-" ? "" : unit}`.trim(), numberText(method.influence[k], 3)],
  }));
  return section(say("study_probability"), paragraph(answer, "answer"),
    rows.length > 0 ? table([say("method_input"), say("method_design"), say("method_influence")], rows) : null,
    paragraph(`${say("method_is_of", { name, event: words })} ${say("study_what_p_is")}` +
      (rows.length > 0 ? ` ${say("method_influence_is")}` : ""), "muted"));
}

/** What share of the slides floods at another level of the water: by the ground that they leave. */
function heightChart({ flood_after_slide_over_level: places }: StudyMeta, store: Store): HTMLElement | null {
  if (!places?.length) return null;
  const line = (label: TextKey, part: number, dash: number[]): Line => styled(2, { label: say(label), dash,
    x: places.map(([level]) => level), y: places.map((place) => place[part] ?? null) });
  return chart(store, { title: say("study_over_level"), xLabel: say("study_level_axis"), unit: "-",
    yLabel: say("study_probability_axis"), fromZero: true },
  [line("study_estimate", 1, []), line("study_lower", 2, [2, 3]), line("study_upper", 3, [2, 3])]);
}

function growthCharts({ growth, flood }: StudyMeta, store: Store): (HTMLElement | null)[] {
  const one = (name: string, places: Place[], k: number) => {
    const line = (label: TextKey, part: number, dash: number[]): Line => styled(k, { label: say(label), dash,
      x: places.map(([n]) => n), y: places.map((place) => place[part] ?? null) });
    return chart(store, { title: say("study_over_n", { name }), xLabel: say("study_realisations"), unit: "-",
      yLabel: say("study_probability_axis"), fromZero: true },
    [line("study_estimate", 1, []), line("study_lower", 2, [2, 3]), line("study_upper", 3, [2, 3])]);
  };
  if (!growth) return [];
  return [flood ? one("P(F)", growth.flood, 1) : null, one("P(I)", growth.slide, 0)];
}

/** Of each group the number of values in classes of one size. */
export function histogram(store: Store, title: string, xLabel: string, groups: Group[]): HTMLElement | null {
  const classes = classesOf(groups);
  if (!classes) return null;
  const options: ChartOptions = { title, xLabel, unit: "-", yLabel: say("study_realisations"), fromZero: true };
  return chart(store, options, groups.map(({ name }, k) => styled(k, { label: name || say("study_realisations"),
    x: classes.edges, y: classes.counts[k]!, steps: true })));
}

/** What follows from what, up to the water that flows over; of a load at each of its levels. */
export function pathPart(data: StudyMeta): HTMLElement | null {
  const language = currentLanguage();
  const load = data.of_load;
  const paths = data.levels ? data.levels.map(({ level, failure_path: path }) => ({ level, path: path ?? [] }))
    : [{ level: NaN, path: data.failure_path ?? [] }];
  const rows = paths.flatMap(({ level, path }) => path.map((event): Row => {
    const name = element("td", { class: "words" }, event.name[language]);
    return { head: load ? numberText(level) : event.name[language],
      cells: [...(load ? [name] : []), element("td", { class: "words" }, event.given_name[language]),
        probability(event.probability), event.of + event.unknown === 0 ? "–" : range(event.low, event.high),
        say("study_of", { n: event.happened, all: event.of }) +
          (event.unknown > 0 ? `, ${say("study_unknown", { n: event.unknown })}` : "")] };
  }));
  if (rows.length === 0) return null;
  const heads = [say("path_given"), say("study_estimate"), say("study_bounds", { confidence: confidenceOf(data) }),
    say("study_realisations")];
  return section(say("failure_path"),
    table(load ? [withUnitOf(load.name, load.unit), say("path_event"), ...heads] : [say("path_event"), ...heads], rows),
    paragraph(say("failure_path_help"), "muted"));
}

/** Each kind with how often it happened, and a realisation to be opened. */
function kindsPart(data: StudyMeta, outcomes: Table): HTMLElement {
  const load = data.of_load;
  const rows = (load?.levels ?? [0]).flatMap((level, k) => kindsAt(outcomes, k).map((kind): Row => ({
    head: load ? numberText(level) : kind.name,
    cells: [...(load ? [element("td", { class: "words" }, kind.name)] : []), numberText(kind.n),
      `${numberText(100 * kind.share, 3)}\u202f%`, numberText(kind.volume), numberText(kind.height),
      String(kind.example)],
  })));
  const heads = [say("study_kind"), say("study_realisations"), say("study_share"), say("study_median_slid"),
    say("study_median_remains"), say("study_example")];
  return section(say("study_happened"), table(load ? [withUnitOf(load.name, load.unit), ...heads] : heads, rows,
    load ? "word-second" : ""),
    paragraph(say("study_kinds_help"), "muted"));
}

function sensitivityPart({ sensitivities, estimator, inputs }: StudyMeta): HTMLElement {
  const goesWith = estimator === "two_stage" ? "study_with_falling"
    : estimator === "multilevel" ? "study_with_coarse" : "study_with_slide";
  return section(say("study_matters"), table(["", say(goesWith), say("study_with_height")],
    sensitivities.map(({ with_slide, with_height }, k): Row =>
      ({ head: inputLabel(inputs.columns[k]!), cells: [bar(with_slide), bar(with_height)] })), "correlations"),
  paragraph(say("study_matters_help"), "muted"));
}

/** A key without what all keys begin with. */
function inputLabel({ name, label }: ColumnMeta): string {
  const key = (label ?? name).replace(/^material\./, "");
  return name === "field" ? say("study_field", { key }) : key;
}

/** A correlation with a bar to the right of the middle, or to the left of it. */
function bar(rho: number | null): HTMLElement {
  if (rho === null) return element("td", {}, "–");
  const part = element("span", { class: rho < 0 ? "bar-part negative" : "bar-part" });
  part.style.width = `${50 * Math.abs(rho)}%`;
  part.style.left = `${rho < 0 ? 50 + 50 * rho : 50}%`;
  return element("td", {}, element("span", { class: "two-sided", "aria-hidden": "true" }, part),
    `${rho < 0 ? "" : "+"}${fixed(rho, 2, "")}`);
}

function realisationsPart(data: StudyMeta, inputs: Table, outcomes: Table): HTMLElement {
  const isSweep = data.estimator === "sweep";
  const shown = Math.min(data.realisations, MOST_ROWS);
  const column = (name: string) => outcomes.column(name)!;
  const kept = [["slide_volume", "study_slid_unit"], ["residual_height", "study_remains_unit"],
    ["first_slide_time", "study_slides_at"], ["flood_time", "study_floods_at"]] as const;
  const labels = data.row_labels.length;
  const rows = Array.from({ length: shown }, (_, k): Row => {
    const [state, slide, flood] = [column("state")[k]!, column("slide")[k]!, column("flood")[k]!];
    const words = data.words[k]!;
    const fault = data.faults_of[k] ?? "";
    return { head: String(k), cells: [
      ...words.slice(0, labels),
      say(state === 1 ? "row_failed" : state === 2 ? "row_not_run" : slide === 1 ? "row_slide" : "row_stands"),
      Number.isNaN(flood) ? "–" : state === 3 ? say("row_not_known") : say(flood === 1 ? "row_floods" : "row_holds"),
      ...inputs.columns.map((_, i) =>
        (isSweep && i < data.sweep.length ? words[labels + i]! : numberText(inputs.at(i)[k], 6))),
      ...kept.map(([name]) => numberText(column(name)[k])),
      element("td", { class: "words", lang: fault && currentLanguage() !== "en" ? "en" : null }, fault)] };
  });
  const inputHeads = inputs.columns.map((column, i) =>
    withUnitOf(inputLabel(column), isSweep && i < data.sweep.length ? "" : column.unit));
  return section(say("study_realisations_title"), table(["", ...data.row_labels, "I", "F", ...inputHeads,
    ...kept.map(([, key]) => say(key)), say("study_why")], rows, "last-is-word"),
  paragraph((data.realisations > shown ? `${say("study_first_rows", { n: shown, all: data.realisations })} ` : "") +
    say("study_keep"), "muted"));
}

/** What would be drawn, before a long run. */
function samplesPage(data: StudyMeta, tables: Tables, store: Store): Content {
  const inputs = tables.get(data.inputs)!;
  return {
    title: data.title, window: say("samples_window", { title: data.title }),
    subtitle: say("samples_subtitle", { n: data.samples!, case: data.case }),
    parts: [
      section(say("samples_histograms"), cards(inputs.columns.map((column, i) =>
        histogram(store, inputLabel(column), withUnitOf(inputLabel(column), column.unit),
          [{ name: "", values: Array.from(inputs.at(i)) }])))),
      ...(data.fields ?? []).map(({ key, across, box, pictures }) => {
        const values = tables.get(pictures)!;
        return section(say("samples_field", { key }), cards(values.columns.map(({ name }, k) =>
          element("figure", { class: "card" }, element("figcaption", {}, say("samples_picture", { n: name })),
            fieldPicture(store, values.at(k), across, box)))));
      }),
    ],
  };
}

/** A field over its trend: half of it dark, twice bright. */
function fieldPicture(store: Store, values: Float32Array, across: number,
  [low, high]: [[number, number], [number, number]]): HTMLElement {
  const down = values.length / across;
  const canvas = element("canvas", { class: "field-picture" });
  canvas.style.aspectRatio = String(Math.min((high[0] - low[0]) / (high[1] - low[1]), 8));
  store.watch(["paper"], (state) => {
    const size = Math.ceil(4 * pixelRatio(state));
    [canvas.width, canvas.height] = [across * size, down * size];
    const context = canvas.getContext("2d")!;
    values.forEach((value, k) => {
      context.fillStyle = mapNamed("viridis").at(0.5 + 0.5 * Math.log2(value));
      context.fillRect((k % across) * size, Math.floor(k / across) * size, size, size);
    });
  });
  return canvas;
}
