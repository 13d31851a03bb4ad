"""Frames as .vtu files of VTK, whose components have names: of the stress xx, yy, zz, xy. A VTKHDF file has no place
for names.
"""

from __future__ import annotations

import base64
import os
import pathlib
from typing import TYPE_CHECKING, Any
from xml.sax.saxutils import quoteattr

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from terp.results import Frame

TYPES = {"f8": "Float64", "f4": "Float32", "i8": "Int64", "u1": "UInt8"}
VERTEX = 1  # VTK_VERTEX of vtkCellType.h


def write_vtu(frame: Frame, file: str | os.PathLike[str]) -> None:
    """The soil of a frame, a vertex for each point; `TimeValue` is its time [s]."""
    soil = frame.soil
    places = np.column_stack([frame.x[soil], np.zeros(int(soil.sum()))])
    n = len(places)
    fields = [_array(name, frame[name][soil], "<f4", frame.run.components.get(name, ()))
              for name in frame.run.fields if name != "position"]
    cells = [_array("connectivity", np.arange(n), "<i8"), _array("offsets", np.arange(1, n + 1), "<i8"),
             _array("types", np.full(n, VERTEX), "<u1")]
    pathlib.Path(file).write_text("\n".join([
        '<?xml version="1.0"?>',
        '<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">',
        "<UnstructuredGrid>", "<FieldData>",
        f'<DataArray type="Float64" Name="TimeValue" NumberOfTuples="1" format="ascii">{frame.time!r}</DataArray>',
        "</FieldData>", f'<Piece NumberOfPoints="{n}" NumberOfCells="{n}">',
        "<PointData>", *fields, "</PointData>",
        "<Points>", _array("Points", places, "<f8", ("x", "y", "z")), "</Points>",
        "<Cells>", *cells, "</Cells>",
        "</Piece>", "</UnstructuredGrid>", "</VTKFile>", ""]), encoding="utf-8")


def _array(name: str, values: npt.NDArray[Any], kind: str, components: tuple[str, ...] = ()) -> str:
    """Length in bytes and values, in base 64."""
    data = np.ascontiguousarray(values, dtype=kind).tobytes()
    names = "".join(f' ComponentName{k}="{component}"' for k, component in enumerate(components))
    shape = f' NumberOfComponents="{len(components)}"' if components else ""
    head = f'type="{TYPES[kind[1:]]}" Name={quoteattr(name)}{shape}{names} format="binary"'
    return f'<DataArray {head}>{base64.b64encode(len(data).to_bytes(8, "little") + data).decode()}</DataArray>'
