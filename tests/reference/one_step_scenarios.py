"""Scenarios of the NumPy twin in one_step.py, written with what it expects to one_step.json for the C++ tests.

A 3 x 3 mesh (regular, or with its nodes moved by up to 25 % of h) holds 50 to 65 points: filled and part-filled cells,
one empty cell, and an empty sub-cell in one filled and in two part-filled cells. Stresses start close to the softening
yield surface and strain increments are 1e-3 to 1e-2 per step, so that faces and both edges of Tresca are met.
Points start away from cell sides and none leaves its cell in the three steps (asserted); some change sub-cell.

Scenarios with shares that overlap have fewer points, which reach beyond sides and corners: one as large as its cell,
sub-cells that no point reaches, cells without points beyond sides and corners, soil that touches at a corner alone,
and three cells that meet at a node.
"""
import json

import numpy as np

from one_step import CENTRE, CORNERS, gauss_volumes, local_coordinates, met, shape_functions, step, strength
from overlap_shares import half_sides

SEED, N_STEPS, DT = 20220917, 3, 3.1e-4
ORIGIN, H = np.array([0.4, -0.3]), np.array([0.12, 0.1])
FILLING = [1.02, 0.97, 0.55, 0.98, 1.04, 0.7, 0.6, 0.4, 0.0]  # sum of Omega_p over V_e, cell by cell
EMPTY_SUB_CELLS = {(4, 2), (2, 1), (7, 3)}                    # (cell, sub-cell)
TRESCA = {"law": "tresca_softening", "density": 1990.0, "shear_modulus": 2.0e6, "poisson_ratio": 0.46,
          "su_peak": 8.0e3, "su_residual": 2.1e3, "eta": 47.0}
ELASTIC = {"law": "linear_elastic", "density": 1870.0, "shear_modulus": 1.3e6, "poisson_ratio": 0.31}
OPTIONS = {"filled_fraction": 0.9, "force_operator": "b_bar", "objective_rate": "none", "shares": "point",
           "local_damping": 0.1, "gravity": np.array([0.7, -9.81])}
# name, scheme, distorted, contact, objective rate, material
SCENARIOS = [(f"{scheme}_{'distorted' if distorted else 'regular'}", scheme, distorted, False, "none", TRESCA)
             for scheme in ("standard_mpm", "mpm_mixed", "mpm_gp") for distorted in (False, True)]
SCENARIOS += [("mpm_mixed_jaumann", "mpm_mixed", True, False, "jaumann", TRESCA),
              ("mpm_gp_jaumann", "mpm_gp", True, False, "jaumann", TRESCA),
              ("mpm_mixed_contact", "mpm_mixed", True, True, "none", TRESCA),
              ("mpm_gp_contact", "mpm_gp", False, True, "none", TRESCA),
              ("mpm_gp_linear_elastic", "mpm_gp", True, True, "none", ELASTIC)]
# Of each cell of the 3 x 3 mesh: sum of Omega_p over V_e, and the number of points in each sub-cell
OVERLAP_CELLS = [(0.98, (0, 4, 4, 4)), (1.04, (0, 0, 1, 0)), (0.6, (1, 1, 1, 1)), (0.97, (1, 1, 1, 1)),
                 (1.01, (1, 1, 2, 1)), (0.7, (1, 1, 1, 1)), (0.1, (0, 0, 0, 2)), (0.3, (0, 1, 1, 0)),
                 (0.8, (1, 1, 1, 1))]
THREE_CELLS = [(1.02, (1, 1, 1, 1)), (0.5, (1, 1, 1, 1)), (0.95, (1, 1, 0, 2))]
MANY_POINTS = [(0.99, (17, 17, 18, 18)), *THREE_CELLS[1:]]  # more than the C++ works on at a time
# name, scheme, make_mesh or make_three_cells, cells, those without points, objective rate
OVERLAP_SCENARIOS = [(f"{scheme}_overlap_{name}", scheme, mesh, cells, empty, rate)
                     for scheme in ("mpm_mixed", "mpm_gp")
                     for name, mesh, cells, empty, rate in (
                         ("regular", "regular", OVERLAP_CELLS, [8], "none"),
                         ("distorted", "distorted", OVERLAP_CELLS, [2, 5], "jaumann"),
                         ("two_at_a_corner", "regular", OVERLAP_CELLS, [0, 1, 2, 3, 5, 6, 7], "none"),
                         ("three_cells", "three cells", THREE_CELLS, [], "none"))]
