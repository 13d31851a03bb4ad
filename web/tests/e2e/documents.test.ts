// Pages of a study, a reach and a sequence of meshes in a real browser, from disk. With TERP=path/to/terp also of pages
// that the program wrote.

import { execFileSync } from "node:child_process";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import type { Browser } from "playwright-core";
import { launch, openDocument } from "../support/browser";
import { EXAMPLES, exampleReach } from "../support/documents";
import { fillTemplate } from "../support/encode";
import { template } from "../support/fixture";

let browser: Browser;
beforeAll(async () => {
  browser = await launch();
});
afterAll(async () => browser?.close());

function written(name: string, { document, chunks } = EXAMPLES[name]!()): string {
  const path = join(mkdtempSync(join(tmpdir(), "terp-web-")), `${name}.html`);
  writeFileSync(path, fillTemplate(template(), document, chunks));
  return path;
}

/** The same sections and charts that a reader looks for. */
const PARTS: Record<string, { titles: string[]; charts: number; dutch: string }> = {
  study: { titles: ["Probabilities", "How sure, and what remains", "Failure path", "What happened", "What matters",
    "Realisations"], charts: 4, dutch: "Kansen" },
  curve: { titles: ["Fragility", "What remains", "What happened", "What matters", "Realisations"], charts: 5, dutch: "Fragiliteit" },
  sweep: { titles: ["Results over material.clay.su_peak", "Realisations"], charts: 2, dutch: "Realisaties" },
  samples: { titles: ["Histograms of the input", "Field of material.clay.su_peak"], charts: 2, dutch: "Histogrammen van de invoer" },
  reach: { titles: [], charts: 0, dutch: "" },
  convergence: { titles: ["as given", "Over the size of the cells", "mesh.turn=45", "All variants", "How to read this"], charts: 5, dutch: "Alle varianten" },
  element: { titles: ["Stresses and strains"], charts: 0, dutch: "Spanningen en rekken" },
};

describe.each(Object.keys(PARTS))("the page of a %s", (name) => {
  const parts = PARTS[name]!;

  it("shows its parts, with nothing from outside and nothing to complain of", async () => {
    const { page, errors, requests } = await openDocument(browser, written(name));
    expect(await page.locator("main h2").allTextContents()).toEqual(parts.titles);
    expect(await page.locator(".uplot canvas").count()).toBe(parts.charts);
    expect(await page.locator("main").textContent()).not.toMatch(/undefined|NaN|\{\w+\}/);
    expect([errors, requests]).toEqual([[], []]);
    await page.context().close();
  });

  it("does not scroll sideways on a phone, in Dutch and in the dark", async () => {
    const { page } = await openDocument(browser, `${written(name)}#lang=nl`, { width: 390, dark: true });
    expect(await page.evaluate("document.documentElement.scrollWidth")).toBe(390);
    expect(await page.evaluate("document.documentElement.dataset.theme")).toBe("dark");
    expect((await page.locator("main h2").allTextContents()).join()).toContain(parts.dutch);
    expect(await page.locator("main").textContent()).not.toMatch(/undefined|NaN|\{\w+\}/);
    await page.context().close();
  });

  it("prints in light colours, and is on the screen as it was", async () => {
    const { page, errors } = await openDocument(browser, written(name), { dark: true });
    await page.evaluate(`window.addEventListener("beforeprint", () => (window.printed = document.documentElement.dataset.theme))`);
    const pdf = (await page.pdf({ preferCSSPageSize: true, printBackground: true })).toString("latin1");
    expect(await page.evaluate("window.printed")).toBe("light");
    expect(await page.evaluate("document.documentElement.dataset.theme")).toBe("dark");
    const [, wide, high] = /\/MediaBox \[0 0 ([\d.]+) ([\d.]+)\]/.exec(pdf)!.map(Number) as [number, number, number];
    expect(wide > high).toBe(name === "reach"); // its rows are long
    expect(errors).toEqual([]);
    await page.context().close();
  });
});

