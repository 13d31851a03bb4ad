// vite-node take_picture.ts PAGE.html OUT.png: what Chromium shows of a page that Terp wrote, once it is drawn.

import { launch, openUntil, until } from "./browser";

const [file, out] = process.argv.slice(2) as [string, string];
const browser = await launch();
const { page } = await openUntil(browser, file, "main", { width: 1200, height: 760 });
await until(page, "document.querySelector('main.document') || (window.terp && window.terp.drawn > 0 && window.terp.ready)");
await page.screenshot({ path: out });
await browser.close();
