"""A clay slope, solved with 20 strengths in parallel: how much slides, and from which strength on does it stand?

usage: slope_study.py [PICTURE]"""
import concurrent.futures
import os
import sys

import matplotlib.pyplot as plt
import numpy as np
import terp

height, cell = 4.0, 0.5
slope = [[0, 0], [36, 0], [36, 2], [20, 2], [12, 2 + height], [0, 2 + height]]
case = terp.Case({
    "title": "Clay slope 1:2", "scheme": "mpm_gp", "time": {"until": "at_rest", "at_most": 20.0},
    "initial": {"stress": "k0", "k0": 1.0}, "mesh": {"size": [36.0, 7.0], "cell": cell},
    "material": {"clay": {"model": "tresca_softening", "density": 1800, "shear_modulus": 1e6, "poisson_ratio": 0.49,
                          "su_peak": 20e3, "su_residual": 5e3, "eta": 20.0, "softening": {"length": 2 * cell}}},
    "body": [{"name": "slope", "material": "clay", "polygon": slope, "points_per_cell": 3}],
    "forces": {"gravity": [0, -9.81], "damping": {"local": 0.05, "averaging_time": 0.3}},
    "method": {"relaxation_time": 0.05},
    "boundary": {"left": "roller", "right": "roller", "bottom": "fixed", "top": "free"},
})
strengths = np.linspace(8e3, 17.5e3, 20)
first = terp.Simulation(case)  # its mesh serves all


def moved_soil(strength):
    run = terp.Simulation(case.changed({"material.clay.su_peak": strength}), mesh_of=first)
    run.run()
    return run.summary["moved_volume"]


with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    volumes = list(pool.map(moved_soil, strengths))
plt.plot(strengths / 1e3, volumes, "o-")
plt.xlabel("undrained shear strength [kPa]"), plt.ylabel("soil that moved [m2]"), plt.grid(alpha=0.3)
plt.savefig(sys.argv[1] if len(sys.argv) > 1 else "slope_study.png", dpi=120)
