// The colour bar below the views, on the page and in exports.

import type { Current } from "./current";
import { barTicks, categoryColour, mapNamed, type Range } from "../logic/colour";
import { niceTicks, unitSuffix } from "../logic/numbers";
import { quantityLabel } from "../logic/quantities";
import { soilName } from "../logic/labels";
import { canvasTheme, FONT } from "./theme";

export const BAR_HEIGHT = 40;

/** What a field is called in the language of the page. */
export function fieldLabel(current: Current, name: string): string {
  return quantityLabel(name, current.fieldMeta(name)?.label ?? name);
}

/** Draws the bar in a box of that width and of BAR_HEIGHT, CSS pixels. */
export function drawColourBar(context: CanvasRenderingContext2D, current: Current, width: number,
  time = current.state.time): void {
  const theme = canvasTheme(current.state.dark);
  const meta = current.fieldMeta();
  if (!meta) return;
  context.textBaseline = "middle";
  context.textAlign = "left";
  context.font = `600 12px ${FONT}`;
  context.fillStyle = theme.text;
  const full = `${quantityLabel(meta.name, meta.label)}${unitSuffix(meta.unit)}`;
  const title = meta.symbol && context.measureText(full).width > 0.4 * width
    ? `${meta.symbol.replace("_", "\u2009")}${unitSuffix(meta.unit)}` : full;
  context.fillText(title, 0, 12);
  const left = Math.min(width * 0.6, context.measureText(title).width + 18);
  if (meta.kind === "category") drawCategories(context, current, left, width, theme.text);
  else drawScale(context, current, current.range(time), left, width - left - 22);
}

/** In as many rows as they need; two have room. */
function drawCategories(context: CanvasRenderingContext2D, current: Current, left: number, width: number,
  text: string): void {
  context.font = `12px ${FONT}`;
  let [x, y] = [left, 5];
  const seen = new Set<string>();
  for (const run of current.shownRuns()) {
    const given = run.meta.materials.map(({ color }) => color);
    for (const { id, name } of run.meta.materials) {
      if (seen.has(name)) continue;
      seen.add(name);
      const wide = 20 + context.measureText(soilName(name)).width;
      if (x > left && x + wide > width) [x, y] = [left, y + 18];
      context.fillStyle = categoryColour(given, id);
      context.fillRect(x, y, 14, 14);
      context.fillStyle = text;
      context.fillText(soilName(name), x + 20, y + 7.5);
      x += wide + 20;
    }
  }
}

function drawScale(context: CanvasRenderingContext2D, current: Current, range: Range, left: number,
  width: number): void {
  const theme = canvasTheme(current.state.dark);
  const map = mapNamed(current.map().name);
  const steps = Math.max(1, Math.round(width));
  for (let k = 0; k < steps; k++) {
    context.fillStyle = map.at(k / Math.max(1, steps - 1));
    context.fillRect(left + k, 4, 1.5, 15);
  }
  context.strokeStyle = theme.frame;
  context.lineWidth = 1;
  context.strokeRect(left - 0.5, 3.5, width + 2, 16);
  context.font = `11px ${FONT}`;
  context.fillStyle = theme.muted;
  context.textAlign = "center";
  let free = -Infinity; // right end of the text before
  for (const { at, text } of barTicks(range, niceTicks)) {
    const x = left + at * width;
    const half = context.measureText(text).width / 2;
    if (x - half < free) continue;
    context.fillRect(Math.round(x), 20, 1, 4);
    context.fillText(text, x, 31);
    free = x + half + 8;
  }
}
