"""What the results in a run folder and those of a run in memory have in common: names, units, tables, the verdict."""

from __future__ import annotations

import abc
import os
from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from terp.errors import RunError, unknown
from terp.tables import COLUMN_UNITS

SOIL_SIGNS: dict[str, Any] = {  # than 0: it is soil
    "material": np.greater_equal, "cell": np.greater_equal, "volume": np.greater}


class Results(abc.ABC):
    """Fields by name and frame, ledger, history, summary and case."""

    @property
    @abc.abstractmethod
    def times(self) -> npt.NDArray[np.float64]:
        """Of the frames [s], shape [n_frames], ascending."""

    @property
    @abc.abstractmethod
    def units(self) -> dict[str, str]:
        """{field: unit}, with "position"."""

    @property
    @abc.abstractmethod
    def components(self) -> dict[str, tuple[str, ...]]:
        """{field: names of its components}, e.g. ("xx", "yy", "zz", "xy")."""

    @property
    @abc.abstractmethod
    def ledger(self) -> npt.NDArray[Any]:
        """Energies, mass, momentum, front and crest over time: structured array with the columns of ledger.csv."""

    @property
    @abc.abstractmethod
    def history(self) -> npt.NDArray[Any]:
        """Named points over time: structured array with the columns of history.csv."""

    @property
    @abc.abstractmethod
    def summary(self) -> dict[str, Any]:
        """That of summary.json."""

    @property
    @abc.abstractmethod
    def case(self) -> Mapping[str, Any]:
        """The keys of its case."""

    @abc.abstractmethod
    def place(self, file: str = "") -> str:
        """How messages name it, or a file of it."""

    @abc.abstractmethod
    def frame(self, k: int) -> Frame:
        """Frame k (negative: from the end)."""

    @property
    @abc.abstractmethod
    def first_places(self) -> npt.NDArray[np.float64]:
        """Of the soil that is there at the start [m], shape [n, 2]."""

    @abc.abstractmethod
    def values(self, name: str, k: int) -> npt.NDArray[Any]:
        """Field `name` of frame k, shape [n_points] or [n_points, n_components]."""

    @property
    def fields(self) -> list[str]:
        """Names of its fields."""
        return sorted(self.units)

    def at(self, time: float) -> int:
        """Index of the frame nearest to `time` [s]; the earlier of two equally near ones."""
        if len(self.times) == 0:
            raise RunError(f"{self.place()} holds no frame")
        if not np.isfinite(time):
            raise ValueError(f"there is no frame at time {time}")
        return int(np.argmin(np.abs(self.times - time)))

    def component(self, field: str, name: str) -> int:
        """Column of component `name` in a field, e.g. 3 for "xy" of the stress."""
        if field not in self.units:
            raise unknown(field, self.fields, "field", self.place())
        names = self.components.get(field, ())
        if name not in names:
            raise unknown(name, names, "component", f"`{field}` in {self.place()}")
        return names.index(name)

    def unit(self, name: str) -> str:
        """Unit of a field or of a column of the tables, e.g. "Pa"; "-" where it has none. "stress.xx" has that of
        "stress"."""
        name = name.partition(".")[0]
        units = {**COLUMN_UNITS, **self._known_units()}
        if name not in units:
            raise unknown(name, sorted(units), "field or column", self.place())
        return units[name]

    def _known_units(self) -> dict[str, str]:
        return self.units

    @property
    def history_points(self) -> list[str]:
        """Names of the points in the history, in its order."""
        return list(dict.fromkeys(self.history["point"].tolist()))

    def history_of(self, point: str) -> npt.NDArray[Any]:
        """The rows of the history of one named point, by time."""
        if point not in self.history_points:
            raise unknown(point, self.history_points, "point", self.place("history.csv"))
        rows: npt.NDArray[Any] = self.history[self.history["point"] == point]
        in_time: npt.NDArray[Any] = rows[np.argsort(rows["time"], kind="stable")]
        return in_time

    @property
    def flood(self) -> dict[str, Any] | None:
        """The verdict on the water, as in summary.json: a dictionary with "verdict" ("stands", "damaged",
        "still_moving", "near" or "floods"; None until the run has ended, unless it floods so far), "residual_height",
        "freeboard", "width_at_level" [m], "first_time_below" [s], "below_for" [s], "below_by" [m],
        "at_strength_damaged", "at_strength_below", "stage_moving" (at whose end soil still moved) and others; None
        without a water level."""
        return self.summary.get("flood")


class Frame:
    """All material points at one time. `frame["su"]` is read at the first use, then kept.

    Rows of points of which there is no soil hold no result: `frame["su"][frame.soil]` leaves them out.
    """

    def __init__(self, run: Results, k: int) -> None:
        self.run = run
        self.k = k
        self.time = float(run.times[k])  # [s]
        self._fields: dict[str, npt.NDArray[Any]] = {}

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        if name not in self._fields:
            self._fields[name] = self._read(name)
        return self._fields[name]

    def _read(self, name: str) -> npt.NDArray[Any]:
        return self.run.values(name, self.k)

    @property
    def x(self) -> npt.NDArray[np.float64]:
        """Positions of the points [m], shape [n_points, 2]."""
        return self["position"]

    @property
    def soil(self) -> npt.NDArray[np.bool_]:
        """Which rows are soil, shape [n_points]. False: the body of the point is not placed yet or was removed, or the
        point left through an open side. A run whose frames have none of the fields `material`, `cell` and `volume` does
        not tell: all rows count as soil."""
        for name, is_soil in SOIL_SIGNS.items():
            if name in self.run.units:
                return np.asarray(is_soil(self[name], 0))
        return np.ones(len(self.x), dtype=bool)

    def scalar(self, name: str) -> npt.NDArray[np.float64]:
        """One number per point, shape [n_points]: a scalar field, the component "stress.xx" of a field, or the size of
        a vector."""
        field, _, component = name.partition(".")
        values = self[field]
        if component:
            return values[:, self.run.component(field, component)]
        if values.ndim == 1:
            return values
        if self.run.components[field] == ("x", "y", "z"):
            return np.asarray(np.linalg.norm(values, axis=1))
        choices = ", ".join(f"{field}.{part}" for part in self.run.components[field])
        raise RunError(f"`{field}` has several components; ask for one of them: {choices}")

    def write_vtu(self, file: str | os.PathLike[str]) -> None:
        """The soil as a .vtu file of VTK, with all fields and the names of their components."""
        from terp.vtu import write_vtu
        write_vtu(self, file)

    def __repr__(self) -> str:
        return f"<frame {self.k} of {self.run.place()}, t = {self.time:g} s>"
