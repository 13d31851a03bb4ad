// The page: header, views with their controls beside the story, pictures, charts, tables, runs.

import type { Report } from "./data/report";
import { Store, type ViewState } from "./logic/store";
import { toScreen } from "./logic/camera";
import { speeds } from "./logic/time";
import { fieldHelp } from "./logic/labels";
import { numberText, withUnit } from "./logic/numbers";
import { Current } from "./view/current";
import { Viewer } from "./view/viewer";
import { Figure, pngOf, save } from "./view/figure";
import { BAR_HEIGHT, drawColourBar } from "./view/colour_bar";
import { record, videoEnding, videoType } from "./view/video";
import { marksOf, Player } from "./shell/player";
import { fieldControls, layerControls, zoomButtons } from "./shell/controls";
import { Keys, type Actions } from "./shell/keys";
import { keepInAddress } from "./shell/address";
import { Notice } from "./shell/notice";
import { element, icon, iconButton } from "./shell/element";
import { storiesSection, summarySection } from "./sections/summary";
import { comparisonSection } from "./sections/comparison";
import { chartsSection } from "./sections/charts";
import { momentsSection } from "./sections/moments";
import { aboutSection } from "./sections/about";
import { Pinned } from "./sections/pinned";

function startState(report: Report): ViewState {
  const [first] = report.runs;
  const times = report.runs.flatMap((run) => [run.meta.times[0]!, run.meta.times[run.meta.times.length - 1]!]);
  const field = first!.meta.fields[0];
  return {
    time: Math.max(...times), playing: false, again: false,
      speed: speeds(Math.max(...times) - Math.min(...times)).start,
    field: field?.name ?? "", map: "viridis", rangeMode: "run", fixed: field?.range ?? [0, 1], log: field?.log ?? false,
    mesh: false, outline: true, slip: true, surfaces: report.runs.length > 1, names: false, pointScale: 1,
    camera: null, layout: "auto", hover: null, pin: null, shown: report.runs.map(() => true), dark: startDark(),
  };
}

function startDark(): boolean {
  return matchMedia("(prefers-color-scheme: dark)").matches;
}

const WIDE = 3.5; // length over height; beside the story such a section gets less than a quarter of the window's height

export function titleOf(report: Report): string {
  const titles = [...new Set(report.runs.map((run) => run.meta.title).filter(Boolean))];
  if (titles.length === 1) return titles[0]!;
  return report.runs.map((run) => run.meta.name).join(" and ");
}

