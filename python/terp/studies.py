"""A study, as `terp study` left it (docs/probability.md): its probabilities, its table, its runs."""

from __future__ import annotations

import csv
import html
import json
import math
import os
import pathlib
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from terp.answers import html_table
from terp.errors import CaseError, RunError, SolveError
from terp.program import call
from terp.run import Run

_TEXT = {"fault", "screening", "resolution"}
_INTEGER = {"results.csv": {"realisation", "solved", "sample"}, "fragility.csv": {"solved", "failed", "slides"}}


class Event(NamedTuple):
    """A probability [-] with its bounds at the confidence of the study; NaN where nothing is known."""

    probability: float
    low: float
    high: float


class Study:
    """The folder of a study, such as runs/dike_study. Files are read when they are asked for, and kept."""

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        """Raises RunError if nothing of a study has been reported there."""
        self.folder = pathlib.Path(folder)
        try:
            self.results = json.loads((self.folder / "results.json").read_text(encoding="utf-8"))
        except FileNotFoundError as error:
            raise RunError(f"{self.folder} has no results.json: write it with `terp study report {self.folder}`"
                           ) from error
        except ValueError as error:
            raise RunError(f"{self.folder}/results.json cannot be read: {error}") from error
        self._tables: dict[str, npt.NDArray[Any]] = {}

    def __repr__(self) -> str:
        events = "".join(f", P({name}) {event.probability:.3g} ({event.low:.3g} to {event.high:.3g})"
                         for name, event in self._events().items())
        return f"terp.Study({str(self.folder)!r}): {self.results['realisations']} realisations{events}"

    def _repr_html_(self) -> str:
        rows = np.array([(name, *event) for name, event in self._events().items()],
                        [("event", "U8"), *((name, float) for name in Event._fields)])
        notes = "".join(f"<li>{html.escape(note)}</li>" for note in self.results["remarks"])
        return f"<p>{self.results['realisations']} realisations</p>{html_table(rows)}<ul>{notes}</ul>"

    def _events(self) -> dict[str, Event]:
        """By name, those of which something is known."""
        events = {"I": self.slide, "F": self.flood, "F|I": self.flood_after_slide}
        return {name: event for name, event in events.items() if not math.isnan(event.probability)}

    @property
    def slide(self) -> Event:
        """P(I)."""
        return _event(self.results["slide"])

    @property
    def flood(self) -> Event:
        """P(F); NaN where no water is judged."""
        return _event(self.results["flood"])

    @property
    def flood_after_slide(self) -> Event:
        """P(F|I); NaN where no water is judged or nothing slid."""
        return _event(self.results["flood_after_slide"])

    @property
    def inputs(self) -> list[str]:
        """Names of what was drawn: columns of the table."""
        return [row["input"] for row in self.results["sensitivities"]]

    @property
    def sensitivities(self) -> dict[str, tuple[float, float]]:
        """Rank correlations [-] of each input, {name: (with a slide, with the height that remains)}; NaN: none."""
        return {row["input"]: (_number(row["with_slide"]), _number(row["with_height"]))
                for row in self.results["sensitivities"]}

    @property
    def table(self) -> npt.NDArray[Any]:
        """results.csv as a structured array, a row per realisation. Columns and units: docs/formats.md."""
        return self._table("results.csv")

    @property
    def levels(self) -> npt.NDArray[Any]:
        """fragility.csv as a structured array, a row per level. Raises RunError if the study has no load."""
        return self._table("fragility.csv")

    @property
    def over_level(self) -> npt.NDArray[Any]:
        """flood_after_slide.csv as a structured array: P(F|I) and its bounds over the level of the water [m], from the
        ground that the slides left. Raises RunError if nothing slid, or no water is judged."""
        return self._table("flood_after_slide.csv")

    def plot(self, events: str | Sequence[str] = ("F_after_I",), panel: Any = None) -> Any:
        """Probabilities over the level of the load, or P(F|I) over that of the water: terp.plot.fragility."""
        from terp import plot
        return plot.fragility(self, events, panel)

    @property
    def pairs(self) -> tuple[npt.NDArray[Any], npt.NDArray[Any]]:
        """Rows of the table of samples that were solved on both levels, (coarse, fine), in the same order.
        Raises RunError if the study has no two levels."""
        table = self.table
        if "resolution" not in (table.dtype.names or ()):
            raise RunError(f"{self.folder} is no study on two levels: its estimator is {self.results['estimator']}")
        fine = np.flatnonzero(table["resolution"] == "fine")
        return table[fine - 1], table[fine]

    def run_of(self, realisation: int, program: str | os.PathLike[str] | None = None) -> Run:
        """The terp.Run of a realisation, with all its fields. It is solved once more by the program, to the same bits,
        unless that was done before and the study is the same. Raises RunError with what the program says."""
        folder = self.folder / "kept" / str(int(realisation))
        if _mark_of(folder) != self.results.get("digits", math.nan):
            try:
                call(["study", "run", str(self.folder), "--keep", str(int(realisation))], program=program)
            except (CaseError, SolveError, RunError) as error:
                raise RunError(f"realisation {realisation} was not solved: {error}") from error
        return Run(folder)

    def _table(self, name: str) -> npt.NDArray[Any]:
        if name not in self._tables:
            self._tables[name] = read_csv(self.folder / name)
        table: npt.NDArray[Any] = self._tables[name]
        return table


def _mark_of(folder: pathlib.Path) -> str | None:
    """Digits of the study, in a run folder that is whole; None: there is no such."""
    try:
        return (folder / "of_study.txt").read_text(encoding="utf-8").strip()
    except FileNotFoundError:
        return None


def _event(row: Mapping[str, Any] | None) -> Event:
    if row is None:
        return Event(math.nan, math.nan, math.nan)
    return Event(*(_number(row[name]) for name in Event._fields))


def _number(value: float | None) -> float:
    return math.nan if value is None else value


def read_csv(path: pathlib.Path) -> npt.NDArray[Any]:
    """A table of the program as a structured array: numbers where a column has no other cells."""
    try:
        with open(path, encoding="utf-8", newline="") as file:
            head, *rows = csv.reader(file)
    except FileNotFoundError as error:
        raise RunError(f"there is no {path}: the study has no such table, or no report yet") from error
    columns = list(zip(*rows)) if rows else [()] * len(head)
    table = np.empty(len(rows), np.dtype([(name, _type(path.name, name, column))
                                          for name, column in zip(head, columns)]))
    for name, column in zip(head, columns):
        table[name] = column
    return table


def _type(file: str, name: str, column: Sequence[str]) -> Any:
    if name in _INTEGER.get(file, ()):
        return np.int64
    try:
        np.array(column, float)
        return "U1" if name in _TEXT else float
    except ValueError:
        return f"U{max(map(len, column), default=1)}"
