"""What `terp export` writes, read by VTK, numpy and csv, compared to the bit with what h5py reads in results.vtkhdf.

    check_export.py TERP

Exit status: 0 all equal, 1 a difference, 77 the system has no VTK.
"""

import csv
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError:
    sys.exit(77)

CASE = Path(__file__).resolve().parents[2] / "cases" / "column_collapse" / "model_2.toml"
SETTINGS = ["mesh.cell=0.5", "time.end=0.2", "output.fields.every=0.1"]


def call(*words):
    subprocess.run([str(word) for word in words], check=True, stdout=subprocess.DEVNULL)


def read_vtu(path):
    """Places, fields and time of a frame."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    assert grid.GetNumberOfCells() == grid.GetNumberOfPoints() and grid.GetCellType(0) == 1
    data = grid.GetPointData()
    fields = {data.GetArrayName(k): vtk_to_numpy(data.GetArray(k)) for k in range(data.GetNumberOfArrays())}
    assert data.GetArray("stress").GetComponentName(3) == "xy"
    time = grid.GetFieldData().GetArray("TimeValue").GetValue(0)
    return vtk_to_numpy(grid.GetPoints().GetData())[:, :2], fields, time


def check_frame(folder, k, time, x, fields):
    name = f"frame_{k:05}"
    places, read, at = read_vtu(folder / "vtu" / f"{name}.vtu")
    assert at == time and np.array_equal(places, x) and set(read) == {"id", *fields}
    assert all(np.array_equal(read[field], values, equal_nan=True) for field, values in fields.items())
    with np.load(folder / "npz" / f"{name}.npz") as arrays:
        assert float(arrays["time"]) == time and np.array_equal(arrays["x"], x)
        assert all(np.array_equal(arrays[field], values, equal_nan=True) for field, values in fields.items())
    rows = list(csv.DictReader((folder / "csv" / f"{name}.csv").open()))
    assert np.array_equal([[float(row["x"]), float(row["y"])] for row in rows], x)
    assert np.array_equal([float(row["stress_yy"]) for row in rows], fields["stress"][:, 1])


def main(terp):
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch) / "run"
        call(terp, "run", CASE, "-q", "-j", 1, "-o", folder,
             *(word for setting in SETTINGS for word in ("--set", setting)))
        for form in ("vtu", "csv", "npz"):
            call(terp, "export", folder, "--format", form)
        with h5py.File(folder / "results.vtkhdf") as file:
            root = file["VTKHDF"]
            times, n = root["Steps/Values"][:], int(root["NumberOfPoints"][0])
            assert len(times) == 3
            for k, time in enumerate(times):
                rows = slice(k * n, (k + 1) * n)
                fields = {name: root["PointData"][name][rows] for name in root["PointData"] if name != "id"}
                check_frame(folder, k, time, root["Points"][rows, :2], fields)
        assert (folder / "vtu" / "frames.pvd").read_text().count("<DataSet ") == 3
        print(f"{len(times)} frames of {n} points: vtu, npz and csv hold what is in results.vtkhdf")


if __name__ == "__main__":
    main(sys.argv[1])
