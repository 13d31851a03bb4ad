"""A file in the VTKHDF format with time steps, type UnstructuredGrid: tables of points and cells, read by step.

Also while a run adds steps to it: a step counts once it is whole (NSteps), and a reading that meets the writer half way is repeated.
Not for: what the fields mean (run.py).
"""

import time

import h5py
import numpy as np

from terp.errors import RunError

KNOWN_VERSION = 2  # the first number of the version; the second adds what an old reader passes over
PATIENCE = 0.4  # how long a file must have stayed the same before a failed reading counts [s]; a frame of 40 000 points takes 0.1 s
GEOMETRY = {"PointData": ("PointOffsets", "NumberOfPoints"), "CellData": ("CellOffsets", "NumberOfCells")}


class VtkhdfFile:
    """Nothing is kept open: each reading opens the file and closes it."""

    def __init__(self, path):
        self.path = path

    def times(self):
        """Times of the whole steps [s], shape [n_steps]."""
        return self.read(lambda root: root["Steps/Values"][:root["Steps"].attrs["NSteps"]])

    def has_steps(self):
        return self.read(lambda root: "Steps" in root)

    def attributes(self, data, key, default=""):
        """{name: text} of attribute `key` of the tables in `data`, "PointData" or "CellData"."""
        return self.read(lambda root: {name: _text(table.attrs.get(key, default)) for name, table in root.get(data, {}).items()})

    def places(self, k):
        """Places of the points in step k [m], shape [n_points, 2]."""
        return self.read(lambda root: root["Points"][_rows(root, "PointData", "", k), :2])

    def values(self, data, name, k):
        """Table `name` of `data` in step k, shape [n] or [n, n_components]."""
        return self.read(lambda root: root[data][name][_rows(root, data, name, k)])

    def series(self, data, name, row):
        """Row `row` of a table in all whole steps, shape [n_steps] or [n_steps, n_components]."""
        def of(root):
            first = [_rows(root, data, name, k).start for k in range(root["Steps"].attrs["NSteps"])]
            return np.array([root[data][name][start + row] for start in first])
        return self.read(of)

    def cells(self):
        """Corners of the cells, shape [n_cells, n_corners]; all cells have the same number."""
        return self.read(lambda root: root["Connectivity"][:].reshape(root["NumberOfCells"][0], -1))

    def read(self, of):
        """of(group /VTKHDF). A failure counts when the file has not changed for a while; until then it is being written."""
        while True:
            before = _stamp(self.path)
            try:
                return self._read_once(of)
            except (OSError, RuntimeError) as error:
                if time.time() - before[0] > PATIENCE and _stamp(self.path) == before:
                    raise RunError(f"{self.path} cannot be read as VTKHDF: {error}") from error
                time.sleep(PATIENCE / 4)

    def _read_once(self, of):
        with h5py.File(self.path, "r") as file:
            if "VTKHDF" not in file:
                raise RunError(f"{self.path} cannot be read as VTKHDF: it has no group /VTKHDF")
            root = file["VTKHDF"]
            version = root.attrs.get("Version", (KNOWN_VERSION,))
            if version[0] != KNOWN_VERSION:
                raise RunError(f"{self.path} is of VTKHDF version {'.'.join(str(n) for n in version)}; this terp reads version {KNOWN_VERSION}")
            try:
                return of(root)
            except KeyError as error:
                raise RunError(f"{self.path} lacks a part of the format: {error.args[0]}") from error


def _stamp(path):
    """What changes when a file is written: (time, size)."""
    try:
        status = path.stat()
    except OSError as error:
        raise RunError(f"{path} cannot be read: {error.strerror}") from error
    return status.st_mtime, status.st_size


def _rows(root, data, name, k):
    """The rows of step k in a table of `data`, by the offsets of the format; name "": Points."""
    offsets, size = GEOMETRY[data]
    if "Steps" not in root:
        return slice(0, int(root[size][0]))
    steps = root["Steps"]
    own = f"{data}Offsets/{name}"
    first = steps[own][k] if name and own in steps else np.ravel(steps[offsets][k])[0]
    part = int(steps["PartOffsets"][k])
    return slice(int(first), int(first) + int(root[size][part]))


def _text(value):
    return value.decode() if isinstance(value, bytes) else str(value)
