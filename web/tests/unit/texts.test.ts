// The words of the page: each in both languages, with the same values in them; used, and none missing.

import type { Trigger } from "../../src/data/format";
import { triggerWords } from "../../src/logic/story";
import { afterEach, describe, expect, it } from "vitest";
import { readdirSync, readFileSync, statSync } from "node:fs";
import { join, resolve } from "node:path";
import { DUTCH, quantityLabel } from "../../src/logic/quantities";
import { metres, numberText } from "../../src/logic/numbers";
import { chooseLanguage, currentLanguage, ordinal, say, TEXTS, type TextKey } from "../../src/logic/texts";

const SOURCE = resolve(__dirname, "../../src");

function sources(folder: string): string[] {
  return readdirSync(folder).flatMap((name) => {
    const path = join(folder, name);
    return statSync(path).isDirectory() ? sources(path) : /\.ts$/.test(name) ? [readFileSync(path, "utf8")] : [];
  });
}

afterEach(() => chooseLanguage("en"));

const valuesIn = (text: string) => [...text.matchAll(/\{(\w+)\}/g)].map((match) => match[1]!).sort();

describe("each text", () => {
  it("exists in both languages, with the same values", () => {
    for (const [key, [english, dutch]] of Object.entries(TEXTS)) {
      for (const text of [english, dutch]) expect(text, key).toMatch(/\S/);
      expect([...new Set(valuesIn(dutch))], key).toEqual([...new Set(valuesIn(english))]);
    }
  });

  it("is used: by its key, or by the beginning of a key that is put together", () => {
    const code = sources(SOURCE).filter((text) => !text.includes("export const TEXTS")).join("\n");
    const made = [...code.matchAll(/`(\w+_)\$\{/g)].map((match) => match[1]!);
    const unused = Object.keys(TEXTS).filter((key) => !code.includes(`"${key}"`) && !made.some((start) => key.startsWith(start)));
    expect(unused.filter((key) => !["mesh", "layers", "water", "outline", "slip", "names", "surfaces"].includes(key) && !key.startsWith("ordinal_"))).toEqual([]);
  });
});

describe("the language", () => {
  it("is English where nothing else is known", () => {
    for (const code of [undefined, null, "fr"]) {
      chooseLanguage(code);
      expect(currentLanguage()).toBe("en");
    }
  });

  it("changes texts, quantities and the decimal sign", () => {
    expect([say("tile_freeboard"), metres(-0.78), numberText(12345.5, 6)]).toEqual(["Freeboard", "−0.78\u00a0m", "12\u202f345.5"]);
    expect(quantityLabel("pore_pressure", "pore pressure")).toBe("pore pressure");
    chooseLanguage("nl");
    expect([say("tile_freeboard"), metres(-0.78), numberText(12345.5, 6)]).toEqual(["Resterende waakhoogte", "−0,78\u00a0m", "12\u202f345,5"]);
    expect(quantityLabel("pore_pressure", "pore pressure")).toBe("waterspanning");
    expect(triggerWords({ stage: "weaker", at_strength: 1.15 } as Trigger))
      .toBe(", na een opgelegde trigger: sterktes gedeeld door 1,15");
    expect(quantityLabel("of_a_new_law", "its label")).toBe("its label");
    expect([ordinal(0), ordinal(6)]).toEqual(["eerste", "7e"]);
  });

  it("leaves a value that is not given as it stands, so that a test finds it", () => {
    expect(say("water_at" as TextKey)).toBe("water at {level}");
  });
});

it("has Dutch for every field and pass of the program that its sources declare", () => {
  const read = (path: string) => readFileSync(resolve(SOURCE, "../../src", path), "utf8");
  const passes = [...read("mpm/step/passes.def").matchAll(/TERP_PASS\(\w+, "([^"]+)"/g)].map((match) => match[1]!);
  const shown = [...read("page/shown.cpp").matchAll(/^ {6}\{"(\w+)", "\w+", "/gm)].map((match) => match[1]!);
  expect(passes.length).toBeGreaterThan(5);
  expect(shown.length).toBeGreaterThan(5);
  expect([...passes, ...shown].filter((name) => !(name in DUTCH))).toEqual([]);
});
