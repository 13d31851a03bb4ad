// The frame of a page that shows no single run, and the parts of which such pages are made: sentences, tables, charts.

import { Chart, DASHES, type ChartOptions, type Line } from "../charts/chart";
import type { DocumentMeta } from "../data/documents";
import { numberText, percentOf } from "../logic/numbers";
import { PLAIN, Store } from "../logic/store";
import { currentLanguage, say, type TextKey } from "../logic/texts";
import { foot, followTheme, startDark, topBar } from "../shell/frame";
import { element, iconButton } from "../shell/element";
import { printOnPaper } from "../shell/paper";
import { runColour } from "../view/theme";

export interface Content {
  title: string;
  window: string; // its title
  subtitle: string;
  foot?: TextKey;
  wide?: boolean; // on paper
  parts: (HTMLElement | null)[];
}

/** Puts a page together. `make` gets the store that its charts need. */
export function buildDocument(meta: DocumentMeta, page: HTMLElement, make: (store: Store) => Content): void {
  const store = new Store({ ...PLAIN, dark: startDark() });
  const content = make(store);
  document.title = `${content.window} · Terp`;
  followTheme(store);
  page.replaceChildren(
    topBar(content.title, content.subtitle, null, [
      iconButton("print", say("print"), "", () => window.print()),
      iconButton("theme", say("theme"), "", () => store.set({ dark: !store.state.dark }))]),
    content.wide ? element("style", {}, "@page { size: A4 landscape; }") : "",
    element("main", { class: `document ${meta.kind}` },
      ...content.parts.filter((part) => part !== null)),
    foot(meta, content.foot));
  printOnPaper(store, null, null, content.wide);
}

export function section(title: string, ...parts: (HTMLElement | null)[]): HTMLElement {
  return element("section", {}, element("h2", {}, title), ...parts.filter((part) => part !== null));
}

/** lang: sentences of the program are English on any page. */
export function paragraph(text: string, name = "", lang?: "en"): HTMLElement | null {
  if (text === "") return null;
  return element("p", { class: name || null, lang: lang !== currentLanguage() ? lang : null }, text);
}

/** Sentences of the program, which are in English. */
export function list(texts: string[], name = ""): HTMLElement | null {
  const lang = currentLanguage() === "en" ? null : "en";
  return texts.length === 0 ? null
    : element("ul", { class: name || null, lang }, ...texts.map((text) => element("li", {}, text)));
}

export function notice(texts: string[]): HTMLElement | null {
  const items = list(texts);
  return items && element("div", { class: "notice" }, items);
}

export interface Row {
  head: string | HTMLElement;
  cells: (string | HTMLElement)[];
  name?: string; // class
}

/** Scrolls by itself. name: classes, of which documents.css says which columns are words. */
export function table(heads: string[], rows: Row[], name = ""): HTMLElement {
  return element("div", { class: "scroll", tabindex: 0 }, element("table", { class: `numbers ${name}`.trim() },
    element("thead", {}, element("tr", {}, ...heads.map((head) => element("th", { scope: "col" }, head)))),
    element("tbody", {}, ...rows.map((row) => element("tr", { class: row.name ?? null },
      element("th", { scope: "row" }, row.head),
      ...row.cells.map((cell) => (typeof cell === "string" ? element("td", {}, cell) : cell)))))));
}

/** A line of a chart: by its number a colour and dashes, so that it is known in print too. */
export function styled(k: number, line: Omit<Line, "colour">): Line {
  return { dash: DASHES[k % DASHES.length], ...line, colour: (dark) => runColour(k, dark) };
}

/** A chart; null if no line has a value. */
export function chart(store: Store, options: ChartOptions, lines: Line[]): HTMLElement | null {
  const drawn = lines.filter(({ y }) => Array.from(y).some((value) => value !== null && Number.isFinite(value)));
  if (drawn.length === 0) return null;
  const made = new Chart(store, { overTime: false, ...options });
  made.show(drawn);
  return element("article", { class: "card" }, made.root);
}

export function cards(made: (HTMLElement | null)[]): HTMLElement | null {
  const there = made.filter((card) => card !== null);
  return there.length === 0 ? null : element("div", { class: "cards" }, ...there);
}

/** "0.012": three digits that count, of small ones too. */
export function probability(p: number | null | undefined, digits = 3): string {
  return numberText(p, typeof p === "number" && Math.abs(p) < 1e-3 ? digits + 1 : digits);
}

/** "3.1 %", "12 %", "0.02 %" */
export function share(value: number | null): string {
  return value === null ? "–" : percentOf(value);
}

/** "volume that slid [m²]" */
export function withUnitOf(label: string, unit: string): string {
  return unit === "" || unit === "-" ? label : `${label} [${unit.replace("^2", "²")}]`;
}
