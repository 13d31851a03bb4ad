// The values of the point under the pointer, beside the pointer.

import type { Current } from "./current";
import type { Run } from "../data/run";
import { element } from "../shell/element";
import { numberText, withUnit } from "../logic/numbers";

/** Name, value and unit of all fields of a point; "…" while a field is being decoded. */
export function pointValues(run: Run, frame: number, point: number): { name: string; label: string; value: string }[] {
  return run.meta.fields.map((meta) => {
    const field = run.fields.get(meta.name);
    let value = "…";
    if (field) {
      const number = field.value(frame, point);
      const material = run.meta.materials.find((m) => m.id === Math.round(number));
      value = meta.kind === "category" && material ? material.name : withUnit(number, meta.unit, 3);
    } else {
      void run.field(meta.name);
    }
    return { name: meta.name, label: meta.label, value };
  });
}

export class Tip {
  readonly root = element("div", { class: "tip", role: "status", hidden: true });

  constructor(private readonly current: Current) {}

  at(x: number, y: number): void {
    const { width, height } = this.root.getBoundingClientRect();
    const left = x + 16 + width > window.innerWidth ? x - 16 - width : x + 16;
    const top = y + 16 + height > window.innerHeight ? y - 16 - height : y + 16;
    this.root.style.transform = `translate(${Math.max(4, left)}px, ${Math.max(4, top)}px)`;
  }

  update(): void {
    const { hover, field } = this.current.state;
    const run = hover && this.current.report.runs[hover.run];
    const frame = run ? this.current.frame(run) : 0;
    this.root.hidden = !run || !run.present(frame, hover.point);
    if (!run || !hover || this.root.hidden) return;
    const [x, y] = run.place(frame, hover.point);
    const rows = pointValues(run, frame, hover.point).map(({ name, label, value }) =>
      element("tr", name === field ? { class: "chosen" } : {}, element("th", {}, label), element("td", {}, value)),
    );
    this.root.replaceChildren(
      element("div", { class: "tip-head" }, `point ${numberText(run.ids[hover.point], 9)}`),
      element("table", {}, element("tr", {}, element("th", {}, "place x, y"), element("td", {}, `${x.toFixed(2)}, ${withUnit(Number(y.toFixed(2)), "m")}`)), ...rows),
    );
  }
}
