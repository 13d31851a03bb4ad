// Which material point is under the pointer.

import type { Run } from "../data/run";
import { FULL } from "../data/quantised";

/** Point of that frame nearest to (x, y), not farther than `reach` [m]; -1 if there is none. */
export function nearestPoint(run: Run, frame: number, x: number, y: number, reach: number): number {
  const [mx, my] = [run.x.meta, run.y.meta];
  const [sx, sy] = [(mx.hi - mx.lo) / FULL, (my.hi - my.lo) / FULL];
  const [qx, qy] = [run.x.frame(frame), run.y.frame(frame)];
  let best = -1;
  let least = reach * reach;
  for (let p = 0; p < qx.length; p++) {
    const dx = mx.lo + sx * qx[p]! - x;
    if (dx > reach || dx < -reach) continue;
    if (qx[p] === FULL && qy[p] === FULL) continue;
    const dy = my.lo + sy * qy[p]! - y;
    const distance = dx * dx + dy * dy;
    if (distance <= least) [least, best] = [distance, p];
  }
  return best;
}
