"""Scenarios of the NumPy twin in one_step.py, written with what it expects to one_step.json for the C++ tests.

A 3 x 3 mesh (regular, or with its nodes moved by up to 25 % of h) holds 50 to 65 points: filled and part-filled cells,
one empty cell, and an empty sub-cell in one filled and in two part-filled cells. Stresses start close to the softening
yield surface and strain increments are 1e-3 to 1e-2 per step, so that faces and both edges of Tresca are met.
Points start away from cell sides and none leaves its cell in the three steps (asserted); some change sub-cell.
"""
import json

import numpy as np

from one_step import CENTRE, CORNERS, gauss_volumes, local_coordinates, met, shape_functions, step, strength

SEED, N_STEPS, DT = 20220917, 3, 3.1e-4
ORIGIN, H = np.array([0.4, -0.3]), np.array([0.12, 0.1])
FILLING = [1.02, 0.97, 0.55, 0.98, 1.04, 0.7, 0.6, 0.4, 0.0]  # sum of Omega_p over V_e, cell by cell
EMPTY_SUB_CELLS = {(4, 2), (2, 1), (7, 3)}                    # (cell, sub-cell)
TRESCA = {"law": "tresca_softening", "density": 1990.0, "shear_modulus": 2.0e6, "poisson_ratio": 0.46,
          "su_peak": 8.0e3, "su_residual": 2.1e3, "eta": 47.0}
ELASTIC = {"law": "linear_elastic", "density": 1870.0, "shear_modulus": 1.3e6, "poisson_ratio": 0.31}
OPTIONS = {"filled_fraction": 0.9, "force_operator": "b_bar", "objective_rate": "none", "local_damping": 0.1,
           "gravity": np.array([0.7, -9.81])}
# name, scheme, distorted, contact, objective rate, material
SCENARIOS = [(f"{scheme}_{'distorted' if distorted else 'regular'}", scheme, distorted, False, "none", TRESCA)
             for scheme in ("standard_mpm", "mpm_mixed", "mpm_gp") for distorted in (False, True)]
SCENARIOS += [("mpm_mixed_jaumann", "mpm_mixed", True, False, "jaumann", TRESCA),
              ("mpm_gp_jaumann", "mpm_gp", True, False, "jaumann", TRESCA),
              ("mpm_mixed_contact", "mpm_mixed", True, True, "none", TRESCA),
              ("mpm_gp_contact", "mpm_gp", False, True, "none", TRESCA),
              ("mpm_gp_linear_elastic", "mpm_gp", True, True, "none", ELASTIC)]


def make_mesh(rng, distorted, contact):
    """Nodes and cells row by row; the sides stay straight. Left x is fixed, the base is a roller or a contact."""
    grid = np.array([[i, j] for j in range(4) for i in range(4)])
    shift = rng.uniform(-0.25, 0.25, (16, 2)) * distorted * ((grid > 0) & (grid < 3))
    nodes = ORIGIN + (grid + shift) * H
    cells = np.array([[k, k + 1, k + 5, k + 4] for k in (4 * j + i for j in range(3) for i in range(3))])
    base, sides = np.flatnonzero(grid[:, 1] == 0), np.diff(nodes[:4, 0])
    length = (np.append(sides, 0) + np.append(0, sides)) / 2
    fixed = np.stack([grid[:, 0] == 0, (grid[:, 1] == 0) & (not contact)], 1)
    slab = {"nodes": base, "adhesion": np.full(4, 9.0e3), "friction": np.full(4, 0.35), "length": length}
    none = {key: a[:0] for key, a in slab.items()}
    return {"nodes": nodes, "cells": cells, "fixed": fixed, "contact": slab if contact else none}


