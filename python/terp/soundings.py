"""Undrained strength from a cone penetration test, as a table that a case takes.

    python3 -m terp.soundings FILE -o su.csv [--nkt 17] [--unit-weight 17] [--step 0.2]

FILE is a GEF file (GEF-CPT-Report) or a BRO file (XML, CPT_O). The table has the columns x, y, value, for all x: y is
the level, value S_u in Pa. In a case: `su_peak = { csv = "su.csv" }`. Only the rows of clay and peat mean something:
name the table for these soils alone.

S_u = (q_t - sigma_v) / N_kt, q_t = q_c + u_2 (1 - a): Lunne, Robertson and Powell, Cone Penetration Testing in
Geotechnical Practice (1997). sigma_v is the depth times one unit weight. Where the file has no depth, it follows from
the length of the rods and their inclination. Levels are of the datum of the file, which is printed: they are y of the
case.

Exit status: 0 written, 2 the file is no such test, 1 the table could not be written.
"""

from __future__ import annotations

import argparse
import csv
import dataclasses
import re
import sys
import xml.etree.ElementTree as xml
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import numpy.typing as npt

from terp.command import exit_status
from terp.errors import RunError

Reals = npt.NDArray[np.float64]

GEF_LENGTH, GEF_CONE, GEF_PRESSURE, GEF_INCLINATION, GEF_DEPTH = 1, 2, 6, 8, 11  # numbers of quantities, #COLUMNINFO
GEF_AREA_RATIO = 3                                                               # number of a #MEASUREMENTVAR
GEF_NAP = 31000                                                                  # number of a #ZID
LENGTHS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3}                  # [m]
PRESSURES = {"MPa": 1e6, "MN/m2": 1e6, "N/mm2": 1e6, "kPa": 1e3, "kN/m2": 1e3, "Pa": 1.0, "bar": 1e5,
             "kg/cm2": 98066.5, "kgf/cm2": 98066.5}            # [Pa]
ANGLES = {"degrees": 1.0, "degree": 1.0, "deg": 1.0, "graden": 1.0, "graad": 1.0, "°": 1.0,
          "rad": 180.0 / np.pi}                                # [degrees]
BRO_COLUMNS = {"length": 0, "depth": 1, "cone": 3, "inclination": 15, "pressure": 22}
BRO_VOID = -999999.0
VACUUM = -101e3        # [Pa]: no u_2 is lower
DEEPEST = 1000.0       # [m]
TOP_OF_VALUES = 1.0    # [m] below the ground: from a lower one on a note says so
STEEPEST = 45.0        # [degrees]: rods that incline more are a fault of the file
LEAST_BETWEEN_ROWS = 2e-3      # [m]
LEAST_UNIT_WEIGHT = 10e3       # [N/m3] of soil with its water


@dataclasses.dataclass(frozen=True)
class Sounding:
    """A cone penetration test. All arrays have the shape [n]; not a number where nothing was measured."""

    name: str
    level: float           # of the ground, of the national datum of the file [m]
    depth: Reals           # below it [m]
    cone: Reals            # q_c [Pa]
    pressure: Reals        # u_2 [Pa]
    area_ratio: float      # a of the cone
    datum: str = ""        # of the level, as the file names it
    notes: tuple[str, ...] = ()  # what was assumed of the file

    def corrected(self) -> Reals:
        """q_t [Pa]; q_c where no pressure was measured."""
        pressure = np.where(np.isfinite(self.pressure), self.pressure, 0.0)
        corrected: Reals = self.cone + pressure * (1.0 - self.area_ratio)
        return corrected

    def strength(self, nkt: float = 17.0, unit_weight: float = 17e3, step: float = 0.2) -> tuple[Reals, Reals]:
        """Levels [m] and S_u [Pa], means over steps of the depth [m]; shapes [m]. Steps without a value are left out.

        unit_weight: of the ground with its water [N/m3].
        """
        for name, value, low, high, unit in (("N_kt", nkt, 1.0, 100.0, ""),
                                             ("the unit weight", 1e-3 * unit_weight, 5.0, 30.0, " kN/m3"),
                                             ("the step of the depth", step, 1e-3, 10.0, " m")):
            if not low <= value <= high:
                raise RunError(f"{name} is {value:g}{unit}; it must be {low:g} to {high:g}{unit}")
        strength = (self.corrected() - unit_weight * self.depth) / nkt
        good = np.isfinite(strength) & (strength > 0.0)
        steps = np.floor(self.depth / step)
        levels, values = [], []
        for number in np.unique(steps[good]):
            levels.append(self.level - (number + 0.5) * step)
            values.append(float(np.mean(strength[good & (steps == number)])))
        return np.array(levels), np.array(values)


