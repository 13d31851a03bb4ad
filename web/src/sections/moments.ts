// The failure in a few pictures: each run at the times of its own events, for the eye, for print, and to jump there.

import type { Current } from "../view/current";
import type { Run } from "../data/run";
import type { Viewer } from "../view/viewer";
import { drawPanel } from "../view/panel";
import { timeDecimals, timeText } from "../logic/numbers";
import { say } from "../logic/texts";
import { marksOf } from "../shell/player";
import { element } from "../shell/element";
import { coloured } from "./summary";

const WIDTH = 300; // CSS pixels of a picture as drawn; the page scales it
const PAD = { left: 6, right: 6, top: 6, bottom: 6 };

interface Moment {
  time: number;
  text: string;
}

/** Start, events, end; times that fall on one frame are one moment. */
export function momentsOf(run: Run, frameOf: (time: number) => number): Moment[] {
  const { times } = run.meta;
  const first = { time: times[0]!, text: say("start") };
  const last = { time: times[times.length - 1]!, text: say(run.meta.finished ? "end" : "so_far") };
  const events = marksOf(run).filter(({ minor }) => !minor).map(({ time, text }) => ({ time, text }));
  const taken = new Set([frameOf(first.time)]);
  const fresh = ({ time }: Moment) => {
    const frame = frameOf(time);
    return frame < times.length - 1 && !taken.has(frame) && taken.add(frame);
  };
  const between = events.sort((a, b) => a.time - b.time).filter(fresh);
  const some = between.length > 0 ? between
    : [0.25, 0.5, 0.75].map((part) => ({ time: first.time + part * (last.time - first.time), text: "" })).filter(fresh);
  return times.length > 1 ? [first, ...some, last] : [last];
}

export function momentsSection(current: Current, viewer: Viewer): HTMLElement | null {
  const { store, report } = current;
  if (!viewer.renderer || report.runs.every((run) => run.meta.times.length < 2)) return null;
  const box = viewer.extent();
  const height = Math.round(Math.min(WIDTH, Math.max(70, ((WIDTH - 12) * (box[3] - box[1])) / (box[2] - box[0]) + 12)));
  const pictures: { run: Run; time: number; canvas: HTMLCanvasElement }[] = [];
  const moments = report.runs.map((run) => momentsOf(run, (time) => current.frame(run, time)));
  const most = Math.max(...moments.map((list) => list.length));
  const rows = report.runs.map((run) => {
    const decimals = timeDecimals(run.meta.times);
    const items = moments[run.index]!.map(({ time, text }) => {
      const canvas = element("canvas", { width: 2 * WIDTH, height: 2 * height, "aria-hidden": "true" });
      pictures.push({ run, time, canvas });
      return element("li", {},
        element("button", { type: "button", title: say("show_this_time_above"),
        onclick: () => store.set({ time, playing: false }) },
        canvas, element("span", {}, element("b", {}, timeText(time, decimals)),
          text ? ` ${text}` : "")));
    });
    return element("div", { class: "moments-row" }, coloured(element("h3", {}, viewer.labels[run.index]!), run, store),
      element("ol", { style: `--most: ${most}` }, ...items));
  });
  const draw = () => {
    for (const { run, time, canvas } of pictures) {
      const context = canvas.getContext("2d")!;
      context.setTransform(2, 0, 0, 2, 0, 0);
      const size = { width: WIDTH, height };
      drawPanel(context, viewer.renderer, run, current,
        { camera: viewer.fitted(size, PAD), size, ratio: 2, time, names: viewer.labels, label: "", note: "",
        bare: true, top: PAD.top });
    }
  };
  let waiting = 0;
  const later = () => {
    clearTimeout(waiting);
    waiting = window.setTimeout(draw, 120);
  };
  store.watch(["field", "map", "rangeMode", "fixed", "log", "mesh", "layers", "water", "outline", "slip", "pointScale"],
    later);
  store.on((_, changed) => changed.has("dark") && draw()); // at once: paper does not wait
  for (const run of report.runs) run.onField.push(later);
  return element("section", { id: "moments", "aria-labelledby": "moments-title" },
    element("h2", { id: "moments-title" }, say("in_pictures")), ...rows);
}
