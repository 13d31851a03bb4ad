"""Calls of the program: a case as a dictionary is written, solved, and its tables are read.

Not for what is judged: rows_*.py. Units as in the case file: SI.
"""
import csv
import json
import math
import os
import subprocess

import numpy as np

import meshes

NEVER = 1e9  # s: an output that is not wanted
SECONDS = 600  # of processor time, after which a call is ended
TODAY = {"strain_shares": "plain", "volume_change": "centre", "pressure": "constant"}  # as before these options


def toml(value):
    """A value as TOML on one line."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml(item)}" for key, item in value.items()) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(toml, value)) + "]"
    if isinstance(value, (bool, str)):
        return json.dumps(value)
    return repr(int(value) if isinstance(value, (int, np.integer)) else float(value))


class Result:
    """Tables of one run, up to where it stopped if it did; infinite if it did not begin."""

    def __init__(self, folder, code, message):
        self.folder, self.code, self.message = folder, code, message
        self.ledger = {}
        if (folder / "ledger.csv").exists():
            with open(folder / "ledger.csv") as file:
                rows = list(csv.DictReader(file))
            self.ledger = {key: np.array([float(row[key]) for row in rows]) for key in (rows[0] if rows else ())}

    def column(self, name):
        """A column of the ledger; zeros where this build has none of that name."""
        return self.ledger.get(name, np.zeros_like(self.ledger["time"]))

    def largest(self, name, until=math.inf):
        return float(np.abs(self.column(name)[self.column("time") <= until]).max()) if self.ledger else math.inf

    def last(self, name):
        return float(self.column(name)[-1]) if self.ledger else math.inf

    def at(self, name, moment):
        return float(np.interp(moment, self.column("time"), self.column(name))) if self.ledger else math.inf

    def unexplained(self):
        """Energy that no outside work and no dissipation explains [J/m], over time: made if positive.

        Formed here from the columns, so that it does not depend on what the program books as `numerical`.
        """
        stored = sum(self.column(name) for name in ("kinetic", "elastic", "pore_elastic", "left_energy"))
        spent = self.column("plastic") + self.column("slip_work")
        works = ("gravity", "damping", "boundary", "clamp", "water", "load", "relaxation", "balance")
        return stored - stored[0] + spent - sum(self.column(f"{name}_work") for name in works)

    def most_made(self, window=0.0):
        """Most of unexplained energy over the largest work of gravity [-], and the least.

        window: means over so many seconds, less that of the first. The kinetic energy of a leapfrog step lies half a
        step beside the elastic one. So in a body that swings their sum swings, too, by some per cent.
        """
        if not self.ledger:
            return math.inf, -math.inf
        relative = self.unexplained() / np.abs(self.column("gravity_work")).max()
        if window:
            part = (self.column("time") / window).astype(int)
            relative = np.bincount(part, relative) / np.maximum(np.bincount(part), 1)
            relative -= relative[0]
        return float(relative.max()), float(relative.min())

    def points(self):
        """The points in the first and in the last frame, in one order: those that are in both."""
        frames = sorted((self.folder / "csv").glob("frame_*.csv"))
        first, last = (np.genfromtxt(frame, delimiter=",", names=True) for frame in (frames[0], frames[-1]))
        _, before, after = np.intersect1d(first["id"], last["id"], return_indices=True)
        return first[before], last[after]

    def motion(self, chosen):
        """Mean displacement [m] and velocity [m/s] at the end, each [x, y], of the points chosen at the start."""
        if self.code:
            return np.full(2, np.nan), np.full(2, np.nan)
        first, last = self.points()
        picked = [chosen(row) for row in first]
        moved = [np.mean(last[picked][c] - first[picked][c]) for c in "xy"]
        return np.array(moved), np.array([np.mean(last[picked][f"velocity_{c}"]) for c in "xy"])


class Variant:
    """One line of the table: a row with one value of each of its factors. It writes its cases into `folder`."""

    def __init__(self, terp, folder, random, settings, factors):
        self.terp, self.folder, self.random, self.settings, self.factors = terp, folder, random, settings, factors
        self.cpu = 0.0  # s of processor time so far
        self.stops = []  # first words of runs that stopped and should not have

    def __getattr__(self, name):
        try:
            return self.__dict__["factors"][name]
        except KeyError:
            raise AttributeError(name)

    def path(self, name):
        self.folder.mkdir(parents=True, exist_ok=True)
        return self.folder / name

    def call(self, command):
        """Exit status and messages of the program; negative if it was ended, as beyond its processor time."""
        command = ["prlimit", f"--cpu={SECONDS}", *map(str, command)]
        with open(self.path("messages.txt"), "w+") as messages:
            process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=messages)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            messages.seek(0)
            self.cpu += usage.ru_utime + usage.ru_stime
            return process.returncode, messages.read()

    def write(self, case, name):
        method = {"shares": self.shares} | case.get("method", {})
        case = {"scheme": f"mpm_{self.scheme}"} | case | {"method": method}
        path = self.path(f"{name}.toml")
        path.write_text("".join(f"{key} = {toml(value)}\n" for key, value in case.items()))
        return path

    def options(self, case):
        """The settings of the command line, but those of [method] in a run as before these options."""
        before = case.get("method", {}).items() >= TODAY.items()
        return [option for setting in self.settings if not (before and setting.startswith("method."))
                for option in ("--set", setting)]

    def run(self, case, name="run", fields=(), may_stop=False):
        """Result of a case; with `fields` the first and the last frame have these. may_stop: that may be right."""
        output = {"ledger": {"every": 0.02}, "fields": {"every": 0.0 if fields else NEVER}} | case.get("output", {})
        path = self.write(case | {"output": output}, name)
        folder = self.folder / name
        code, message = self.call([self.terp, "run", path, "-o", folder, "-q", "--force", "-j", 1,
                                   *self.options(case)])
        if not may_stop:
            self.note_stop(name, code, message)
        if fields and code == 0:
            named = [option for field in fields for option in ("--field", field)]
            self.call([self.terp, "export", folder, *named])
        return Result(folder, code, message)

    def note_stop(self, name, code, message):
        if code:
            words = [text for text in message.splitlines() if text.startswith("error")]
            self.stops.append(f"{name}: {words[0] if words else f'exit status {code}'}")

    def stability(self, case, *options, name="stability"):
        """stability.json, or None where the search found no factor."""
        path = self.write(case, name)
        folder = self.folder / name
        code, message = self.call([self.terp, "stability", path, "-o", folder, "-j", 1, *options, *self.options(case)])
        file = folder / "stability.json"
        if not file.exists():
            self.note_stop(name, code or "without a factor", message)
        return json.loads(file.read_text()) if file.exists() else None

    def moves_of_nodes(self, values=(0.1, 0.25, 0.35)):
        """How far nodes of a mesh of moved nodes are moved, as a part of a cell."""
        return self.draw("amount", values) if self.kind == "quads" else 0.0

    def draw(self, name, values):
        """One of the values at random; the line of the variant says which."""
        if name not in self.factors:
            self.factors[name] = self.random.choice(list(values))
        return self.factors[name]

    def mesh(self, width, height, cell, amount=0.25, level=(), kept=(), place=lambda x, y: (x, y), slant=0.37):
        """`mesh` of a case: the box width x height of the kind of this variant, with sides of the four names.

        level: heights of rows that stay level in a mesh of moved nodes; kept: places of nodes that stay. place: takes
        the box elsewhere. The top of a polygon slants up by `slant`, a part of the height, or gmsh would fill it with
        squares.
        """
        columns, rows = round(width / cell), round(height / cell)
        corners = [place(x, y) for x, y in ((0, 0), (width, 0), (width, height), (0, height))]
        if self.kind == "quads":
            rows_kept = {round(y / cell) for y in level}
            nodes_kept = {(round(x / cell), round(y / cell)) for x, y in kept}
            nodes = meshes.moved_grid(columns, rows, amount, self.random, rows_kept, nodes_kept)
            nodes = np.array([[place(x * cell, y * cell) for x, y in row] for row in nodes])
            name = f"quads_{columns}_{rows}.msh"
            meshes.write_msh(self.path(name), nodes)
            return {"file": name}
        if self.kind == "polygon":
            corners[2] = place(width, height * (1 + slant * self.random.uniform(0.5, 1)))
            return {"polygon": corners, "edges": {"bottom": [0], "right": [1], "top": [2], "left": [3]}, "cell": cell,
                    "variant": self.random.randrange(8), "follow_bodies": False}
        return {"cells": [columns, rows], "sides": {"bottom": corners[:2], "right": corners[1:3],
                                                    "top": corners[3:1:-1], "left": [corners[0], corners[3]]}}