def read_sounding(path: str | Path) -> Sounding:
    """Reads a GEF or BRO file. Raises RunError: what is missing in it."""
    try:
        data = Path(path).read_bytes()
    except OSError as error:
        raise RunError(f"{path} cannot be read: {error.strerror}") from error
    text = data.decode("utf-8", errors="replace")
    if text.lstrip("\ufeff \r\n").startswith("#GEFID"):
        return from_gef(text, str(path))
    if text.lstrip("\ufeff \r\n").startswith("<"):
        return from_bro(data, str(path))
    raise RunError(f"{path} is no GEF file and no BRO file: the first begins with #GEFID, the second is XML")


def from_gef(text: str, path: str) -> Sounding:
    """The same from the text of a GEF file."""
    head, mark, body = text.partition("#EOH")
    if not mark:
        raise RunError(f"{path} has no end of its head, #EOH")
    if "GEF-BORE" in head:
        raise RunError(f"{path} is a boring, and no cone penetration test")
    values = re.findall(r"^\s*#(\w+)\s*=(.*)$", head, re.M)
    lines: dict[str, list[list[str]]] = {}
    for key, value in values:
        lines.setdefault(key, []).append([part.strip() for part in value.split(",")])
    separators = {key: value.strip() for key, value in values if key.endswith("SEPARATOR")}
    places = {whole(info[3]): (whole(info[0]) - 1, info[1]) for info in lines.get("COLUMNINFO", []) if len(info) > 3}
    voids = {whole(info[0]) - 1: number_of(info[1]) for info in lines.get("COLUMNVOID", []) if len(info) > 1}
    record, column = separators.get("RECORDSEPARATOR") or "!", separators.get("COLUMNSEPARATOR", "")
    rows = []
    for line in body.split("\n", 1)[-1].replace(record, "\n").splitlines():
        cells = [cell for cell in (line.split(column) if column else line.split()) if cell.strip()]
        if cells:
            rows.append([number_of(cell) for cell in cells])
    width = max(map(len, rows), default=0)
    table = np.array([row + [np.nan] * (width - len(row)) for row in rows], dtype=float).reshape(len(rows), width)
    for place, void in voids.items():
        if 0 <= place < width:
            table[table[:, place] == void, place] = np.nan

    def quantity(number: int, units: dict[str, float]) -> Reals | None:
        if number not in places or not 0 <= places[number][0] < width:
            return None
        place, unit = places[number]
        size = {name.lower(): factor for name, factor in units.items()}.get(unit.replace("^", "").lower())
        if size is None:
            raise RunError(f"{path} has a unit that Terp does not know, `{unit}`; known are {', '.join(units)}")
        values: Reals = table[:, place] * size
        return values

    depth, length = quantity(GEF_DEPTH, LENGTHS), quantity(GEF_LENGTH, LENGTHS)
    ratio = next((number_of(info[1]) for info in lines.get("MEASUREMENTVAR", [])
                  if len(info) > 1 and info[0] == str(GEF_AREA_RATIO)), np.nan)
    level = lines.get("ZID", [["", ""]])[0]
    datum = "NAP" if whole(level[0]) == GEF_NAP else f"datum {level[0]} (#ZID)"
    return sounding(path, lines.get("TESTID", [[path]])[0][0], number_of(level[1]) if len(level) > 1 else np.nan, datum,
                    depth, length, quantity(GEF_INCLINATION, ANGLES), quantity(GEF_CONE, PRESSURES),
                    quantity(GEF_PRESSURE, PRESSURES), ratio)


