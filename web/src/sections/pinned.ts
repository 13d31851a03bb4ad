// The pinned point: its values now, and the chosen field over all frames, also in runs that have the same point.

import type { Current } from "../view/current";
import type { Run } from "../data/run";
import { Chart, type Line } from "../charts/chart";
import { runLabels } from "../logic/labels";
import { numberText, withUnit } from "../logic/numbers";
import { sameBody } from "../logic/same_body";
import { fieldLabel } from "../view/colour_bar";
import { pointValues } from "../view/tip";
import { say } from "../logic/texts";
import { runColour } from "../view/theme";
import { element, iconButton } from "../shell/element";

export class Pinned {
  readonly root = element("section", { class: "pinned card", hidden: true, "aria-label": say("pinned") });
  private readonly title = element("h3");
  private readonly values = element("table", { class: "values" });
  private readonly nothing = element("p", { class: "muted", hidden: true });
  private readonly chart: Chart;
  private readonly labels: string[];

  constructor(private readonly current: Current) {
    const { store, report } = current;
    this.labels = runLabels(report.runs.map((run) => run.meta));
    this.chart = new Chart(store, { title: "", xLabel: say("time_axis"), unit: "-", height: 210 });
    this.root.append(
      element("header", {}, this.title,
        iconButton("close", say("let_go"), "Esc", () => store.set({ pin: null }))),
      element("div", { class: "pinned-body" }, element("div", { class: "scroll" }, this.values), this.nothing,
        this.chart.root));
    store.on((_, changed) => {
      if (changed.has("pin") || changed.has("field")) void this.showPoint();
      if (changed.has("time")) this.showValues();
    });
  }

  /** The pinned point in its run and, where they have it, in the others, in the order of the runs. */
  private same(): { run: Run; point: number }[] {
    const { pin } = this.current.state;
    if (!pin) return [];
    const { runs } = this.current.report;
    const of = runs[pin.run]!;
    const alike = runs.filter((run) => run === of || sameBody(of, run));
    return alike.map((run) => ({ run, point: run.pointOfId(of.ids[pin.point]!) })).filter(({ point }) => point >= 0);
  }

  private async showPoint(): Promise<void> {
    const all = this.same();
    this.root.hidden = all.length === 0;
    if (all.length === 0) return;
    const { field } = this.current.state;
    const { run, point } = all[0]!; // the id is the same in all
    this.title.textContent = say("point", { id: numberText(run.ids[point], 9) });
    await Promise.all(all.flatMap(({ run: r }) => r.meta.fields.map((meta) => r.field(meta.name))));
    if (field !== this.current.state.field) return;
    this.showValues();
    const meta = this.current.fieldMeta();
    const lines = all.flatMap(({ run: r, point: p }): Line[] => {
      const values = r.fields.get(field);
      if (!values) return [];
      const y = r.meta.times.map((_, f) => (r.present(f, p) ? values.value(f, p) : null));
      return [{ label: this.labels[r.index]!, x: r.meta.times, y, colour: (dark) => runColour(r.index, dark),
        width: 2 }];
    });
    const hasValues = lines.some(({ y }) => Array.from(y).some((value) => value !== null && Number.isFinite(value)));
    this.nothing.hidden = hasValues;
    this.chart.root.hidden = !hasValues;
    if (!hasValues) {
      this.nothing.textContent =
        say("no_value", { label: fieldLabel(this.current, field) });
      return;
    }
    this.chart.title = say("over_frames", { label: fieldLabel(this.current, field) });
    this.chart.show(lines, { unit: meta?.unit ?? "-" });
  }

  private showValues(): void {
    const all = this.same();
    if (all.length === 0) return;
    const columns = all.map(({ run, point }) => {
      const frame = this.current.frame(run);
      if (!run.present(frame, point)) return null;
      const [x, y] = run.place(frame, point);
      return [{ name: "x", label: "x", value: withUnit(Number(x.toFixed(3)), "m", 5) },
        { name: "y", label: "y", value: withUnit(Number(y.toFixed(3)), "m", 5) }, ...pointValues(run, frame, point)];
    });
    const rows = columns.find((column) => column !== null) ?? [];
    const head = element("tr", {}, element("td"),
      ...all.map(({ run }) => element("th", { scope: "col" }, this.labels[run.index]!)));
    this.values.replaceChildren(
      element("thead", {}, all.length > 1 ? head : null),
      element("tbody", {}, ...rows.map(({ name, label }) =>
        element("tr", name === this.current.state.field ? { class: "chosen" } : {},
        element("th", { scope: "row" }, label),
        ...columns.map((column) =>
          element("td", {}, column?.find((row) => row.name === name)?.value ?? say("not_there")))))));
  }
}
