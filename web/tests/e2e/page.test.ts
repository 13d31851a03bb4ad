// The page in a real browser, from disk. With TERP=path/to/terp the same tests run on a page that the program wrote.

import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { readFileSync } from "node:fs";
import { PNG } from "pngjs";
import type { Browser, Page } from "playwright-core";
import type { ReportMeta } from "../../src/data/format";
import { launch, open, until, type Opened } from "../support/browser";
import { dikePage, examplePage, realDike, realRuns } from "../support/fixture";

let browser: Browser;
beforeAll(async () => {
  browser = await launch();
});
afterAll(async () => browser?.close());

const pages: [string, () => string][] = [["made-up runs", () => examplePage(40)]];
if (process.env.TERP) pages.push(["runs of the program", () => realRuns().page]);

const state = <T>(page: Page, key: string) => page.evaluate(`window.terp.store.state.${key}`) as Promise<T>;

/** Pixels of a view as RGBA. */
async function pixels(page: Page, view: number): Promise<PNG> {
  const url = (await page.evaluate(`document.querySelectorAll(".view")[${view}].toDataURL("image/png")`)) as string;
  return PNG.sync.read(Buffer.from(url.split(",")[1]!, "base64"));
}

/** Number of pixels that are neither grey nor white: soil in viridis. */
function coloured(png: PNG): number {
  let count = 0;
  for (let k = 0; k < png.data.length; k += 4) {
    const [r, g, b] = [png.data[k]!, png.data[k + 1]!, png.data[k + 2]!];
    if (Math.max(r, g, b) - Math.min(r, g, b) > 40) count++;
  }
  return count;
}

async function settled(page: Page): Promise<void> {
  await page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))");
}

