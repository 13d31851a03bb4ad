#!/usr/bin/env python3
"""Whether two programs give the same bits: ledger, history, frames and checkpoints of the rows in rows.toml, byte by
byte, on each instruction set that this machine offers. For changes that must not change a result.

usage: tests/bits/compare.py BASE NEW [--rows NAME ...] [--sets avx512 avx2 sse2] [-j 2] [--keep FOLDER]
BASE, NEW: programs of terp. Exit status 0: all the same, 1: some are not, or a run failed.
"""
import argparse
import concurrent.futures
import os
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
CASES = HERE.parent.parent / "cases"
LEFT_OUT = {"summary.json", "case.toml"}  # wall time; the text of the user


def with_set(instructions):
    return {**os.environ, "TERP_INSTRUCTIONS": instructions}


def solve(program, row, instructions, folder):
    """Runs a row into a folder; returns why it failed, or nothing."""
    command = [program, "run", str(CASES / row["case"]), "-o", str(folder), "-j", "1"]
    for change in row.get("set", []):
        command += ["--set", change]
    done = subprocess.run(command, capture_output=True, text=True, env=with_set(instructions))
    return "" if done.returncode in (0, 3) else done.stderr.strip()[:300]


def files_of(folder):
    return {p.relative_to(folder).as_posix(): p.read_bytes() for p in sorted(folder.rglob("*"))
            if p.is_file() and p.name not in LEFT_OUT}


def differences(row, instructions, base, new, keep):
    """Lines that say what differs in a row."""
    with tempfile.TemporaryDirectory(dir=keep) as scratch:
        folders = [Path(scratch) / name for name in ("base", "new")]
        for program, folder in zip((base, new), folders):
            if fault := solve(program, row, instructions, folder):
                return [f"{program} failed: {fault}"]
        a, b = map(files_of, folders)
        if not any(name.endswith(".h5") for name in a):
            return ["the run wrote no checkpoint"]
        return ([f"{name} is missing in one of them" for name in sorted(a.keys() ^ b.keys())]
                + [f"{name} differs" for name in sorted(a.keys() & b.keys()) if a[name] != b[name]])


def sets_here(program):
    """Instruction sets that the program and this processor offer."""
    return [s for s in ("avx512", "avx2", "sse2")
            if subprocess.run([program, "list"], capture_output=True, env=with_set(s)).returncode == 0]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("base")
    parser.add_argument("new")
    parser.add_argument("--rows", nargs="*")
    parser.add_argument("--sets", nargs="*")
    parser.add_argument("-j", type=int, default=2)
    parser.add_argument("--keep", help="folder for scratch files")
    options = parser.parse_args()
    rows = tomllib.loads((HERE / "rows.toml").read_text())["row"]
    if options.rows:
        rows = [row for row in rows if row["name"] in options.rows]
    wanted = options.sets or sets_here(options.new)
    jobs = [(row, s) for row in rows for s in wanted]
    bad = 0
    with concurrent.futures.ThreadPoolExecutor(options.j) as pool:
        found = pool.map(lambda job: differences(*job, options.base, options.new, options.keep), jobs)
        for (row, instructions), lines in zip(jobs, found):
            print(f"{row['name']:28} {instructions:7} {'same' if not lines else '; '.join(lines[:4])}", flush=True)
            bad += bool(lines)
    print(f"{len(jobs) - bad} of {len(jobs)} the same")
    return 1 if bad or not jobs else 0


if __name__ == "__main__":
    sys.exit(main())