def from_bro(data: bytes, path: str) -> Sounding:
    """The same from a BRO file."""
    try:
        root = xml.fromstring(data)
    except xml.ParseError as error:
        raise RunError(f"{path} is no sound XML file: {error}") from error

    def text_of(name: str) -> str:
        return next((e.text or "" for e in root.iter() if e.tag.rpartition("}")[2] == name), "")

    rows = [[number_of(cell) for cell in row.split(",")] for row in text_of("values").strip().split(";") if row.strip()]
    width = 1 + max(BRO_COLUMNS.values())
    if not rows or any(len(row) < width for row in rows):
        raise RunError(f"{path} has no measurements of a cone penetration test (CPT_O): `values` of 25 columns")
    table = np.array([row[:width] for row in rows], dtype=float)
    table[table == BRO_VOID] = np.nan
    column = {name: table[:, place] for name, place in BRO_COLUMNS.items()}
    return sounding(path, text_of("broId") or path, number_of(text_of("offset")),
                    text_of("verticalDatum") or "a datum that the file does not name", column["depth"],
                    column["length"], column["inclination"], 1e6 * column["cone"], 1e6 * column["pressure"],
                    number_of(text_of("coneSurfaceQuotient")))


def below_the_ground(path: str, depth: Reals | None, length: Reals | None,
                     inclination: Reals | None) -> tuple[Reals, str]:
    """Depths [m], and what was assumed of them. Raises RunError where there are none."""
    if depth is not None and np.isfinite(depth).any():
        return depth, ""
    if length is None or not np.isfinite(length).any():
        raise RunError(f"{path} has no depth and no length of the rods")
    if np.nanmax(length) <= 0.0:
        length = -length
    if inclination is None or not np.isfinite(inclination).any():
        return length, "no depth and no inclination: depths are the length of the rods"
    known = np.isfinite(length) & np.isfinite(inclination)
    if np.abs(inclination[known]).max(initial=0.0) > STEEPEST:
        raise RunError(f"{path} has rods that incline by {np.abs(inclination[known]).max():.3g} degrees, more than "
                       f"{STEEPEST:g}")
    order = np.flatnonzero(known)[np.argsort(length[known], kind="stable")]
    if not len(order):
        return length, "no row has both length and inclination: depths are the length of the rods"
    lengths, cosines = length[order], np.cos(np.radians(inclination[order]))
    steps = np.diff(lengths) * 0.5 * (cosines[1:] + cosines[:-1])
    depths = lengths[0] * cosines[0] + np.concatenate([[0.0], np.cumsum(steps)])
    vertical = np.interp(length, lengths, depths)
    vertical[~np.isfinite(length)] = np.nan
    return vertical, f"no depth: it was found from the inclination, {depths[-1]:.2f} m for {lengths[-1]:.2f} m of rods"


def sounding(path: str, name: str, level: float, datum: str, depth: Reals | None, length: Reals | None,
             inclination: Reals | None, cone: Reals | None, pressure: Reals | None, area_ratio: float) -> Sounding:
    """Raises RunError where depth, cone or level are missing, or not those of a test."""
    depth, note = below_the_ground(path, depth, length, inclination)
    if cone is None or not np.isfinite(cone).any():
        raise RunError(f"{path} has no cone resistance")
    if not np.isfinite(level):
        raise RunError(f"{path} has no level of the ground")
    if np.isfinite(area_ratio) and not 0.0 < area_ratio <= 1.0:
        raise RunError(f"{path} has an area ratio of the cone of {area_ratio:g}; it must be more than 0 and at most 1")
    if np.nanmax(depth) <= 0.0:
        depth = -depth  # some files count downwards
    if np.nanmin(depth) < 0.0:
        raise RunError(f"{path} has depths above and below the ground")
    if np.nanmax(depth) > DEEPEST:
        raise RunError(f"{path} has depths to {np.nanmax(depth):.4g} m: is their unit right?")
    if pressure is not None and np.nanmin(pressure, initial=0.0) < VACUUM:
        raise RunError(f"{path} has u_2 of {np.nanmin(pressure) / 1e3:.4g} kPa, less than a vacuum: #COLUMNVOID names "
                       "the value where nothing was measured, or take the column out")
    order = np.argsort(depth, kind="stable")
    none = np.full(len(depth), np.nan)
    return Sounding(name, level, depth[order], cone[order], (none if pressure is None else pressure)[order],
                    area_ratio if np.isfinite(area_ratio) else 1.0, datum, (note,) if note else ())