describe.each(pages)("the page of %s", (_, make) => {
  let opened: Opened;
  let page: Page;
  let path: string;

  beforeAll(async () => {
    path = make();
    opened = await open(browser, path);
    page = opened.page;
  });
  afterAll(async () => page?.context().close());

  it("shows soil of both runs, a title, the story and the numbers", async () => {
    for (const view of [0, 1]) expect(coloured(await pixels(page, view))).toBeGreaterThan(5000);
    expect(await page.locator("h1").textContent()).toMatch(/\w/);
    expect(await page.locator(".facts").textContent()).toMatch(/First slide begins/);
    expect(await page.locator(".story-of p").count()).toBeGreaterThan(0);
    expect(await page.locator(".facts td").count()).toBeGreaterThan(5);
  });

  it("plays, pauses and scrubs, all runs at one time", async () => {
    await page.keyboard.press("Home");
    await page.getByRole("slider", { name: "Time" }).focus();
    await page.keyboard.press("Home");
    expect(await state<number>(page, "time")).toBe(0);
    await settled(page);
    const before = await pixels(page, 1);
    await page.getByRole("button", { name: "Play" }).click();
    await until(page, "window.terp.store.state.time > 0.3");
    await page.getByRole("button", { name: "Pause" }).click();
    expect(await state<boolean>(page, "playing")).toBe(false);
    await page.getByRole("slider", { name: "Time" }).fill("2.5");
    expect(await state<number>(page, "time")).toBeCloseTo(2.5, 1);
    expect(await page.locator(".now").textContent()).toMatch(/^2\.5/);
    await settled(page);
    const after = await pixels(page, 1);
    expect(before.data.equals(after.data)).toBe(false);
    await page.keyboard.press("ArrowRight");
    expect(await state<number>(page, "time")).toBeGreaterThan(2.5);
  });

  it("colours by another field, with another range, on another map", async () => {
    const first = await pixels(page, 0);
    const names = (await page.evaluate(`[...document.querySelectorAll("#field option")].map((o) => o.value)`)) as string[];
    const velocity = names.find((name) => name === "velocity")!;
    await page.selectOption("#field", velocity);
    await until(page, "window.terp.ready");
    await settled(page);
    const second = await pixels(page, 0);
    expect(first.data.equals(second.data)).toBe(false);
    await page.selectOption("#field", names[0]!);
    await settled(page);
    const third = await pixels(page, 0);
    await page.selectOption("#range", "fixed");
    await page.getByLabel("Upper end of the range").fill("0.001");
    await page.getByLabel("Upper end of the range").blur();
    expect((await state<number[]>(page, "fixed"))[1]).toBe(0.001);
    await settled(page);
    expect((await pixels(page, 0)).data.equals(third.data)).toBe(false);
    await page.selectOption("#range", "frame");
    await page.selectOption("#map", "cividis");
    await page.selectOption("#field", "material");
    await until(page, "window.terp.ready");
    expect(await page.locator("#map").isDisabled()).toBe(true);
    await page.selectOption("#field", names[0]!);
    await page.selectOption("#map", "viridis");
    await page.selectOption("#range", "run");
    await until(page, "window.terp.ready");
  });

  it("zooms and pans both runs alike, and shows all again", async () => {
    const view = page.locator(".view").first();
    const box = (await view.boundingBox())!;
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    const other = await pixels(page, 1);
    await page.keyboard.down("Control");
    await page.mouse.wheel(0, -240);
    await page.keyboard.up("Control");
    const scale = await state<number>(page, "camera.scale");
    await settled(page);
    expect((await pixels(page, 1)).data.equals(other.data)).toBe(false);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 + 60, box.y + box.height / 2 + 10, { steps: 3 });
    await page.mouse.up();
    expect(await state<number>(page, "camera.scale")).toBe(scale);
    expect(await state(page, "pin")).toBeNull(); // a drag is no click
    await page.keyboard.press("0");
    expect(await state(page, "camera")).toBeNull();
  });

  it("does not take the wheel away from the page", async () => {
    await page.evaluate("document.activeElement.blur(); window.scrollTo(0, 0)");
    const box = (await page.locator(".view").first().boundingBox())!;
    await page.mouse.move(box.x + 100, box.y + 60);
    await page.mouse.wheel(0, 200);
    await until(page, "window.scrollY > 50");
    expect(await state(page, "camera")).toBeNull();
    await page.evaluate("window.scrollTo(0, 0)");
  });

  it("shows the values of a point under the pointer, and pins it with its history in both runs", async () => {
    await page.locator(".player").scrollIntoViewIfNeeded();
    const box = (await page.locator(".view").first().boundingBox())!;
    const [x, y] = (await page.evaluate("window.terp.place(0, 3)")) as [number, number];
    await page.mouse.move(box.x + x, box.y + y);
    await page.waitForSelector(".tip:not([hidden])");
    await until(page, `!document.querySelector(".tip").textContent.includes("…")`);
    expect(await page.locator(".tip").textContent()).toMatch(/x, y.*\sm.*point \d+/);
    await page.mouse.click(box.x + x, box.y + y);
    await page.waitForSelector(".pinned:not([hidden]) canvas");
    const pin = await state<{ run: number; point: number }>(page, "pin");
    expect(pin.run).toBe(0);
    const [px, py] = (await page.evaluate(`window.terp.place(0, ${pin.point})`)) as [number, number];
    expect(Math.hypot(px - x, py - y)).toBeLessThan(2);
    expect(await page.locator(".pinned thead th").count()).toBe(2);
    expect(await page.locator(".tip").isHidden()).toBe(true); // its values stand beside the views now
    await page.keyboard.press("Escape");
    expect(await page.locator(".pinned").isHidden()).toBe(true);
  });

  it("says so where the pinned point has no value of the chosen field", async () => {
    const { page } = await open(browser, examplePage(20, 1));
    await page.evaluate(`window.terp.store.set({ field: "pressure", pin: { run: 0, point: 0 } })`);
    await until(page, `document.querySelector(".pinned").textContent.includes("This point has no value of mean stress")`);
    expect(await page.locator(".pinned .chart").isHidden()).toBe(true);
    await page.evaluate(`window.terp.store.set({ pin: { run: 0, point: 1 } })`);
    await page.waitForSelector(".pinned .chart canvas");
    expect(await page.locator(".pinned p").isHidden()).toBe(true);
    await page.context().close();
  });

  it("switches mesh, outline and surfaces on and off", async () => {
    await page.mouse.move(2, 2);
    for (const name of ["mesh", "outline", "other surface"]) {
      await settled(page);
      const before = await pixels(page, 0);
      const button = page.locator(".toggle", { hasText: name }).first();
      const pressed = await button.getAttribute("aria-pressed");
      await button.click();
      expect(await button.getAttribute("aria-pressed")).not.toBe(pressed);
      await settled(page);
      expect((await pixels(page, 0)).data.equals(before.data), name).toBe(false);
      await button.click();
      await settled(page);
      expect((await pixels(page, 0)).data.equals(before.data), name).toBe(true);
    }
  });

  it("saves an image that shows soil, title and colour bar", async () => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Save the views as a PNG (E)" }).click()]);
    expect(download.suggestedFilename()).toMatch(/\.png$/);
    const png = PNG.sync.read(readFileSync((await download.path())!));
    expect(png.width).toBeGreaterThan(1200);
    expect(coloured(png)).toBeGreaterThan(20_000);
    const at = (x: number, y: number) => [...png.data.subarray(4 * (y * png.width + x), 4 * (y * png.width + x) + 3)];
    expect(at(2, 2)).toEqual([255, 255, 255]); // the ground
    const bar = Array.from({ length: png.width }, (_, x) => at(x, png.height - 2 * (14 + 40 - 6 - 12))); // through the colour bar
    expect(bar.some(([r, g, b]) => r! > 220 && g! > 200 && b! < 90)).toBe(true); // viridis' yellow end
    expect(bar.some(([r, g, b]) => r! < 80 && g! < 30 && b! > 70)).toBe(true); // its violet end
    const title = Array.from({ length: 400 }, (_, x) => Array.from({ length: 30 }, (_, y) => at(28 + x, 34 + y))).flat();
    expect(title.some(([r]) => r! < 60)).toBe(true); // dark letters
  });

  it("records the animation as a video", async () => {
    await page.evaluate("window.terp.store.set({ speed: 5 })");
    const [download] = await Promise.all([page.waitForEvent("download", { timeout: 0 }), page.keyboard.press("v")]);
    expect(download.suggestedFilename()).toMatch(/\.(webm|mp4)$/);
    const bytes = readFileSync((await download.path())!);
    expect(bytes.length).toBeGreaterThan(10_000);
    const webm = bytes.subarray(0, 4).toString("hex") === "1a45dfa3";
    expect(webm || bytes.subarray(4, 8).toString() === "ftyp").toBe(true);
  }, 600_000);

  it("answers the keyboard and lists the keys", async () => {
    await page.evaluate("document.activeElement.blur()");
    await page.keyboard.press("Shift+?");
    expect(await page.locator("dialog.keys").isVisible()).toBe(true);
    await page.keyboard.press("Escape");
    expect(await page.locator("dialog.keys").isVisible()).toBe(false);
    await page.keyboard.press("m");
    expect(await state<boolean>(page, "mesh")).toBe(true);
    await page.keyboard.press("m");
    await page.keyboard.press("t");
    expect(await page.evaluate("document.documentElement.dataset.theme")).toBe("dark");
    await page.keyboard.press("t");
    await page.keyboard.press("2");
    expect(await state<string>(page, "field")).not.toBe(await page.locator("#field option").first().getAttribute("value"));
    await page.keyboard.press("1");
  });

  it("goes to the time of a click in a chart", async () => {
    const over = page.locator("#charts .u-over").first();
    await over.scrollIntoViewIfNeeded();
    const box = (await over.boundingBox())!;
    await page.mouse.click(box.x + box.width / 2, box.y + 40);
    const end = Number(await page.getByRole("slider", { name: "Time" }).getAttribute("max"));
    expect(await state<number>(page, "time")).toBeCloseTo(end / 2, 1);
  });

  it("names every control, needs no network and leaves the console clean", async () => {
    const nameless = await page.evaluate(`[...document.querySelectorAll("button, select, input, canvas.view")].filter((e) => !(e.getAttribute("aria-label") || e.textContent.trim() || e.labels?.length)).length`);
    expect(nameless).toBe(0);
    expect(opened.requests).toEqual([]);
    expect(opened.errors).toEqual([]);
  });

  it("does not scroll sideways on a phone, a laptop or a projector", async () => {
    for (const width of [400, 800, 1366, 1920]) {
      await page.setViewportSize({ width, height: 800 });
      await settled(page);
      expect(await page.evaluate("document.documentElement.scrollWidth - document.documentElement.clientWidth"), `${width}`).toBeLessThanOrEqual(0);
    }
  });
});