def make_points(rng, mesh, mat):
    """Two or so points per sub-cell; volumes scaled to the filling of each cell."""
    cell, x, volume = [], [], []
    for e, filling in enumerate(FILLING):
        corners = mesh["nodes"][mesh["cells"][e]]
        xi = [CORNERS[g] * rng.uniform(0.12, 0.8, 2) for g in range(4) if (e, g) not in EMPTY_SUB_CELLS
              for _ in range(rng.integers(1, 4))] * (filling > 0)
        if e == 0:
            xi[0] = CENTRE  # a tie: belongs to the right upper sub-cell
        share = rng.uniform(0.4, 1.6, len(xi))
        volume += list(share / share.sum() * filling * gauss_volumes(corners).sum() if len(xi) else [])
        x += [shape_functions(each) @ corners for each in xi]
        cell += [e] * len(xi)
    x, volume, n = np.array(x), np.array(volume), len(cell)
    l = rng.uniform(-7e-3, 7e-3, (2, 2)) / DT  # velocity gradient that all points share
    v = (x - x.mean(0)) @ l.T + np.array([0.35, -0.2]) + rng.uniform(-0.3, 0.3, (n, 2))
    plastic = mat["law"] == "tresca_softening"
    eps_eq_p = rng.uniform(0.0, 0.05, n) * plastic
    limit = strength(mat, eps_eq_p) if plastic else np.full(n, 6e3)
    return {"cell": np.array(cell), "x": x, "v": v, "volume": volume, "eps_eq_p": eps_eq_p,
            "mass": mat["density"] * volume * rng.uniform(0.97, 1.03, n),
            "sigma": np.array([stress_near_yield(rng, su) for su in limit]),
            "strain": np.array([(e + e.T) / 2 * np.array([[1, 1, 0], [1, 1, 0], [0, 0, 1]])
                                for e in rng.uniform(-0.02, 0.02, (n, 3, 3))])}


def stress_near_yield(rng, su):
    """Random Lode angle, pressure and in-plane direction; zz may be any of the three principal values."""
    s = rng.permutation([1.0, rng.uniform(-1, 1), -1.0]) * su * rng.uniform(0.7, 1.0) + rng.uniform(-3e4, 5e3)
    c, d = np.cos(angle := rng.uniform(0, np.pi)), np.sin(angle)
    turn = np.array([[c, -d, 0], [d, c, 0], [0, 0, 1]])
    return turn @ np.diag(s) @ turn.T


def make_case(rng, name, scheme, distorted, contact, rate, mat):
    """Everything but the points, and the points."""
    mesh = make_mesh(rng, distorted, contact)
    case = {"name": name, "scheme": scheme, "n_steps": N_STEPS, "dt": DT,
            "options": {**OPTIONS, "objective_rate": rate}, "material": mat, "mesh": mesh}
    return case, make_points(rng, mesh, mat)


def run_case(case, start):
    """Points after the steps; says how hard the scenario is. Fails if a point leaves its cell."""
    end, seen = start, []
    for _ in range(case["n_steps"]):
        end, more = step(case, end)
        seen.append(more)
    for x, corners in zip(end["x"], case["mesh"]["nodes"][case["mesh"]["cells"][end["cell"]]]):
        local_coordinates(corners, x)
    largest = [f"{np.abs(s['d_eps']).max():.1e}" for s in seen]
    moved = np.count_nonzero(seen[0]["sub_cell"] != seen[-1]["sub_cell"])
    print(f"{case['name']:24s}{len(start['mass'])} points, {moved} change sub-cell, largest increments {largest}")
    return end


def to_plain(value):
    """Lists of numbers for JSON; 3 x 3 tensors as xx yy zz xy; flags as 0 and 1."""
    if isinstance(value, dict):
        return {key: to_plain(each) for key, each in value.items()}
    if not isinstance(value, np.ndarray):
        return value
    if value.ndim == 3:
        value = value[:, [0, 1, 2, 0], [0, 1, 2, 1]]
    return (value.astype(int) if value.dtype == bool else value).tolist()


def scenarios_text():
    """The whole of one_step.json."""
    met.clear()
    lines = []
    for index, description in enumerate(SCENARIOS):
        case, start = make_case(np.random.default_rng([SEED, index]), *description)
        end = run_case(case, start)
        expected = {key: end[key] for key in ("x", "v", "volume", "sigma", "strain", "eps_eq_p")}
        lines.append(json.dumps(to_plain({**case, "points": start, "expected": expected})))
    print("met:", {key: int(met[key]) for key in sorted(met)})
    return '{"scenarios": [\n' + ",\n".join(lines) + "\n]}\n"


def all_numbers(value):
    """Every number of a parsed JSON value, in order."""
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, list):
        return [number for each in value for number in all_numbers(each)]
    return [float(value)] if isinstance(value, (int, float)) else []


def differs(text, path):
    """Whether a new text says something else than the file: other numbers than round-off of another NumPy explains."""
    new, old = (np.array(all_numbers(json.loads(each))) for each in (text, path.read_text()))
    return new.shape != old.shape or not np.allclose(new, old, rtol=1e-12, atol=1e-12)
