"""results.vtkhdf and mesh.vtkhdf read by VTK itself, step by step, compared to the bit with what h5py reads.

    check_vtkhdf.py TERP --vtk system|FOLDER     FOLDER: made by fetch_vtk

VTK 9.3 was the first to read steps; an older one reads the first.
Exit status: 0 all equal, 1 a difference, 77 this VTK is missing.
"""

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

HERE = Path(__file__).resolve().parent
CASE = HERE.parents[1] / "cases" / "column_collapse" / "model_2.toml"
SETTINGS = ["mesh.cell=0.5", "time.end=0.3", "output.fields.every=0.1", "output.mesh=true"]
FILES = [("results.vtkhdf", 4, "vtkVertex"), ("mesh.vtkhdf", 4, "vtkQuad")]  # name, steps, class of the cells
NOT_THERE = 77


class CannotRead(Exception):
    """VTK's own words."""


def command_of(vtk):
    """(command that starts the Python of this VTK, its environment), or None if it is not there."""
    environment = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}
    if vtk == "system":
        command = ["/usr/bin/python3"]
        test = [*command, "-c", "import vtkmodules.vtkIOHDF"]
        found = subprocess.run(test, capture_output=True, env=environment).returncode == 0
        return (command, environment) if found else None
    root = Path(vtk).resolve() / "root" / "usr"
    libraries = root / "lib" / "x86_64-linux-gnu"
    pythons = sorted(path for path in root.glob("bin/python3.*") if re.fullmatch(r"python3\.\d+", path.name))
    if not pythons:
        return None
    path = ":".join(str(libraries / part) for part in (".", "openmpi/lib", "blas", "lapack"))
    loader = [libraries / "ld-linux-x86-64.so.2", "--library-path", path, pythons[-1]]
    return [str(part) for part in loader], {**environment, "PYTHONHOME": str(root)}


def read_with_vtk(vtk, path, folder):
    """index.json of read_with_vtk.py, with the arrays' values in place of their files' names."""
    command, environment = vtk
    folder.mkdir()
    said = subprocess.run([*command, HERE / "read_with_vtk.py", path, folder], stderr=subprocess.PIPE, text=True,
                          env=environment)
    if said.returncode != 0:
        raise CannotRead(said.stderr)
    index = json.loads((folder / "index.json").read_text())

    def values(array):
        read = np.frombuffer((folder / array["file"]).read_bytes(), dtype=array["type"])
        return read.reshape(-1, array["components"]) if array["components"] > 1 else read

    for step in index["steps"]:
        for name in ("Points", "Connectivity", "Offsets"):
            step[name] = values(step[name])
        for data in ("PointData", "CellData"):
            step[data] = {name: values(array) for name, array in step[data].items()}
    index["complaints"] = said.stderr
    return index


def version_of(index):
    return tuple(int(part) for part in index["version"].split(".")[:2])


class Checker:
    """Counts what was compared and keeps what differs."""

    def __init__(self):
        self.n = 0
        self.faults = []

    def equal(self, what, got, wanted):
        self.n += 1
        floating = isinstance(wanted, np.ndarray) and wanted.dtype.kind == "f"
        same = np.array_equal(got, wanted, equal_nan=floating)
        if not same:
            self.faults.append(f"{what}: VTK has {np.asarray(got)!s:.80}, the file {np.asarray(wanted)!s:.80}")


def rows(values, k, size):
    """Step k of a table of all steps, or one for all; not by the file's own offsets, which may be wrong."""
    first = k * size if len(values) > size else 0
    return values[first:first + size]


def compare(index, path, n_steps, cell):
    """Every array of every step that this VTK knows; n_steps: 0 for a file without time; cell: class of all cells."""
    check = Checker()
    with h5py.File(path) as file:
        root = file["VTKHDF"]
        check.equal("steps in the file", "Steps" in root and root["Steps"].attrs["NSteps"], n_steps or False)
        if version_of(index) >= (9, 3):
            check.equal("complaints", index["complaints"], "")
            check.equal("times", index["times"], root["Steps/Values"][:] if n_steps else [])
        else:
            check.equal("steps of a VTK that knows no time", len(index["steps"]), 1)
        for k, step in enumerate(index["steps"]):
            compare_step(check, root, k, step, cell)
    return check


def compare_step(check, root, k, step, cell):
    n, n_cells = int(root["NumberOfPoints"][0]), int(root["NumberOfCells"][0])
    check.equal(f"step {k}: class", step["class"], "vtkUnstructuredGrid")
    check.equal(f"step {k}: points and cells", [step["points"], step["cells"]], [n, n_cells])
    check.equal(f"step {k}: type of cells", step["types"], [cell])
    check.equal(f"step {k}: Connectivity", step["Connectivity"], root["Connectivity"][:])
    check.equal(f"step {k}: Offsets", step["Offsets"], root["Offsets"][:])
    check.equal(f"step {k}: Points", step["Points"], rows(root["Points"], k, n))
    for data, size in (("PointData", n), ("CellData", n_cells)):
        names = set(root[data]) if data in root else set()
        check.equal(f"step {k}: names of {data}", set(step[data]), names)
        for name in names & set(step[data]):
            check.equal(f"step {k}: {name}", step[data][name], rows(root[data][name], k, size))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("terp", type=Path)
    parser.add_argument("--vtk", default="system", help="system, or a folder made by fetch_vtk")
    options = parser.parse_args()
    vtk = command_of(options.vtk)
    if vtk is None:
        print(f"not checked: no VTK in {options.vtk}; `make vtk` brings some "
              "(Debian 12's own: apt-get install python3-vtk9)")
        return NOT_THERE
    with tempfile.TemporaryDirectory() as scratch:
        run = Path(scratch) / "run"
        changes = [word for setting in SETTINGS for word in ("--set", setting)]
        subprocess.run([options.terp, "run", CASE, "-o", run, "-q", *changes], check=True)
        return max([check_file(vtk, run / name, Path(scratch) / name, n_steps, cell) for name, n_steps, cell in FILES])


def check_file(vtk, path, scratch, n_steps, cell):
    """Exit status of one file."""
    try:
        index = read_with_vtk(vtk, path, scratch)
    except CannotRead as error:
        print(f"VTK cannot read {path.name}: {error}")
        return 1
    check = compare(index, path, n_steps, cell)
    print(f"VTK {index['version']}, {path.name}: {len(index['steps'])} steps, {check.n} comparisons, "
          f"{len(check.faults)} differ")
    for fault in check.faults:
        print("  " + fault)
    return 1 if check.faults else 0


if __name__ == "__main__":
    sys.exit(main())
