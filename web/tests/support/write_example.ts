// npm run example: dist/example.html, the built template with the made-up runs in it. Argument: points per side.

import { readFileSync, writeFileSync } from "node:fs";
import { exampleReport } from "./example";
import { fillTemplate } from "./encode";

const { report, chunks } = exampleReport(Number(process.argv[2] ?? 80));
writeFileSync("dist/example.html", fillTemplate(readFileSync("dist/index.html", "utf8"), report, chunks));
