// Time: play, pause, scrub, speed; marks of the events of each run on the bar.

import type { Current } from "../view/current";
import type { Run } from "../data/run";
import { advance, allTimes, speeds, stepTime } from "../logic/time";
import { numberText, timeDecimals, timeText } from "../logic/numbers";
import { slidesOf } from "../logic/slides";
import { runLabels } from "../logic/labels";
import { ordinal, say } from "../logic/texts";
import { runColour } from "../view/theme";
import { element, icon, iconButton } from "./element";

interface Mark {
  time: number;
  run: number;
  sign: string;
  text: string;
  minor: boolean; // has no picture of its own
}

export function marksOf(run: Run): Mark[] {
  const marks: Mark[] = [];
  const add = (time: number | null | undefined, sign: string, text: string, minor = false) => {
    if (typeof time === "number" && Number.isFinite(time)) marks.push({ time, run: run.index, sign, text, minor });
  };
  (run.meta.events?.stages ?? []).filter(({ name }) => name !== "").forEach(({ name, start }) =>
    add(start, "▸", say("mark_stage", { name })));
  add(run.meta.events?.flood?.first_time_below, "≈", say("mark_floods"));
  slidesOf(run.meta).forEach((slide, k) => {
    const which = { ordinal: ordinal(k) };
    add(slide.begins, String(k + 1), say("mark_begins", which));
    add(slide.slip_surface?.time, "~", say("mark_fastest", which), k > 0);
    add(slide.stops, "■", say("mark_stops", which), true);
  });
  return marks;
}

export class Player {
  readonly root: HTMLElement;
  readonly times: number[];
  readonly span: [number, number];
  private readonly decimals: number;
  private readonly bar: HTMLInputElement;
  private last = 0;

  constructor(private readonly current: Current) {
    const { report, store } = current;
    this.times = allTimes(report.runs.map((run) => run.meta.times));
    this.span = [this.times[0] ?? 0, this.times[this.times.length - 1] ?? 0];
    this.decimals = timeDecimals(this.times);
    this.bar = element("input",
      { type: "range", class: "scrub", min: this.span[0], max: this.span[1], step: "any", "aria-label": say("time"),
      oninput: () => store.set({ time: this.bar.valueAsNumber, playing: false }) });
    const play = iconButton("play", say("play"), "Space", () => this.toggle());
    play.classList.add("primary");
    const again = iconButton("again", say("again"), "", () => store.set({ again: !store.state.again }));
    const now = element("output", { class: "now", "aria-live": "off" });
    this.root = element("div", { class: "player" },
      element("div", { class: "buttons" },
        iconButton("back", say("frame_back"), "←", () => this.step(-1)), play,
          iconButton("forward", say("frame_on"), "→", () => this.step(1)), again),
      element("div", { class: "track" }, this.bar, this.marks()),
      now,
      this.speedChoice(),
    );
    store.watch(["playing"], ({ playing }) => {
      play.replaceChildren(icon(playing ? "pause" : "play"));
      play.setAttribute("aria-label", say(playing ? "pause" : "play"));
    });
    store.watch(["again"], (state) => again.setAttribute("aria-pressed", String(state.again)));
    store.watch(["time"], ({ time }) => {
      this.bar.value = String(time);
      this.bar.setAttribute("aria-valuetext", timeText(time, this.decimals));
      now.textContent = timeText(time, this.decimals);
    });
  }

  private marks(): HTMLElement {
    const { report, store } = this.current;
    const labels = runLabels(report.runs.map((run) => run.meta));
    const length = this.span[1] - this.span[0] || 1;
    const rows = report.runs.map((run) => {
      const row = element("div", { class: "marks", "data-run": run.index });
      for (const mark of marksOf(run)) {
        const text = `${labels[run.index]}: ${mark.text}, ${timeText(mark.time, this.decimals)}`;
        const button = element("button",
          { type: "button", class: "mark", title: text, "aria-label": say("go_to", { text }),
          onclick: () => store.set({ time: mark.time, playing: false }) }, mark.sign);
        button.style.left = `${(100 * (mark.time - this.span[0])) / length}%`;
        row.append(button);
      }
      store.watch(["dark"], ({ dark }) => row.style.setProperty("--run", runColour(run.index, dark)));
      return row;
    });
    return element("div", { class: "mark-rows" }, ...rows);
  }

  private speedChoice(): HTMLElement {
    const { store } = this.current;
    const { all } = speeds(this.span[1] - this.span[0]);
    const select = element("select",
      { "aria-label": say("speed_help"),
      onchange: () => store.set({ speed: Number(select.value) }) },
      ...all.map((speed) =>
        element("option", { value: speed },
          speed === 1 ? say("real_time") : say("times_real_time", { factor: numberText(speed) }))));
    store.watch(["speed"], ({ speed }) => (select.value = String(speed)));
    return element("label", { class: "speed" }, element("span", {}, say("speed")), select);
  }

  changeSpeed(by: number): void {
    const { all } = speeds(this.span[1] - this.span[0]);
    const { store } = this.current;
    const k = all.indexOf(store.state.speed) + by;
    if (all[k] !== undefined) store.set({ speed: all[k] });
  }

  step(frames: number): void {
    const { store } = this.current;
    store.set({ time: stepTime(this.times, store.state.time, frames), playing: false });
  }

  toggle(): void {
    const { store } = this.current;
    if (store.state.playing) return store.set({ playing: false });
    if (store.state.time >= this.span[1]) store.set({ time: this.span[0] });
    store.set({ playing: true });
    this.last = performance.now();
    requestAnimationFrame((now) => this.tick(now));
  }

  private tick(now: number): void {
    const { store } = this.current;
    if (!store.state.playing) return;
    const elapsed = Math.min(0.25, Math.max(0, now - this.last) / 1000); // a tab that slept does not jump
    this.last = now;
    const { time, speed, again } = store.state;
    const next = advance(time, elapsed, speed, this.span, again);
    store.set({ time: next.time, ...(next.ended ? { playing: false } : {}) });
    requestAnimationFrame((later) => this.tick(later));
  }
}