it("an element has a curve of each soil, also where the pressure comes back", async () => {
  const { page } = await openDocument(browser, written("element"));
  expect(await page.locator("figcaption").allTextContents()).toEqual(
    ["Path of the stress", "Deviator stress over strain", "Volume over pressure", "Volume over strain"]);
  expect(await page.locator(".curves polyline").count()).toBe(8);
  const path = (await page.locator(".curves polyline").first().getAttribute("points"))!.split(" ").map(Number);
  const x = path.filter((_, k) => k % 2 === 0);
  expect([x.length, x[10]]).toEqual([11, x[0]]); // there and back
  expect(x[5]!).toBeGreaterThan(x[0]!);
  expect(await page.locator(".notice").textContent()).toContain("clay: no strain leads there");
  await page.context().close();
});

it("a reach leads to the page of each section, and marks English on a Dutch page", async () => {
  const { page } = await openDocument(browser, written("reach", exampleReach("nl")));
  expect(await page.locator("tbody a").first().getAttribute("href")).toBe("a%20dike/run/report.html");
  expect(await page.locator("tr.floods .verdict-words").textContent()).toMatch(/^Loopt over, na een opgelegde trigger/);
  expect(await page.locator("[lang=en]").allTextContents()).toEqual(["it is <no> zip file\nTry another."]);
  expect(await page.locator("tbody canvas").count()).toBe(3);
  await page.getByRole("combobox", { name: "Taal" }).selectOption("en");
  await page.getByRole("heading", { name: "Sections of a reach" }).waitFor();
  await page.context().close();
});

describe.runIf(process.env.TERP)("pages of the program", () => {
  const folder = mkdtempSync(join(tmpdir(), "terp-web-"));
  const terp = (...words: string[]) => execFileSync(resolve(process.env.INIT_CWD ?? ".", process.env.TERP!), words, { stdio: "pipe", cwd: folder });
  const column = resolve(__dirname, "../../../cases/column_collapse/model_2.toml");
  const short = ["time.end=0.3", "output.fields.every=0.1"].flatMap((text) => ["--set", text]);

  it("of cell sizes", async () => {
    terp("converge", column, "--cells", "1,0.5", "-o", "cells", ...short);
    const { page, errors } = await openDocument(browser, join(folder, "cells/convergence.html"));
    expect(await page.locator("main h2").allTextContents()).toEqual(["as given", "Over the size of the cells", "How to read this"]);
    expect(await page.locator(".uplot canvas").count()).toBeGreaterThan(8);
    expect(await page.locator("tbody tr").count()).toBeGreaterThan(8);
    expect(await page.locator("main").textContent()).not.toMatch(/undefined|NaN/);
    expect(errors).toEqual([]);
    await page.context().close();
  });

  it("of a study, and of what it would draw", async () => {
    writeFileSync(join(folder, "demo.toml"), `case = "${column}"\nset = { "mesh.cell" = 1.0, "time.end" = 0.3 }\n[[random]]\nkey = "material.clay.su_peak"\n` +
      `distribution = "lognormal"\nmean = "8 kPa"\ncov = 0.4\n[estimator]\nkind = "monte_carlo"\n[stop]\nnumber = 8\n[events]\nvolume = 1.0\ndisplacement = 0.1\n`);
    terp("study", "run", "demo.toml", "-o", "demo", "-q");
    const { page, errors } = await openDocument(browser, join(folder, "demo/report.html"));
    expect(await page.locator("main h2").allTextContents()).toEqual(PARTS.study!.titles);
    expect(await page.locator("section:last-of-type tbody tr").count()).toBe(8);
    await page.context().close();
    terp("study", "sample", "demo.toml", "-o", "demo");
    const drawn = await openDocument(browser, join(folder, "demo/sample.html"));
    expect(await drawn.page.locator(".uplot canvas").count()).toBe(1);
    expect([...errors, ...drawn.errors]).toEqual([]);
    await drawn.page.context().close();
  });
});
