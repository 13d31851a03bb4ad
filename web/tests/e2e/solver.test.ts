// The page with the solver in a real browser, from disk: TERP_HTML=build/browser/terp.html, which `make browser` builds;
// skipped without it. With TERP=path/to/terp also against the native program.

import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, writeFileSync, mkdirSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import type { Browser, Page } from "playwright-core";
import { launch, openUntil, type Opened } from "../support/browser";
import { readZip, type Files } from "../../solver/zip";

const PAGE = resolve(process.env.TERP_HTML ?? "none");
const TERP = process.env.TERP;
const ROOT = resolve(__dirname, "../../..");
const SAMPLES = join(ROOT, "tests/import/dstability/samples");
const SMALL = resolve(__dirname, "../fixtures/small.toml");
const PATIENCE = { timeout: 400_000 };
const folder = () => mkdtempSync(join(tmpdir(), "terp-solver-"));

let browser: Browser;

const open = (options = {}): Promise<Opened> => openUntil(browser, PAGE, ".welcome", options);

async function give(page: Page, ...paths: string[]): Promise<void> {
  await page.setInputFiles("#files", paths);
}

/** Looked at without trouble: the button to run is there. */
async function ready(page: Page): Promise<void> {
  await page.waitForSelector("#run, .trouble", PATIENCE);
  expect(await page.locator(".trouble").allTextContents()).toEqual([]);
}

async function lookAgain(page: Page, cell: number): Promise<void> {
  await page.fill("input[name=cell]", String(cell));
  await page.click("#choices button[type=submit]");
  await page.waitForSelector("#choices", { state: "detached" }).catch(() => undefined);
  await ready(page);
}

async function runToEnd(page: Page): Promise<void> {
  await page.click("#run");
  await page.waitForSelector("#result, .trouble", PATIENCE);
  expect(await page.locator(".trouble").allTextContents()).toEqual([]);
}

async function saved(page: Page, key: string): Promise<Uint8Array<ArrayBuffer>> {
  const [download] = await Promise.all([page.waitForEvent("download"), page.click(`[data-save=${key}]`)]);
  return new Uint8Array(readFileSync(await download.path()));
}

function unpackTo(files: Files): string {
  const to = folder();
  for (const [path, bytes] of files) {
    mkdirSync(dirname(join(to, path)), { recursive: true });
    writeFileSync(join(to, path), bytes);
  }
  return to;
}

