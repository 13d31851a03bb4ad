"""A file in the VTKHDF format, type UnstructuredGrid, without time steps: one frame, or a mesh.

A run writes each file under a temporary name and renames it: what is there is whole, and never changes. All arrays
carry checksums, which HDF5 verifies: a damaged one raises RunError. Not for: what the fields mean (run.py).
"""

import os
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import numpy.typing as npt

from terp.errors import RunError

KNOWN_VERSION = 1  # the first number of the version; the second adds what an old reader passes over


def list_frames(folder: Path, kind: str) -> dict[int, Path]:
    """{number: path} of the frames "points" or "mesh" in a run folder, ascending."""
    frames = folder / "frames"
    try:
        names = os.listdir(frames) if frames.is_dir() else []
    except OSError as error:
        raise RunError(f"{frames} cannot be read: {error.strerror}") from error
    found = ((re.fullmatch(rf"{kind}_(\d+)\.vtkhdf", name), frames / name) for name in names)
    return dict(sorted((int(match[1]), path) for match, path in found if match))


class VtkhdfFile:
    """Nothing is kept open: each reading opens the file and closes it."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def head(self) -> tuple[int, float, int, str]:
        """(number, time [s], step, case) of a frame; case: 16 digits that depend on the case of its run."""
        def of(root: Any) -> Any:
            attributes = root.parent.attrs
            number, step = int(attributes["frame"]), int(attributes["step"])
            return number, float(attributes["time"]), step, _text(attributes["case"])
        head: tuple[int, float, int, str] = self.read(of)
        return head

    def attributes(self, data: str, key: str, default: str = "") -> dict[str, str]:
        """{name: text} of attribute `key` of the arrays in `data`, "PointData" or "CellData"."""
        def of(root: Any) -> Any:
            # By the list of links: `in` and `get` take a group that is damaged for one that is not there.
            return {name: _text(array.attrs.get(key, default)) for name, array in root[data].items()
                    } if data in list(root) else {}
        texts: dict[str, str] = self.read(of)
        return texts

    def places(self) -> npt.NDArray[np.float64]:
        """Places of the points [m], shape [n_points, 2]."""
        places: npt.NDArray[np.float64] = self.read(lambda root: root["Points"][:, :2])
        return places

    def values(self, data: str, name: str, rows: Any = slice(None)) -> npt.NDArray[Any]:
        """Array `name` of `data`, shape [n] or [n, n_components], or some of its rows. Numbers of single precision
        become float64."""
        values: npt.NDArray[Any] = self.read(lambda root: root[data][name][rows])
        return values.astype(float) if values.dtype.kind == "f" else values

    def cells(self) -> npt.NDArray[Any]:
        """Corners of the cells, shape [n_cells, n_corners]; all cells have the same number."""
        corners: npt.NDArray[Any] = self.read(
            lambda root: root["Connectivity"][:].reshape(root["NumberOfCells"][0], -1))
        return corners

    def read(self, of: Callable[[Any], Any]) -> Any:
        """of(group /VTKHDF)."""
        try:
            with h5py.File(self.path, "r") as file:
                return of(self._checked_root(file))
        except KeyError as error:
            raise RunError(f"{self.path} lacks a part of the format: {error.args[0]}") from error
        except (AttributeError, OSError, RuntimeError, TypeError, ValueError, IndexError) as error:  # of damaged bytes
            raise RunError(f"{self.path} cannot be read as VTKHDF: {error}") from error

    def _checked_root(self, file: Any) -> Any:
        if "VTKHDF" not in file:
            raise RunError(f"{self.path} cannot be read as VTKHDF: it has no group /VTKHDF")
        root = file["VTKHDF"]
        version = root.attrs.get("Version", (KNOWN_VERSION,))
        if version[0] != KNOWN_VERSION:
            raise RunError(f"{self.path} is of VTKHDF version {'.'.join(str(n) for n in version)}; this terp reads "
                           f"version {KNOWN_VERSION}")
        return root


def _text(value: object) -> str:
    return value.decode() if isinstance(value, bytes) else str(value)
