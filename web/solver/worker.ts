// What runs in the worker: the program of Terp, once per worker, on files of its own. The function is handed over as a
// text, so nothing of this module may be used in it but types.

export interface Call {
  words: string[];
  always?: boolean; // also after a call that failed
}

export interface Job {
  module: WebAssembly.Module;
  template: Uint8Array; // of the report page
  files: [path: string, bytes: Uint8Array<ArrayBuffer>][];
  calls: Call[];
}

export interface ProgressNow {
  time: number;
  end_time: number;
  step: number;
  n_steps: number;
  n_points: number;
  searches: boolean; // for equilibrium
  eta_s: number; // of the search
  at_most: boolean;
  stage: string;
}

export type FromWorker =
  { kind: "line"; text: string; error: boolean } | { kind: "progress"; now: ProgressNow } | { kind: "fault"; text: string } |
  { kind: "heard" } | // the wish to stop
  { kind: "end"; statuses: number[]; files: [string, Uint8Array<ArrayBuffer>][] };

interface FileSystem {
  mkdir(path: string): void;
  chdir(path: string): void;
  writeFile(path: string, data: Uint8Array): void;
  readFile(path: string): Uint8Array<ArrayBuffer>;
  readdir(path: string): string[];
  stat(path: string): { mode: number };
  isDir(mode: number): boolean;
  analyzePath(path: string): { exists: boolean };
}

interface Program {
  FS: FileSystem;
  callMain(words: string[]): number;
  _terp_go_on(until: number): number;
  _terp_time(): number;
  _terp_stop(): void;
}

export type MakeProgram = (options: object) => Promise<Program>;

export function workInWorker(makeProgram: MakeProgram): void {
  const GOES_ON = -1;
  const PART_MS = 200; // between two looks at what the page asks
  let stops = false;
  const tell = (message: FromWorker, hand_over: Transferable[] = []) =>
    (self as unknown as { postMessage(m: unknown, t: Transferable[]): void }).postMessage(message, hand_over);

  const channel = new MessageChannel();
  const breath = () => new Promise<void>((go) => {
    channel.port1.onmessage = () => go();
    channel.port2.postMessage(0);
  });

  async function goOn(program: Program): Promise<number> {
    for (let part = 1e-6; ;) {
      await breath();
      if (stops) {
        tell({ kind: "heard" });
        program._terp_stop();
      }
      const [begin, clock] = [program._terp_time(), performance.now()];
      const status = program._terp_go_on(begin + part);
      if (status !== GOES_ON) return status;
      const made = program._terp_time() - begin;
      if (made > 0) part = made * Math.min(8, PART_MS / Math.max(1, performance.now() - clock));
    }
  }

  function filesBelow(fs: FileSystem, folder: string, path: string): [string, Uint8Array<ArrayBuffer>][] {
    return fs.readdir(folder).filter((name) => name !== "." && name !== "..").flatMap((name) => {
      const there = `${folder}/${name}`;
      return fs.isDir(fs.stat(there).mode) ? filesBelow(fs, there, `${path}${name}/`)
        : [[path + name, fs.readFile(there)] as [string, Uint8Array<ArrayBuffer>]];
    });
  }

  async function work({ module, template, files, calls }: Job): Promise<void> {
    const line = (text: string, error: boolean) => {
      if (text.startsWith("\x1e")) tell({ kind: "progress", now: JSON.parse(text.slice(1)) });
      else tell({ kind: "line", text, error });
    };
    const program = await makeProgram({
      print: (text: string) => line(text, false),
      printErr: (text: string) => line(text, true),
      instantiateWasm: (imports: WebAssembly.Imports, done: (made: WebAssembly.Instance) => void) => {
        void WebAssembly.instantiate(module, imports).then(done);
        return {};
      },
    });
    const fs = program.FS;
    fs.mkdir("/terp");
    fs.writeFile("/terp/page.html", template);
    fs.mkdir("/job");
    fs.chdir("/job");
    for (const [path, bytes] of files) {
      path.split("/").slice(0, -1).reduce((folder, name) => {
        if (!fs.analyzePath(folder + name).exists) fs.mkdir(folder + name);
        return `${folder}${name}/`;
      }, "/job/");
      fs.writeFile(`/job/${path}`, bytes);
    }
    const statuses: number[] = [];
    for (const { words, always } of calls) {
      if (!always && statuses.some((status) => status !== 0)) continue;
      const status = program.callMain(words);
      statuses.push(status === GOES_ON ? await goOn(program) : status);
    }
    const made = filesBelow(fs, "/job", "");
    tell({ kind: "end", statuses, files: made }, made.map(([, bytes]) => bytes.buffer));
  }

  self.onmessage = ({ data }: MessageEvent<Job | "stop">) => {
    if (data === "stop") stops = true;
    else work(data).catch((error: unknown) => tell({ kind: "fault", text: String(error) }));
  };
}
