#!/usr/bin/python3
"""Does a slide know the mesh? A column and a block of softening clay, with and without a softening length.

    PYTHONPATH=python python3 python/examples/mesh_dependence.py RUNS -o FILE [--program build/terp] [--solve]

RUNS/length_h0.1, RUNS/local_gmsh, RUNS/block_length_h0.05, ... are the runs; `--solve` solves those that are missing
(about ten minutes). Draws FILE.png and FILE.pdf; docs/softening_length.md says what they show.
"""
import argparse
import subprocess
import sys
from pathlib import Path

import numpy as np

import terp
from terp import plot, style

COLUMN, BLOCK = "cases/column_collapse/model_2_bed.toml", "cases/verification/biaxial/case.toml"
TIME = 1.0                                                 # of the column [s]
KINDS = {                                                  # changes of the column and of the block
    "local": (["material.clay.softening.length=0", "material.clay.eta=50"], ["material.*.softening.length=0"]),
    "length": ([], [])}
TITLES = {"local": "softening point by point", "length": "softening over a length"}
OUTLINE = [[-0.6, -0.6], [16.6, -0.6], [17.0, 1.1], [16.6, 2.8], [-0.6, 2.8], [-1.0, 1.1]]   # for gmsh [m]
LEANING = ["mesh.cells=[192, 34]",                         # columns of cells lean by 30 degrees
           "mesh.sides.bottom=[[-2.6, -0.6], [16.6, -0.6]]", "mesh.sides.right=[[16.6, -0.6], [18.5629907, 2.8]]",
           "mesh.sides.top=[[-0.6370093, 2.8], [18.5629907, 2.8]]",
           "mesh.sides.left=[[-2.6, -0.6], [-0.6370093, 2.8]]"]
MESHES = {                                                 # name: words, changes of the column; None: by gmsh
    "h0.2": ("h = 0.2 m", ["mesh.cells=[86, 17]"]), "h0.1": ("h = 0.1 m", []),
    "h0.05": ("h = 0.05 m", ["mesh.cells=[344, 68]"]), "gmsh": ("h = 0.1 m, gmsh", None),
    "leaning": ("h = 0.1 m, leaning by 30°", LEANING)}
CELLS = {"local": (0.1, 0.05), "length": (0.1, 0.05, 0.025)}   # of the block [m]
WINDOW = (3.5, -0.05, 11.5, 2.25)                          # of the column that is drawn [m]


def gmsh_case(folder):
    """The column on a mesh of gmsh, as a file: a mesh of another kind is no change of a key."""
    text = Path(COLUMN).read_text()
    begin, end = text.index("[mesh]"), text.index("[[body]]")
    path = folder / "gmsh.toml"
    path.write_text(f"{text[:begin]}[mesh]\npolygon = {OUTLINE}\ncell = 0.1\nfollow_bodies = false\n\n{text[end:]}")
    return path


def cases_of(folder):
    """(run folder, case, changes) of all runs."""
    for kind, (column, block) in KINDS.items():
        for mesh, (_, changes) in MESHES.items():
            case = COLUMN if changes is not None else gmsh_case(folder)
            yield folder / f"{kind}_{mesh}", case, (changes or []) + column + [f"time.end={TIME}"]
        for cell in CELLS[kind]:
            yield folder / f"block_{kind}_h{cell}", BLOCK, [f"mesh.cell={cell}"] + block


def solve(program, folder):
    """Solve the runs that are not there."""
    folder.mkdir(parents=True, exist_ok=True)
    for run, case, changes in cases_of(folder):
        if not ((run / "summary.json").exists() and terp.open(run).finished):
            sets = [word for change in changes for word in ("--set", change)]
            subprocess.run([program, "run", case, "-o", run, "--force", "-q", *sets], check=True)


