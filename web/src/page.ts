// The page: header, views with their controls beside the story, pictures, charts, tables, runs.

import type { Report } from "./data/report";
import type { FieldMeta } from "./data/format";
import { PLAIN, pixelRatio, Store, type ViewState } from "./logic/store";
import { toScreen } from "./logic/camera";
import { speeds } from "./logic/time";
import { fieldHelp } from "./logic/labels";
import { numberText, withUnit } from "./logic/numbers";
import { say, type TextKey } from "./logic/texts";
import { Current } from "./view/current";
import { Viewer } from "./view/viewer";
import { Figure, pngOf, save } from "./view/figure";
import { BAR_HEIGHT, drawColourBar, fieldLabel } from "./view/colour_bar";
import { record, videoEnding, videoType } from "./view/video";
import { marksOf, Player } from "./shell/player";
import { fieldControls, layerControls, zoomButtons } from "./shell/controls";
import { Keys, type Actions } from "./shell/keys";
import { keepInAddress } from "./shell/address";
import { followTheme, foot, startDark, topBar } from "./shell/frame";
import { Notice } from "./shell/notice";
import { printOnPaper } from "./shell/paper";
import { element, icon, iconButton } from "./shell/element";
import { storiesSection, summarySection } from "./sections/summary";
import { comparisonSection } from "./sections/comparison";
import { chartsSection } from "./sections/charts";
import { profileCards } from "./sections/profile";
import { strengthCard } from "./sections/strength";
import { hasWater } from "./logic/verdict";
import { verdictSection } from "./sections/verdict";
import { howSureSection } from "./sections/how_sure";
import { momentsSection } from "./sections/moments";
import { aboutSection } from "./sections/about";
import { Pinned } from "./sections/pinned";

function startState(report: Report): ViewState {
  const times = report.runs.flatMap((run) => [run.meta.times[0]!, run.meta.times[run.meta.times.length - 1]!]);
  const field = startField(report);
  return {
    ...PLAIN, time: Math.max(...times), speed: speeds(Math.max(...times) - Math.min(...times)).start,
    field: field?.name ?? "", fixed: field?.range ?? [0, 1], log: field?.log ?? false,
    surfaces: report.runs.length > 1, shown: report.runs.map(() => true), dark: startDark(),
  };
}

/**
 * Of a dike what is left of its strength, which suits layers of any strength; where nothing softens its soils. Else the
 * first.
 */
export function startField({ runs }: Pick<Report, "runs">): FieldMeta | undefined {
  const { fields } = runs[0]!.meta;
  const softens = runs.some(({ meta }) => meta.summary.softened_strain !== null);
  const name = softens ? "su_ratio" : "material";
  return (runs.some(hasWater) && fields.find((field) => field.name === name)) || fields[0];
}

const WIDE = 3.5; // length over height; beside the story such a section gets less than a quarter of the window's height

export function titleOf(report: Report): string {
  const titles = [...new Set(report.runs.map((run) => run.meta.title).filter(Boolean))];
  if (titles.length === 1) return titles[0]!;
  const names = report.runs.map((run) => run.meta.name);
  return names.slice(1).reduce((text, name) => say("and", { a: text, b: name }), names[0] ?? "");
}

