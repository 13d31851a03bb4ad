// Which page a document is.

import { Chunks, type ChunkText } from "../data/chunks";
import { readTables, type ConvergenceMeta, type DocumentMeta, type ElementMeta, type ReachMeta,
  type StudyMeta } from "../data/documents";
import { FORMAT } from "../data/report";
import { convergencePage } from "./convergence";
import { buildDocument } from "./document";
import { elementPage } from "./element";
import { reachPage } from "./reach";
import { studyPage } from "./study";

export async function openDocument(meta: DocumentMeta, text: ChunkText, page: HTMLElement): Promise<void> {
  if (meta.format !== FORMAT)
    throw new Error(`This page reads format ${FORMAT}, but its data has format ${meta.format}.`);
  const tables = await readTables(meta.data, new Chunks(text));
  buildDocument(meta, page, (store) => {
    if (meta.kind === "convergence") return convergencePage(meta.data as ConvergenceMeta, tables, store);
    if (meta.kind === "element") return elementPage(meta.data as ElementMeta, tables, store);
    if (meta.kind === "reach") return reachPage(meta.data as ReachMeta, store);
    if (meta.kind === "study") return studyPage(meta.data as StudyMeta, tables, store);
    throw new Error(`This page knows no "${meta.kind}". Write it anew with one version of Terp.`);
  });
}
