// What the program wrote into a page, decoded by the page's own code, against its history.csv. Needs TERP.

import { describe, expect, it } from "vitest";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { realRuns } from "../support/fixture";
import { csv, misfit, reportIn } from "../support/written";

describe.runIf(process.env.TERP)("a page of the program", () => {
  it("holds places and fields to the precision that it states", async () => {
    const { runs, page } = realRuns();
    const report = await reportIn(readFileSync(page, "utf8"));
    for (const run of report.runs) {
      const { compared, worst } = await misfit(run, csv(readFileSync(join(runs[run.index]!, "history.csv"), "utf8")));
      expect(compared).toBeGreaterThan(100);
      expect(Object.keys(worst).sort()).toEqual(["eps_deviatoric", "eps_eq_p", "pressure", "su", "x", "y"]);
      for (const [name, steps] of Object.entries(worst)) expect(steps, `${run.meta.name}: ${name}`).toBeLessThan(0.51);
    }
  });
});