export function buildPage(report: Report, page: HTMLElement): void {
  const store = new Store(startState(report));
  const current = new Current(report, store);
  const title = titleOf(report);
  document.title = `${title} · Terp`;
  followTheme(store);
  loadFields(current);

  const viewer = new Viewer(current);
  const player = new Player(current);
  const notice = new Notice();
  const see = element("div", { class: "see" });
  const actions = makeActions(current, viewer, player, notice, title, see);
  const keys = new Keys(current, viewer, player, actions);
  const pinned = new Pinned(current);

  const before = element("canvas", { class: "before" });
  const paper = report.runs.length === 1 && hasWater(report.runs[0]!) && report.runs[0]!.fieldMeta("material");
  see.append(
    paper ? element("figure", { class: "paper-only" }, element("figcaption", {}, say("before")), before) : "",
    viewer.trouble ? element("p", { class: "notice" }, viewer.trouble) : "",
    element("div", { class: "stage" }, viewer.root, zoomButtons(current, viewer)),
    colourBar(current), player.root,
    element("div", { class: "control-rows no-print" }, fieldControls(current), exportButtons(actions),
      layerControls(current, viewer)),
    sampling(report));
  page.replaceChildren(
    topBar(title, report.runs.map((run) => run.meta.name).join(" · "), store,
      [iconButton("print", say("print"), "P", actions.print), iconButton("theme", say("theme"), "T", actions.theme),
        iconButton("help", say("keys"), "?", () => keys.toggleHelp())]),
    element("main", { class: report.runs.some(hasWater) ? "dike" : "" },
      verdictSection(report, store) ?? "",
      element("div", { class: isWide(viewer) ? "first wide" : "first" }, see,
        element("div", { class: "beside" }, pinned.root, ...summarySection(report, store))),
      storiesSection(report, store) ?? "",
      howSureSection(report, store) ?? "",
      remainsSection(current) ?? "",
      momentsSection(current, viewer) ?? "",
      comparisonSection(report, store) ?? "",
      chartsSection(current),
      aboutSection(report, store)),
    foot(report.meta),
    notice.root, keys.help);
  keepInAddress(store, report.fieldNames(), player.span);
  printOnPaper(store, viewer, paper ? before : null);
  window.terp = probe(current, viewer);
}

/** What remains of a dike, and the strength along a vertical. */
function remainsSection(current: Current): HTMLElement | null {
  const cards = [...profileCards(current), strengthCard(current)].filter((card) => card !== null);
  if (cards.length === 0) return null;
  return element("section", { id: "remains", "aria-label": say("profile_title") },
    element("div", { class: "cards" }, ...cards));
}

/** A section much longer than high: the views take the whole width of the page, the story stands below them. */
function isWide(viewer: Viewer): boolean {
  const [x0, y0, x1, y1] = viewer.extent();
  return x1 - x0 > WIDE * (y1 - y0);
}

declare global {
  interface Window {
    terp?: Probe;
  }
}

/** For tests, and for who wants to drive the page from the console. */
export interface Probe {
  store: Store;
  drawn: number; // pictures so far
  ready: boolean; // the chosen field is there in all shown runs
  place: (run: number, point: number) => [number, number]; // of a point now, CSS pixels in its view
}

function probe(current: Current, viewer: Viewer): Probe {
  const { store, report } = current;
  const made: Probe = {
    store,
    drawn: 0,
    get ready() {
      return current.shownRuns().every((run) => !run.fieldMeta(store.state.field) || run.fields.has(store.state.field));
    },
    place: (k, point) => {
      const run = report.runs[k]!;
      return toScreen(viewer.camera(), viewer.viewSize(), ...run.place(current.frame(run), point));
    },
  };
  viewer.onDrawn = () => made.drawn++;
  return made;
}

/** The chosen field of the shown runs first; the others when they are asked for. */
function loadFields(current: Current): void {
  current.store.watch(["field", "shown"], ({ field }) => {
    for (const run of current.shownRuns()) {
      void run.field(field);
      void run.field("material"); // colours the points that have no value
    }
  });
  current.store.on((state, changed) => {
    if (!changed.has("field")) return;
    const meta = current.fieldMeta();
    if (meta) current.store.set({ log: meta.log, rangeMode: state.rangeMode === "fixed" ? "run" : state.rangeMode });
  });
}

/** What the signs on the bar of time, just below, stand for. */
const MARKS: [string, TextKey][] = [["1", "sign_slide"], ["~", "sign_fastest"], ["■", "sign_stops"],
  ["▸", "sign_stage"], ["≈", "sign_floods"]];

