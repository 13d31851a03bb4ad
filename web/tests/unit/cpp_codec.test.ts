// Bytes that the C++ writer wrote, read by the page, against history.csv of the same run.

import { describe, expect, it } from "vitest";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { csv, misfit, reportIn } from "../support/written";

const file = (name: string) => readFileSync(join(__dirname, "../fixtures", name), "utf8");

describe("a report of the C++ program", () => {
  it("gives places and fields to half a step of rounding", async () => {
    const [run] = (await reportIn(file("small_report.html"))).runs;
    expect(run!.meta.name).toBe("small");
    const { compared, worst } = await misfit(run!, csv(file("small_history.csv")));
    expect(compared).toBe(21); // 3 points, 7 times
    expect(Object.keys(worst).sort()).toEqual(["eps_deviatoric", "eps_eq_p", "pressure", "su", "x", "y"]);
    for (const [name, steps] of Object.entries(worst)) expect(steps, name).toBeLessThan(0.51);
  });

  it("gives histories as they are in history.csv", async () => {
    const [run] = (await reportIn(file("small_report.html"))).runs;
    const rows = csv(file("small_history.csv")).filter((row) => row.point === "C");
    const { table } = run!.histories.find((history) => history.name === "C")!;
    rows.forEach((row, k) => {
      expect(table.column("x")![k]).toBeCloseTo(Number(row.x), 5);
      expect(table.column("su")![k]).toBeCloseTo(1e-3 * Number(row.su), 5);
    });
    expect(table.unit("su")).toBe("kPa");
  });

  it("has an outline, a mesh and a surface per frame", async () => {
    const [run] = (await reportIn(file("small_report.html"))).runs;
    expect([...run!.outline.filter((v) => Number.isFinite(v))].sort((a, b) => a - b)).toEqual(expect.arrayContaining([0, 2]));
    expect(run!.edges.length / 4).toBe(run!.meta.mesh!.edges.count);
    for (let f = 0; f < run!.frames; f++) expect(run!.surface(f).length).toBeGreaterThan(0);
    expect(run!.surface(0).filter((_, k) => k % 2 === 1).every((y) =>
      Math.abs(y - (1.875 + run!.meta.point_size / 2)) < run!.meta.position_precision)).toBe(true); // highest row of points
  });
});
