"""One run folder: results.vtkhdf, history.csv, ledger.csv and summary.json as numpy arrays and dictionaries.

Not for drawing (terp.figures) and not for judging a run: it hands out what the solver wrote, in SI units.
"""

import difflib
import functools
import json
import tomllib
from pathlib import Path

import h5py
import numpy as np

UNITS = {
    "x": "m", "y": "m", "displacement": "m", "velocity": "m/s", "stress": "Pa", "pressure": "Pa", "su": "Pa",
    "volume": "m^2", "strain": "-", "eps_deviatoric": "-", "eps_eq_p": "-", "id": "-", "material": "-",
    "cell": "-", "time": "s", "step": "-", "kinetic": "J per m", "elastic": "J per m", "plastic": "J per m",
    "gravity_work": "J per m", "damping_work": "J per m", "boundary_work": "J per m", "left_energy": "J per m",
    "numerical": "J per m",
    "mass": "kg per m", "momentum_x": "kg m/s per m", "momentum_y": "kg m/s per m", "clamped": "-", "left": "-",
    "front_x": "m", "crest_x": "m", "v_max": "m/s", "v_999": "m/s",
}
"""Unit of each field and column; "per m" is per metre of thickness."""

TEXT_COLUMNS = {"point"}
INTEGER_COLUMNS = {"id", "step", "clamped", "left"}


class RunError(Exception):
    """A run folder does not hold what was asked of it. The message says which file and what to do."""


class Frame:
    """All material points at one time. `frame["su"]` is read from the file at the first use, then kept."""

    def __init__(self, run, k):
        self.run = run
        self.k = k
        self.time = float(run.times[k])  # [s]
        self._fields = {}

    def __getitem__(self, name):
        if name not in self._fields:
            self._fields[name] = self.run.field(name, self.k)
        return self._fields[name]

    @property
    def x(self):
        """Places of the points [m], shape [n_points, 2]."""
        return self["x"]

    def __repr__(self):
        return f"<frame {self.k} of {self.run.folder}, t = {self.time:g} s>"


