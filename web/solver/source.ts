// From the files that a user gives to what can be looked at: a section to import, or a case with its tables.

import { say } from "./texts";
import { readZip, ZipError, type Bytes, type Files } from "./zip";

export interface Source {
  name: string; // as the user knows it
  kind: "section" | "case";
  path: string; // of the section or case in `files`
  files: Files;
  checked_run: boolean; // it has a run with a checkpoint, which can go on
}

/** Says what is wrong, in the language of the page. */
export class Refusal extends Error {}

const MOST_BYTES = 200e6;
const SECTIONS = /\.(stix|dxf)$/i;

const extension = (name: string) => name.slice(name.lastIndexOf(".") + 1).toLowerCase();

async function bytesOf(file: File): Promise<Bytes> {
  if (file.size > MOST_BYTES) throw new Refusal(say("bad_size", { name: file.name, size: `${Math.round(file.size / 1e6)} MB` }));
  try {
    return new Uint8Array(await file.arrayBuffer());
  } catch {
    throw new Refusal(say("bad_folder"));
  }
}

async function unpack(name: string, bytes: Bytes): Promise<Files> {
  try {
    return await readZip(bytes);
  } catch (error) {
    throw new Refusal(say(error instanceof ZipError && error.message === "large" ? "bad_zip_large" : "bad_zip", { name }));
  }
}

/** The case of the first run that a report shows. */
function caseInReport(name: string, bytes: Bytes): Files {
  const found = /<script id="terp-report" type="application\/json">([\s\S]*?)<\/script>/.exec(new TextDecoder().decode(bytes));
  try {
    const text = (JSON.parse(found?.[1] ?? "") as { runs: { case_toml: string }[] }).runs[0]!.case_toml;
    return new Map([["case.toml", new TextEncoder().encode(text)]]);
  } catch {
    throw new Refusal(say("bad_report", { name }));
  }
}

/** A case that lies beside its tables comes into a folder of its own, as an import has it. */
function caseIn(name: string, path: string, files: Files): Source {
  const folder = path.includes("/") ? path.slice(0, path.lastIndexOf("/") + 1) : "";
  const moved: Files = new Map();
  for (const [file, bytes] of files) moved.set(folder === "" ? `case/${file}` : file, bytes);
  const checked_run = [...files.keys()].some((file) => /^run\/.*checkpoint.*\.h5$/.test(file));
  return { name, kind: "case", path: folder === "" ? `case/${path}` : path, files: moved, checked_run };
}

function chooseCase(name: string, files: Files): Source {
  const cases = [...files.keys()].filter((path) => extension(path) === "toml" && !/^(run|stability)\/|(^|\/)imported\.toml$/.test(path));
  if (cases.length > 1) throw new Refusal(say("bad_several", { names: cases.join(", ") }));
  if (cases.length === 1) return caseIn(name, cases[0]!, files);
  const sections = [...files.keys()].filter((path) => SECTIONS.test(path));
  const only = files.size === 1 ? [...files.keys()][0]! : "";
  const path = sections.length === 1 ? sections[0]! : /\.csv$/i.test(only) ? only : "";
  if (path === "") throw new Refusal(say("bad_kind", { name }));
  return { name, kind: "section", path, files, checked_run: false };
}

/** Throws Refusal. */
export async function readFiles(list: readonly File[]): Promise<Source> {
  const files: Files = new Map();
  for (const file of list) files.set(file.name, await bytesOf(file));
  const [first] = list;
  if (!first) throw new Refusal(say("bad_folder"));
  if (list.length > 1) return chooseCase(list.map(({ name }) => name).join(", "), files);
  const bytes = files.get(first.name)!;
  if (extension(first.name) === "zip") return chooseCase(first.name, await unpack(first.name, bytes));
  if (/^html?$/.test(extension(first.name))) return caseIn(first.name, "case.toml", caseInReport(first.name, bytes));
  return chooseCase(first.name, files);
}
