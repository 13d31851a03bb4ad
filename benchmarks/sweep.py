#!/usr/bin/env python3
"""Measures what benchmarks/README.md states: speed of the schemes, threads, sizes, meshes, memory and output.

    benchmarks/sweep.py [build/terp] [--only NAME ...] [--machine NAME]

Prints a table and writes benchmarks/results/MACHINE.csv (what, value, unit, low, high). Compared runs take turns, A B A
B, and the ratio is the median of the ratios of neighbours, so that a drifting speed of the machine cancels. Takes about
eight minutes, on an otherwise idle machine.
"""

import argparse
import csv
import datetime
import json
import os
import platform
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).parent.parent
COLUMN = ROOT / "cases/column_collapse/model_2.toml"
UNSTRUCTURED = ROOT / "cases/column_collapse/model_2_unstructured.toml"
SCHEMES = ("mpm_gp", "mpm_mixed", "standard_mpm")
REPEATS = 5


class Sweep:
    def __init__(self, terp):
        self.terp = terp
        self.rows = []

    def bench(self, case=COLUMN, threads=1, steps=200, settings=()):
        """Point-steps per second of one `terp bench`: its median of five groups of steps."""
        command = [self.terp, "bench", case, "-j", str(threads), "--steps", str(steps), "--warm", str(steps // 4)]
        for setting in settings:
            command += ["--set", setting]
        return self.point_steps(command)

    @staticmethod
    def point_steps(command):
        done = subprocess.run([*command, "--json"], check=True, capture_output=True, text=True)
        return json.loads(done.stdout)["point_steps_per_s"]

    def enter(self, what, values, unit, scale=1.0):
        scaled = [v * scale for v in values]
        row = {"what": what, "value": statistics.median(scaled), "unit": unit, "low": min(scaled), "high": max(scaled)}
        self.rows.append(row)
        print(f"{what:58} {row['value']:8.3g} {unit:16} ({row['low']:.3g} to {row['high']:.3g})", flush=True)

    def in_turn(self, *measures, repeats=REPEATS):
        """Each measure as often, in turn."""
        results = [[] for _ in measures]
        for _ in range(repeats):
            for values, measure in zip(results, measures):
                values.append(measure())
        return results

    def schemes(self):
        """One thread, the paper's column, at rest and as it flows."""
        for warm, state in ((0, "at the start"), (3000, "at 2 s, flowing")):
            for scheme in SCHEMES:
                rates = [self.bench_warm(scheme, warm) for _ in range(REPEATS)]
                self.enter(f"{scheme}, column of 40 000 points, one thread, {state}", rates, "M point-steps/s", 1e-6)

    def bench_warm(self, scheme, warm):
        return self.point_steps([self.terp, "bench", COLUMN, "-j", "1", "--steps", "200", "--warm", str(warm or 50),
                                 "--set", f"scheme={scheme}"])

    def threads(self):
        """Two threads against one; and against one when another process is busy."""
        one, two = self.in_turn(self.bench, lambda: self.bench(threads=2))
        self.enter("2 threads over 1", [b / a for a, b in zip(one, two)], "x")
        busy = subprocess.Popen(["sh", "-c", "while :; do :; done"])
        try:
            one_busy, two_busy = self.in_turn(self.bench, lambda: self.bench(threads=2))
        finally:
            busy.kill()
            busy.wait()
        self.enter("2 threads over 1, with one busy foreign process", [b / a for a, b in zip(one_busy, two_busy)], "x")

    def meshes(self):
        """An unstructured mesh against rectangles, per point-step."""
        for scheme in SCHEMES:
            setting = f"scheme={scheme}"
            rectangles, quads = self.in_turn(lambda: self.bench(settings=[setting]),
                                             lambda: self.bench(UNSTRUCTURED, settings=[setting, "mesh.variant=1"]))
            self.enter(f"unstructured over rectangles, {scheme}", [b / a for a, b in zip(rectangles, quads)], "x")

    def sizes(self):
        """Cost of a point-step against that of 40 000 points."""
        for cell, points, steps in ((0.2, "10 000", 800), (0.05, "160 000", 60), (0.0125, "2 560 000", 8)):
            base, other = self.in_turn(self.bench, lambda: self.bench(steps=steps, settings=[f"mesh.cell={cell}"]))
            self.enter(f"cost of a point-step, {points} points over 40 000", [a / b for a, b in zip(base, other)], "x")

    def memory(self):
        """Largest resident memory of a run of 2.56 million points, everything in it, per point."""
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.Popen([self.terp, "run", COLUMN, "-o", f"{folder}/run", "-q", "--set", "mesh.cell=0.0125",
                                    "--set", "time.end=0.001", "--set", "output.fields.every=0.001"])
            _, status, usage = os.wait4(run.pid, 0)  # of this process alone
        if status != 0:
            raise SystemExit("the run for the memory failed")
        peak = usage.ru_maxrss * 1024
        self.enter("memory of a run of 2 560 000 points", [peak / 2.56e6], "bytes per point")

    def output(self):
        """Wall time of the paper's model 2 with output over that without; and with output but the ledger."""
        def wall(settings):
            with tempfile.TemporaryDirectory() as folder:
                command = [self.terp, "run", COLUMN, "-o", f"{folder}/run", "-q", "-j", "1"]
                for setting in settings:
                    command += ["--set", setting]
                start = time.monotonic()
                subprocess.run(command, check=True)
                return time.monotonic() - start
        rare = [f"output.{what}.every=4" for what in ("ledger", "fields", "history", "checkpoint")]
        all_, paper, without = self.in_turn(lambda: wall([]), lambda: wall(rare[:1]), lambda: wall(rare), repeats=11)
        for what, walls in (("fields, history and checkpoints at the paper's rate", paper),
                            ("the same with 100 ledger rows per second", all_)):
            self.enter(f"{what}, of the wall time", [(a - b) / b * 100.0 for a, b in zip(walls, without)], "%")


def write(path, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, ["what", "value", "unit", "low", "high"], lineterminator="\n")
        writer.writeheader()
        writer.writerows({key: f"{v:.4g}" if isinstance(v, float) else v for key, v in row.items()} for row in rows)


def machine_name():
    for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            return "_".join(line.split(":")[1].split()).lower().replace("(r)", "").replace("@", "")
    return platform.machine()


def main():
    helpers = ("bench", "bench_warm", "point_steps", "enter", "in_turn")
    names = [name for name in vars(Sweep) if not name.startswith("_") and name not in helpers]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("terp", nargs="?", type=Path, default=ROOT / "build/terp")
    parser.add_argument("--only", nargs="+", choices=names, default=names, help="what to measure (default: all)")
    parser.add_argument("--machine", default=machine_name(), help="name of the file in benchmarks/results")
    options = parser.parse_args()
    sweep = Sweep(options.terp)
    print(f"{platform.node() and options.machine}, {os.cpu_count()} processors, {datetime.date.today()}; "
          f"median of {REPEATS} (low to high)")
    for name in options.only:
        getattr(sweep, name)()
    if options.only == names:
        write(ROOT / "benchmarks/results" / f"{options.machine}.csv", sweep.rows)


if __name__ == "__main__":
    main()
