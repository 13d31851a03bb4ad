"""Whether a table of a run is still what the run wrote.

A run that ended has rows up to its end, and its newest checkpoint holds a checksum of each table up to the checkpoint's
time (docs/formats.md). Not for reading tables (tables.py).
"""

from pathlib import Path
from typing import Any

import h5py
import numpy.typing as npt

from terp.errors import RunError

CURE = "copy the folder again, or solve the case again"
MOST_BYTES = 20_000_000  # a longer table is not summed: that takes 0.2 s per million


def check_unaltered(path: Path) -> None:
    """Raise RunError if rows of a table were altered, added or removed before the newest checkpoint."""
    found = _newest_tables(path.parent)
    if found is None or path.stat().st_size > MOST_BYTES:
        return
    time, sums = found
    text = path.read_bytes()
    if path.name in sums and _checksum(_part_until(text, time)) != sums[path.name]:
        raise RunError(f"{path} is not what the run wrote: rows up to t = {time:.4g} s were altered; {CURE}")


def check_end(path: Path, rows: npt.NDArray[Any], end: float) -> None:
    """Raise RunError if the rows of a table, of each of its points, end before the run did, at `end` [s]."""
    points = rows["point"] if "point" in (rows.dtype.names or ()) else None
    for name in [None] if points is None else dict.fromkeys(points.tolist()):
        times = rows["time"] if points is None else rows["time"][points == name]
        of_point = "" if name is None else f" of point {name}"
        if len(times) == 0 or times[-1] < end:
            last = f"t = {times[-1]:g} s" if len(times) else "its header"
            raise RunError(f"{path} was cut: the rows{of_point} end at {last}, the run at {end:g} s; {CURE}")


def _newest_tables(folder: Path) -> tuple[float, dict[str, str]] | None:
    """(time [s], {table: checksum}) of the newest checkpoint after the first step that can be read; none: None."""
    for path in sorted(folder.glob("checkpoint_*.h5"), reverse=True):
        if not path.stem.removeprefix("checkpoint_").strip("0"):
            break
        try:
            with h5py.File(path, "r") as file:
                lines = file["tables"][()].tobytes().decode("utf-8").splitlines()
                return float(file.attrs["time"]), dict(line.split(" = ") for line in lines)
        except (OSError, KeyError, ValueError):
            continue  # an older one may be whole
    return None


def _part_until(text: bytes, time: float) -> bytes:
    """The bytes of a table up to its last whole row with a time of at most `time`."""
    length = text.find(b"\n") + 1
    while (end := text.find(b"\n", length)) >= 0:
        try:
            if not float(text[length:end].partition(b",")[0]) <= time:
                break
        except ValueError:
            break
        length = end + 1
    return text[:length]


def _checksum(data: bytes) -> str:
    """FNV-1a of 64 bits, 16 hexadecimal digits."""
    value = 0xCBF29CE484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
    return f"{value:016x}"
