// Parts of the summary of a run, on elements that only keep their texts.

import { afterEach, beforeEach, expect, it, vi } from "vitest";
import type { Report } from "../../src/data/report";
import { chooseLanguage } from "../../src/logic/texts";
import type { Store } from "../../src/logic/store";
import { summarySection } from "../../src/sections/summary";

class Kept {
  parts: (Kept | string)[] = [];
  names = "";
  setAttribute(name: string, value: string) { if (name === "class") this.names = value; }
  append(part: Kept | string) { this.parts.push(part); }
  find(name: string): Kept[] {
    const below = this.parts.flatMap((part) => typeof part === "string" ? [] : part.find(name));
    return this.names.split(" ").includes(name) ? [this, ...below] : below;
  }
  texts(): string[] {
    return this.parts.flatMap((part) => typeof part === "string" ? [part] : part.texts());
  }
}

beforeEach(() => vi.stubGlobal("document", { createElement: () => new Kept() }));
afterEach(() => {
  vi.unstubAllGlobals();
  chooseLanguage("en");
});

function noticeOf(changed: Record<string, string[]> | undefined): string[][] {
  const meta = { changed, times: [0], finished: true, events: null, summary: {}, warnings: {}, scheme: "mpm_gp",
    materials: [{ name: "clay_below" }] };
  const report = { runs: [{ meta, index: 0, series: null }], comparison: null } as unknown as Report;
  const parts = summarySection(report, {} as Store) as unknown as Kept[];
  return parts.flatMap((part) => part.find("changed")).map((notice) => notice.texts());
}

it("lists what changed since the import, in the language of the page", () => {
  const changed = { en: ["clay_below: S was 0.3 in the import, is 0.2 here.", "`scheme` was a in the import, is b here."],
    nl: ["clay_below: S was bij het inlezen 0,3, is hier 0,2."] };
  expect(noticeOf(changed)).toEqual([["Changed since the import (2)",
    "clay, below water: S was 0.3 in the import, is 0.2 here.", "`scheme` was a in the import, is b here."]]);
  chooseLanguage("nl");
  expect(noticeOf(changed)).toEqual([["Veranderd na het inlezen (1)",
    "clay, onder water: S was bij het inlezen 0,3, is hier 0,2."]]);
  expect(noticeOf({ en: [], nl: [] })).toEqual([]);
  expect(noticeOf(undefined)).toEqual([]);
});
