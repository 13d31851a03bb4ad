// node assemble.mjs PROGRAM.js PROGRAM.wasm REPORT.html PAGE.html LICENCES.txt VERSION OUT.html
//
// Puts the program, the report page and the examples into the page of the solver, each compressed, as texts that no
// browser runs. The policy of the page names the scripts that may run by their hashes.
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const [glue, wasm, report, page, texts, version, out] = process.argv.slice(2);
const root = join(dirname(fileURLToPath(import.meta.url)), "../..");
const samples = "tests/import/dstability/samples";
const EXAMPLES = {
  dike: { "dike.toml": "cases/dike/dike.toml" },
  stix: { "tutorial.stix": `${samples}/tutorial-2023.stix` },
  slope: { "slope.toml": "cases/retrogressive_slope/slope_5m.toml" },
};

const digest = (data, encoding) => createHash("sha256").update(data).digest(encoding);
const program = readFileSync(wasm);
const template = readFileSync(report);
let html = readFileSync(page, "utf8");

const examples = Object.fromEntries(Object.entries(EXAMPLES).map(([name, files]) =>
  [name, Object.fromEntries(Object.entries(files).map(([path, at]) => [path, readFileSync(join(root, at)).toString("base64")]))]));
const licences = `${readFileSync(texts, "utf8")}\n${readFileSync(join(root, samples, "SOURCES.md"), "utf8")}`;
const parts = (size) => Object.entries({
  wasm: program, glue: readFileSync(glue), template, examples: JSON.stringify(examples),
  meta: JSON.stringify({ version, sum: digest(program, "hex"), size, licences }),
}).map(([name, data]) =>
  `<script type="application/octet-stream" data-part="${name}">${gzipSync(data, { level: 9 }).toString("base64")}</script>`).join("\n");

const scripts = [html, template.toString("utf8")].flatMap((text) =>
  [...text.matchAll(/<script type="module"[^>]*>([\s\S]*?)<\/script>/g)].map(([, script]) => script));
if (scripts.length < 2 || scripts.some((script) => script === "")) throw new Error("the scripts are not in the pages yet");
const policy = [
  "default-src 'none'", `script-src ${scripts.map((script) => `'sha256-${digest(script, "base64")}'`).join(" ")} 'wasm-unsafe-eval' blob:`,
  "worker-src blob:", "frame-src blob:", "style-src 'unsafe-inline'", "img-src data: blob:", "media-src blob:",
  "connect-src 'none'", "base-uri 'none'", "form-action 'none'",
].join("; ");
html = html.replace("<head>", () => `<head>\n    <meta http-equiv="Content-Security-Policy" content="${policy}" />`);
const size = html.length + parts(0).length;
writeFileSync(out, html.replace("<!--terp-parts-->", () => parts(size)));
console.log(`${out}: ${(size / 1e6).toFixed(2)} MB`);
