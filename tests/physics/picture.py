#!/usr/bin/python3
"""Draws docs/images/sound_physics.png: level clay, still water and a sand dike, as before the options and now."""
import argparse
import random
import tempfile
from pathlib import Path

import matplotlib
import numpy as np

from rows_ground import GRAVITY, WALLS, clay
from rows_sand import sand
from runs import TODAY, Variant

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # after the choice of what draws

K0 = {"stress": "k0", "k0": 1.0}
BANK = [[0, 0], [46, 0], [46, 4.7], [35.5, 4.7], [25.5, 8.7], [21.5, 8.7], [9.5, 4.7], [0, 4.7]]


def cases(v):
    """(title, case) of each row of the picture."""
    def case(end, soil, outline, mesh, **more):
        return {"time": {"end": end}, "mesh": mesh, "body": [{"material": "soil", "polygon": outline,
                "points_per_cell": 4}], "material": {"soil": soil}, "initial": K0, "forces": GRAVITY,
                "boundary": WALLS} | more

    water = {"model": "newtonian_fluid", "density": 1000.0, "bulk_modulus": 2e6, "viscosity": 0.001}
    basin = v.mesh(4.0, 2.0, 0.25, place=lambda x, y: (x * (1 + 0.375 * y), y))
    yield "Level clay, $S_u$ 0.5 kPa, after 4.5 s", case(
        4.5, clay(500.0), [[0, 0], [20, 0], [20, 7.5], [0, 7.5]], v.mesh(20.0, 9.0, 1.0))
    yield "Still water before a bank, after 2 s", case(
        2.0, water, [[0, 0], [4, 0], [6.25, 1.5], [0, 1.5]], basin, boundary=dict.fromkeys(WALLS, "roller"))
    yield "Sand dike 1:3 and 1:2.5, phi 30, after 4 s", case(
        4.0, sand(30.0), BANK, {"size": [46, 12], "cell": 0.5}, initial=K0 | {"k0": 0.5})


def main():
    root = Path(__file__).parents[2]
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--terp", default=root / "build/terp", help="the program")
    parser.add_argument("-o", default=root / "docs/images/sound_physics.png", help="the picture")
    options = parser.parse_args()
    figure, axes = plt.subplots(3, 2, figsize=(13, 8.2), constrained_layout=True)
    with tempfile.TemporaryDirectory() as folder:
        v = Variant(options.terp, Path(folder), random.Random(3), [],
                    {"scheme": "gp", "shares": "by_law", "kind": "quads"})
        for row, (title, case) in zip(axes, cases(v)):
            runs = [v.run(case | {"method": method}, name, fields=("velocity",))
                    for name, method in (("before", TODAY | {"flip": 1.0}), ("now", {}))]
            ways = [np.hypot(*(last[c] - first[c] for c in "xy")) for first, last in (run.points() for run in runs)]
            for axis, run, way in zip(row, runs, ways):
                last = run.points()[1]
                dots = axis.scatter(last["x"], last["y"], c=way, s=2.5, vmin=0, vmax=max(map(np.max, ways)))
                axis.set_aspect("equal")
                axis.set_title(f"{title}\n{run.folder.name}: moved by up to {way.max():.2g} m, "
                               f"{run.largest('kinetic'):.2g} J of motion", fontsize=10)
            figure.colorbar(dots, ax=row, label="moved [m]", shrink=0.85)
    figure.savefig(options.o, dpi=75)


if __name__ == "__main__":
    main()
