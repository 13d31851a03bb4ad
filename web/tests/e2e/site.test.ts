// The site of the documents in a real browser, from disk: SITE=build/site, which `make site` makes; skipped without it.

import { existsSync, readdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import type { Browser } from "playwright-core";
import { launch, openUntil, until, type Opened } from "../support/browser";

const SITE = resolve(process.env.SITE ?? "none");
const PAGES = existsSync(SITE)
  ? readdirSync(SITE, { recursive: true, encoding: "utf8" }).filter((file) => file.endsWith(".html")) : [];

describe.skipIf(!PAGES.length)("the site", () => {
  let browser: Browser;
  let opened: Opened;
  beforeAll(async () => {
    browser = await launch();
    opened = await openUntil(browser, join(SITE, "index.html"), "main", {});
  });
  afterAll(async () => browser?.close());

  it("opens page by page: pictures are there, and nothing is asked of the network", async () => {
    for (const file of PAGES) {
      await opened.page.goto(`file://${join(SITE, file)}`);
      const lost = await opened.page.evaluate("[...document.images].filter((image) => !image.naturalWidth).map((image) => image.src)");
      expect([file, lost]).toEqual([file, []]);
    }
    expect(opened.requests).toEqual([]);
    expect(opened.errors).toEqual([]);
  });

  it("finds a section, by keyboard, from a folder", async () => {
    const { page } = opened;
    await page.goto(`file://${join(SITE, "docs/decisions/index.html")}`);
    await page.keyboard.press("/");
    await until(page, "globalThis.sections");
    await page.keyboard.type("trigger strength");
    await until(page, "document.querySelector('.search li a')");
    await Promise.all([page.waitForURL("**/dstability.html#*"), page.keyboard.press("Enter")]);
    expect(await page.evaluate("document.getElementById(location.hash.slice(1)) !== null")).toBe(true);
    await page.fill(".search input", "no such word anywhere");
    await expect.poll(() => page.textContent(".search ol")).toBe("Nothing found.");
    expect(opened.errors).toEqual([]);
  });

  it("fits a narrow screen", async () => {
    const { page } = await openUntil(browser, join(SITE, "index.html"), "main", { width: 360 });
    expect(await page.evaluate("document.documentElement.scrollWidth")).toBeLessThanOrEqual(360);
  });
});
