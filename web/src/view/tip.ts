// Place and chosen field of the point under the pointer, beside the pointer: small, so that it covers little of the
// section. All values of a point are shown by the pinned point (sections/pinned.ts).

import type { Current } from "./current";
import type { Run } from "../data/run";
import { element } from "../shell/element";
import { quantityLabel } from "../logic/quantities";
import { soilName } from "../logic/labels";
import { say } from "../logic/texts";
import { fixed, numberText, toSteps, withUnit } from "../logic/numbers";

/** Name, value and unit of fields of a point (by default all); "…" while a field is being decoded. */
export function pointValues(run: Run, frame: number, point: number, fields = run.meta.fields): { name: string;
  label: string; value: string }[] {
  return fields.map((meta) => {
    const field = run.fields.get(meta.name);
    let value = "…";
    if (field) {
      const number = field.value(frame, point);
      const material = run.meta.materials.find((m) => m.id === Math.round(number));
      value = meta.kind === "category" && material ? soilName(material.name)
        : withUnit(toSteps(number, meta.precision), meta.unit, 3);
    } else {
      void run.field(meta.name);
    }
    return { name: meta.name, label: quantityLabel(meta.name, meta.label), value };
  });
}

/** Whether a point is the pinned one, whose values stand beside the views. */
function isPinned(current: Current, point: { run: number; point: number }): boolean {
  const { pin } = current.state;
  return pin !== null && pin.run === point.run && pin.point === point.point;
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
    this.root.hidden = !run || !run.present(frame, hover.point) || isPinned(this.current, hover);
    if (!run || !hover || this.root.hidden) return;
    const [x, y] = run.place(frame, hover.point);
    const row = (label: string, value: string) => element("tr", {}, element("th", {}, label), element("td", {}, value));
    const chosen = pointValues(run, frame, hover.point, run.meta.fields.filter(({ name }) => name === field));
    this.root.replaceChildren(
      element("table", {},
        row("x, y", `${fixed(x, 2, "")}; ${withUnit(Number(y.toFixed(2)), "m")}`),
        ...chosen.map(({ label, value }) => row(label, value))),
      element("div", { class: "tip-more" }, say("tip_point", { id: numberText(run.ids[hover.point], 9) })),
    );
  }
}