OVERLAP_SCENARIOS += [("mpm_gp_overlap_many_points", "mpm_gp", "three cells", MANY_POINTS, [], "none")]


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


def make_three_cells(rng):
    """A distorted hexagon of three cells that meet at its middle, each with another first corner. No side is held."""
    angles = np.arange(6) * np.pi / 3 + rng.uniform(-0.15, 0.15, 6)
    nodes = ORIGIN + H * np.vstack([rng.uniform(-0.1, 0.1, (1, 2)), np.stack([np.cos(angles), np.sin(angles)], 1)])
    cells = np.array([np.roll([0, 1 + 2 * k, 2 + 2 * k, 1 + (2 * k + 2) % 6], k) for k in range(3)])
    contact = {key: np.array([]) for key in ("nodes", "adhesion", "friction", "length")}
    contact["nodes"] = contact["nodes"].astype(int)
    return {"nodes": nodes, "cells": cells, "fixed": np.zeros((7, 2), bool), "contact": contact}


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
    return with_state(rng, np.array(cell), np.array(x), np.array(volume), mat)


def make_overlap_points(rng, mesh, cells, empty, mat):
    """Points of almost equal volume in a cell, away from its middle lines."""
    cell, x, volume = [], [], []
    for e, (filling, counts) in enumerate(cells):
        if e in empty:
            continue
        corners = mesh["nodes"][mesh["cells"][e]]
        xi = [CORNERS[g] * rng.uniform(0.5, 0.8, 2) for g in range(4) for _ in range(counts[g])]
        share = rng.uniform(0.9, 1.1, len(xi))
        volume += list(share / share.sum() * filling * gauss_volumes(corners).sum())
        x += [shape_functions(each) @ corners for each in xi]
        cell += [e] * len(xi)
    cell, volume = np.array(cell), np.array(volume)
    cell_volume = np.array([gauss_volumes(mesh["nodes"][nodes]).sum() for nodes in mesh["cells"]])
    return {**with_state(rng, cell, np.array(x), volume, mat), "extent": half_sides(volume, cell_volume[cell])}


def with_state(rng, cell, x, volume, mat):
    """Velocity, stress and state of points close to yield."""
    n = len(cell)
    l = rng.uniform(-7e-3, 7e-3, (2, 2)) / DT  # velocity gradient that all points share
    v = (x - x.mean(0)) @ l.T + np.array([0.35, -0.2]) + rng.uniform(-0.3, 0.3, (n, 2))
    plastic = mat["law"] == "tresca_softening"
    eps_eq_p = rng.uniform(0.0, 0.05, n) * plastic
    limit = strength(mat, eps_eq_p) if plastic else np.full(n, 6e3)
    return {"cell": cell, "x": x, "v": v, "volume": volume, "eps_eq_p": eps_eq_p,
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


def make_overlap_case(rng, name, scheme, kind, cells, empty, rate):
    mesh = make_three_cells(rng) if kind == "three cells" else make_mesh(rng, kind == "distorted", False)
    case = {"name": name, "scheme": scheme, "n_steps": N_STEPS, "dt": DT, "material": TRESCA, "mesh": mesh,
            "options": {**OPTIONS, "objective_rate": rate, "shares": "overlap"}}
    return case, make_overlap_points(rng, mesh, cells, empty, TRESCA)


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
    print(f"{case['name']:33s}{len(start['mass'])} points, {moved} change sub-cell, largest increments {largest}")
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
    kinds = [(make_case, each) for each in SCENARIOS] + [(make_overlap_case, each) for each in OVERLAP_SCENARIOS]
    for index, (make, description) in enumerate(kinds):
        case, start = make(np.random.default_rng([SEED, index]), *description)
        end = run_case(case, start)
        given = {key: each for key, each in start.items() if key != "extent"}  # follows from the volume
        expected = {key: end[key] for key in ("x", "v", "volume", "sigma", "strain", "eps_eq_p")}
        lines.append(json.dumps(to_plain({**case, "points": given, "expected": expected})))
    print("met:", {key: int(met[key]) for key in sorted(met)})
    assert all(met.values()), "a branch that no scenario meets"
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
