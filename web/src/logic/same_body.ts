// Whether a point of one run is a point of another.

import type { Run } from "../data/run";

/** True if ids mean the same points in both runs: as many points, seeded at the same places. */
export function sameBody(a: Run, b: Run): boolean {
  if (a.meta.n_points !== b.meta.n_points) return false;
  const near = 4 * Math.max(a.meta.position_precision, b.meta.position_precision);
  for (const part of [0, 0.37, 0.71, 0.99]) {
    const p = Math.floor(part * (a.points - 1));
    const other = b.pointOfId(a.ids[p]!);
    if (other < 0) continue;
    const [[ax, ay], [bx, by]] = [a.place(0, p), b.place(0, other)];
    if (Math.abs(ax - bx) > near || Math.abs(ay - by) > near) return false;
  }
  return true;
}
