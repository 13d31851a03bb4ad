"""The hard properties of the paper's model 2, that no change of mesh or frame may break.

hard_properties.py TERP CASE [--set KEY=VALUE ...] [--free]

Runs the case with MPM-Mixed and MPM-GP and prints each property. --free leaves out what depends on the mesh (which
points soften by when, the window of the second failure), because softening is not regularised.
"""

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from named_points import regained, softening_time
from terp.run import Run


def run(terp, case, settings, folder):
    command = [terp, "run", case, "-o", folder, "-q"]
    for setting in settings:
        command += ["--set", setting]
    subprocess.run(command, check=True)
    return Run(folder)


def softened(model_run, time):
    """Share of the volume that lost half of what softening takes, at the output time nearest to `time`."""
    return min(model_run.summary["softened_fraction"], key=lambda row: abs(row["time"] - time))["fraction"]


def properties(mixed, gp):
    """What holds on any mesh: (words, value, holds)."""
    s_mixed, s_gp = mixed.summary, gp.summary
    for time in (1.0, 2.5, 4.0):
        a, b = softened(mixed, time), softened(gp, time)
        yield f"softened volume at {time:g} s, Mixed and GP", f"{a:.3f} {b:.3f}", a > b
    ratio = s_gp["max_eps_eq_p"] / s_mixed["max_eps_eq_p"]
    yield "largest eps_eq_p, GP over Mixed", f"{ratio:.2f}", ratio >= 1.15
    yield "points of GP whose eps_eq_p fell", s_gp["points_eps_eq_p_fell"], s_gp["points_eps_eq_p_fell"] == 0
    yield "points of GP whose S_u rose", s_gp["points_su_rose"], s_gp["points_su_rose"] == 0
    yield "of A-J, regained S_u in Mixed", " ".join(regained(mixed)), len(regained(mixed)) >= 2
    for name, one in (("Mixed", mixed), ("GP", gp)):
        yield f"points put back at a wall, {name}", one.summary["clamped_points"], one.summary["clamped_points"] == 0
        second = one.summary["second_failure_time"]
        yield f"second failure in {name}", second, second is not None


def grid_bound(mixed, gp):
    """What holds on the paper's mesh: (words, value, holds)."""
    for name, one in (("Mixed", mixed), ("GP", gp)):
        for point in "ACDE":
            t = softening_time(one, point)
            yield f"{point} softens in {name} [s]", t, t is not None and t < 0.3
        second = one.summary["second_failure_time"]
        yield f"second failure in {name} [s]", second, second is not None and 2.0 < second < 3.2
        strain = largest_strain_left_of(one, 3.5)
        yield f"largest eps_eq_p at x < 3.5 m in {name}", f"{strain:.1e}", strain < 1e-6
        t = softening_time(one, "I")
        yield f"I softens in {name} [s]", t, t is not None
    b_mixed, b_gp = softening_time(mixed, "B"), softening_time(gp, "B")
    yield "B softens in Mixed and GP [s]", f"{b_mixed} {b_gp}", b_mixed < 1.2 and (b_gp is None or b_gp > 0.4)
    yield "H softens in Mixed and GP [s]", f"{softening_time(mixed, 'H')} {softening_time(gp, 'H')}", \
        softening_time(mixed, "H") is not None and softening_time(gp, "H") is None


def largest_strain_left_of(one, x):
    frame = one.frame(len(one.times) - 1)
    x_initial = frame.x[:, 0] - frame["displacement"][:, 0]
    return float(np.max(frame["eps_eq_p"][x_initial < x], initial=0.0))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("terp", type=Path)
    parser.add_argument("case", type=Path)
    parser.add_argument("--set", action="append", default=[], dest="settings")
    parser.add_argument("--free", action="store_true", help="without what is bound to the grid")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        mixed = run(options.terp, options.case, options.settings + ["scheme=mpm_mixed"], folder + "/mixed")
        gp = run(options.terp, options.case, options.settings + ["scheme=mpm_gp"], folder + "/gp")
        rows = list(properties(mixed, gp)) + ([] if options.free else list(grid_bound(mixed, gp)))
    for words, value, holds in rows:
        print(f"{'   ok' if holds else 'WRONG'}  {words}: {value}")
    fronts = ", ".join(f"{name} front {one.summary['front_x']:.2f} crest {one.summary['crest_x']:.2f} second failure "
                       f"{one.summary['second_failure_time']}" for name, one in (("Mixed", mixed), ("GP", gp)))
    print(fronts)
    sys.exit(0 if all(holds for _, _, holds in rows) else 1)


if __name__ == "__main__":
    main()
