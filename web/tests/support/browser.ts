// Debian's Chromium with the page from disk, no network; everything that it says on the console is kept.

import { existsSync } from "node:fs";
import { chromium, type Browser, type Page } from "playwright-core";

const FLAGS = [
  "--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader", // as on a computer without a graphics card
  "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync",
];

export function launch(): Promise<Browser> {
  const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
  if (!existsSync(executablePath)) throw new Error(`No ${executablePath}: tools/install-dependencies --web installs it, or set CHROMIUM.`);
  return chromium.launch({ executablePath, args: FLAGS });
}

export interface Opened {
  page: Page;
  errors: string[]; // console errors and warnings, exceptions
  requests: string[]; // addresses other than file: and data:
}

/** Waits until an expression is true in the page. Asked from outside: the page's policy allows no `eval`, which waitForFunction needs. */
export async function until(page: Page, expression: string, seconds = 60): Promise<void> {
  for (const end = Date.now() + 1000 * seconds; !(await page.evaluate(`Boolean(${expression})`)); await page.waitForTimeout(30)) {
    if (Date.now() > end) throw new Error(`not true after ${seconds} s: ${expression}`);
  }
}

interface Screen {
  width?: number;
  height?: number;
  dark?: boolean;
}

/** Opens the file and waits for an element. */
export async function openUntil(browser: Browser, file: string, selector: string, { width = 1366, height = 768, dark = false }: Screen): Promise<Opened> {
  const context = await browser.newContext({ viewport: { width, height }, colorScheme: dark ? "dark" : "light", acceptDownloads: true });
  const page = await context.newPage();
  const errors: string[] = [];
  const requests: string[] = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type()) && !isDriverNote(message.text())) errors.push(message.text());
  });
  page.on("pageerror", (error) => errors.push(String(error)));
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) requests.push(request.url());
  });
  await page.goto(`file://${file}`);
  await page.waitForSelector(selector, { timeout: 60_000 });
  return { page, errors, requests };
}

/** Opens the page of runs and waits for the first picture. */
export async function open(browser: Browser, file: string, options: Screen = {}): Promise<Opened> {
  const opened = await openUntil(browser, file, ".view", options);
  await until(opened.page, "window.terp && window.terp.drawn > 0 && window.terp.ready");
  return opened;
}

/** Opens a page that shows no single run. */
export function openDocument(browser: Browser, file: string, options: Screen = {}): Promise<Opened> {
  return openUntil(browser, file, "main.document", options);
}

/** Notes of the software renderer on its own speed; they are not the page's. */
function isDriverNote(text: string): boolean {
  return /GPU stall due to ReadPixels|GL Driver Message/.test(text);
}