def draw(folder):
    """The figure: the column, a row per mesh and a column per kind of softening; below, shares and loads."""
    width = 80.0
    height = width * (WINDOW[3] - WINDOW[1]) / (WINDOW[2] - WINDOW[0])
    bottom = 6.0 + len(MESHES) * (height + 2.0)
    figure = style.new_figure(style.TWO_COLUMNS, bottom + 82.0)
    panels = style.panel_grid(figure, (len(MESHES), 2), (10.0, 6.0), (width, height), (3.0, 2.0))
    runs = {kind: {mesh: terp.open(folder / f"{kind}_{mesh}") for mesh in MESHES} for kind in KINDS}
    norm = plot.norm_of_limits(runs["length"]["h0.1"], "eps_eq_p", (0.0, 1.0))
    frames = [frame for column, kind in enumerate(KINDS) for frame in sections(panels, column, runs[kind], norm)]
    for column, kind in enumerate(KINDS):
        panels[0][column].set_title(f"({'ab'[column]}) {TITLES[kind]}", loc="left", pad=3)
        panels[-1][column].set_xlabel("x (m)")
    plot.colour_bar(figure, norm, frames, "eps_eq_p", cax=style.add_panel(figure, 50.0, bottom + 10.0, 76.0, 2.6))
    shares(style.add_panel(figure, 12.0, bottom + 30.0, 70.0, 40.0), runs)
    loads(style.add_panel(figure, 98.0, bottom + 30.0, 70.0, 40.0), folder)
    return figure


def sections(panels, column, runs, norm):
    """The plastic strain on each mesh, down a column of panels; returns the frames."""
    frames = []
    for row, (mesh, run) in zip(panels, runs.items()):
        panel = row[column]
        panel.set(xlim=WINDOW[::2], ylim=WINDOW[1::2], yticks=[0, 1, 2])
        panel.tick_params(labelbottom=row is panels[-1], labelleft=column == 0)
        frames.append(run.frame(run.at(TIME)))
        plot.squares(panel, frames[-1], "eps_eq_p", norm)
        panel.text(0.99, 0.96, MESHES[mesh][0], transform=panel.transAxes, ha="right", va="top", fontsize=8)
    return frames


def shares(chart, runs):
    """Share of the clay that lost half of its drop over time, a colour per mesh; dashed: point by point."""
    for kind, dashes in (("length", "-"), ("local", (0, (3, 1.4)))):
        for (mesh, run), colour in zip(runs[kind].items(), style.COLOURS):
            frames = [run.frame(k) for k in range(run.at(TIME) + 1)]
            clay = np.isfinite(frames[0].scalar("su"))
            share = [np.average(f.scalar("su")[clay] < 5e3, weights=f.scalar("volume")[clay]) for f in frames]
            chart.plot([f.time for f in frames], 100.0 * np.array(share), color=colour, ls=dashes,
                       label=MESHES[mesh][0] if kind == "length" else None)
    chart.set(xlabel="time (s)", ylabel="softened share of the clay (%)", xlim=(0, TIME), ylim=(0, 55))
    chart.set_title("(c) column; dashed: point by point", loc="left", pad=3)
    chart.legend(loc="upper left", fontsize=6.5, ncol=2)


def loads(chart, folder):
    """Load against shortening of the block in biaxial compression, and the closed form of its README."""
    for kind, dashes in (("length", "-"), ("local", (0, (3, 1.4)))):
        for cell, colour in zip(CELLS[kind], style.COLOURS):
            table = np.genfromtxt(folder / f"block_{kind}_h{cell}" / "footings.csv", delimiter=",", names=True,
                                  dtype=None, encoding="utf-8")
            chart.plot(-1e3 * table["displacement_y"], 1e-3 * table["reaction_y"], color=colour, ls=dashes,
                       label=f"h = {cell:g} m" if kind == "length" else None)
    slip = np.linspace(0.0, 0.02, 200)                     # [m]; Eq. (1) of cases/verification/biaxial/README.md
    load = 2 * (2e3 + 6e3 * np.exp(-100.0 * slip / (2 * 0.307)))
    chart.plot(1e3 * (load * 2.0 / (2 * 4e6 / 0.55) + slip / np.sqrt(2)), 1e-3 * load, color=style.GREY, lw=2.4,
               alpha=0.5, zorder=1, label="closed form")
    chart.set(xlabel="shortening (mm)", ylabel="load (kN/m)", xlim=(0, 14), ylim=(0, 17))
    chart.set_title("(d) block; dashed: point by point", loc="left", pad=3)
    chart.legend(loc="upper right", fontsize=6.5)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("runs", type=Path)
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="FILE", help="without extension")
    parser.add_argument("--program", default="build/terp")
    parser.add_argument("--solve", action="store_true", help="solve the runs that are missing")
    options = parser.parse_args()
    if options.solve:
        solve(options.program, options.runs)
    with style.house_style():
        print(*style.save_figure(draw(options.runs), options.output))


if __name__ == "__main__":
    sys.exit(main())
