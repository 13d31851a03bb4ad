"""What VTK's own reader makes of a file, for check_vtkhdf.py. Runs in the Python of any VTK from 9.1 on, without numpy.

    python3 read_with_vtk.py FILE.vtkhdf FOLDER

Writes FOLDER/index.json: version of VTK, times, and for each step its sizes and arrays. The values of array number k
are in FOLDER/k.bin in the byte order of the machine. Complaints of VTK go to the standard error stream.
"""

import json
import sys
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkIOHDF import vtkHDFReader

INTEGERS = {"long", "long long", "vtkIdType"}


def main(path, folder):
    reader = vtkHDFReader()
    reader.SetFileName(str(path))
    reader.UpdateInformation()
    information = reader.GetOutputInformation(0)
    steps = Pipeline.TIME_STEPS()
    times = [information.Get(steps, k) for k in range(information.Length(steps))] if information.Has(steps) else []
    writer = Writer(folder)
    read = [writer.step(update(reader, time)) for time in times or [None]]
    index = {"version": vtkVersion.GetVTKVersion(), "times": times, "steps": read}
    (folder / "index.json").write_text(json.dumps(index))


def update(reader, time):
    """The data set at `time`; None: of a reader that knows no time."""
    reader.Update() if time is None else reader.UpdateTimeStep(time)
    return reader.GetOutputDataObject(0)


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
        return {"file": name, "type": "int64" if kind in INTEGERS
                else {"double": "float64", "unsigned char": "uint8"}[kind],
                "components": values.GetNumberOfComponents()}

    def step(self, grid):
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
