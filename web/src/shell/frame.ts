// What all pages have around them: the bar at the top with the language, the foot, light and dark.

import type { Store } from "../logic/store";
import { currentLanguage, LANGUAGES, say, type TextKey } from "../logic/texts";
import { openIn } from "./address";
import { element } from "./element";

export function startDark(): boolean {
  return matchMedia("(prefers-color-scheme: dark)").matches;
}

export function followTheme(store: Store): void {
  store.watch(["dark"], ({ dark }) => (document.documentElement.dataset.theme = dark ? "dark" : "light"));
}

/** store: null of a page on which nothing is chosen. */
export function topBar(title: string, subtitle: string, store: Store | null, buttons: HTMLElement[]): HTMLElement {
  const select = element("select", { class: "language", "aria-label": say("language"),
    onchange: () => openIn(store, select.value) },
  ...LANGUAGES.map(({ code, name }) => element("option", { value: code }, name)));
  select.value = currentLanguage();
  return element("header", { class: "top" },
    element("span", { class: "mark-name" }, "Terp"),
    element("div", { class: "titles" }, element("h1", {}, title), element("p", { class: "muted" }, subtitle)),
    element("nav", { class: "no-print", "aria-label": say("page_nav") }, select, ...buttons));
}

/** more: what else to read. */
export function foot({ terp, written }: { terp: string; written: string }, more: TextKey = "holds_all"): HTMLElement {
  const time = written.replace("T", " ").replace("Z", " UTC");
  return element("footer", {}, `${say("footer", { version: terp, time })} ${say(more)}`);
}
