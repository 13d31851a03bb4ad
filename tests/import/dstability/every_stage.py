#!/usr/bin/env python3
"""Imports and checks every stage of D-Stability files at the defaults, without a hand.

    every_stage.py TERP FILE.stix... [--cell H] [--strength design] [--table]

Prints a line for each stage: whether it was imported and passes `terp check`, and what either warns of. --table writes
the lines as a table of Markdown. Exit status 1: a stage was refused, or its case.
"""
import argparse
import json
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path


def warnings_of(text):
    """First lines of the warnings, without the place in the file."""
    return [re.sub(r"^\S*case\.toml:\d+:\d+: ", "", line[len("warning: "):])
            for line in text.splitlines() if line.startswith("warning: ")]


def stages_of(terp, path):
    """(scenario, stage, label), numbers from 1."""
    listing = json.loads(subprocess.run([terp, "import", path, "--json"], check=True, capture_output=True).stdout)
    return [(s, k, stage["label"]) for s, scenario in enumerate(listing["scenarios"], 1)
            for k, stage in enumerate(scenario["stages"], 1)]


def look_at(terp, path, scenario, stage, options):
    """Whether the stage is imported and checked, the number of points, doubts, and seconds."""
    began = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        made = subprocess.run([terp, "import", path, "--scenario", str(scenario), "--stage", str(stage), "-o", folder,
                               "--force", *options], capture_output=True, text=True)
        if made.returncode != 0:
            return False, "", [made.stderr.strip()], time.monotonic() - began
        seen = subprocess.run([terp, "check", folder + "/case.toml"], capture_output=True, text=True)
        points = re.search(r"^  points +(\d+)", seen.stdout, re.MULTILINE)
        doubts = warnings_of(made.stderr) + [w for w in warnings_of(seen.stderr) if w != "the import was in doubt"]
        if seen.returncode != 0:
            doubts.append(seen.stderr.strip())
        return seen.returncode == 0, points.group(1) if points else "", doubts, time.monotonic() - began


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("terp")
    parser.add_argument("files", nargs="+")
    parser.add_argument("--cell")
    parser.add_argument("--strength")
    parser.add_argument("--table", action="store_true")
    arguments = parser.parse_args()
    options = [text for name in ("cell", "strength") if getattr(arguments, name)
               for text in (f"--{name}", getattr(arguments, name))]
    failed = 0
    for path in arguments.files:
        for scenario, stage, label in stages_of(arguments.terp, path):
            good, points, doubts, seconds = look_at(arguments.terp, path, scenario, stage, options)
            failed += not good
            row = [Path(path).stem, f"{scenario}.{stage}", label, "yes" if good else "NO", points, f"{seconds:.1f} s",
                   "; ".join(doubts) or "none"]
            print("| " + " | ".join(row) + " |" if arguments.table else "  ".join(row), flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
