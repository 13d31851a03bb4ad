"""Writes run folders that look like those of Terp: a column that slumps twice, by formula.

Not a simulation: displacements and strains are smooth made-up functions, so that the tests know what to expect.
"""

import json

import h5py
import numpy as np

POINTS = {"A": (7.60, 0.07), "B": (7.60, 1.93), "C": (7.13, 1.09), "D": (6.90, 1.00), "E": (6.60, 1.00),
          "F": (6.00, 1.00), "G": (5.50, 1.00), "H": (5.20, 1.00), "I": (4.70, 1.00), "J": (4.50, 1.00)}
WIDTH, HEIGHT = 8.0, 2.0  # of the column [m]
SU_PEAK, ETA = 8000.0, 50.0
TIMES = np.arange(0.0, 4.01, 0.5)

CASE = """
title  = "Column collapse, model {model}: {title}"
scheme = "{scheme}"
[time]
end = 4.0
[mesh]
size = [16.0, 3.0]
cell = 0.1
[[body]]
material = "clay"
box = [[0.0, 0.0], [8.0, 2.0]]
points_per_cell = [5, 5]
[material.clay]
model = "tresca_softening"
density = 1990.0
su_peak = 8.0e3
su_residual = {su_residual}
eta = 50.0
[boundary]
left = "roller"
right = "roller"
bottom = {bottom}
[output]
fields = {{ every = 0.5, names = ["eps_deviatoric", "eps_eq_p", "su"] }}
history = {{ every = 0.01, points = {{ {points} }} }}
"""


def write_run(folder, scheme="mpm_gp", model=2, times=TIMES, spacing=0.1):
    """A whole run folder; spacing 0.02 m is that of the paper. Returns the folder."""
    folder.mkdir(parents=True)
    start = lattice(spacing)
    write_frames(folder, start, scheme, model, times)
    write_mesh(folder / "mesh.vtkhdf", 16, 3)
    write_history(folder / "history.csv", start, scheme, model, times[-1])
    write_ledger(folder / "ledger.csv", times[-1])
    (folder / "case.toml").write_text(case_text(scheme, model))
    (folder / "summary.json").write_text(json.dumps(summary(scheme, model, times, len(start))))
    return folder


def lattice(spacing):
    """Places of the points at rest [m], shape [n_points, 2], by columns."""
    x, y = (np.arange(spacing / 2, length, spacing) for length in (WIDTH, HEIGHT))
    return np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)


def progress(t, begin, duration):
    """0 before `begin`, 1 after `begin + duration`, smooth between [-]."""
    s = np.clip((t - begin) / duration, 0.0, 1.0)
    return s * s * (3 - 2 * s)


def slumps(t, model):
    """(foot x, crest x, progress) of the two slip surfaces at time t [m, m, -]."""
    second = 4.2 if model == 2 else 4.9
    return ((6.9, 5.9, progress(t, 0.0, 1.3)), (5.6, second, progress(t, 2.1, 1.5)))


def distance_to_slip(x, foot, crest):
    """Signed horizontal distance to the slip line, positive on the sliding side [m]."""
    return x[:, 0] - (foot + (crest - foot) * x[:, 1] / HEIGHT)


def places(start, t, model):
    """Places of the points at time t [m]: beyond a slip line the soil flattens and keeps its volume."""
    x = start.copy()
    for foot, crest, s in slumps(t, model):
        d = distance_to_slip(x, foot, crest)
        flat = np.where(d > 0, 1 - 0.45 * s, 1.0)
        y = flat * x[:, 1]
        x = np.column_stack([x[:, 0] - d + (crest - foot) * (y - x[:, 1]) / HEIGHT + d / flat, y])
    return x


def strains(start, t, scheme, model):
    """(total, plastic) deviatoric strain at time t [-], shape [n_points] each."""
    width = 0.16 if scheme == "mpm_gp" else 0.24
    total = np.zeros(len(start))
    for foot, crest, s in slumps(t, model):
        d = distance_to_slip(start, foot, crest)
        base = np.exp(-start[:, 1] / 0.25) * (d > 0)
        total += 2.5 * s * (0.45 * np.exp(-(d / width) ** 2) + 0.25 * base + 0.03 * (d > 0)) * 0.16 / width
    if scheme == "mpm_gp":
        return total, 0.97 * total
    cell = np.floor(start / 0.1 + 1e-9).astype(int) @ (1, 1000)  # MPM-Mixed: one value per cell, and it may fall
    mean = (np.bincount(cell, total) / np.maximum(np.bincount(cell), 1))[cell]
    return total, mean * (0.85 + 0.06 * np.sin(5 * t + 3 * start[:, 0]))


def strength(plastic, model):
    """S_u by Eq. (5) [Pa]."""
    residual = SU_PEAK if model == 1 else 2000.0
    return residual + (SU_PEAK - residual) * np.exp(-ETA * plastic)


UNITS = {"eps_deviatoric": "-", "eps_eq_p": "-", "su": "Pa", "displacement": "m", "stress": "Pa"}
COMPONENTS = {"displacement": "x y z", "stress": "xx yy zz xy"}


def fields_at(start, t, scheme, model):
    """Every field of one frame, as in the file."""
    total, plastic = strains(start, t, scheme, model)
    x, zero = places(start, t, model), np.zeros(len(start))
    return {"eps_deviatoric": total, "eps_eq_p": plastic, "su": strength(plastic, model),
            "displacement": np.column_stack([x - start, zero]),
            "stress": np.column_stack([-1e3 * start[:, 1], -2e3 * start[:, 1], zero, 10.0 * total])}


