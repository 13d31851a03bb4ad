"""A first look at a run with numpy: what moved, how the soil softened, where its strength fell. Read, change, run it.

    PYTHONPATH=python python3 python/examples/first_look.py RUN FOLDER

Prints numbers and leaves three pictures in FOLDER. docs/python.md explains the calls.
"""

import sys
from pathlib import Path

import numpy as np

import terp
from terp import plot

run = terp.open(sys.argv[1])
pictures = Path(sys.argv[2])
pictures.mkdir(parents=True, exist_ok=True)

# 1. What is there. A run that is still going shows its whole frames; run.refresh() looks again.
print(run.case.get("title", run.folder))
print(f"{len(run)} frames to t = {run.times[-1]:g} s, {len(run.frame(0).x)} material points, finished: {run.finished}")
for name in run.fields:
    print(f"  {name:<16} {run.unit(name):<6} {' '.join(run.components[name])}")

# 2. One frame. Arrays are read when they are asked for; a row is the same material point in every frame. `soil` leaves
# out points of bodies that a stage has not placed yet or has removed, and those that left the mesh.
last = run.frame(-1)
travel = np.linalg.norm(last["displacement"][last.soil], axis=1)  # [m]
print(f"{np.mean(travel > 0.1):.0%} of the points moved farther than 0.1 m, the farthest {travel.max():.2f} m")

# 3. Over all frames: the share of the points that have lost more than half their strength.
if "su" in run.fields:
    peak = run.frame(0)["su"]
    for frame in run:
        share = np.mean((frame["su"] < 0.5 * peak)[frame.soil])
        print(f"  t = {frame.time:5.2f} s: {share:6.1%} have lost more than half of S_u")

# 4. One point: the one nearest to a place, followed through all frames.
x_middle, y_middle = np.median(run.frame(0).x[run.frame(0).soil], axis=0)
row = run.nearest(x_middle, y_middle, time=0.0)
path = run.series("position", row)  # [n_frames, 2]
print(f"the point nearest to ({x_middle:.2f}, {y_middle:.2f}) m is row {row}; "
      f"it ends at ({path[-1, 0]:.2f}, {path[-1, 1]:.2f}) m")

# 5. What the solver has judged already is in the ledger and the summary: front, crest, energies.
print(f"front at {run.ledger['front_x'][-1]:.2f} m, second failure: {run.summary['second_failure_time']} s")

# 6. Pictures. Each call draws into axes of matplotlib (its own, or those given as `panel`) and returns them.
shown = "eps_eq_p" if "eps_eq_p" in run.fields else "displacement"
plot.field(run, shown).figure.savefig(pictures / "field.png", dpi=150)
plot.ledger(run, ["kinetic", "plastic", "gravity_work"]).figure.savefig(pictures / "energies.png", dpi=150)
if run.history_points:
    plot.history(run, "eps_deviatoric").figure.savefig(pictures / "points.png", dpi=150)
