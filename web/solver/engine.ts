// The program of Terp as the page calls it: each job has a worker of its own, which ends with it. So a fault or a lack
// of memory ends that worker alone, and what a job did not change is as it was.

import { workInWorker, type Call, type FromWorker, type ProgressNow } from "./worker";
import type { Bytes, Files } from "./zip";

export interface Program {
  module: WebAssembly.Module;
  glue: string; // what emscripten wrote: `Terp(options)` makes the program
  template: Bytes;
}

export interface Outcome {
  statuses: number[]; // of the calls that were made; empty: it was ended, or ended by a fault
  files: Files; // all that are there afterwards
  out: string;
  errors: string;
  fault: string; // of the program itself; empty: none
  ended: boolean; // it gave no answer to `stop`
}

export interface Watch {
  line?: (text: string, error: boolean) => void;
  progress?: (now: ProgressNow) => void;
}

const PATIENCE_MS = 2500; // a search cannot be cut into parts

export class Work {
  readonly outcome: Promise<Outcome>;
  private readonly worker: Worker;
  private patience: ReturnType<typeof setTimeout> | undefined;
  private end: (outcome: Partial<Outcome>) => void = () => undefined;

  constructor(program: Program, files: Files, calls: Call[], watch: Watch = {}) {
    const text = `${program.glue}\n(${workInWorker.toString()})(Terp);`;
    const address = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
    this.worker = new Worker(address);
    const lines = { out: "", errors: "" };
    this.outcome = new Promise((resolve) => {
      this.end = (outcome) => {
        this.worker.terminate();
        URL.revokeObjectURL(address);
        resolve({ statuses: [], files: new Map(files), fault: "", ended: false, ...lines, ...outcome });
      };
    });
    this.worker.onmessage = ({ data }: MessageEvent<FromWorker>) => {
      if (data.kind === "line") {
        lines[data.error ? "errors" : "out"] += `${data.text}\n`;
        watch.line?.(data.text, data.error);
      } else if (data.kind === "progress") watch.progress?.(data.now);
      else if (data.kind === "heard") clearTimeout(this.patience);
      else if (data.kind === "fault") this.end({ fault: data.text });
      else this.end({ statuses: data.statuses, files: new Map(data.files) });
    };
    this.worker.onerror = (event) => {
      event.preventDefault();
      this.end({ fault: event.message || "the worker did not start" });
    };
    this.worker.postMessage({ module: program.module, template: program.template, files: [...files], calls });
  }

  /** Asks a run to end with a checkpoint; ends the worker where it gives no answer. */
  stop(): void {
    this.worker.postMessage("stop");
    this.patience = setTimeout(() => this.end({ ended: true }), PATIENCE_MS);
  }
}
