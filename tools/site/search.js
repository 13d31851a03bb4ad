// Search in all documents. The sections are a script of their own, since a page from a folder may not read files; they
// are loaded when the box is first used.
const up = document.currentScript.dataset.up;
addEventListener("DOMContentLoaded", () => {
  const box = document.querySelector(".search input");
  const list = document.querySelector(".search ol");
  const MOST = 12;

  function hits(query) {
    const words = query.toLowerCase().split(/\s+/).filter(Boolean);
    const found = [];
    for (const [page, anchor, title, heading, text] of words.length ? globalThis.sections : []) {
      const [high, low] = [`${title} ${heading}`.toLowerCase(), text.toLowerCase()];
      if (!words.every((word) => high.includes(word) || low.includes(word))) continue;
      const weight = words.reduce((sum, word) => sum + (heading.toLowerCase().includes(word) ? 20 : 0)
        + (high.includes(word) ? 10 : 0) + Math.min(low.split(word).length - 1, 5), 0);
      const at = Math.max(0, low.indexOf(words[0]) - 40);
      found.push({ weight, page, anchor, title, heading, text: text.slice(at, at + 160) });
    }
    return found.sort((a, b) => b.weight - a.weight).slice(0, MOST);
  }

  function show() {
    if (!globalThis.sections) return;
    const found = hits(box.value);
    list.replaceChildren(...found.map(({ page, anchor, title, heading, text }) => {
      const link = Object.assign(document.createElement("a"), { href: `${up}${page}#${anchor}` });
      const name = document.createElement("b");
      name.textContent = heading === title ? title : `${title}: ${heading}`;
      link.append(name, ` ${text}`);
      const item = document.createElement("li");
      item.append(link);
      return item;
    }));
    if (!found.length) list.textContent = "Nothing found.";
    list.hidden = !box.value.trim();
  }

  box.addEventListener("focus", () => {
    const script = Object.assign(document.createElement("script"), { src: `${up}sections.js`, onload: show });
    if (!globalThis.sections) document.head.append(script);
  }, { once: true });
  box.addEventListener("input", show);
  box.addEventListener("keydown", (event) => {
    if (event.key === "Enter") list.querySelector("a")?.click();
  });
  list.addEventListener("click", () => { list.hidden = true; });
  addEventListener("keydown", (event) => {
    if (event.key === "Escape") list.hidden = true;
    if (event.key !== "/" || document.activeElement === box) return;
    event.preventDefault();
    box.focus();
  });
});
