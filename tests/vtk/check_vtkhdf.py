"""Frames and mesh of a run read by VTK itself, against the values that h5py finds in the files, to the bit.

    check_vtkhdf.py TERP --vtk system|FOLDER     FOLDER: made by fetch_vtk

Exit status: 0 all equal, 1 a difference, 77 this VTK is not there.
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
CELLS = {"frames/points_*.vtkhdf": "vtkVertex", "frames/mesh_*.vtkhdf": "vtkQuad", "mesh.vtkhdf": "vtkQuad"}
N_FILES = 9  # four frames of each kind, and the mesh
NOT_THERE = 77


class CannotRead(Exception):
    """VTK's own words."""


def command_of(vtk):
    """(command that starts the Python of this VTK, its environment), or None if it is not there."""
    environment = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}
    if vtk == "system":
        command = ["/usr/bin/python3"]
        found = subprocess.run([*command, "-c", "import vtkmodules.vtkIOHDF"], capture_output=True,
                               env=environment).returncode == 0
        return (command, environment) if found else None
    root = Path(vtk).resolve() / "debian" / "usr"
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

    for name in ("Points", "Connectivity", "Offsets"):
        index[name] = values(index[name])
    for data in ("PointData", "CellData"):
        index[data] = {name: values(array) for name, array in index[data].items()}
    index["complaints"] = said.stderr
    return index


class Checker:
    """Counts what was compared and keeps what differs."""

    def __init__(self):
        self.n = 0
        self.faults = []

    def equal(self, what, got, wanted):
        self.n += 1
        has_nan = isinstance(wanted, np.ndarray) and wanted.dtype.kind == "f"
        same = np.array_equal(got, wanted, equal_nan=has_nan)
        if not same:
            self.faults.append(f"{what}: VTK has {np.asarray(got)!s:.80}, the file {np.asarray(wanted)!s:.80}")


def compare(index, path, cell):
    """Every array of the file; cell: class of all cells."""
    check = Checker()
    with h5py.File(path) as file:
        root = file["VTKHDF"]
        check.equal("complaints", index["complaints"], "")
        check.equal("class", index["class"], "vtkUnstructuredGrid")
        check.equal("points and cells", [index["points"], index["cells"]], [root["NumberOfPoints"][0],
                                                                            root["NumberOfCells"][0]])
        check.equal("type of cells", index["types"], [cell])
        for name in ("Connectivity", "Offsets", "Points"):
            check.equal(name, index[name], root[name][:])
        for data in ("PointData", "CellData"):
            check.equal(f"names of {data}", set(index[data]), set(root.get(data, ())))
            for name, values in index[data].items():
                check.equal(name, values, root[data][name][:])
    return check


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("terp", type=Path)
    parser.add_argument("--vtk", default="system", help="system, or a folder made by fetch_vtk")
    options = parser.parse_args()
    vtk = command_of(options.vtk)
    if vtk is None:
        print(f"not checked: no VTK in {options.vtk}; `make vtk` brings some (or: apt-get install python3-vtk9)")
        return NOT_THERE
    with tempfile.TemporaryDirectory() as scratch:
        run = Path(scratch) / "run"
        changes = [word for setting in SETTINGS for word in ("--set", setting)]
        subprocess.run([options.terp, "run", CASE, "-o", run, "-q", *changes], check=True)
        files = [(path, cell) for pattern, cell in CELLS.items() for path in sorted(run.glob(pattern))]
        faults = [fault for k, (path, cell) in enumerate(files) for fault in check_file(vtk, path,
                                                                                        Path(scratch) / str(k), cell)]
    if len(files) != N_FILES:
        faults.append(f"there are {len(files)} files, not {N_FILES}")
    print(f"{len(files)} files, {len(faults)} faults")
    for fault in faults:
        print("  " + fault)
    return 1 if faults else 0


def check_file(vtk, path, scratch, cell):
    """What differs in one file."""
    try:
        index = read_with_vtk(vtk, path, scratch)
    except CannotRead as error:
        return [f"VTK cannot read {path.name}: {error}"]
    check = compare(index, path, cell)
    print(f"VTK {index['version']}, {path.name}: {check.n} comparisons, {len(check.faults)} differ")
    return [f"{path.name}: {fault}" for fault in check.faults]


if __name__ == "__main__":
    sys.exit(main())
