// Where the words at the head of a view stand.

import { expect, it } from "vitest";
import { keyPlaces } from "../../src/view/panel";

const context = { font: "", measureText: (text: string) => ({ width: 10 * text.length }) } as CanvasRenderingContext2D;

it("gives slip planes rows of their own where the head is full, and leaves other words out", () => {
  const plane = (text: string) => ({ text, colour: "#000", dash: [], plane: true });
  const entries = [plane("first"), plane("second"), { text: "ground", colour: "#000", dash: [] }, plane("third"),
    plane("one of a long name")];
  const places = keyPlaces(context, entries, [100, 200], 300).map(({ entry, x, row }) => [entry.text, x, row]);
  expect(places).toEqual([["first", 100, 0], ["second", 40, 1], ["third", 142, 1], ["one of a long name", 40, 2]]);
});
