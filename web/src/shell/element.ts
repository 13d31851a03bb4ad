// Elements in one call: element("button", { class: "icon", onclick }, "Play").

type Child = Node | string | null | undefined | false;
type Attributes = Record<string, string | number | boolean | null | undefined | ((event: never) => void)>;

export function element<K extends keyof HTMLElementTagNameMap>(tag: K, attributes: Attributes = {},
  ...children: Child[]): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === "function") made.addEventListener(name.slice(2), value as EventListener);
    else made.setAttribute(name, value === true ? "" : String(value));
  }
  for (const child of children) if (child) made.append(child);
  return made;
}

const ICONS: Record<string, string> = {
  play: "M7 4.5v15l12.5-7.5z",
  pause: "M6.5 4.5h4v15h-4zM13.5 4.5h4v15h-4z",
  back: "M15.5 5v14L6 12zM4 5h2v14H4z",
  forward: "M8.5 5v14l9.5-7zM18 5h2v14h-2z",
  again: "M12 5V1.8L7 6l5 4.2V7a5 5 0 1 1-5 5H5a7 7 0 1 0 7-7z",
  plus: "M11 5h2v6h6v2h-6v6h-2v-6H5v-2h6z",
  minus: "M5 11h14v2H5z",
  fit: "M4 9V4h5v2H6v3zm11-5h5v5h-2V6h-3zM6 15v3h3v2H4v-5zm12 3v-3h2v5h-5v-2z",
  close: "M6.4 5 5 6.4 10.6 12 5 17.6 6.4 19l5.6-5.6 5.6 5.6 1.4-1.4-5.6-5.6L19 6.4 17.6 5 12 10.6z",
  image: "M4 5h16v14H4zm2 2v7.6l3.5-3.6 3 3 2-2L18 15.4V7zm9.5 3.5a1.5 1.5 0 1 1 0-3 1.5 1.5 0 0 1 0 3z",
  film: "M3 6h13v3.6l5-3v10.8l-5-3V18H3z",
  full: "M4 4h7v2H7.4l3.3 3.3-1.4 1.4L6 7.4V11H4zm16 16h-7v-2h3.6l-3.3-3.3 1.4-1.4 3.3 3.3V13h2z",
  print: "M7 3h10v5H7zM4 9h16v8h-3v4H7v-4H4zm5 5v5h6v-5z",
  theme: "M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zm0 2a7 7 0 0 1 0 14z",
  help: "M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zm-1 13h2v2h-2zm1-10a4 4 0 0 1 2 7.4" +
    "c-.7.4-1 .8-1 1.6h-2c0-1.7.8-2.6 1.9-3.3A2 2 0 1 0 10 10H8a4 4 0 0 1 4-4z",
};

export function icon(name: string): SVGElement {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 24 24");
  svg.setAttribute("aria-hidden", "true");
  svg.classList.add("icon");
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  path.setAttribute("d", ICONS[name] ?? "");
  path.setAttribute("fill-rule", "evenodd");
  svg.append(path);
  return svg;
}

/** A button with an icon; its label is for screen readers and the tip. */
export function iconButton(name: string, label: string, key: string, onclick: () => void): HTMLButtonElement {
  return element("button",
    { type: "button", class: "icon-button", "aria-label": label, title: key ? `${label} (${key})` : label, onclick },
    icon(name));
}
