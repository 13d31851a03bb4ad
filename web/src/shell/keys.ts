// The keyboard, and the table of keys that "?" shows.

import type { Current } from "../view/current";
import type { Viewer } from "../view/viewer";
import type { Player } from "./player";
import type { ViewState } from "../logic/store";
import { say } from "../logic/texts";
import { chooseMode } from "./controls";
import { element, iconButton } from "./element";

export interface Actions {
  image: () => void;
  video: () => void;
  fullScreen: () => void;
  theme: () => void;
  print: () => void;
}

interface Key {
  keys: string[]; // KeyboardEvent.key
  show: string;
  does: string;
  act: (event: KeyboardEvent) => void;
}

export class Keys {
  readonly help: HTMLDialogElement;
  private readonly keys: Key[];

  constructor(current: Current, viewer: Viewer, player: Player, actions: Actions) {
    const { store } = current;
    const flip = (key: "mesh" | "layers" | "water" | "outline" | "slip" | "surfaces" | "names" | "log") => () =>
      store.set({ [key]: !store.state[key] } as Partial<ViewState>);
    const arrow = (frames: number, dx: number) => (event: KeyboardEvent) =>
      (event.shiftKey ? viewer.move(dx, 0) : player.step(frames));
    this.keys = [
      { keys: [" "], show: "Space", does: say("key_play"), act: () => player.toggle() },
      { keys: ["ArrowLeft"], show: "←", does: say("key_back"), act: arrow(-1, 60) },
      { keys: ["ArrowRight"], show: "→", does: say("key_on"), act: arrow(1, -60) },
      { keys: ["PageUp", "j"], show: "J", does: say("key_back_10"), act: () => player.step(-10) },
      { keys: ["PageDown", "k"], show: "K", does: say("key_on_10"), act: () => player.step(10) },
      { keys: ["Home"], show: "Home", does: say("key_first"), act: () => player.step(-1e9) },
      { keys: ["End"], show: "End", does: say("key_last"), act: () => player.step(1e9) },
      { keys: ["<", ","], show: ",", does: say("key_slower"), act: () => player.changeSpeed(-1) },
      { keys: [">", "."], show: ".", does: say("key_faster"), act: () => player.changeSpeed(1) },
      { keys: ["1", "2", "3", "4", "5", "6", "7", "8", "9"], show: "1 … 9", does: say("key_field"),
        act: (event) => {
        const name = current.report.fieldNames()[Number(event.key) - 1];
        if (name) store.set({ field: name });
      } },
      { keys: ["r"], show: "R", does: say("key_range"),
        act: () => chooseMode(current,
        ({ run: "frame", frame: "fixed", fixed: "run" } as const)[store.state.rangeMode]) },
      { keys: ["l"], show: "L", does: say("key_log"), act: flip("log") },
      { keys: ["+", "="], show: "+", does: say("key_zoom_in"),
        act: () => viewer.zoom(1.3) },
      { keys: ["-"], show: "−", does: say("key_zoom_out"), act: () => viewer.zoom(1 / 1.3) },
      { keys: ["ArrowUp", "ArrowDown"], show: "Shift arrows", does: say("key_move"),
        act: (event) => event.shiftKey && viewer.move(0, event.key === "ArrowUp" ? 60 : -60) },
      { keys: ["0"], show: "0", does: say("key_all"), act: () => store.set({ camera: null }) },
      { keys: ["m"], show: "M", does: say("key_mesh"), act: flip("mesh") },
      { keys: ["y"], show: "Y", does: say("key_layers"), act: flip("layers") },
      { keys: ["w"], show: "W", does: say("key_water"), act: flip("water") },
      { keys: ["o"], show: "O", does: say("key_outline"), act: flip("outline") },
      { keys: ["s"], show: "S", does: say("key_slip"), act: flip("slip") },
      { keys: ["n"], show: "N", does: say("key_names"), act: flip("names") },
      { keys: ["d"], show: "D", does: say("key_surfaces"), act: flip("surfaces") },
      { keys: ["e"], show: "E", does: say("key_image"), act: actions.image },
      { keys: ["v"], show: "V", does: say("key_video"), act: actions.video },
      { keys: ["f"], show: "F", does: say("key_full"), act: actions.fullScreen },
      { keys: ["t"], show: "T", does: say("key_theme"), act: actions.theme },
      { keys: ["p"], show: "P", does: say("key_print"), act: actions.print },
      { keys: ["Escape"], show: "Esc", does: say("key_escape"), act: () => store.set({ pin: null }) },
      { keys: ["?"], show: "?", does: say("key_help"), act: () => this.toggleHelp() },
    ];
    this.help = this.makeHelp();
    document.addEventListener("keydown", (event) => this.press(event));
  }

  toggleHelp(): void {
    if (this.help.open) this.help.close();
    else this.help.showModal();
  }

  private press(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (this.help.open && event.key !== "?") return;
    if (event.ctrlKey || event.metaKey || event.altKey
      || target.closest("input:not([type=range]), textarea, select")) return;
    const onRange = target.matches("input[type=range]");
    if (onRange && !target.classList.contains("scrub") && event.key.startsWith("Arrow")) return;
    if (event.key === " " && target.closest("button, summary, a")) return; // Space presses what has the focus
    // scrolls the page
    if (/^(Arrow(Up|Down)|Page|Home|End)/.test(event.key) && !event.shiftKey && !target.closest(".see")) return;
    const key = this.keys.find(({ keys }) => keys.includes(event.key) || keys.includes(event.key.toLowerCase()));
    if (!key || (event.key.startsWith("Arrow") && /Up|Down/.test(event.key) && !event.shiftKey)) return;
    event.preventDefault();
    key.act(event);
  }

  private makeHelp(): HTMLDialogElement {
    const close = iconButton("close", say("close"), "Esc", () => this.help.close());
    const rows = this.keys.map(({ show, does }) =>
      element("div", {}, element("dt", {},
      ...show.split(" ").map((part) => (part.length > 1 || /\S/.test(part) ? element("kbd", {}, part) : null))),
      element("dd", {}, does)));
    return element("dialog", { class: "keys", "aria-labelledby": "keys-title" },
      element("header", {}, element("h2", { id: "keys-title" }, say("keys")), close), element("dl", {}, ...rows));
  }
}
