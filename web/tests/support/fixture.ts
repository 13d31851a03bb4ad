// The page to test: of the real program if TERP names it, else the built template with made-up runs.

import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { exampleReport } from "./example";
import { fillTemplate } from "./encode";

const ROOT = resolve(__dirname, "../../..");

export function template(): string {
  const path = join(ROOT, "web/dist/index.html");
  if (!existsSync(path)) throw new Error("No web/dist/index.html: npm run build makes it.");
  return readFileSync(path, "utf8");
}

/** A page with made-up runs of side x side points. */
export function examplePage(side: number, runs = 2): string {
  const { report, chunks } = exampleReport(side, runs);
  const path = join(mkdtempSync(join(tmpdir(), "terp-web-")), "example.html");
  writeFileSync(path, fillTemplate(template(), report, chunks));
  return path;
}

/** Runs model 2 on coarse cells with both schemes and writes their page; null if TERP is not set. */
export function realPage(): string | null {
  const { TERP } = process.env;
  if (!TERP) return null;
  const program = resolve(process.env.INIT_CWD ?? ".", TERP);
  const folder = mkdtempSync(join(tmpdir(), "terp-web-"));
  const runs = ["mpm_mixed", "mpm_gp"].map((scheme) => {
    const run = join(folder, `model_2_${scheme.slice(4)}`);
    execFileSync(program, ["run", join(ROOT, "cases/column_collapse/model_2.toml"), "--set", `scheme=${scheme}`, "--set", "mesh.cell=0.25",
      "--set", "output.fields.every=0.1", "-o", run], { stdio: "pipe" });
    return run;
  });
  const path = join(folder, "report.html");
  execFileSync(program, ["report", ...runs, "-o", path], { stdio: "pipe" });
  return path;
}
