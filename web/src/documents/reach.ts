// The sections of a reach: a row for each with its verdict and a link to the page of its run. Verdicts and hints are
// those of the program. A fault, and why there is no trigger, are in English alone, and are marked so on a Dutch page.

import type { ReachMeta, ReachSection } from "../data/documents";
import { fixed, metres, numberText } from "../logic/numbers";
import { pixelRatio, type Store } from "../logic/store";
import { currentLanguage, say, type TextKey } from "../logic/texts";
import { triggerWords } from "../logic/story";
import { canvasTheme } from "../view/theme";
import { element } from "../shell/element";
import { paragraph, table, type Content, type Row } from "./document";

const VERDICTS = ["stands", "damaged", "still_moving", "near", "floods"] as const;
const isSolved = ({ state }: ReachSection) => state === "solved";
const verdictOf = (s: ReachSection) => (isSolved(s) ? s.flood?.verdict ?? null : null);
const inDutch = () => currentLanguage() === "nl";

export function reachPage({ sections }: ReachMeta, store: Store): Content {
  const heads = ["section", "picture", "verdict", "height", "freeboard", "factor", "time"] as const;
  return {
    title: say("reach_title"), window: say("reach_title"), subtitle: countsOf(sections), foot: "reach_foot", wide: true,
    parts: [
      paragraph(say("reach_caution"), "notice"),
      table(heads.map((head) => say(`reach_${head}`)), sections.map((s) => rowOf(s, store)), "sections"),
    ],
  };
}

export function countsOf(sections: ReachSection[]): string {
  const solved = sections.filter(isSolved);
  const n = Object.fromEntries(VERDICTS.map((verdict) =>
    [verdict, solved.filter((s) => verdictOf(s) === verdict).length]));
  const moving = sections.filter(({ moves }) => moves).length;
  return say("reach_counts", { solved: solved.length, all: sections.length, ...n,
    none: solved.filter((s) => verdictOf(s) === null).length, open: sections.length - solved.length }) +
    (moving > 0 ? ` ${say("reach_moving", { n: moving })}` : "");
}

/** Of a section: what stands in bold, and what follows from it. */
export function verdictWords(s: ReachSection): { verdict: string; before: string } {
  if (!isSolved(s)) return { verdict: say(`reach_${s.state.replace(" ", "_")}` as TextKey), before: "" };
  const { flood } = s;
  if (!flood?.verdict) return { verdict: say("verdict_none"), before: "" };
  const { trigger } = flood;
  const before = !trigger ? "" : trigger.before ? say(`before_trigger_${trigger.before}` as TextKey)
    : s.moved_before_trigger ? say("reach_moved_before") : "";
  return { verdict: say(`verdict_${flood.verdict}` as TextKey) + triggerWords(trigger), before };
}

function rowOf(s: ReachSection, store: Store): Row {
  const { verdict, before } = verdictWords(s);
  const marked = verdictOf(s) && s.moves ? element("span", { class: "caution" }, ` ⚠ ${say("reach_at_rest")}`) : null;
  const stored = inDutch() ? s.stored_text_nl : s.stored_text;
  const words = element("td", { class: "words" }, element("p", { class: "verdict-words" }, verdict, marked),
    paragraph(s.state === "solved" ? "" : s.fault, "", "en"), paragraph(before),
    ...(inDutch() ? s.hints_nl : s.hints).map((hint) => paragraph(hint, "caution")),
    isSolved(s) ? paragraph(s.trigger, "", "en") : null);
  const factor = element("td", { class: "words" },
    s.factor === null ? null : element("p", {}, s.uncertainty === null
      ? say("reach_at_most", { factor: fixed(s.factor, 3, "") })
      : `${fixed(s.factor, 3, "")} ± ${fixed(s.uncertainty, 3, "")}`),
    stored ? paragraph(`${say("reach_stored")}: ${stored}`, "muted") : null);
  return {
    head: nameOf(s), name: isSolved(s) ? s.flood?.verdict ?? undefined : "fault",
    cells: [picture(s, store), words, numberCell(metres(isSolved(s) ? s.residual_height : null)),
      numberCell(metres(isSolved(s) ? s.flood?.freeboard : null)), factor,
      numberCell(`${numberText(Math.round(s.seconds))}\u00a0s`)],
  };
}

const numberCell = (text: string) => element("td", {}, text);

/** Its name with a link to the page of its run, its title, and what was assumed. */
function nameOf({ name, title, has_report, state }: ReachSection): HTMLElement {
  const folder = encodeURIComponent(name);
  return element("div", {},
    element("p", {}, state === "solved"
      ? element("a", { href: `${folder}/run/report.html`, title: say("reach_report") }, name) : name),
    paragraph(title, "muted"),
    has_report ? element("p", {}, element("a", { href: `${folder}/report.md` }, say("reach_assumed"))) : null);
}

/** The ground before and after, and the water. */
function picture({ ground, flood, name }: ReachSection, store: Store): HTMLElement {
  const [wide, high, edge] = [220, 74, 4];
  const level = typeof flood?.water_level === "number" ? flood.water_level : null;
  const heights = [...ground.flatMap(([, before, after]) => [before, after]), level].filter((y) => y !== null);
  const xs = ground.map(([x]) => x);
  const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...heights), Math.max(...heights)];
  if (!(x0 < x1 && y0 < y1)) return element("td", {}, "");
  const canvas = element("canvas", { role: "img", "aria-label": `${name}: ${say("reach_picture")}` });
  canvas.style.width = `${wide}px`;
  const place = (x: number, y: number) => [edge + ((x - x0) / (x1 - x0)) * (wide - 2 * edge),
    high - edge - ((y - y0) / (y1 - y0)) * (high - 2 * edge)] as const;
  const line = (context: CanvasRenderingContext2D, places: [number, number | null][], colour: string,
    dash: number[]) => {
    context.beginPath();
    for (const [x, y] of places) if (y !== null) context.lineTo(...place(x, y));
    context.setLineDash(dash);
    context.strokeStyle = colour;
    context.stroke();
  };
  store.watch(["dark", "paper"], (state) => {
    const ratio = pixelRatio(state);
    const theme = canvasTheme(state.dark);
    [canvas.width, canvas.height] = [wide * ratio, high * ratio];
    const context = canvas.getContext("2d")!;
    context.scale(ratio, ratio);
    context.lineWidth = 1.5;
    if (level !== null) line(context, [[x0, level], [x1, level]], theme.water, [3, 3]);
    line(context, ground.map(([x, before]) => [x, before]), theme.muted, [6, 3]);
    line(context, ground.map(([x, , after]) => [x, after]), theme.text, []);
  });
  return element("td", {}, canvas);
}
