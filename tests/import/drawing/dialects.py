#!/usr/bin/env python3
"""One section, drawn in many ways by ezdxf in the dialects of DXF, and read.

    dialects.py TERP [--keep FOLDER]

The section has a dike (40.5 m2) on clay (80 m2) on sand (100 m2). Each way of drawing it is written as R12, 2000, 2010
and 2018, where that release has it, and gives these areas. A way that a bent line changes has its own areas; a way that
cannot be read has a word of its message.
"""
import argparse
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import ezdxf

import ways_beside  # noqa: F401  (puts its ways into the table)
from ways import WAYS


def areas_of(text):
    """Name and area of each region, from the list that `terp import` prints."""
    found = {}
    for name, area in re.findall(r"^(\S.*?) +([0-9.]+) +\d+ +\S+ to ", text, re.M):
        found[name] = found.get(name, 0.0) + float(area)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("terp")
    parser.add_argument("--keep", metavar="FOLDER", help="leave the drawings there")
    parser.add_argument("--only", metavar="NAME", help="of one way")
    options = parser.parse_args()
    folder = Path(options.keep or tempfile.mkdtemp())
    folder.mkdir(parents=True, exist_ok=True)
    failed = tried = 0
    for name, (draw, releases, insunits, given, areas, refused, warned) in WAYS.items():
        if options.only and name != options.only:
            continue
        for release in releases:
            document = ezdxf.new(release)
            document.header["$INSUNITS"] = insunits
            draw(document.modelspace())
            path = folder / f"{name}_{release}.dxf"
            document.saveas(path)
            more = given
            if release == "R12" and not more and insunits:  # whose header has no unit
                more = ("--unit", {6: "m", 4: "mm", 2: "ft"}[insunits])
            done = subprocess.run([options.terp, "import", path, *more], capture_output=True, text=True)
            tried += 1
            if refused:
                good = done.returncode == 2 and refused in done.stderr
            else:
                found = areas_of(done.stdout)
                good = done.returncode == 0 and warned in done.stderr and found.keys() == areas.keys() and all(
                    abs(found[soil] - areas[soil]) <= 0.006 * areas[soil] + 0.005 for soil in areas)
            if not good:
                failed += 1
                print(f"{path.name}: status {done.returncode}\n{done.stdout}{done.stderr}")
    print(f"{tried} drawings, {failed} failed")
    return 1 if failed or not tried else 0


if __name__ == "__main__":
    sys.exit(main())
