"""One run folder as numpy arrays and dictionaries.

Not for drawing (plot.py) and not for judging a run: it hands out what the solver wrote, in SI units, and computes
nothing anew.
"""

from __future__ import annotations

import functools
import json
import os
import tomllib
import typing
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from terp.errors import RunError, unknown
from terp.results import Frame, Results
from terp.tables import read_table
from terp.vtkhdf import VtkhdfFile, list_frames
from terp.written import check_end, check_unaltered

MESH = "mesh.vtkhdf"
SAME_PLACE = 1e-9  # distances that differ by less are those of one lattice [m]


class Mesh:
    """The background mesh, and, of a run with `output.mesh = true`, what it carries."""

    def __init__(self, file: VtkhdfFile, frames: list[FrameFile]) -> None:
        self.nodes = file.places()  # [m], shape [n_nodes, 2]
        self.cells = file.cells()   # corners, counter-clockwise, shape [n_cells, 4]
        self._path = file.path
        self._frames = frames
        self.times = np.array([frame.time for frame in frames])  # of its frames [s]: those of the run, or none

    @functools.cached_property
    def units(self) -> dict[str, str]:
        """{field: unit}, of nodes and cells."""
        if not self._frames:
            return {}
        return {**self._frames[0].file.attributes("PointData", "unit"), **self._frames[0].file.attributes("CellData",
                                                                                                          "unit")}

    def field(self, name: str, k: int) -> npt.NDArray[Any]:
        """Field `name` of frame k: "mass" [n_nodes], "velocity" [n_nodes, 3], "pressure" [n_cells]."""
        if name not in self.units:
            raise unknown(name, sorted(self.units), "field", self._path)
        file = self._frames[k].file
        return file.values("CellData" if name in file.attributes("CellData", "unit") else "PointData", name)


class FrameFile(typing.NamedTuple):
    """A frame that is there and whose head can be read."""

    file: VtkhdfFile
    time: float  # [s]


def read_frames(folder: Path, kind: str) -> list[FrameFile]:
    """The frames "points" or "mesh" of a run folder. Those that are missing or damaged are left out with a warning."""
    frames, case, due = [], None, 0
    for number, path in list_frames(folder, kind).items():
        for missing in range(due, number):
            warnings.warn(f"{folder / 'frames'} lacks frame {missing} of the {kind}", stacklevel=3)
        due = number + 1
        try:
            own_number, time, _, own_case = VtkhdfFile(path).head()
        except RunError as error:
            warnings.warn(f"left out: {error}", stacklevel=3)
            continue
        if own_number != number:
            warnings.warn(f"left out: {path} is frame {own_number} by what is written in it", stacklevel=3)
            continue
        if case not in (None, own_case):
            raise RunError(f"{path} is of a run of another case than the frames before it")
        case = own_case
        frames.append(FrameFile(VtkhdfFile(path), time))
    return frames


