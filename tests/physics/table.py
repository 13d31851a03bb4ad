#!/usr/bin/python3
"""Prints the table of sound physics: what must rest rests, what must slide slides, no energy comes from nothing.

    table.py [--terp build/terp] [--seed 1] [--rows NAME ...] [--share 1] [--jobs 2] [--set KEY=VALUE] [--keep FOLDER]

One line per variant of a row: verdict, row, factors, each number with its bounds, processor time. Verdicts: `pass`;
`open`: known red, no worse than open.toml says; `FAIL`; `info`: nothing to judge. README.md says how rows are made.
Exit status: 0 if nothing failed, else 1.
"""
import argparse
import math
import random
import shutil
import sys
import tempfile
import tomllib
import traceback
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import rows_energy
import rows_ground
import rows_sand
from row import ROWS, Measure
from runs import Variant

HERE = Path(__file__).parent
MARGIN = 0.25  # an open number may be worse than its size by this part before it fails: other seeds, other meshes
MODULES = (rows_ground, rows_sand, rows_energy)  # they enter their rows


def open_entry(entries, name, factors, measure):
    """The entry of open.toml for a number that does not pass."""
    for entry in entries:
        where = entry.get("where", {})
        if entry["row"] == name and entry["measure"] == measure.name:
            if all(factors.get(key) in (value if isinstance(value, list) else [value]) for key, value in where.items()):
                return entry
    return None


def judge(entries, name, factors, measures):
    """Verdict over all numbers of a variant, and the entries of open.toml that it needed."""
    verdicts, needed = set(), []
    for measure in measures:
        if measure.passes():
            verdicts.add("pass" if measure.judged() else "info")
            continue
        entry = open_entry(entries, name, factors, measure)
        needed += [id(entry)] if entry else []
        verdicts.add("open" if entry and not measure.excess(entry["size"], MARGIN) else "FAIL")
    return next(verdict for verdict in ("FAIL", "open", "pass", "info") if verdict in verdicts), needed


def chosen(options):
    """(row, number of the variant, factors) of all that is solved, as the seed says."""
    work = []
    for name, row in ROWS.items():
        if options.rows and name not in options.rows:
            continue
        variants = list(enumerate(row.variants(options.seed)))
        if len(variants) == 1 and options.share < 1 and name not in (options.rows or []):
            continue  # the finest cells: minutes each
        count = math.ceil(options.share * len(variants) - 1e-9)
        taken = sorted(random.Random(f"{options.seed}/{name}/share").sample(range(len(variants)), count))
        work += [(row, *variants[k]) for k in taken]
    return work


def solve(options, folder, row, number, factors):
    """Measures of one variant, its processor time, and why there are none."""
    place = folder / row.name / str(number)
    variant = Variant(options.terp, place, random.Random(f"{options.seed}/{row.name}/{number}"), options.set, factors)
    try:
        measures = row.solve(variant)
        if variant.stops:
            measures.append(Measure("stopped runs", len(variant.stops), at_most=0))
        return measures, variant.cpu, variant.stops
    except Exception:
        return [], variant.cpu, variant.stops + [traceback.format_exc()]
    finally:
        if not options.keep:
            shutil.rmtree(place, ignore_errors=True)


def line(verdict, row, number, factors, measures, cpu):
    words = " ".join(f"{value}" if key in ("scheme", "shares", "kind") else f"{key}={value}"
                     for key, value in factors.items())
    return f"{verdict:5}{row.name} {number} [{words}] " + "; ".join(map(str, measures)) + f"  ({cpu:.1f} s)"


def main():
    parser = argparse.ArgumentParser(description="Prints the table of sound physics.")
    parser.add_argument("--terp", type=Path, default=HERE.parents[1] / "build/terp", metavar="PATH", help="the program")
    parser.add_argument("--seed", default="1", help="of meshes, places and of what is combined with what")
    parser.add_argument("--rows", nargs="+", choices=list(ROWS), metavar="NAME", help=f"of {', '.join(ROWS)}")
    parser.add_argument("--share", type=float, default=1.0, help="part of the variants of each row; 0.1 in CI")
    parser.add_argument("--jobs", type=int, default=2, help="runs at a time, of one thread each")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="for every run")
    parser.add_argument("--keep", type=Path, metavar="FOLDER", help="keep cases and results")
    options = parser.parse_args()
    options.terp = options.terp.resolve()
    entries = tomllib.loads((HERE / "open.toml").read_text()).get("open", [])
    counts, spent, seen = Counter(), Counter(), set()
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(options.jobs) as pool:
        folder = (options.keep or Path(scratch)).resolve()
        work = chosen(options)
        done = pool.map(lambda part: solve(options, folder, *part), work)
        for (row, number, factors), (measures, cpu, stops) in zip(work, done):
            if measures:
                verdict, needed = judge(entries, row.name, factors, measures)
            else:
                verdict, needed = "FAIL", []
            counts[verdict] += 1
            spent[row.name] += cpu
            seen.update(needed)
            print("\n     ".join([line(verdict, row, number, factors, measures, cpu), *stops]), flush=True)
    print("\nprocessor time [s]: " + ", ".join(f"{name} {time:.0f}" for name, time in spent.items()))
    rows_run = {row.name for row, _, _ in work}
    better = [entry for entry in entries if entry["row"] in rows_run and id(entry) not in seen]
    for entry in better if options.share == 1 else ():
        print(f"better than open.toml says: {entry}")
    print(f"{counts['pass']} passed, {counts['FAIL']} failed, {counts['open']} open, {counts['info']} not judged, "
          f"{sum(spent.values()):.0f} s of processor time, seed {options.seed}")
    return 1 if counts["FAIL"] else 0


if __name__ == "__main__":
    sys.exit(main())
