#!/usr/bin/env python3
"""The program of the page against the native one on the SSE2 kernels: model 1 of the paper must be equal byte for byte,
in its tables and frames, also where it is solved in parts, as a page does.

usage: same_numbers.py TERP TERP.js [--end S]     exit status 77: one of the two is not there
"""
import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SKIPPED = 77
TABLES = ("ledger.csv", "history.csv", "frames/points_00000.vtkhdf", "frames/points_00001.vtkhdf")


def differences(native, page):
    for name in TABLES:
        if not (native / name).exists() or (native / name).read_bytes() != (page / name).read_bytes():
            yield name


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("terp")
    parser.add_argument("script")
    parser.add_argument("--end", default="0.1")
    options = parser.parse_args()
    if not Path(options.script).exists() or not shutil.which("node"):
        print(f"no {options.script}: `make browser` builds it")
        return SKIPPED
    words = ["run", "model_1.toml", "--force", "--set", f"time.end={options.end}",
             "--set", f"output.fields.every={options.end}", "-q", "-o"]
    with tempfile.TemporaryDirectory() as folder:
        case = Path(folder, "model_1.toml")
        shutil.copy(ROOT / "cases/column_collapse/model_1.toml", case)
        native = subprocess.run([options.terp, *words, "native", "-j", "1"], cwd=folder, text=True, capture_output=True,
                                env={**os.environ, "TERP_INSTRUCTIONS": "sse2"})
        if "no such set in this build" in native.stderr:
            print("the native program was built without the SSE2 kernels")
            return SKIPPED
        native.check_returncode()
        failed = []
        for name, part in (("whole", "Infinity"), ("in_parts", "0.013")):
            subprocess.run(["node", ROOT / "tests/browser/run_in_node.mjs", options.script, folder, "--", *words, name],
                           env={**os.environ, "PART_S": part}, check=True)
            failed += [f"{name}: {table} differs" for table in differences(Path(folder, "native"), Path(folder, name))]
    print("\n".join(failed) or f"{len(TABLES)} files are equal, twice")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