describe("the page", () => {
  it("of one run has no comparison and no second view", async () => {
    const { page, errors } = await open(browser, examplePage(20, 1));
    expect(await page.locator(".view").count()).toBe(1);
    expect(await page.locator("#comparison").count()).toBe(0);
    expect(errors).toEqual([]);
    await page.context().close();
  });

  it("runs no script but its own, and asks no network, whatever is put into it", async () => {
    const { page, errors, requests } = await open(browser, examplePage(20, 1));
    const tried = await page.evaluate(`(async () => {
      const script = document.createElement("script");
      script.textContent = "window.foreign = 1";
      document.body.append(script);
      return fetch("https://example.org/").then(() => "sent", () => "refused");
    })()`);
    expect(tried).toBe("refused");
    expect(await page.evaluate("window.foreign")).toBeUndefined();
    expect(requests).toEqual([]);
    expect(errors.filter((text) => /Content Security Policy/.test(text)).length).toBeGreaterThanOrEqual(2);
    await page.context().close();
  });

  it("of a wide section gives the views the whole width, and two fifths of the window's height", async () => {
    const room = async (height: number) => {
      const low = ({ runs: [run] }: ReportMeta) => Object.assign(run!, { outline: null, positions: { ...run!.positions, y: { ...run!.positions.y, lo: 0, hi: height } } });
      const { page } = await open(browser, examplePage(20, 1, low));
      const views = (await page.locator(".stage").boundingBox())!;
      await page.context().close();
      return views;
    };
    expect((await room(5)).width).toBeLessThan(1000); // of 1366: the story stands beside
    const wide = await room(0.8);
    expect(wide.width).toBeGreaterThan(1200);
    expect(wide.height).toBeGreaterThan(0.38 * 768);
  });

  it("of a wide section in a high window shows the soil, not the air over it", async () => {
    const low = ({ runs: [run] }: ReportMeta) => Object.assign(run!, { outline: null, positions: { ...run!.positions, y: { ...run!.positions.y, lo: 0, hi: 0.8 } } });
    const { page } = await open(browser, examplePage(20, 1, low), { height: 1800 });
    expect((await page.locator(".stage").boundingBox())!.height).toBeLessThanOrEqual(320);
    await page.context().close();
  });

  it("of three runs can hide one", async () => {
    const { page, errors } = await open(browser, examplePage(20, 3));
    await page.locator(".toggle", { hasText: "MPM-GP" }).click();
    await settled(page);
    expect(await page.locator(".view:visible").count()).toBe(2);
    expect(await page.evaluate("document.documentElement.scrollWidth - document.documentElement.clientWidth")).toBeLessThanOrEqual(0);
    expect(errors).toEqual([]);
    await page.context().close();
  });

  it("says that only some of many points are shown, that a run is under way, and what to beware of", async () => {
    const { page, errors } = await open(browser, examplePage(20, 1, (report) => Object.assign(report.runs[0]!, { n_points: 4000, finished: false, warnings: { en: ["Beware."] } })));
    expect(await page.locator(".see").textContent()).toContain("One material point in 10 is shown: 400 of 4000.");
    expect(await page.locator(".beside").textContent()).toMatch(/has not reached its end.*up to 3.s.*Beware\./);
    expect(errors).toEqual([]);
    await page.context().close();
  });

  it("keeps what one looks at over a reload", async () => {
    const { page, errors } = await open(browser, examplePage(20));
    await page.evaluate(`window.terp.store.set({ field: "velocity", time: 1.5, mesh: true })`);
    await until(page, `location.hash.includes("velocity")`);
    await page.reload();
    await until(page, "window.terp && window.terp.ready");
    expect([await state(page, "field"), await state(page, "time"), await state(page, "mesh")]).toEqual(["velocity", 1.5, true]);
    expect(errors).toEqual([]);
    await page.context().close();
  });

  it("without WebGL says so, and has its story and charts", async () => {
    const context = await browser.newContext();
    await context.addInitScript(`const get = HTMLCanvasElement.prototype.getContext; HTMLCanvasElement.prototype.getContext = function (type, ...more) { return type === "webgl2" ? null : get.call(this, type, ...more); }`);
    const page = await context.newPage();
    const errors: string[] = [];
    page.on("pageerror", (error) => errors.push(String(error)));
    await page.goto(`file://${examplePage(20)}`);
    await page.waitForSelector("#charts canvas");
    expect(await page.locator(".see .notice").textContent()).toContain("no WebGL 2");
    expect(await page.locator(".facts td").count()).toBeGreaterThan(5);
    expect(errors).toEqual([]);
    await context.close();
  });

  it("prints in light colours on a few pages, from a dark screen too", async () => {
    const { page, errors } = await open(browser, examplePage(20), { dark: true });
    const before = await pixels(page, 0);
    await page.evaluate(`window.addEventListener("beforeprint", () => (window.printed = document.documentElement.dataset.theme))`);
    const pdf = await page.pdf({ preferCSSPageSize: true, printBackground: true });
    const sheets = pdf.toString("latin1").match(/\/Type \/Page\b/g)!.length;
    expect(sheets).toBeGreaterThan(1);
    expect(sheets).toBeLessThan(9);
    expect(await page.evaluate("window.printed")).toBe("light");
    expect(await page.evaluate("document.documentElement.dataset.theme")).toBe("dark");
    await expect.poll(async () => (await pixels(page, 0)).data.equals(before.data), { timeout: 5000 }).toBe(true); // sizes come back with the next layout
    expect(errors).toEqual([]);
    await page.context().close();
  });

  it("of a dike tells the verdict, draws layers, loads and slip planes, and colours by the strength that is left", async () => {
    const { page, errors } = await open(browser, dikePage());
    expect(await page.locator(".verdict-word").textContent()).toBe("Damaged, holds the water");
    expect(await page.locator(".tiles").textContent()).toMatch(/First slide0\.20.s.*Entry pointx = 2\.00.m.*Freeboard0\.40.m/);
    expect(await state<string>(page, "field")).toBe("su_ratio");
    for (const key of ["layers", "water", "slip"]) {
      await settled(page);
      const before = await pixels(page, 0);
      await page.evaluate(`window.terp.store.set({ ${key}: false })`);
      await settled(page);
      expect((await pixels(page, 0)).data.equals(before.data), key).toBe(false);
    }
    expect(await page.locator(".strength h3").textContent()).toMatch(/^Undrained strength at x = /);
    await page.locator(".strength button").first().click();
    expect(await state<number>(page, "profileX")).toBeGreaterThan(0);
    expect(await page.locator(".profile-x").getAttribute("aria-valuetext")).toMatch(/^\d+\.\d\d.m$/);
    expect(errors).toEqual([]);
    await page.context().close();
  });

  it("of a dike whose run was stopped gives no verdict, and where nothing softens shows its soils", async () => {
    const { page } = await open(browser, dikePage(({ runs: [run] }) => {
      run!.finished = false;
      run!.summary.softened_strain = null;
      Object.assign(run!.events!.flood!, { verdict: "stands", first_time_damaged: null }); // as an older terp wrote it
      run!.events!.slides = [];
      run!.events!.moved_fraction = 0;
      run!.summary.findings = [{ id: "side", en: "Soil came to the side `right`.", nl: "Grond bereikte de rand `right`.", see: "" }];
    }));
    expect(await page.getByRole("heading", { name: "No verdict yet: not at its end" }).count()).toBe(1);
    expect(await page.locator("article.verdict").getAttribute("class")).toContain("running");
    const words = await page.locator("main").innerText();
    expect(words).toContain("so far, to 3.00");
    expect(words).toContain("Soil came to the side “right”.");
    expect(words).not.toMatch(/stands\b.*at the end|The soil holds/);
    expect(await state<string>(page, "field")).toBe("material");
    await page.context().close();
  });

  it("draws charts and views for a sheet at the size that they have there", async () => {
    const { page } = await open(browser, dikePage());
    await page.evaluate(`window.addEventListener("beforeprint", () => {
      const shown = (canvas) => ({ width: canvas.width / canvas.clientWidth, height: canvas.height / canvas.clientHeight });
      window.drawn = [...document.querySelectorAll(".view, .strength canvas, #charts .card:not(.energy, .surfaces) .u-wrap canvas")].map(shown);
      window.tall = document.querySelector(".view").clientHeight;
    })`);
    await page.pdf({ preferCSSPageSize: true, printBackground: true });
    const drawn = (await page.evaluate("window.drawn")) as { width: number; height: number }[];
    expect(drawn.length).toBeGreaterThan(3);
    for (const { width, height } of drawn) {
      expect(width).toBeGreaterThan(1.9); // pixels per CSS pixel: sharp
      expect(width / height).toBeCloseTo(1, 1); // and not squashed
    }
    expect(await page.evaluate("window.tall")).toBeGreaterThan(200);
    await expect.poll(async () => page.evaluate("document.body.style.width"), { timeout: 5000 }).toBe("");
    await page.context().close();
  });

  it("of a dike prints on two sheets, also with many doubts, and is on the screen as it was", async () => {
    const lines = Array.from({ length: 12 }, (_, k) => `The layer \`soil ${k}\` has SHANSEP strength, but no state point or ` +
      "state line of any stage gives it a POP above zero: it counts as normally consolidated, the weakest that it can be.");
    const { page } = await open(browser, dikePage(({ runs: [run] }) => (run!.doubts = { en: lines, nl: lines })));
    const sheets = async () => (await page.pdf({ preferCSSPageSize: true, printBackground: true })).toString("latin1")
      .match(/\/Type \/Page\b/g);
    expect(await sheets()).toHaveLength(2);
    expect(await page.evaluate("[document.body.style.zoom, document.body.style.width]")).toEqual(["", ""]);
    expect(await page.evaluate(`document.querySelector(".views").style.getPropertyValue("--paper-height")`)).toBe("");
    await page.context().close();
  });

  it("of a dike prints on two sheets, with the path and the checksum of its case", async () => {
    const lines = Array.from({ length: 25 }, (_, k) => `soil_${k}: stiffness and K0 are defaults of clay, 0.5 each.`);
    const { page, errors } = await open(browser, dikePage(({ runs: [run] }) => (run!.assumed = { en: lines, nl: lines })));
    const pdf = await page.pdf({ preferCSSPageSize: true, printBackground: true });
    expect(pdf.toString("latin1").match(/\/Type \/Page\b/g)).toHaveLength(2);
    expect(await page.locator(".assumed summary").innerText()).toContain("(25)");
    expect(await page.locator(".assumed tbody tr").first().isVisible()).toBe(false); // folded
    await page.locator(".assumed summary").click();
    expect(await page.locator(".assumed tbody td:first-child").nth(24).innerText()).toBe(lines[24]);
    await page.emulateMedia({ media: "print" });
    expect(await page.locator(".about-run pre").isVisible()).toBe(false);
    expect(await page.locator(".about-run .pairs").innerText()).toContain("runs/example/case.toml, checksum 0123456789abcdef");
    expect(await state<string>(page, "field")).toBe("su_ratio"); // printing showed the soils, and went back
    expect(errors).toEqual([]);
    await page.context().close();
  });

  it("of a dike shows all numbers beside a long verdict, on paper too", async () => {
    const { page } = await open(browser, dikePage(({ runs: [run] }) => {
      run!.events!.flood!.trigger = { stage: "weaker_soil", at_strength: 1.2345, river: 12.34, before: "stands" };
    }));
    const cut = "[...document.querySelectorAll('.facts')].some((t) => t.parentElement.scrollWidth > t.parentElement.clientWidth)";
    await page.setViewportSize({ width: 1000, height: 900 });
    await settled(page);
    expect(await page.evaluate(cut)).toBe(false);
    await page.emulateMedia({ media: "print" });
    await page.setViewportSize({ width: 718, height: 1047 }); // of A4 within its margins
    expect(await page.evaluate(cut)).toBe(false);
    await page.context().close();
  });

  it("speaks Dutch where the report says so, or the reader chooses it", async () => {
    const { page, errors } = await open(browser, dikePage((report) => (report.language = "nl")));
    const words = () => page.locator("body").innerText();
    expect(await words()).toMatch(/Beschadigd, keert het water.*waakhoogte.*0,40.m.*Restprofiel/s);
    expect(await words()).not.toMatch(/\b(slide|what happened|residual|colour by|named points|checks)\b/i);
    const again = page.waitForEvent("load"); // the page loads anew in the other language
    await page.selectOption(".language", "en");
    await again;
    await until(page, `document.querySelector(".verdict-word")?.textContent.startsWith("Damaged")`);
    expect(page.url()).toContain("lang=en");
    expect(errors).toEqual([]);
    await page.context().close();
  });

  it("without data says how to get some", async () => {
    const context = await browser.newContext();
    const page = await context.newPage();
    await page.goto(`file://${process.cwd()}/dist/index.html`);
    expect(await page.getByRole("alert").textContent()).toContain("terp report RUN");
    await context.close();
  });

  it("plays 40 000 points per run", async () => {
    const { page } = await open(browser, examplePage(200));
    await page.evaluate("window.terp.store.set({ time: 0, again: true, speed: 2 })");
    await page.keyboard.press(" ");
    const rate = (await page.evaluate(`new Promise((done) => { const [n, t] = [window.terp.drawn, performance.now()]; setTimeout(() => done(1000 * (window.terp.drawn - n) / (performance.now() - t)), 4000); })`)) as number;
    console.log(`two runs of 40 000 points, software rendering: ${rate.toFixed(1)} pictures per second`);
    expect(rate).toBeGreaterThan(2);
    await page.context().close();
  });
});

