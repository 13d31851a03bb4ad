// A line at the foot of the window: what could not be done, or how far something is.

import { say } from "../logic/texts";
import { element } from "./element";

export class Notice {
  readonly root = element("div", { class: "toast", role: "status", hidden: true });
  private timer = 0;

  say(text: string): void {
    clearTimeout(this.timer);
    this.root.replaceChildren(text);
    this.root.hidden = false;
    this.timer = window.setTimeout(() => this.hide(), 6000);
  }

  progress(text: string, part: number, cancel: () => void): void {
    clearTimeout(this.timer);
    if (this.root.hidden || !this.root.querySelector("progress")) {
      this.root.replaceChildren(element("span", {}, text), element("progress", { max: 1 }),
        element("button", { type: "button", class: "text-button", onclick: cancel }, say("cancel")));
      this.root.hidden = false;
    }
    this.root.querySelector("progress")!.value = part;
  }

  hide(): void {
    this.root.hidden = true;
    this.root.replaceChildren();
  }
}