def whole(text: str) -> int:
    """-1 where the text is no whole number."""
    return int(text) if re.fullmatch(r"\s*\d{1,9}\s*", text) else -1


def number_of(text: str) -> float:
    """Not a number where the text is none, or one that no file means."""
    try:
        value = float(text)
    except ValueError:
        return float("nan")
    return value if abs(value) < 1e12 else float("nan")


def main(arguments: Sequence[str] | None = None) -> int:
    """The command."""
    parser = argparse.ArgumentParser(prog="python3 -m terp.soundings", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", metavar="FILE", help="GEF or BRO file of a cone penetration test")
    parser.add_argument("-o", "--output", required=True, metavar="FILE", help="the table")
    parser.add_argument("--nkt", type=float, default=17.0, help="N_kt (default: 17)")
    parser.add_argument("--unit-weight", type=float, default=17.0, metavar="W",
                        help="of the ground with its water [kN/m3] (default: 17)")
    parser.add_argument("--step", type=float, default=0.2, help="means over this depth [m] (default: 0.2)")
    options = parser.parse_args(arguments)
    return exit_status(lambda: write(options))


def write(options: argparse.Namespace) -> None:
    """Writes the table, and prints what is in it."""
    test = read_sounding(options.file)
    levels, values = test.strength(options.nkt, 1e3 * options.unit_weight, options.step)
    if not len(levels):
        raise RunError(f"{options.file} has no place where q_t is more than the weight above")
    with open(options.output, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["x", "y", "value"])
        for level, value in zip(levels, values):
            table.writerow(["0", f"{level:.3f}", f"{value:.0f}"])
    print(f"{options.output}: {len(levels)} values of {test.name}, levels {levels[-1]:.2f} to {levels[0]:.2f} m, "
          f"{test.datum}, S_u {values.min() / 1e3:.1f} to {values.max() / 1e3:.0f} kPa by N_kt = {options.nkt:g}")
    for note in (*test.notes, *notes_of(test, levels)):
        print(f"note: {note}")


def notes_of(test: Sounding, levels: Reals) -> list[str]:
    """What a user of the table should know."""
    notes = []
    lost = int(np.count_nonzero(~(np.isfinite(test.corrected()) & np.isfinite(test.depth))))
    if lost:
        notes.append(f"{lost} of {len(test.depth)} rows have no depth or no cone resistance")
    n_void = int(np.count_nonzero(~np.isfinite(test.pressure)))
    if n_void == len(test.depth):
        notes.append("no u_2: q_t was taken as q_c")
    elif test.area_ratio == 1.0:
        notes.append("no area ratio of the cone: q_t was taken as q_c")
    elif n_void:
        notes.append(f"{n_void} of {len(test.depth)} rows have no u_2: there q_t was taken as q_c")
    depth = test.depth[np.isfinite(test.depth)]
    between = np.ptp(depth) / max(len(depth) - 1, 1)
    if between < LEAST_BETWEEN_ROWS:
        notes.append(f"rows are {1e3 * between:.2g} mm of depth apart, usually 10 to 20 mm: is the unit of the depth "
                     "another one?")
    below = test.corrected() < LEAST_UNIT_WEIGHT * test.depth
    for odd, what in ((below, "q_t is less than the weight of the soil above"),
                      (test.pressure > test.cone, "u_2 is above q_c")):
        if 2 * np.count_nonzero(odd) > len(test.depth):
            notes.append(f"in {np.count_nonzero(odd)} of {len(test.depth)} rows {what}: is its unit another one?")
    if test.level - levels[0] > TOP_OF_VALUES:
        notes.append(f"the highest value lies {test.level - levels[0]:.2f} m below the ground at {test.level:.2f} m; "
                     "above it a case takes that value")
    return notes


if __name__ == "__main__":
    sys.exit(main())