describe.runIf(process.env.TERP)("the page of a dike of the program", () => {
  it("is in Dutch where it was asked for, prints on two sheets, and draws all that a section has", async () => {
    const path = realDike();
    const { page, errors } = await open(browser, path);
    expect(await page.locator(".verdict-word").textContent()).toBe("Loopt over");
    expect(await page.locator(".tile").count()).toBe(7);
    expect(await page.locator(".toggle:visible").allTextContents()).toEqual(
      expect.arrayContaining(["grondlagen", "water en belasting", "omtrek", "glijvlak", "punten"]));
    expect(await page.locator("#field option").allTextContents()).toEqual(expect.arrayContaining(["waterspanning", "grondsoort"]));
    const words = await page.evaluate(`[document.querySelector("main").innerText, ...[...document.querySelectorAll("#field option, .u-legend")].map((e) => e.textContent)].join(" ").replace(/[\\w/.]*report[\\w/.]*/g, "")`);
    expect(words).not.toMatch(/\b(the|work|energy|strain|strength|slide|slip|stress|speed|share|shown)\b/i);
    const pdf = await page.pdf({ preferCSSPageSize: true, printBackground: true });
    expect(pdf.toString("latin1").match(/\/Type \/Page\b/g)).toHaveLength(2);
    expect(errors).toEqual([]);
    await page.context().close();
  });
});
