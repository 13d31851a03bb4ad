// node run_in_node.mjs TERP.js FOLDER -- WORDS...: the program of the page (make browser) in Node.js, as its worker calls it. The
// files of FOLDER are what it sees; what it leaves there comes back. Exit status: that of the program.
import { createRequire } from "node:module";
import fs from "node:fs";
import path from "node:path";

const [script, folder, , ...words] = process.argv.slice(2);
const GOES_ON = -1;
const terp = await createRequire(import.meta.url)(path.resolve(script))({
  print: (text) => text.startsWith("\x1e") || console.log(text), printErr: (text) => console.error(text) });
const { FS } = terp;

function put(from, to) {
  for (const entry of fs.readdirSync(from, { withFileTypes: true })) {
    const [here, there] = [path.join(from, entry.name), `${to}/${entry.name}`];
    if (entry.isDirectory()) {
      FS.mkdir(there);
      put(here, there);
    } else FS.writeFile(there, fs.readFileSync(here));
  }
}

function take(from, to) {
  fs.mkdirSync(to, { recursive: true });
  for (const name of FS.readdir(from).filter((n) => n !== "." && n !== "..")) {
    const [there, here] = [`${from}/${name}`, path.join(to, name)];
    if (FS.isDir(FS.stat(there).mode)) take(there, here);
    else fs.writeFileSync(here, FS.readFile(there));
  }
}

FS.mkdir("/terp");
if (process.env.REPORT_PAGE) FS.writeFile("/terp/page.html", fs.readFileSync(process.env.REPORT_PAGE));
FS.mkdir("/job");
put(folder, "/job");
FS.chdir("/job");
let status = terp.callMain(words);
const part = Number(process.env.PART_S ?? Infinity); // of the run [s]; infinite: in one go
while (status === GOES_ON) status = terp._terp_go_on(terp._terp_time() + part);
take("/job", folder);
process.exitCode = status;
