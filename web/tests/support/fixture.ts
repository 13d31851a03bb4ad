// The page to test: of the real program if TERP names it, else the built template with made-up runs.

import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import type { ReportMeta } from "../../src/data/format";
import { exampleDike, exampleReport } from "./example";
import { fillTemplate } from "./encode";

const ROOT = resolve(__dirname, "../../..");

export function template(): string {
  const path = join(ROOT, "web/dist/index.html");
  if (!existsSync(path)) throw new Error("No web/dist/index.html: npm run build makes it.");
  return readFileSync(path, "utf8");
}

/** A page with made-up runs of side x side points, changed by `change`. */
export function examplePage(side: number, runs = 2, change: (report: ReportMeta) => void = () => undefined): string {
  const { report, chunks } = exampleReport(side, runs);
  change(report);
  const path = join(mkdtempSync(join(tmpdir(), "terp-web-")), "example.html");
  writeFileSync(path, fillTemplate(template(), report, chunks));
  return path;
}

/** A page with one made-up run that has all of a dike: soils, a load, free water, a slip plane of another method. */
export function dikePage(change: (report: ReportMeta) => void = () => undefined): string {
  const made = exampleDike();
  change(made.report);
  const path = join(mkdtempSync(join(tmpdir(), "terp-web-")), "dike.html");
  writeFileSync(path, fillTemplate(template(), made.report, made.chunks));
  return path;
}

export interface RealRuns {
  runs: string[]; // folders
  page: string;
}

let made: RealRuns | null = null;

/** The dike on coarse cells, and its page in Dutch, by the program that TERP names. */
export function realDike(): string {
  const program = resolve(process.env.INIT_CWD ?? ".", process.env.TERP!);
  const folder = mkdtempSync(join(tmpdir(), "terp-web-"));
  const settings = ["mesh.cell=1", "output.fields.every=2"].flatMap((text) => ["--set", text]);
  execFileSync(program, ["run", join(ROOT, "cases/dike/dike.toml"), ...settings, "-o", join(folder, "dike"), "--report", "--language", "nl"],
    { stdio: "pipe" });
  return join(folder, "dike", "report.html");
}

/** Model 2 on coarse cells with both schemes, and their page, by the program that TERP names. Made once. */
export function realRuns(): RealRuns {
  if (made) return made;
  const program = resolve(process.env.INIT_CWD ?? ".", process.env.TERP!);
  const folder = mkdtempSync(join(tmpdir(), "terp-web-"));
  const runs = ["mpm_mixed", "mpm_gp"].map((scheme) => {
    const run = join(folder, `model_2_${scheme.slice(4)}`);
    const settings = [`scheme=${scheme}`, "mesh.cell=0.25", "output.fields.every=0.1"].flatMap((text) => ["--set", text]);
    execFileSync(program, ["run", join(ROOT, "cases/column_collapse/model_2.toml"), ...settings, "-o", run], { stdio: "pipe" });
    return run;
  });
  const page = join(folder, "report.html");
  execFileSync(program, ["report", ...runs, "-o", page], { stdio: "pipe" });
  made = { runs, page };
  return made;
}
