// One time for all runs. Runs may have frames at other times: each shows the frame nearest to the time.

/** Index of the time nearest to t; the earlier of two equally near. `times` ascends. */
export function frameAt(times: readonly number[], t: number): number {
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle]! <= t) low = middle;
    else high = middle - 1;
  }
  const next = low + 1;
  return next < times.length && times[next]! - t < t - times[low]! ? next : low;
}

/** All times at which any run has a frame, ascending, each once. */
export function allTimes(runs: readonly (readonly number[])[]): number[] {
  const sorted = runs.flatMap((times) => [...times]).sort((a, b) => a - b);
  const span = (sorted[sorted.length - 1] ?? 0) - (sorted[0] ?? 0);
  return sorted.filter((t, k) => k === 0 || t - sorted[k - 1]! > 1e-4 * (span / sorted.length));
}

/** The time `steps` frames on from t, not beyond the ends. */
export function stepTime(times: readonly number[], t: number, steps: number): number {
  const k = Math.min(times.length - 1, Math.max(0, frameAt(times, t) + steps));
  return times[k] ?? 0;
}

/** Speeds to offer, in seconds of the run per second of the viewer, and the one with which a run takes about 10 s. */
export function speeds(duration: number): { all: number[]; start: number } {
  const all = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];
  const wanted = duration / 10;
  let best = 0;
  all.forEach((speed, k) => {
    if (Math.abs(Math.log(speed / wanted)) < Math.abs(Math.log(all[best]! / wanted))) best = k;
  });
  return { all: all.slice(Math.max(0, best - 3), best + 4), start: all[best]! };
}

/** Time after `elapsed` seconds of the viewer; at the end it stops, or begins again if `again`. */
export function advance(t: number, elapsed: number, speed: number, span: [number, number],
  again: boolean): { time: number; ended: boolean } {
  const next = t + elapsed * speed;
  if (next < span[1]) return { time: next, ended: false };
  return again ? { time: span[0], ended: false } : { time: span[1], ended: true };
}