class Run(Results):
    """The results in one run folder. Each file is read when it is first asked for, and what was read is kept:
    `refresh` lets go of it, for a run that is still going."""

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        self.folder = Path(folder)
        if not self.folder.is_dir():
            raise RunError(f"there is no run folder {self.folder}")

    def __repr__(self) -> str:
        return f"<terp run {self.folder}>"

    def place(self, file: str = "") -> str:
        return str(self.folder / file)

    def refresh(self) -> Run:
        """Forget what was read, so that frames and rows that were added since are seen. Returns the run."""
        kept = [name for name in vars(self) if isinstance(getattr(type(self), name, None), functools.cached_property)]
        for name in kept:
            delattr(self, name)
        return self

    @property
    def finished(self) -> bool:
        """Whether the run reached its end time. A run that is still going, was stopped, or stopped itself, did not."""
        return bool(self.summary.get("finished"))

    @property
    def _has_ended(self) -> bool:
        return (self.folder / "summary.json").is_file() and self.finished

    # Frames

    @functools.cached_property
    def times(self) -> npt.NDArray[np.float64]:
        """Times of the frames [s], shape [n_frames], ascending. Of a run that is going on, those that are there."""
        return np.array([frame.time for frame in self._frames])

    @functools.cached_property
    def units(self) -> dict[str, str]:
        """{field: unit} of the fields that the frames have, and of "position"."""
        return {"position": "m", **self._first_frame.attributes("PointData", "unit", "-")}

    @functools.cached_property
    def components(self) -> dict[str, tuple[str, ...]]:
        """{field: names of its components}, e.g. ("xx", "yy", "zz", "xy"); empty for a scalar."""
        texts = self._first_frame.attributes("PointData", "components")
        return {"position": ("x", "y"), **{name: tuple(text.split()) for name, text in texts.items()}}

    def __len__(self) -> int:
        return len(self.times)

    def frame(self, k: int) -> Frame:
        """Frame k (negative: from the end)."""
        return Frame(self, self._checked_index(k))

    def __iter__(self) -> Iterator[Frame]:
        return (self.frame(k) for k in range(len(self)))

    def field(self, name: str, k: int) -> npt.NDArray[Any]:
        """Field `name` of frame k, shape [n_points] or [n_points, n_components]; of "position" [n_points, 2].

        Row r is the same material point in every frame; `frame(k).soil` says where there is soil of it.
        """
        k = self._checked_index(k)
        self._check_field(name)
        file = self._frames[k].file
        return file.places() if name == "position" else file.values("PointData", name)

    values = field

    @property
    def first_places(self) -> npt.NDArray[np.float64]:
        first = self.frame(0)
        return first.x[first.soil]

    def series(self, name: str, row: int) -> npt.NDArray[Any]:
        """Field `name` of one material point in all frames, shape [n_frames] or [n_frames, n_components]."""
        self._check_field(name)
        n = len(self.field("position", 0))
        if not 0 <= row < n:
            raise IndexError(f"{self.folder} has {n} points; there is no row {row}")
        if name == "position":
            return np.array([self.field("position", k)[row] for k in range(len(self))])
        return np.array([frame.file.values("PointData", name, row) for frame in self._frames])

    def nearest(self, x: float, y: float, time: float = 0.0) -> int:
        """Row of the material point nearest to (x, y) [m] in the frame nearest to `time` [s], of those of which there
        is soil; ties: lower x, then lower y."""
        if not np.isfinite([x, y]).all():
            raise ValueError(f"({x}, {y}) is no place")
        frame = self.frame(self.at(time))
        if not frame.soil.any():
            raise RunError(f"{self.folder} has no soil at t = {frame.time:g} s")
        places = frame.x
        distance = np.where(frame.soil, np.hypot(places[:, 0] - x, places[:, 1] - y), np.inf)
        near = np.flatnonzero(distance <= distance.min() + SAME_PLACE)
        return int(near[np.lexsort((places[near, 1], places[near, 0]))[0]])

    # Tables: history.csv, ledger.csv

    @functools.cached_property
    def history(self) -> npt.NDArray[Any]:
        """Named points over time: structured array with the columns of history.csv."""
        rows = self._table("history.csv")
        if self._has_ended and (self.folder / "ledger.csv").is_file() and len(self.ledger):
            check_end(self.folder / "history.csv", rows, self.ledger["time"][-1])
        return rows

    @functools.cached_property
    def ledger(self) -> npt.NDArray[Any]:
        """Energies, mass, momentum, front and crest over time: structured array with the columns of ledger.csv."""
        return self._table("ledger.csv")

    # Summary, case, mesh

    @functools.cached_property
    def summary(self) -> dict[str, Any]:
        """summary.json as a dictionary. Of a run that is going on, it was written at the start."""
        try:
            summary: dict[str, Any] = json.loads(self._file("summary.json").read_text(encoding="utf-8"))
            return summary
        except ValueError as error:
            raise RunError(f"{self.folder / 'summary.json'} cannot be read: {error}") from error

    @functools.cached_property
    def case_text(self) -> str:
        """The case as it was run: the text of case.toml."""
        return self._file("case.toml").read_text(encoding="utf-8")

    @functools.cached_property
    def case(self) -> dict[str, Any]:
        """The case as a dictionary of its TOML text."""
        try:
            return tomllib.loads(self.case_text)
        except ValueError as error:
            raise RunError(f"{self.folder / 'case.toml'} cannot be read: {error}") from error

    @functools.cached_property
    def mesh(self) -> Mesh:
        """The background mesh."""
        return Mesh(VtkhdfFile(self._file(MESH)), read_frames(self.folder, "mesh"))

    # Inside

    def _known_units(self) -> dict[str, str]:
        return self.units if (self.folder / "frames").is_dir() else {}

    def _table(self, name: str) -> npt.NDArray[Any]:
        path = self._file(name)
        rows = read_table(path)
        check_unaltered(path)
        return rows

    def _file(self, name: str) -> Path:
        path = self.folder / name
        if not path.is_file():
            raise RunError(f"{self.folder} has no {name}; is it the folder of a run, and has that run begun?")
        return path

    @functools.cached_property
    def _frames(self) -> list[FrameFile]:
        if (self.folder / "results.vtkhdf").exists():
            raise RunError(f"{self.folder / 'results.vtkhdf'} holds all frames of a run of an earlier terp (VTKHDF "
                           "2.0); this one reads one file per frame (VTKHDF 1.0): read it with the terp that wrote it")
        if not (self.folder / "frames").is_dir():
            raise RunError(f"{self.folder} has no frames; is it the folder of a run, and has that run begun?")
        return read_frames(self.folder, "points")

    @property
    def _first_frame(self) -> VtkhdfFile:
        if not self._frames:
            raise RunError(f"{self.folder} holds no frame that can be read; is it the folder of a run, and has "
                           "that run begun?")
        return self._frames[0].file

    def _check_field(self, name: str) -> None:
        if name not in self.units:
            raise unknown(name, self.fields, "field", self.folder)

    def _checked_index(self, k: int) -> int:
        n = len(self.times)
        if not -n <= k < n:
            raise IndexError(f"{self.folder} has {n} frames; there is no frame {k}")
        return k % n
