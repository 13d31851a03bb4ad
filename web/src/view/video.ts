// The animation as a video, recorded by the browser itself (MediaRecorder), in real time at the chosen speed.

import type { Figure } from "./figure";

const TYPES = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"];
const RATE = 30; // pictures per second

/** The kind of video that this browser records; null if it records none. */
export function videoType(): string | null {
  if (typeof MediaRecorder === "undefined" || !("captureStream" in HTMLCanvasElement.prototype)) return null;
  return TYPES.find((type) => MediaRecorder.isTypeSupported(type)) ?? null;
}

export function videoEnding(type: string): string {
  return type.startsWith("video/mp4") ? "mp4" : "webm";
}

export interface Recording {
  done: Promise<Blob | null>; // null: cancelled
  cancel: () => void;
}

/** Records from span[0] to span[1] with `speed` seconds of the run per second; `progress` gets 0...1. */
export function record(figure: Figure, type: string, span: [number, number], speed: number,
  progress: (part: number) => void): Recording {
  const canvas = document.createElement("canvas");
  const { width } = figure.size();
  const ratio = Math.min(2, 1920 / width);
  figure.draw(canvas, span[0], ratio);
  const recorder = new MediaRecorder(canvas.captureStream(RATE), { mimeType: type, videoBitsPerSecond: 8e6 });
  const parts: Blob[] = [];
  let cancelled = false;
  recorder.ondataavailable = (event) => parts.push(event.data);
  const done = new Promise<Blob | null>((resolve, reject) => {
    recorder.onstop = () => {
      const blob = new Blob(parts, { type: type.split(";")[0]! });
      if (cancelled) resolve(null);
      else if (blob.size === 0)
        reject(new Error("The browser recorded nothing: it seems to lack the encoder that it names."));
      else resolve(blob);
    };
    recorder.onerror = () => reject(new Error("The browser stopped recording."));
  });
  const length = (span[1] - span[0]) / speed + 1; // the last picture stays for a second
  recorder.start(500);
  const begun = performance.now();
  const next = () => {
    if (recorder.state === "inactive") return;
    const elapsed = (performance.now() - begun) / 1000;
    figure.draw(canvas, Math.min(span[1], span[0] + elapsed * speed), ratio);
    progress(Math.min(1, elapsed / length));
    if (cancelled || elapsed >= length) recorder.stop();
    else setTimeout(next, 1000 / RATE);
  };
  setTimeout(next, 1000 / RATE);
  return { done, cancel: () => (cancelled = true) };
}