export function buildPage(report: Report, page: HTMLElement): void {
  const store = new Store(startState(report));
  const current = new Current(report, store);
  const title = titleOf(report);
  document.title = `${title} · Terp`;
  store.watch(["dark"], ({ dark }) => (document.documentElement.dataset.theme = dark ? "dark" : "light"));
  loadFields(current);

  const viewer = new Viewer(current);
  const player = new Player(current);
  const notice = new Notice();
  const see = element("div", { class: "see" });
  const actions = makeActions(current, viewer, player, notice, title, see);
  const keys = new Keys(current, viewer, player, actions);
  const pinned = new Pinned(current);

  see.append(
    viewer.trouble ? element("p", { class: "notice" }, viewer.trouble) : "",
    element("div", { class: "stage" }, viewer.root, zoomButtons(current, viewer)),
    colourBar(current), player.root,
    element("div", { class: "control-rows no-print" }, fieldControls(current), exportButtons(actions),
      layerControls(current, viewer)),
    sampling(report));
  page.replaceChildren(
    header(report, title, actions, keys),
    element("main", {},
      element("div", { class: isWide(viewer) ? "first wide" : "first" }, see,
        element("div", { class: "beside" }, pinned.root, summarySection(report, store))),
      storiesSection(report, store) ?? "",
      momentsSection(current, viewer) ?? "",
      comparisonSection(report, store) ?? "",
      chartsSection(current),
      aboutSection(report, store)),
    element("footer", {},
      `Written by Terp ${report.meta.terp}, ${report.meta.written.replace("T", " ").replace("Z", " UTC")}. ` +
        "This file holds all data that it shows."),
    notice.root, keys.help);
  keepInAddress(store, report.fieldNames(), player.span);
  printLight(store, viewer);
  window.terp = probe(current, viewer);
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

function header(report: Report, title: string, actions: Actions, keys: Keys): HTMLElement {
  const names = report.runs.map((run) => run.meta.name).join(" · ");
  return element("header", { class: "top" },
    element("span", { class: "mark-name" }, "Terp"),
    element("div", { class: "titles" }, element("h1", {}, title), element("p", { class: "muted" }, names)),
    element("nav", { class: "no-print", "aria-label": "Page" },
      iconButton("print", "Print, or save as PDF", "P", actions.print),
        iconButton("theme", "Light, dark", "T", actions.theme),
        iconButton("help", "Keys", "?", () => keys.toggleHelp())));
}

/** The chosen field of the shown runs first; the others when they are asked for. */
function loadFields(current: Current): void {
  current.store.watch(["field", "shown"], ({ field }) => {
    for (const run of current.shownRuns()) void run.field(field);
  });
  current.store.on((state, changed) => {
    if (!changed.has("field")) return;
    const meta = current.fieldMeta();
    if (meta) current.store.set({ log: meta.log, rangeMode: state.rangeMode === "fixed" ? "run" : state.rangeMode });
  });
}

/** What the signs on the bar of time, just below, stand for. */
const MARKS: [string, string][] = [["1", "1, 2 slide begins"], ["~", "~ shears fastest"], ["■", "■ stops"],
  ["▸", "▸ stage begins"], ["≈", "≈ floods"]];

function colourBar(current: Current): HTMLElement {
  const canvas = element("canvas", { role: "img", "aria-label": "Colour bar" });
  const help = element("span");
  const signs = new Set(current.report.runs.flatMap((run) => marksOf(run).map(({ sign }) => sign)));
  const words = MARKS.filter(([sign]) => signs.has(sign)).map(([, text]) => text).join(" · ");
  const marks = words ? element("span", { class: "no-print" }, `Below: ${words}`) : null;
  const root = element("div", { class: "colour-bar" }, canvas, element("p", { class: "muted small" }, help, marks));
  const draw = () => {
    const ratio = window.devicePixelRatio || 1;
    const width = root.clientWidth;
    if (width === 0) return;
    [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(BAR_HEIGHT * ratio)];
    const context = canvas.getContext("2d")!;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    drawColourBar(context, current, width);
    const { lo, hi } = current.range();
    const meta = current.fieldMeta();
    canvas.setAttribute("aria-label",
      `Colours: ${meta?.label} from ${numberText(lo, 3)} to ${withUnit(hi, meta?.unit ?? "", 3)}`);
  };
  const { store, report } = current;
  store.watch(["field"], ({ field }) => (help.textContent = fieldHelp(field)));
  store.on((state, changed) => {
    const keys = ["field", "map", "rangeMode", "fixed", "log", "dark", "shown"] as const;
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
    button("image", "Image", "Save the views as a PNG (E)", actions.image),
    button("film", "Video", "Save the animation (V)", actions.video),
    button("full", "Full screen", "Views on the full screen (F)", actions.fullScreen));
}

function sampling(report: Report): HTMLElement | string {
  const sampled = report.runs.filter((run) => run.meta.n_shown < run.meta.n_points);
  if (sampled.length === 0) return "";
  const [run] = sampled;
  const every = Math.round(run!.meta.n_points / run!.meta.n_shown);
  return element("p", { class: "muted small" },
    `One material point in ${every} is shown: ${numberText(run!.meta.n_shown, 9)} of ` +
      `${numberText(run!.meta.n_points, 9)}. ` +
      "All are in the frames of the run.");
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
      if (!type) return notice.say("This browser cannot record a video. Chrome, Edge and Firefox can.");
      store.set({ playing: false });
      const recording = record(figure, type, player.span, store.state.speed,
        (part) => notice.progress("Recording the video", part, () => recording.cancel()));
      recording.done.then((blob) => {
        notice.hide();
        if (blob) save(blob, `${name}.${videoEnding(type)}`);
      }, (error: Error) => notice.say(error.message));
    },
    fullScreen: () => void (document.fullscreenElement ? document.exitFullscreen()
      : see.requestFullscreen?.())?.catch?.(() => notice.say("This browser does not allow the full screen here.")),
    theme: () => store.set({ dark: !store.state.dark }),
    print: () => window.print(),
  };
}

/** Paper is white, and nothing on it can be opened: prints in light colours with the case files, then goes back. */
function printLight(store: Store, viewer: Viewer): void {
  let dark = false;
  let opened: HTMLDetailsElement[] = [];
  window.addEventListener("beforeprint", () => {
    dark = store.state.dark;
    opened = [...document.querySelectorAll<HTMLDetailsElement>("details:not([open])")];
    for (const details of opened) details.open = true;
    store.set({ dark: false, playing: false });
    viewer.draw();
  });
  window.addEventListener("afterprint", () => {
    store.set({ dark });
    for (const details of opened) details.open = false;
  });
}