def write_frames(folder, start, scheme, model, times):
    """Frames as docs/formats.md has them."""
    (folder / "frames").mkdir(exist_ok=True)
    for k, t in enumerate(times):
        write_frame(frame_file(folder, k), k, t, places(start, t, model), fields_at(start, t, scheme, model))


def frame_file(folder, k):
    return folder / "frames" / f"points_{k:05}.vtkhdf"


def write_frame(path, number, time, x, fields, case="0123456789abcdef"):
    n = len(x)
    with h5py.File(path, "w") as file:
        file.attrs["frame"], file.attrs["time"], file.attrs["step"] = number, time, round(time / 6.06e-4)
        file.attrs["case"] = np.bytes_(case)
        root = file.create_group("VTKHDF")
        root.attrs["Version"], root.attrs["Type"] = (1, 0), np.bytes_("UnstructuredGrid")
        for name in ("NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"):
            root[name] = [n]
        root["Connectivity"], root["Offsets"], root["Types"] = np.arange(n), np.arange(n + 1), np.ones(n, np.uint8)
        root["Points"] = np.column_stack([x, np.zeros(n)])
        for name, values in fields.items():
            array = root.create_dataset(f"PointData/{name}", data=values, dtype="f4", compression="gzip",
                                        fletcher32=True)
            array.attrs["unit"] = np.bytes_(UNITS.get(name, "-"))
            if name in COMPONENTS:
                array.attrs["components"] = np.bytes_(COMPONENTS[name])


def write_mesh(path, n_x, n_y):
    """mesh.vtkhdf: cells of 1 m, numbered along x; coarser than the case's, for the tests need few."""
    x, y = np.meshgrid(np.arange(n_x + 1.0), np.arange(n_y + 1.0))
    i, j = (part.ravel() for part in np.meshgrid(np.arange(n_x), np.arange(n_y)))
    first = j * (n_x + 1) + i
    with h5py.File(path, "w") as file:
        root = file.create_group("VTKHDF")
        root["Points"] = np.column_stack([x.ravel(), y.ravel(), 0 * x.ravel()])
        root["Connectivity"] = np.column_stack([first, first + 1, first + n_x + 2, first + n_x + 1]).ravel()
        root["NumberOfPoints"], root["NumberOfCells"] = [x.size], [first.size]


def write_history(path, start, scheme, model, end):
    ids = [int(np.argmin(np.hypot(*(start - place).T))) for place in POINTS.values()]
    lines = ["time,point,id,x,y,eps_deviatoric,eps_eq_p,su,pressure"]
    for t in np.arange(0.0, end + 1e-9, 0.02):
        x = places(start, t, model)[ids]
        total, plastic = (values[ids] for values in strains(start, t, scheme, model))
        su = strength(plastic, model)
        for k, name in enumerate(POINTS):
            values = ",".join(f"{value:.9g}" for value in (*x[k], total[k], plastic[k], su[k], -2.0e4))
            lines.append(f"{t:.9g},{name},{ids[k]},{values}")
    path.write_text("\n".join(lines) + "\n")


def write_ledger(path, end):
    names = ("time,step,kinetic,elastic,plastic,gravity_work,damping_work,boundary_work,left_energy,numerical,mass,"
             "momentum_x,momentum_y,clamped,left,front_x,crest_x,crest_y,moved_volume,v_max,v_999")
    rows = [f"{t:.9g},{round(t / 6.06e-4)},1,2,3,4,5,6,0,0,31840,0,0,0,0,8,nan,nan,0,1,1"
            for t in np.arange(0.0, end + 1e-9, 0.1)]
    path.write_text("\n".join([names, *rows]) + "\n")


def case_text(scheme, model):
    points = ", ".join(f"{name} = [{x}, {y}]" for name, (x, y) in POINTS.items())
    return CASE.format(model=model, scheme=scheme, title="softening" if model == 2 else "no softening", points=points,
                       su_residual=2000.0 if model == 2 else 8000.0,
                       bottom='{ contact = "bilateral", adhesion = 8.0e3 }' if model == 2 else '"roller"')


def summary(scheme, model, times, n_points):
    """A run is finished if it reached the end of its case, 4 s."""
    mixed = scheme == "mpm_mixed"
    return {
        "finished": bool(times[-1] >= 4.0),
        "scheme": scheme, "points": n_points, "cells": 4800, "steps": round(times[-1] / 6.06e-4), "dt": 6.06e-4,
        "wall_s": 31.4, "point_steps_per_s": 8.4e6, "threads": 2, "front_x": 13.2, "crest_x": None if mixed else 4.1,
        "second_failure_time": 2.4, "max_eps_eq_p": 2.1 if mixed else 2.9,
        "softened_fraction": [{"time": float(t), "fraction": 0.05 * float(t)} for t in times],
        "points_eps_eq_p_fell": 812 if mixed else 0, "points_su_rose": 640 if mixed else 0,
        "residual_height": 1.9, "flood": None,
        "energy_balance_error": 2.3e-4, "clamped_points": 0, "v_999": 4.9, "terp_version": "0.1.0",
        "case_name": f"model_{model}", "case": case_text(scheme, model),
    }