const terp = (cwd: string, ...words: string[]) => execFileSync(resolve(TERP!), words, { cwd, encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
const json = (path: string) => JSON.parse(readFileSync(path, "utf8"));

describe.skipIf(!existsSync(PAGE))("the page with the solver", () => {
  beforeAll(async () => {
    browser = await launch();
  });
  afterAll(async () => browser?.close());

  it("opens with nothing from outside, says its limits, and fits a phone in both languages", async () => {
    const { page, errors, requests } = await open({ width: 390, dark: true });
    expect(await page.locator("main").textContent()).toMatch(/Nothing leaves this machine.*gmsh/s);
    await page.selectOption("select.language", "nl");
    expect(await page.locator("main").textContent()).toMatch(/Niets verlaat deze computer/);
    expect(await page.evaluate("document.documentElement.scrollWidth")).toBe(390);
    expect(readFileSync(PAGE).length).toBeLessThan(4.5e6);
    expect(await page.locator("footer").textContent()).toMatch(/Terp \d+\.\d+\.\d+, terp\.html .*SHA-256 .* [0-9a-f]{64}/);
    const licences = await page.locator(".licences pre").textContent();
    for (const name of ["fmtlib", "hdf5", "libzip", "muparser", "zlib", "Eigen", "Boost", "uplot", "emscripten"]) {
      expect(licences).toMatch(new RegExp(`^${name} \\d\\S+`, "m"));
    }
    expect([errors, requests]).toEqual([[], []]);
    await page.context().close();
  });

  it("solves a case to a report, whose zip the native program takes, with its numbers", async () => {
    const { page, errors, requests } = await open();
    await give(page, SMALL);
    await ready(page);
    expect(await page.evaluate("document.querySelector('img.picture').naturalWidth")).toBeGreaterThan(0);
    await runToEnd(page);
    const report = page.frames().find((frame) => frame.url().startsWith("blob:"))!;
    await report.waitForSelector(".view", PATIENCE);
    expect(await report.locator("main").textContent()).not.toMatch(/undefined|NaN|\{\w+\}/);
    const at = unpackTo(await readZip(await saved(page, "save_case")));
    if (TERP) {
      terp(at, "run", "case/small.toml", "-o", "native", "-j", "1", "-q");
      const [there, here] = ["run", "native"].map((name) => json(join(at, name, "summary.json")));
      expect([there.steps, there.points]).toEqual([here.steps, here.points]);
      expect(terp(at, "compare", "run", "native")).toMatch(/front/);
      terp(at, "report", "run");
    }
    expect(new TextDecoder().decode(await saved(page, "save_report"))).toContain("terp-report");
    expect(new TextDecoder().decode(await saved(page, "save_csv"))).toMatch(/x/);
    expect([errors, requests]).toEqual([[], []]);
    await page.context().close();
  }, 600_000);

  it("stops a run with a report of what there is, goes on with it, and opens its zip again", async () => {
    const { page } = await open();
    await page.click("[data-example=dike]");
    await ready(page);
    await lookAgain(page, 1);
    const stop = async (start: string) => {
      await page.click(start);
      await expect.poll(() => page.locator(".progress p").textContent(), { timeout: 300_000, interval: 100 }).toMatch(/t = /);
      await page.click("#stop");
      await page.waitForSelector("#result", PATIENCE);
      return Number(/t = ([\d.]+)/.exec((await page.locator("#result .notice").textContent())!)![1]);
    };
    const first = await stop("#run");
    expect(await page.locator("iframe.report").count()).toBe(1);
    expect(await stop("#go-on")).toBeGreaterThanOrEqual(first);
    const zip = join(folder(), "dike.zip");
    writeFileSync(zip, await saved(page, "save_case"));
    await page.click("nav .text-button");
    await give(page, zip);
    await ready(page);
    expect(await page.locator("#go-on").count()).toBe(1);
    await page.context().close();
  }, 900_000);

  it.each([["tutorial-2023.stix", 4], ["berm-fragility-2023.stix", 2]])("looks at %s as the native program does", async (name, cell) => {
    const { page } = await open();
    await give(page, join(SAMPLES, name));
    await ready(page);
    await lookAgain(page, cell);
    const facts = await page.locator(".facts").textContent();
    const options = await page.locator("select[name=stage] option").count();
    if (TERP) {
      const at = folder();
      terp(at, "import", join(SAMPLES, name), "-o", "case", "--scenario", "1", "--stage", String(options), "--cell", String(cell), "--strength", "deterministic");
      const check = JSON.parse(terp(at, "check", "case/case.toml", "--json"));
      expect(facts).toContain(String(check.points));
      expect(facts).toContain(String(check.steps));
    }
    await page.context().close();
  }, 600_000);

  it("finds a factor of safety, as the native program does", async () => {
    const { page } = await open();
    const slope = join(ROOT, "cases/verification/slope_60/case.toml");
    await give(page, slope);
    await ready(page);
    await lookAgain(page, 1);
    await page.uncheck("input[name=verdict]");
    await page.check("input[name=factor]");
    await runToEnd(page);
    const factor = Number(/([\d.]+)$/.exec((await page.locator(".factor").textContent())!)![1]);
    if (TERP) {
      const at = folder();
      terp(at, "stability", slope, "--set", "mesh.cell=1", "-o", "found", "-j", "1", "-q");
      expect(factor).toBeCloseTo(json(join(at, "found/stability.json")).factor_of_safety, 1);
    }
    await page.context().close();
  }, 900_000);

  it("refuses what it cannot use in one sentence, and goes on", async () => {
    const { page } = await open();
    const at = folder();
    const damaged = readFileSync(join(SAMPLES, "berm-fragility-2023.stix")).subarray(0, 9000);
    const bomb = readFileSync(join(SAMPLES, "berm-fragility-2023.stix"));
    bomb.writeUInt32LE(900e6, bomb.indexOf("PK\x01\x02") + 24); // what its first member unpacks to
    const files: [string, string | Uint8Array, RegExp][] = [
      ["damaged.stix", damaged, /damaged\.stix cannot be used.*zip/s],
      ["bomb.stix", bomb, /bomb\.stix cannot be used.*is too large/s],
      ["photo.png", "x", /none of the files/],
      ["bad.toml", "[mesh]\ncell = 'wide'\n", /bad\.toml cannot be used.*bad\.toml:2:8/s],
      ["empty.stix", readFileSync(join(SAMPLES, "empty-2023.stix")), /empty\.stix cannot be used/],
      ["huge.toml", readFileSync(join(ROOT, "cases/dike/dike.toml"), "utf8").replace(/^cell *=.*$/m, "cell = 0.004"), /memory|cannot be used/],
    ];
    for (const [name, content, says] of files) {
      writeFileSync(join(at, name), content);
      await give(page, join(at, name));
      await page.waitForSelector(".trouble", PATIENCE);
      expect(await page.locator(".trouble").textContent(), name).toMatch(says);
      if (await page.locator("#files").count() === 0) await page.click("nav .text-button");
      else await page.reload();
      await page.waitForSelector(".welcome");
    }
    await page.context().close();
  }, 600_000);
});
