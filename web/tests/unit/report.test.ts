import { describe, expect, it } from "vitest";
import { Report } from "../../src/data/report";
import { nearestPoint } from "../../src/logic/nearest";
import { sameBody } from "../../src/logic/same_body";
import { exampleReport } from "../support/example";

async function opened(): Promise<Report> {
  const { report, chunks } = exampleReport(20);
  const made = new Report(report, (k) => chunks[k] ?? null);
  await made.open();
  return made;
}

describe("a report", () => {
  it("gives places to their precision", async () => {
    const [run] = (await opened()).runs;
    const [x, y] = run!.place(0, 21); // second point of the second row, spacing 0.2 m, base at 1 m
    expect(x).toBeCloseTo(0.3, 3);
    expect(y).toBeCloseTo(1.3, 3);
  });

  it("knows the point that left, and does not find it under the pointer", async () => {
    const [run] = (await opened()).runs;
    expect(run!.present(0, 399)).toBe(true);
    expect(run!.present(60, 399)).toBe(false);
    expect(nearestPoint(run!, 60, ...run!.place(60, 399), 0.01)).toBe(-1);
  });

  it("finds the nearest point within reach, and none beyond", async () => {
    const [run] = (await opened()).runs;
    expect(nearestPoint(run!, 0, 0.32, 1.28, 0.2)).toBe(21);
    expect(nearestPoint(run!, 0, 7, 7, 0.2)).toBe(-1);
  });

  it("decodes a field once, and fields of one chunk from the same text", async () => {
    const { report, chunks } = exampleReport(10);
    const meta = report.runs[0]!.fields[0]!;
    report.runs[0]!.fields.push({ ...meta, name: "twin", data: { ...meta.data, lo: 0, hi: 65535 } });
    const asked: number[] = [];
    const made = new Report(report, (k) => (asked.push(k), chunks[k]!));
    await made.open();
    const run = made.runs[0]!;
    const [a, b, twin] = await Promise.all([run.field(meta.name), run.field(meta.name), run.field("twin")]);
    expect(a).toBe(b);
    expect(asked.filter((k) => k === meta.data.chunk)).toHaveLength(1);
    expect(twin!.value(3, 5)).toBe(a!.frame(3)[5]);
    expect(await run.field("nothing")).toBeNull();
  });

  it("tells runs of the same body from others", async () => {
    const [a, b] = (await opened()).runs;
    expect(sameBody(a!, b!)).toBe(true);
    const { report, chunks } = exampleReport(21);
    const other = new Report(report, (k) => chunks[k]!);
    await other.open();
    expect(sameBody(a!, other.runs[0]!)).toBe(false);
  });

  it("finds points by id", async () => {
    const [run] = (await opened()).runs;
    expect(run!.pointOfId(0)).toBe(0);
    expect(run!.pointOfId(399)).toBe(399);
    expect(run!.pointOfId(400)).toBe(-1);
  });

  it("of another format is refused", () => {
    const { report } = exampleReport(10);
    expect(() => new Report({ ...report, format: 1 }, () => null)).toThrow("reads reports of format 2, but the data in it has format 1");
  });

  it("that was cut short says which part is missing", async () => {
    const { report, chunks } = exampleReport(10);
    const made = new Report(report, (k) => (k > 2 ? null : chunks[k]!));
    await expect(made.open()).rejects.toThrow("the file was cut short");
  });

  it("may leave out what a writer does not know", async () => {
    const { report, chunks } = exampleReport(10);
    for (const key of ["events", "layers", "loads", "passes", "warnings"] as const) delete (report.runs[0] as Partial<(typeof report.runs)[0]>)[key];
    const made = new Report(report, (k) => chunks[k]!);
    await made.open();
    expect(made.runs[0]!.layers).toEqual([]);
  });

  it("has tables by column", async () => {
    const [run] = (await opened()).runs;
    expect(run!.series!.column("time")![60]).toBe(3);
    expect(run!.series!.column("nothing")).toBeNull();
    expect(run!.series!.unit("kinetic")).toBe("J/m");
  });
});
