// The page with the solver, without a browser: its words, zip files, and what the dropped files are taken for.

import { readdirSync, readFileSync } from "node:fs";
import { resolve } from "node:path";
import { afterEach, describe, expect, it } from "vitest";
import { check, NO_CHOICES, run, stability } from "../../solver/job";
import { readFiles } from "../../solver/source";
import { bytes, chooseLanguage, currentLanguage, duration, say, TEXTS, type TextKey } from "../../solver/texts";
import { readZip, writeZip, type Files } from "../../solver/zip";

const SOURCE = resolve(__dirname, "../../solver");
const file = (name: string, content: string | Uint8Array<ArrayBuffer> = "x") => new File([content], name);
const written = async (files: Files) => new Uint8Array(await writeZip(files).arrayBuffer());
const encode = (text: string) => new TextEncoder().encode(text);

afterEach(() => chooseLanguage(["en"]));

describe("the words", () => {
  it("are in both languages, with the same values, and used", () => {
    const code = readdirSync(SOURCE).filter((name) => name.endsWith(".ts") && name !== "texts.ts")
      .map((name) => readFileSync(resolve(SOURCE, name), "utf8")).join("\n") + readFileSync(resolve(SOURCE, "texts.ts"), "utf8").split("TextKey")[2]!;
    const values = (text: string) => [...new Set([...text.matchAll(/\{(\w+)\}/g)].map((match) => match[1]!))].sort();
    const made = [...code.matchAll(/`(\w+_)\$\{/g)].map((match) => match[1]!);
    for (const [key, [english, dutch]] of Object.entries(TEXTS)) {
      expect(values(dutch), key).toEqual(values(english));
      if (key !== "findings_language") expect([english, dutch].every((text) => /\S/.test(text)), key).toBe(true);
      expect(code.includes(`"${key}"`) || made.some((start) => key.startsWith(start)), `${key} is used`).toBe(true);
    }
  });

  it("follow the browser, and else are English", () => {
    for (const [codes, language] of [[["nl-NL", "en"], "nl"], [["fr", "nl"], "nl"], [["fr"], "en"], [[], "en"]] as [string[], string][]) {
      chooseLanguage(codes);
      expect(currentLanguage()).toBe(language);
    }
    chooseLanguage(["nl"]);
    expect([duration(0.2), duration(200), duration(9000), bytes(2.5e9), say("run")]).toEqual(["1 s", "3 min", "2,5 uur", "2,5 GB", "Rekenen"]);
  });
});

describe("zip files", () => {
  const files: Files = new Map([["case/case.toml", encode("title = 'dijk à é'")], ["case/é.csv", new Uint8Array(700).fill(7)], ["empty", new Uint8Array(0)]]);

  it("come back as they were written, the same bytes each time", async () => {
    const zip = await written(files);
    expect(await readZip(zip)).toEqual(files);
    expect(await written(files)).toEqual(zip);
  });

  it("that are damaged, cut or none are refused", async () => {
    const zip = await written(files);
    const damaged = zip.slice();
    damaged[200]! ^= 1;
    for (const bad of [damaged, zip.slice(0, zip.length - 30), encode("no zip file at all, but long enough"), new Uint8Array(0)])
      await expect(readZip(bad)).rejects.toThrow("damaged");
  });

  it("that would unpack to more than a page holds are refused before", async () => {
    const zip = await written(new Map([["a", encode("abc")]]));
    const central = zip.length - 22 - 46 - 1;
    new DataView(zip.buffer).setUint32(central + 24, 900e6, true);
    await expect(readZip(zip)).rejects.toThrow("large");
  });

  it("of other programs are read, without files outside of their folder", async () => {
    const zip = await written(new Map([["../outside", encode("a")], ["/root", encode("b")], ["inside", encode("c")]]));
    expect([...(await readZip(zip)).keys()]).toEqual(["inside"]);
  });
});

describe("dropped files", () => {
  it("are a section, or a case with its tables in a folder of its own", async () => {
    expect(await readFiles([file("a dike.STIX")])).toMatchObject({ kind: "section", path: "a dike.STIX" });
    expect(await readFiles([file("ground.csv")])).toMatchObject({ kind: "section", path: "ground.csv" });
    const source = await readFiles([file("loads.csv"), file("dike.toml")]);
    expect([source.kind, source.path, [...source.files.keys()]]).toEqual(["case", "case/dike.toml", ["case/loads.csv", "case/dike.toml"]]);
  });

  it("that were saved here go on", async () => {
    const zip = await written(new Map([["case/case.toml", encode("a")], ["case/imported.toml", encode("a")], ["run/case.toml", encode("a")], ["run/checkpoint_000000012.h5", encode("b")]]));
    expect(await readFiles([file("dike.zip", zip)])).toMatchObject({ kind: "case", path: "case/case.toml", checked_run: true });
  });

  it("that are a report give its case", async () => {
    const html = `<!doctype html><script id="terp-report" type="application/json">{"runs":[{"case_toml":"title = 1"}]}</script>`;
    const source = await readFiles([file("report.html", html)]);
    expect(new TextDecoder().decode(source.files.get("case/case.toml"))).toBe("title = 1");
  });

  it.each([
    ["photo.png", "bad_kind"], ["report.html", "bad_report"], ["case.zip", "bad_zip"],
  ] as [string, TextKey][])("%s is refused in a sentence", async (name, key) => {
    await expect(readFiles([file(name)])).rejects.toThrow(say(key, { name }));
  });

  it("of two cases are refused, with their names", async () => {
    await expect(readFiles([file("a.toml"), file("b.toml")])).rejects.toThrow("a.toml, b.toml");
  });
});

describe("the words of the program", () => {
  const section = { name: "s", kind: "section", path: "s.stix", files: new Map(), checked_run: false } as const;
  const words = (calls: { words: string[] }[]) => calls.map((call) => call.words.join(" "));

  it("have what was chosen, and nothing else", () => {
    expect(words(check(section, { ...NO_CHOICES, scenario: 1, stage: 2, cell: 1.5, trigger: "water" }))).toEqual([
      "import s.stix -o case --force --scenario 1 --stage 2 --cell 1.5 --strength deterministic --trigger water",
      "check case/case.toml --json --picture section.svg"]);
    const of_case = { ...section, kind: "case", path: "case/d.toml" } as const;
    expect(words(check(of_case, { ...NO_CHOICES, cell: 0.5, at_strength: 1.2 })))
      .toEqual(["check case/d.toml --json --picture section.svg --set mesh.cell=0.5 --set at_strength=1.2"]);
    expect(words(run(of_case, NO_CHOICES, "nl"))).toEqual(["run case/d.toml -o run --force",
      "report run -o report.html --language nl", "export run --dxf after.dxf --profile after.csv"]);
    expect(words(stability(of_case, { ...NO_CHOICES, least_depth: 2 }))).toEqual(["stability case/d.toml -o stability --force --least-depth 2"]);
  });
});
