// The page with the solver: a section is dropped, looked at, run and judged. All that is chosen and found is in `Page`;
// `render` draws it anew whenever one of them changes, the progress of a run alone is renewed in place.

import "../src/style.css";
import "./solver.css";
import { bytesOfBase64, gunzip } from "../src/data/chunks";
import { LANGUAGES } from "../src/logic/texts";
import { element } from "../src/shell/element";
import { save } from "../src/view/figure";
import { Work, type Outcome, type Program } from "./engine";
import * as job from "./job";
import { NO_CHOICES, type Choices } from "./job";
import { readFiles, Refusal, type Source } from "./source";
import { bytes, chooseLanguage, currentLanguage, duration, number, say, type TextKey } from "./texts";
import type { ProgressNow } from "./worker";
import { writeZip, type Files } from "./zip";

interface Meta {
  version: string;
  sum: string;
  size: number;
  licences: string;
}

interface Listing {
  scenarios: { label: string; stages: { label: string }[] }[];
}

interface Checked {
  title: string;
  cells: number;
  cell_size: number;
  points: number;
  bodies: { name: string; material: string; area: number; points: number }[];
  read_as: string[];
  doubts: { en: string[]; nl: string[] };
  steps: number;
  may_end_early: boolean;
  flood: { level: number } | null;
  memory_bytes: number;
  expected_s: number;
}

interface Result {
  files: Files;
  status: number; // of the run
  stopped: boolean;
  time: number; // reached [s]
  said: string;
}

interface Factor {
  factor: string;
  picture: string; // address; empty: none
  said: string;
}

const MOST_MEMORY = 3e9;
const LONG_S = 600;
const text_of = (files: Files, path: string) => new TextDecoder().decode(files.get(path));

class Page {
  source: Source | null = null;
  listing: Listing | null = null;
  choices: Choices = { ...NO_CHOICES };
  checked: Checked | null = null;
  case_files: Files = new Map();
  findings: string[] = [];
  trouble = "";
  details = ""; // of the trouble, in the words of the program
  busy = ""; // what is being done; empty: nothing
  work: Work | null = null;
  solves = false;
  result: Result | null = null;
  factor: Factor | null = null;
  private addresses: string[] = [];

  constructor(readonly program: Program, readonly examples: Map<string, Files>, readonly meta: Meta, readonly root: HTMLElement) {}

  /** Of a file, for a picture or frame; those before are given back. */
  address(blob: Blob): string {
    const address = URL.createObjectURL(blob);
    this.addresses.push(address);
    return address;
  }

  forget(): void {
    this.addresses.forEach((address) => URL.revokeObjectURL(address));
    this.addresses = [];
  }
}

let page: Page;
let progress: { bar: HTMLProgressElement; words: HTMLElement } | null = null;

// ------------------------------------------------------------------------------------------------ what is done

function refuse(what: string, details = ""): void {
  Object.assign(page, { trouble: what, details, busy: "", work: null, solves: false });
  render();
  page.root.querySelector<HTMLElement>(".trouble")?.focus();
}

/** What went wrong in a job, in words; empty: nothing, or a run that ended by itself. */
function faultOf(outcome: Outcome): string {
  if (outcome.fault !== "")
    return /memory|allocat/i.test(outcome.fault) ? say("no_memory") : say("fault", { text: outcome.fault });
  return /not enough memory/.test(outcome.errors) ? say("no_memory") : "";
}

async function take(files: readonly File[]): Promise<void> {
  if (files.length > 0) await takeSource(() => readFiles(files), files[0]!.name);
}

