// Reads the data of the page, then builds the page.

import "./style.css";
import "./documents/documents.css";
import type { ReportMeta } from "./data/format";
import { textInPage } from "./data/chunks";
import type { DocumentMeta } from "./data/documents";
import { Report } from "./data/report";
import { openDocument } from "./documents/open";
import { element } from "./shell/element";
import { buildPage } from "./page";
import { languageIn } from "./shell/address";
import { chooseLanguage, currentLanguage } from "./logic/texts";

async function start(): Promise<void> {
  const page = document.getElementById("page")!;
  try {
    const data = document.getElementById("terp-report")?.textContent;
    if (!data)
      throw new Error("This is the empty template of the report page. `terp report RUN` writes one with data.");
    if (typeof DecompressionStream === "undefined")
      throw new Error("This browser is too old to unpack the data: " +
        "Chrome and Edge from 80, Firefox from 113, Safari from 16.4 can.");
    const meta = JSON.parse(data) as ReportMeta & DocumentMeta;
    chooseLanguage(languageIn(location.hash) ?? meta.language);
    document.documentElement.lang = currentLanguage();
    if (meta.kind && meta.kind !== "run") return await openDocument(meta, textInPage, page);
    const report = new Report(meta, textInPage);
    if (report.runs.length === 0) throw new Error("The report holds no run.");
    await report.open();
    buildPage(report, page);
  } catch (error) {
    page.replaceChildren(element("p", { class: "loading", role: "alert" }, (error as Error).message));
  }
}

void start();
