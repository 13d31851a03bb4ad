"""A file in the VTKHDF format with time steps, type UnstructuredGrid: tables of points and cells, read by step.

Also while a run adds steps to it: a step counts once it is whole (NSteps), and a reading disturbed by a step is
repeated. Not for: what the fields mean (run.py).
"""

import time

import h5py
import numpy as np

from terp.errors import RunError

KNOWN_VERSION = 2  # the first number of the version; the second adds what an old reader passes over
HEAD_SIZE = 64  # the first bytes of a file, where HDF5 keeps its size: what adding a step changes first
MOMENT = 0.01  # before a reading is repeated [s]
PATIENCE = 1.0  # with a file in the middle of a change, which takes 0.2 ms unless the run was killed [s]
STEPS_AT_ONCE = 20  # a reading must be done before the next step comes
PAGE_SIZE = 4096  # of a journal: "terpjnl2", the size, the head before, pages with their numbers, a checksum
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
        return self.read(lambda root: {name: _text(table.attrs.get(key, default))
                                       for name, table in root.get(data, {}).items()})

    def places(self, k):
        """Places of the points in step k [m], shape [n_points, 2]."""
        return self.read(lambda root: root["Points"][_rows(root, "PointData", "", k), :2])

    def values(self, data, name, k):
        """Table `name` of `data` in step k, shape [n] or [n, n_components]."""
        return self.read(lambda root: root[data][name][_rows(root, data, name, k)])

    def series(self, data, name, row):
        """Row `row` of a table in all whole steps, shape [n_steps] or [n_steps, n_components]."""
        n = len(self.times())
        parts = [range(first, min(first + STEPS_AT_ONCE, n)) for first in range(0, n, STEPS_AT_ONCE)]
        return np.array([value for ks in parts
                         for value in self.read(lambda root: [root[data][name][_rows(root, data, name, k).start + row]
                                                              for k in ks])])

    def cells(self):
        """Corners of the cells, shape [n_cells, n_corners]; all cells have the same number."""
        return self.read(lambda root: root["Connectivity"][:].reshape(root["NumberOfCells"][0], -1))

    def read(self, of):
        """of(group /VTKHDF), repeated until no step came meanwhile: then its result, or failure, is of one content."""
        half_head, half_since = None, 0.0  # of the change that the file is in the middle of
        while True:
            head = _head(self.path)
            if not _is_half_changed(self.path, head):
                try:
                    value = self._read_once(of)
                    if _head(self.path) == head:
                        return value
                except RunError:
                    if _head(self.path) == head:
                        raise
            elif head != half_head:
                half_head, half_since = head, time.monotonic()
            elif time.monotonic() - half_since > PATIENCE:
                raise RunError(f"{self.path} cannot be read: its run was killed while it added a frame; "
                               "`terp resume` ends that, and goes on")
            time.sleep(MOMENT)

    def _read_once(self, of):
        try:
            with h5py.File(self.path, "r") as file:
                return of(self._checked_root(file))
        except KeyError as error:
            raise RunError(f"{self.path} lacks a part of the format: {error.args[0]}") from error
        except (OSError, RuntimeError, TypeError, ValueError, IndexError) as error:  # h5py's, of what HDF5 cannot read
            raise RunError(f"{self.path} cannot be read as VTKHDF: {error}") from error

    def _checked_root(self, file):
        if "VTKHDF" not in file:
            raise RunError(f"{self.path} cannot be read as VTKHDF: it has no group /VTKHDF")
        root = file["VTKHDF"]
        version = root.attrs.get("Version", (KNOWN_VERSION,))
        if version[0] != KNOWN_VERSION:
            raise RunError(f"{self.path} is of VTKHDF version {'.'.join(str(n) for n in version)}; this terp reads "
                           f"version {KNOWN_VERSION}")
        return root


def _head(path):
    try:
        with path.open("rb") as file:
            return file.read(HEAD_SIZE)
    except OSError as error:
        raise RunError(f"{path} cannot be read: {error.strerror}") from error


def _is_half_changed(path, head):
    """Whether a file with this head has some, but not all, pages of the change in the journal (docs/reliability.md)."""
    try:
        journal = path.with_name(path.name + ".journal").read_bytes()
    except OSError:
        return False
    pages = journal[16 + HEAD_SIZE:-8]
    if not journal.startswith(b"terpjnl2") or not pages or len(pages) % (8 + PAGE_SIZE) != 0:
        return False
    if head == journal[16:16 + HEAD_SIZE] or head != pages[8:8 + HEAD_SIZE]:
        return False  # nothing is written yet, or it is of another file
    with path.open("rb") as file:
        for number, page in np.frombuffer(pages, [("number", "<u8"), ("page", f"V{PAGE_SIZE}")]):
            file.seek(int(number) * PAGE_SIZE)
            if not page.tobytes().startswith(file.read(PAGE_SIZE)):
                return True
    return False


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