async function takeSource(read: () => Promise<Source>, name: string): Promise<void> {
  page.work?.stop();
  page.forget();
  const { program, examples, meta, root } = page;
  page = new Page(program, examples, meta, root);
  page.busy = say("reading", { name });
  render();
  try {
    page.source = await read();
  } catch (error) {
    if (!(error instanceof Refusal)) throw error;
    return refuse(error.message);
  }
  if (job.isStix(page.source)) {
    const outcome = await new Work(page.program, page.source.files, job.listing(page.source)).outcome;
    if (outcome.statuses[0] !== 0) return refuse(faultOf(outcome) || say("bad_file", { name }), outcome.errors);
    page.listing = JSON.parse(outcome.out) as Listing;
    page.choices.scenario = 1;
    page.choices.stage = page.listing.scenarios[0]?.stages.length ?? 0;
  }
  await look();
}

/** Imports, checks and draws what is chosen. */
async function look(): Promise<void> {
  const { source } = page;
  if (!source) return;
  page.forget();
  Object.assign(page, { busy: say("reading", { name: source.name }), trouble: "", details: "", result: null, factor: null, checked: null });
  render();
  page.work = new Work(page.program, source.files, job.check(source, page.choices));
  const outcome = await page.work.outcome;
  if (page.source !== source) return; // another file was dropped meanwhile
  page.work = null;
  const fault = faultOf(outcome);
  if (fault || outcome.statuses.length === 0 || outcome.statuses.some((status) => status !== 0))
    return refuse(fault || say("bad_file", { name: source.name }), outcome.errors);
  page.checked = JSON.parse(outcome.out.slice(outcome.out.indexOf("\n{") + 1)) as Checked;
  page.case_files = outcome.files;
  page.findings = outcome.errors.split(/\n(?=warning: )/).map((text) => text.trim()).filter((text) => text.startsWith("warning: "))
    .map((text) => text.slice(9));
  page.busy = "";
  render();
}

async function solve(goes_on = false): Promise<void> {
  const { source, choices, result } = page;
  if (!source || (goes_on && !result && !source.checked_run)) return;
  const language = currentLanguage();
  Object.assign(page, { solves: true, trouble: "", details: "", busy: " " });
  const start = goes_on ? result?.files ?? source.files : page.case_files;
  if (choices.verdict || goes_on) {
    let time = result?.time ?? 0;
    page.result = null;
    render();
    const calls = goes_on ? job.resume(source, choices, language) : job.run(source, choices, language);
    const watch = progressWatch((now) => (time = now.time));
    page.work = new Work(page.program, start, calls, { ...watch, line: (line) => /^(solved|stopped) /.test(line) && tellProgress(1, say("writing_report")) });
    const outcome = await page.work.outcome;
    const fault = faultOf(outcome);
    if (fault) return refuse(fault, outcome.errors);
    if (outcome.ended) return refuse(say("was_ended"));
    const status = outcome.statuses[0]!;
    if (status === 2 || !outcome.files.has(job.REPORT)) return refuse(say("bad_file", { name: source.name }), outcome.errors);
    const stopped = /^stopped at t = /m.test(outcome.out);
    page.result = { files: outcome.files, status, stopped, time, said: outcome.out + outcome.errors };
    if (stopped) return finish();
  }
  if (choices.factor && !goes_on) {
    page.factor = null;
    render();
    page.work = new Work(page.program, page.case_files, job.stability(source, choices),
      { line: (line) => line.startsWith("factor ") && tellProgress(null, say("factor_so_far", { line: line.replace(/^factor /, "") })) });
    tellProgress(null, say("what_factor"));
    const outcome = await page.work.outcome;
    const fault = faultOf(outcome);
    if (fault) return refuse(fault, outcome.errors);
    if (outcome.ended) return page.result ? finish() : refuse(say("was_ended"));
    const json = outcome.files.has("stability/stability.json") ? JSON.parse(text_of(outcome.files, "stability/stability.json")) as
      { factor_of_safety: number | null } : { factor_of_safety: null };
    const picture = outcome.files.get("stability/mechanism.svg");
    page.factor = {
      factor: json.factor_of_safety === null ? "–" : number(json.factor_of_safety, 3),
      picture: picture ? page.address(new Blob([picture], { type: "image/svg+xml" })) : "",
      said: outcome.out + outcome.errors,
    };
    for (const [path, content] of outcome.files) if (path.startsWith("stability/")) page.case_files.set(path, content);
  }
  finish();
}

