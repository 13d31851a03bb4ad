"""A study, as `terp study` left it (docs/probability.md): its probabilities, its table, its runs."""

import csv
import json
import math
import pathlib
import subprocess
from typing import NamedTuple

import numpy as np

from terp.errors import RunError
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

    def __init__(self, folder):
        """Raises RunError if nothing of a study has been reported there."""
        self.folder = pathlib.Path(folder)
        try:
            self.results = json.loads((self.folder / "results.json").read_text(encoding="utf-8"))
        except FileNotFoundError as error:
            raise RunError(f"{self.folder} has no results.json: write it with `terp study report {self.folder}`"
                           ) from error
        except ValueError as error:
            raise RunError(f"{self.folder}/results.json cannot be read: {error}") from error
        self._tables = {}

    def __repr__(self):
        return f"terp.Study({str(self.folder)!r}): {self.results['realisations']} realisations"

    @property
    def slide(self):
        """P(I)."""
        return _event(self.results["slide"])

    @property
    def flood(self):
        """P(F); NaN where no water is judged."""
        return _event(self.results["flood"])

    @property
    def flood_after_slide(self):
        """P(F|I); NaN where no water is judged or nothing slid."""
        return _event(self.results["flood_after_slide"])

    @property
    def inputs(self):
        """Names of what was drawn: columns of the table."""
        return [row["input"] for row in self.results["sensitivities"]]

    @property
    def sensitivities(self):
        """Rank correlations [-] of each input, {name: (with a slide, with the height that remains)}; NaN: none."""
        return {row["input"]: (_number(row["with_slide"]), _number(row["with_height"]))
                for row in self.results["sensitivities"]}

    @property
    def table(self):
        """results.csv as a structured array, a row per realisation. Columns and units: docs/formats.md."""
        return self._table("results.csv")

    @property
    def levels(self):
        """fragility.csv as a structured array, a row per level. Raises RunError if the study has no load."""
        return self._table("fragility.csv")

    @property
    def pairs(self):
        """Rows of the table of samples that were solved on both levels, (coarse, fine), in the same order.
        Raises RunError if the study has no two levels."""
        table = self.table
        if "resolution" not in table.dtype.names:
            raise RunError(f"{self.folder} is no study on two levels: its estimator is {self.results['estimator']}")
        fine = np.flatnonzero(table["resolution"] == "fine")
        return table[fine - 1], table[fine]

    def run_of(self, realisation, program="terp"):
        """The terp.Run of a realisation, with all its fields. It is solved once more by the program, to the same bits,
        unless that was done before and the study is the same. Raises RunError with what the program says."""
        folder = self.folder / "kept" / str(int(realisation))
        if _mark_of(folder) != self.results.get("digits", math.nan):
            command = [program, "study", "run", str(self.folder), "--keep", str(int(realisation)), "-q"]
            try:
                done = subprocess.run(command, capture_output=True, text=True, check=False)
            except OSError as error:
                raise RunError(f"cannot start `{program}`: {error.strerror}. Give the path of the program") from error
            if done.returncode != 0:
                raise RunError(f"realisation {realisation} was not solved: {done.stderr.strip()}")
        return Run(folder)

    def _table(self, name):
        if name not in self._tables:
            self._tables[name] = _read(self.folder / name)
        return self._tables[name]


def _mark_of(folder):
    """Digits of the study, in a run folder that is whole; None: there is no such."""
    try:
        return (folder / "of_study.txt").read_text(encoding="utf-8").strip()
    except FileNotFoundError:
        return None


def _event(row):
    if row is None:
        return Event(math.nan, math.nan, math.nan)
    return Event(*(_number(row[name]) for name in Event._fields))


def _number(value):
    return math.nan if value is None else value


def _read(path):
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


def _type(file, name, column):
    if name in _INTEGER[file]:
        return np.int64
    try:
        np.array(column, float)
        return "U1" if name in _TEXT else float
    except ValueError:
        return f"U{max(map(len, column))}"
