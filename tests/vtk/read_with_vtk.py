"""What VTK's own reader makes of a file, for check_vtkhdf.py. Runs in the Python of any VTK from 9.1 on, which
need not have numpy.

    python3 read_with_vtk.py FILE.vtkhdf FOLDER

Writes FOLDER/index.json: version of VTK, sizes and arrays. The values of array number k lie in FOLDER/k.bin, in the
byte order of the machine. What VTK complains about goes to the standard error stream.
"""

import json
import sys
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkIOHDF import vtkHDFReader

INTEGERS = {"long", "long long", "vtkIdType"}
TYPES = {"double": "float64", "float": "float32", "int": "int32", "unsigned char": "uint8"}


def main(path, folder):
    reader = vtkHDFReader()
    reader.SetFileName(str(path))
    reader.Update()
    index = {"version": vtkVersion.GetVTKVersion(), **Writer(folder).grid(reader.GetOutputDataObject(0))}
    (folder / "index.json").write_text(json.dumps(index))


class Writer:
    """Puts arrays into files of their own."""

    def __init__(self, folder):
        self.folder = folder
        self.n = 0

    def array(self, values):
        """{file, type, components} of a vtkDataArray."""
        name = f"{self.n}.bin"
        self.n += 1
        (self.folder / name).write_bytes(bytes(memoryview(values)))
        kind = values.GetDataTypeAsString()
        return {"file": name, "type": "int64" if kind in INTEGERS else TYPES[kind],
                "components": values.GetNumberOfComponents()}

    def grid(self, grid):
        def fields(data):
            return {data.GetArrayName(k): self.array(data.GetArray(k)) for k in range(data.GetNumberOfArrays())}
        cells = grid.GetCells()
        types = {grid.GetCell(k).GetClassName() for k in range(grid.GetNumberOfCells())}
        return {"class": grid.GetClassName(), "points": grid.GetNumberOfPoints(), "cells": grid.GetNumberOfCells(),
                "types": sorted(types),
                "Points": self.array(grid.GetPoints().GetData()),
                "Connectivity": self.array(cells.GetConnectivityArray()),
                "Offsets": self.array(cells.GetOffsetsArray()), "PointData": fields(grid.GetPointData()),
                "CellData": fields(grid.GetCellData())}


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