function finish(): void {
  Object.assign(page, { solves: false, work: null, busy: "" });
  render();
  page.root.querySelector<HTMLElement>("#result h2")?.focus();
}

function progressWatch(seen: (now: ProgressNow) => void) {
  let first: { step: number; clock: number } | null = null;
  return {
    progress: (now: ProgressNow) => {
      seen(now);
      if (now.searches) return tellProgress(null, say("searching", { step: now.step }));
      first ??= { step: now.step, clock: performance.now() };
      const rate = (now.step - first.step) / (performance.now() - first.clock); // steps per ms
      const left = rate > 0 && performance.now() - first.clock > 1000 ? (now.n_steps - now.step) / rate / 1000 : null;
      const words = say("solving", { time: now.time.toFixed(2), end: number(now.end_time), step: now.step, steps: now.n_steps });
      tellProgress(now.step / now.n_steps,
        left === null ? words : `${words}; ${say(now.at_most ? "left_at_most" : "left", { time: duration(left) })}`);
    },
  };
}

/** share: null where it is not known. */
function tellProgress(share: number | null, words: string): void {
  if (!progress) return;
  if (share === null) progress.bar.removeAttribute("value");
  else progress.bar.value = share;
  progress.words.textContent = words;
}

function saveFile(path: string, name: string, type: string): void {
  save(new Blob([page.result!.files.get(path)!], { type }), name);
}

function saveCase(): void {
  const files: Files = new Map([...(page.result?.files ?? page.case_files)].filter(([path]) =>
    path.startsWith("case/") || path.startsWith("run/") || path === page.source!.path));
  for (const [path, content] of page.case_files) if (path.startsWith("stability/")) files.set(path, content);
  save(writeZip(files), `${stem()}.zip`);
}