function colourBar(current: Current): HTMLElement {
  const canvas = element("canvas", { role: "img", "aria-label": say("colour_bar") });
  const help = element("span");
  const signs = new Set(current.report.runs.flatMap((run) => marksOf(run).map(({ sign }) => sign)));
  const words = MARKS.filter(([sign]) => signs.has(sign)).map(([, key]) => say(key)).join(" · ");
  const marks = words ? element("span", { class: "no-print" }, say("below", { signs: words })) : null;
  const root = element("div", { class: "colour-bar" }, canvas, element("p", { class: "muted small" }, help, marks));
  const draw = () => {
    const ratio = pixelRatio(store.state);
    const width = root.clientWidth;
    if (width === 0) return;
    [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(BAR_HEIGHT * ratio)];
    const context = canvas.getContext("2d")!;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    drawColourBar(context, current, width);
    const { lo, hi } = current.range();
    const meta = current.fieldMeta();
    canvas.setAttribute("aria-label",
      say("colours_from", { label: fieldLabel(current, store.state.field), lo: numberText(lo, 3),
        hi: withUnit(hi, meta?.unit ?? "", 3) }));
  };
  const { store, report } = current;
  store.watch(["field"], ({ field }) => (help.textContent = fieldHelp(field)));
  store.on((state, changed) => {
    const keys = ["field", "map", "rangeMode", "fixed", "log", "dark", "shown", "paper"] as const;
    if (keys.some((key) => changed.has(key)) || (changed.has("time") && state.rangeMode === "frame")) draw();
  });
  for (const run of report.runs) run.onField.push(draw);
  new ResizeObserver(draw).observe(root);
  return root;
}

function exportButtons(actions: Actions): HTMLElement {
  const button = (name: string, text: string, title: string, act: () => void) =>
    element("button", { type: "button", class: "text-button", title, "aria-label": title, onclick: act }, icon(name),
    element("span", {}, text));
  return element("div", { class: "controls exports" },
    button("image", say("image"), say("save_image"), actions.image),
    button("film", say("video"), say("save_video"), actions.video),
    button("full", say("full_screen"), say("full_screen_views"), actions.fullScreen));
}

function sampling(report: Report): HTMLElement | string {
  const sampled = report.runs.filter((run) => run.meta.n_shown < run.meta.n_points);
  if (sampled.length === 0) return "";
  const [run] = sampled;
  const every = Math.round(run!.meta.n_points / run!.meta.n_shown);
  return element("p", { class: "muted small" },
    say("sampling",
      { every, shown: numberText(run!.meta.n_shown, 9), all: numberText(run!.meta.n_points, 9) }));
}

function makeActions(current: Current, viewer: Viewer, player: Player, notice: Notice, title: string,
  see: HTMLElement): Actions {
  const { store } = current;
  const figure = new Figure(current, viewer, title);
  const name = current.report.runs.map((run) => run.meta.name).join("_");
  return {
    image: () => void pngOf(figure,
      store.state.time).then((blob) => save(blob, `${name}_${store.state.time.toFixed(2)}s.png`),
      (error: Error) => notice.say(error.message)),
    video: () => {
      const type = videoType();
      if (!type) return notice.say(say("no_video"));
      store.set({ playing: false });
      const recording = record(figure, type, player.span, store.state.speed,
        (part) => notice.progress(say("recording"), part, () => recording.cancel()));
      recording.done.then((blob) => {
        notice.hide();
        if (blob) save(blob, `${name}.${videoEnding(type)}`);
      }, (error: Error) => notice.say(error.message));
    },
    fullScreen: () => void (document.fullscreenElement ? document.exitFullscreen()
      : see.requestFullscreen?.())?.catch?.(() => notice.say(say("no_full_screen"))),
    theme: () => store.set({ dark: !store.state.dark }),
    print: () => window.print(),
  };
}