class Run:
    """The results in one run folder. Each file is read when it is first asked for."""

    def __init__(self, folder):
        self.folder = Path(folder)
        if not self.folder.is_dir():
            raise RunError(f"there is no run folder {self.folder}")

    def __repr__(self):
        return f"<terp run {self.folder}>"

    # Frames: results.vtkhdf

    @functools.cached_property
    def times(self):
        """Times of the frames [s], shape [n_frames], ascending."""
        with self._results() as root:
            return np.asarray(root["Steps/Values"][:], dtype=float)

    @functools.cached_property
    def field_names(self):
        """Names that `field` knows in this run, besides "x"."""
        with self._results() as root:
            return sorted(root["PointData"])

    def frame(self, k):
        """Frame k (negative: from the end)."""
        return Frame(self, self._checked_index(k))

    def field(self, name, k):
        """Field `name` of frame k, shape [n_points] or [n_points, n_components]; "x" is the place, [n_points, 2].

        Row r is the same material point in every frame.
        """
        k = self._checked_index(k)
        if name != "x" and name not in self.field_names:
            raise RunError(self._unknown(name, self.field_names, "field", "results.vtkhdf"))
        with self._results() as root:
            if name == "x":
                return root["Points"][_rows(root, "", k), :2]
            return root["PointData"][name][_rows(root, name, k)]

    def at(self, time):
        """Index of the frame nearest to `time` [s]; the earlier of two equally near ones."""
        if len(self.times) == 0:
            raise RunError(f"{self.folder / 'results.vtkhdf'} holds no frame")
        return int(np.argmin(np.abs(self.times - time)))

    def nearest_point(self, x, y):
        """Row of the material point nearest to (x, y) [m] in the first frame; ties: lower x, then lower y."""
        places = self.field("x", 0)
        distance = np.hypot(places[:, 0] - x, places[:, 1] - y)
        near = np.flatnonzero(distance <= distance.min() + 1e-9)  # 1e-9 m: round-off of a lattice
        return int(near[np.lexsort((places[near, 1], places[near, 0]))[0]])

    # Tables: history.csv, ledger.csv

    @functools.cached_property
    def history(self):
        """Named points over time: structured array with the columns of history.csv."""
        return self._table("history.csv")

    @functools.cached_property
    def ledger(self):
        """Energies, mass, momentum, front and crest over time: structured array with the columns of ledger.csv."""
        return self._table("ledger.csv")

    @functools.cached_property
    def history_points(self):
        """Names of the points in history.csv, in the order of the file."""
        return list(dict.fromkeys(self.history["point"].tolist()))

    def history_of(self, point):
        """The rows of history.csv of one named point, by time."""
        if point not in self.history_points:
            raise RunError(self._unknown(point, self.history_points, "point", "history.csv"))
        rows = self.history[self.history["point"] == point]
        return rows[np.argsort(rows["time"], kind="stable")]

    # Summary and case

    @functools.cached_property
    def summary(self):
        """summary.json as a dictionary."""
        try:
            return json.loads(self._file("summary.json").read_text(encoding="utf-8"))
        except ValueError as error:
            raise RunError(f"{self.folder / 'summary.json'} cannot be read: {error}") from error

    @functools.cached_property
    def case(self):
        """The case that was run, as a dictionary of its TOML text."""
        if "case" not in self.summary:
            raise RunError(f"{self.folder / 'summary.json'} has no entry `case`")
        try:
            return tomllib.loads(self.summary["case"])
        except ValueError as error:
            raise RunError(f"the case in {self.folder / 'summary.json'} cannot be read: {error}") from error

    def unit(self, name):
        """Unit of a field or column, e.g. "Pa"; "-" where it has none."""
        return UNITS.get(name, "-")

    # Inside

    def _file(self, name):
        path = self.folder / name
        if not path.is_file():
            raise RunError(f"{self.folder} has no {name}; has the run been solved to its end?")
        return path

    def _results(self):
        path = self._file("results.vtkhdf")
        try:
            return _Group(path)
        except (OSError, KeyError) as error:
            raise RunError(f"{path} cannot be read as VTKHDF: {error}") from error

    def _table(self, name):
        path = self._file(name)
        with path.open(encoding="utf-8") as lines:
            columns = lines.readline().strip().split(",")
            rows = [line for line in lines if line.strip()]
        dtype = np.dtype([(column, _column_type(column)) for column in columns])
        if not rows:
            return np.empty(0, dtype)
        try:
            return np.loadtxt(rows, dtype=dtype, delimiter=",", comments=None, quotechar='"', ndmin=1)
        except ValueError as error:
            raise RunError(f"{path} cannot be read: {error}") from error

    def _checked_index(self, k):
        n = len(self.times)
        if not -n <= k < n:
            raise IndexError(f"{self.folder} has {n} frames; there is no frame {k}")
        return k % n

    def _unknown(self, name, known, kind, file):
        close = difflib.get_close_matches(name, known, n=1)
        hint = f" Did you mean `{close[0]}`?" if close else ""
        return f"{self.folder / file} has no {kind} `{name}`.{hint} It has: {', '.join(known) or 'none'}"


class _Group:
    """The group /VTKHDF of a file, open for the length of a `with`."""

    def __init__(self, path):
        self._path = path
        self._file = h5py.File(path, "r")
        if "VTKHDF" not in self._file:
            self._file.close()
            raise KeyError("it has no group /VTKHDF")

    def __enter__(self):
        return self._file["VTKHDF"]

    def __exit__(self, kind, error, _):
        self._file.close()
        if kind is KeyError:
            raise RunError(f"{self._path} lacks a part of the format: {error.args[0]}") from error


def _rows(root, name, k):
    """The rows of frame k in a data set that holds frame after frame."""
    offsets = root["Steps/PointOffsets"]
    part = int(root["Steps/PartOffsets"][k]) if "Steps/PartOffsets" in root else k
    n = int(root["NumberOfPoints"][part]) if "NumberOfPoints" in root else len(root["Points"]) // len(offsets)
    own = f"Steps/PointDataOffsets/{name}"
    first = int((root[own] if name and own in root else offsets)[k])
    return slice(first, first + n)


def _column_type(name):
    if name in TEXT_COLUMNS:
        return "U64"
    return np.int64 if name in INTEGER_COLUMNS else float