const stem = () => page.source!.name.replace(/^.*\//, "").replace(/\.\w+$/, "").replace(/[^\w.-]+/g, "_");

// ------------------------------------------------------------------------------------------------ how it looks

function render(): void {
  const { source, checked } = page;
  progress = null;
  document.documentElement.lang = currentLanguage();
  document.title = source ? `${source.name} · Terp` : "Terp";
  page.root.replaceChildren(header(), element("main", { class: "solver" },
    page.trouble ? trouble() : null,
    source ? null : welcome(),
    page.busy && !page.solves ? element("p", { class: "card", role: "status" }, page.busy) : null,
    checked ? section(checked) : null,
    source && !(page.busy && !page.solves) ? choices(source) : null,
    checked ? running(checked) : null,
    page.result || page.factor ? results() : null), footer());
}

function header(): HTMLElement {
  const select = element("select", { class: "language", "aria-label": say("language"), disabled: page.solves, onchange: () => {
    chooseLanguage([select.value]);
    render();
  } }, ...LANGUAGES.map(({ code, name }) => element("option", { value: code }, name)));
  select.value = currentLanguage();
  return element("header", { class: "top" }, element("span", { class: "mark-name" }, "Terp"),
    element("div", { class: "titles" }, element("h1", {}, say("title")),
      element("p", { class: "muted" }, page.checked?.title ?? "")),
    element("nav", { class: "no-print" }, select,
      page.source ? element("button", { type: "button", class: "text-button", disabled: page.solves, onclick: anew }, say("other_file")) : null));
}

function anew(): void {
  page.work?.stop();
  page.forget();
  page = new Page(page.program, page.examples, page.meta, page.root);
  render();
}

function footer(): HTMLElement {
  return element("footer", {}, say("version", { version: page.meta.version, size: bytes(page.meta.size), sum: page.meta.sum }),
    element("details", { class: "licences" }, element("summary", {}, "Licences"), element("pre", {}, page.meta.licences)));
}

function trouble(): HTMLElement {
  return element("section", { class: "notice trouble", role: "alert", tabindex: -1 }, element("p", {}, page.trouble),
    page.details ? element("pre", { class: "scroll" }, page.details) : null);
}

function welcome(): HTMLElement {
  const input = element("input", { type: "file", multiple: true, class: "hidden-input", id: "files",
    onchange: () => void take([...(input.files ?? [])]) });
  return element("section", { class: "welcome" },
    element("p", { class: "lead" }, say("intro")),
    element("div", { class: "drop" }, input, element("label", { for: "files" }, say("drop")), element("p", { class: "muted small" }, say("kinds"))),
    element("p", { class: "controls" }, say("examples"), ...[...page.examples].map(([name, files]) =>
      element("button", { type: "button", class: "text-button", "data-example": name, onclick: () => void takeExample(name, files) },
        say(`example_${name}` as TextKey)))),
    element("p", {}, say("stays_here")),
    element("h2", {}, say("limits")), element("p", {}, say("limits_text")));
}

function takeExample(name: string, files: Files): Promise<void> {
  const list = [...files].map(([path, content]) => new File([content], path));
  return takeSource(() => readFiles(list), say(`example_${name}` as TextKey));
}

function section(checked: Checked): HTMLElement {
  const picture = page.case_files.get(job.PICTURE);
  const doubts = checked.doubts[currentLanguage()];
  const findings = [...doubts, ...page.findings];
  const fact = (key: TextKey, value: string) => [element("dt", {}, say(key)), element("dd", {}, value)];
  return element("section", { id: "section" },
    element("h2", {}, say("section")),
    element("p", { class: "muted" }, say("read_from", { name: page.source!.name })),
    element("div", { class: "card" },
      picture ? element("img", { class: "picture", alt: say("picture"), src: page.address(new Blob([picture], { type: "image/svg+xml" })) }) : null),
    element("div", { class: "columns" },
      element("div", { class: "card scroll" }, element("table", {},
        element("thead", {}, element("tr", {}, ...(["soil", "area", "points"] as const).map((key) => element("th", { scope: "col" }, say(key))))),
        element("tbody", {}, ...checked.bodies.map((body) => element("tr", {},
          element("td", {}, body.name && body.name !== body.material ? `${body.name}: ${body.material}` : body.material),
          element("td", {}, `${number(body.area)} m²`), element("td", {}, String(body.points))))))),
      element("dl", { class: "card facts" },
        ...fact("cells", say("cells_value", { n: checked.cells, size: number(checked.cell_size, 2) })),
        ...fact("points", String(checked.points)),
        ...(checked.flood ? fact("judged", `${number(checked.flood.level)} m`) : []),
        ...fact("steps", checked.may_end_early ? say("at_most", { n: checked.steps }) : String(checked.steps)),
        ...fact("memory", bytes(checked.memory_bytes)),
        ...fact("time", duration(checked.expected_s)))),
    element("details", { class: "card findings", open: findings.length > 0 && findings.length < 8 },
      element("summary", {}, findings.length ? say("findings", { n: findings.length }) : say("no_findings")),
      page.findings.length && say("findings_language") ? element("p", { class: "muted small" }, say("findings_language")) : null,
      element("ul", {}, ...findings.map((finding) => element("li", {}, finding)))),
    checked.read_as.length ? element("details", { class: "card findings" }, element("summary", {}, say("read_as")),
      element("ul", {}, ...checked.read_as.map((note) => element("li", {}, note)))) : null);
}

function field(key: TextKey, control: HTMLElement): HTMLElement {
  return element("label", { class: "field" }, element("span", {}, say(key)), control);
}

function numberInput(key: "cell" | "at_strength" | "least_depth", placeholder: string): HTMLInputElement {
  const input = element("input", { type: "number", min: 0, step: "any", inputmode: "decimal", class: "bound", name: key, placeholder,
    value: page.choices[key] ?? "", disabled: page.solves,
    onchange: () => {
      const value = input.valueAsNumber;
      page.choices[key] = value > 0 ? value : null;
    } });
  return input;
}

function choice<K extends keyof Choices>(key: K, options: [value: Choices[K], label: string][]): HTMLSelectElement {
  const select = element("select", { name: key, disabled: page.solves, onchange: () => {
    page.choices[key] = options[select.selectedIndex]![0];
    if (key === "scenario") page.choices.stage = page.listing!.scenarios[page.choices.scenario - 1]!.stages.length;
    if (key === "scenario") render();
  } }, ...options.map(([, label]) => element("option", {}, label)));
  select.selectedIndex = options.findIndex(([value]) => value === page.choices[key]);
  return select;
}

function toggle(key: "verdict" | "factor", words: TextKey): HTMLElement {
  const input = element("input", { type: "checkbox", name: key, checked: page.choices[key], disabled: page.solves,
    onchange: () => (page.choices[key] = input.checked) });
  return element("label", { class: "toggle-line" }, input, say(words));
}

function choices(source: Source): HTMLElement {
  const scenarios = page.listing?.scenarios ?? [];
  const stages = scenarios[page.choices.scenario - 1]?.stages ?? [];
  const of_stix = job.isStix(source) && page.listing;
  return element("form", { id: "choices", class: "card", onsubmit: (event: Event) => {
    event.preventDefault();
    void look();
  } },
  element("h2", {}, say("choices")),
  element("div", { class: "fields" },
    of_stix ? field("scenario", choice("scenario", scenarios.map(({ label }, k) => [k + 1, label || String(k + 1)]))) : null,
    of_stix ? field("stage", choice("stage", stages.map(({ label }, k) => [k + 1, label || String(k + 1)]))) : null,
    field("cell", numberInput("cell", page.checked ? number(page.checked.cell_size, 2) : say("from_section"))),
    of_stix ? field("strength", choice("strength", (["deterministic", "mean", "design"] as const).map((s) => [s, say(`strength_${s}`)]))) : null,
    of_stix ? field("trigger", choice("trigger", (["none", "water", "strength"] as const).map((t) => [t, say(`trigger_${t}`)]))) : null,
    field("at_strength", numberInput("at_strength", "1"))),
  element("button", { type: "submit", class: "text-button", disabled: page.solves }, say("check_again")));
}

/** Cells on which the run takes half of the limit. */
const shorter = (checked: Checked) => Math.ceil(20 * checked.cell_size * Math.cbrt(checked.expected_s / (0.5 * LONG_S))) / 20;

function running(checked: Checked): HTMLElement {
  const too_large = checked.memory_bytes > MOST_MEMORY;
  const larger = Math.ceil(20 * checked.cell_size * Math.sqrt(checked.memory_bytes / MOST_MEMORY)) / 20;
  const start = element("button", { type: "button", class: "run-button", id: "run", disabled: too_large,
    onclick: () => void solve() }, say("run"));
  const bar = element("progress", { max: 1 });
  const words = element("p", { role: "status", "aria-live": "polite" });
  if (page.solves) progress = { bar, words };
  const stop = element("button", { type: "button", class: "run-button", id: "stop", onclick: () => {
    stop.disabled = true;
    words.textContent = say("stopping");
    page.work?.stop();
  } }, say("stop"));
  const goes_on = !page.solves && (page.result?.stopped || (page.source!.checked_run && !page.result));
  return element("section", { id: "running", class: "card" },
    element("fieldset", { class: "fields", disabled: page.solves }, element("legend", {}, say("what")),
      toggle("verdict", "what_verdict"), toggle("factor", "what_factor"),
      field("least_depth", numberInput("least_depth", "0"))),
    too_large ? element("p", { class: "notice" }, say("too_large", { memory: bytes(checked.memory_bytes), cell: number(larger, 2) })) : null,
    checked.expected_s > LONG_S ? element("p", { class: "notice" }, say("too_long",
      { time: duration(checked.expected_s), cell: number(shorter(checked), 2), other: duration(0.5 * LONG_S) })) : null,
    page.solves ? element("div", { class: "progress" }, bar, words, stop)
      : element("div", { class: "controls" }, start, goes_on ? element("button", { type: "button", class: "run-button", id: "go-on",
        onclick: () => void solve(true) }, say("go_on")) : null));
}

function results(): HTMLElement {
  const { result, factor } = page;
  const button = (key: TextKey, onclick: () => void) => element("button", { type: "button", class: "text-button", "data-save": key, onclick }, say(key));
  const file = (path: string, key: TextKey, ending: string, type: string) =>
    (result?.files.has(path) ? button(key, () => saveFile(path, `${stem()}${ending}`, type)) : null);
  const report = result?.files.get(job.REPORT);
  return element("section", { id: "result" },
    element("h2", { tabindex: -1 }, say("result")),
    result?.stopped ? element("p", { class: "notice" }, say("was_stopped", { time: number(result.time), go_on: say("go_on") })) : null,
    result?.status === 3 ? element("p", { class: "notice" }, say("stopped_itself")) : null,
    factor ? element("p", { class: "factor" }, say("factor_is", { factor: factor.factor })) : null,
    factor?.picture ? element("img", { class: "picture card", alt: say("mechanism"), src: factor.picture }) : null,
    element("div", { class: "controls no-print" }, element("span", {}, `${say("save")}:`),
      file(job.REPORT, "save_report", ".html", "text/html"), button("save_case", saveCase),
      file("after.dxf", "save_dxf", ".dxf", "image/vnd.dxf"), file("after.csv", "save_csv", ".csv", "text/csv"),
      file("after.stix", "save_stix", "_after.stix", "application/zip")),
    report ? element("iframe", { class: "report", title: say("report"), src: page.address(new Blob([report], { type: "text/html" })) }) : null,
    element("details", {}, element("summary", {}, say("words_of_program")),
      element("pre", { class: "scroll" }, [result?.said, factor?.said].filter(Boolean).join("\n"))));
}

// ------------------------------------------------------------------------------------------------ how it begins

async function part(name: string): Promise<Uint8Array<ArrayBuffer>> {
  const text = document.querySelector(`script[data-part="${name}"]`)?.textContent;
  if (!text) throw new Refusal(say("bad_page"));
  return gunzip(bytesOfBase64(text));
}

async function start(root: HTMLElement): Promise<void> {
  chooseLanguage(navigator.languages);
  try {
    if (typeof DecompressionStream === "undefined" || typeof WebAssembly === "undefined") throw new Refusal(say("bad_browser"));
    const text = async (name: string) => new TextDecoder().decode(await part(name));
    const [wasm, glue, template] = await Promise.all([part("wasm"), text("glue"), part("template")]);
    const module = await WebAssembly.compile(wasm).catch(() => {
      throw new Refusal(say("bad_browser"));
    });
    const shipped = JSON.parse(await text("examples")) as Record<string, Record<string, string>>;
    const examples = new Map(Object.entries(shipped).map(([name, files]) =>
      [name, new Map(Object.entries(files).map(([path, content]) => [path, bytesOfBase64(content)]))] as [string, Files]));
    page = new Page({ module, glue, template }, examples, JSON.parse(await text("meta")) as Meta, root);
  } catch (error) {
    root.replaceChildren(element("p", { class: "loading", role: "alert" }, (error as Error).message));
    return;
  }
  for (const event of ["dragover", "drop"] as const)
    document.addEventListener(event, (e) => {
      e.preventDefault();
      if (event === "drop" && !page.solves) void take([...(e.dataTransfer?.files ?? [])]);
    });
  render();
}

void start(document.getElementById("page")!);
