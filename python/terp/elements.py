"""Element tests: a soil by itself on the path of a laboratory test, or on any path of strains and stresses."""

from __future__ import annotations

import math
import os
import warnings
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy
import numpy.typing

from terp import _core
from terp.errors import CaseError
from terp.simulation import Case
from terp.toml import toml_text

INCREMENTS = 1000  # to each turning point, as of `terp element`


class ElementTest(Mapping[str, "numpy.typing.NDArray[numpy.float64]"]):
    """What the soil did: columns by name as numpy arrays over the increments, the start first.

    test["mean_pressure"], test["deviator"], ...: the columns of the table of `terp element` (docs/element.md).
    fault: why the path was not followed to its end; empty if it was."""

    def __init__(self, material: str, columns: list[Any], fault: str):
        self.material, self.fault = material, fault
        self._columns = {name: numpy.array(values) for name, _, _, values in columns}
        self.units = {name: unit for name, unit, _, _ in columns}
        self.labels = {name: label for name, _, label, _ in columns}

    def __getitem__(self, name: str) -> numpy.typing.NDArray[numpy.float64]:
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __repr__(self) -> str:
        return f"<ElementTest of {self.material}: {len(self['time']) - 1} increments, {len(self)} columns>"

    def to_pandas(self) -> Any:
        """The columns as a pandas.DataFrame."""
        import pandas

        return pandas.DataFrame(self._columns)

    def plot(self, axes: Any = None, **line: Any) -> Any:
        """Draws q over p', q over the deviator strain, the volume or void ratio over log p', and the pore pressure
        into four axes of matplotlib, and returns them."""
        if axes is None:
            import matplotlib.pyplot as plt

            axes = plt.subplots(2, 2, figsize=(8.0, 6.5), layout="constrained")[1].ravel()
        line.setdefault("label", self.material)
        volume = "void_ratio" if "void_ratio" in self else "volume_strain"
        pictures = [("mean_pressure", "deviator"), ("deviator_strain", "deviator"), ("mean_pressure", volume),
                    ("deviator_strain", "pore_pressure")]
        for axis, (x, y) in zip(axes, pictures, strict=True):
            axis.plot(self[x] * self._scale(x), self[y] * self._scale(y), **line)
            axis.set_xlabel(self._label(x))
            axis.set_ylabel(self._label(y))
        axes[2].set_xscale("log")
        return axes

    def _scale(self, name: str) -> float:
        return 1e-3 if self.units[name] == "Pa" else 1.0

    def _label(self, name: str) -> str:
        return f"{self.labels[name]}{' [kPa]' if self.units[name] == 'Pa' else ''}"


def _file_of(case: Any) -> Any:
    if isinstance(case, Case):
        return case._file
    if isinstance(case, (str, os.PathLike)) and "\n" not in str(case):
        return _core.read_element_case(os.fspath(case), [])
    text = toml_text(case) if isinstance(case, Mapping) else case
    if not isinstance(text, str):
        raise CaseError(f"a case is a path, a text or a dictionary, not {type(case).__name__}")
    return _core.read_element_case_text(text, "text", [])


def _csv_of(path: Mapping[str, Sequence[float | None]]) -> str:
    """A dictionary of columns as a table; None and nan leave a cell empty."""
    rows = zip(*path.values(), strict=True)
    return "\n".join([",".join(path), *(",".join(map(_cell_of, row)) for row in rows)]) + "\n"


def _cell_of(value: float | None) -> str:
    return "" if value is None or math.isnan(value) else repr(float(value))


def element(case: Case | str | os.PathLike[str] | Mapping[str, Any], material: str | None = None,
            test: str = "triaxial", *, strain: float | Sequence[float] | None = None,
            load: float | Sequence[float] | None = None,
            path: str | os.PathLike[str] | Mapping[str, Sequence[float | None]] | None = None,
            pressure: float | None = None, k0: float = 1.0,
            stress: Sequence[float] | None = None, at: tuple[float, float] | None = None, undrained: bool = False,
            increments: int | None = None, duration: float = 1000.0, void_ratio: float | None = None) -> ElementTest:
    """Drives a material of a case through a test: isotropic, oedometer, triaxial, biaxial or shear.

    case: a Case, a file, a text or a dictionary; materials alone will do. material: its name, if there are several.
    strain, load: turning points of what the test drives: strain [-] or stress [Pa], compression positive.
    path: instead of a test, a CSV file or a dictionary of its columns, tension positive (docs/element.md).
    pressure, k0: vertical effective stress at the start [Pa], and that across over it; without it that of the place
    or the body, or 100 kPa. stress: instead xx yy zz xy, tension positive. at: x and y of the element in the section
    [m], where parameters vary.
    Raises CaseError for what is asked wrongly; warns where the soil does not go all the way."""
    file = _file_of(case)
    names = _core.materials(file)
    if material is None and len(names) > 1:
        raise CaseError(f"the case has several materials: give one of {', '.join(names)}")
    material = names[0] if material is None else material
    soil = _core.Element(file, material, at)
    xx, yy, zz, xy = soil.stress if pressure is None else (-pressure, -pressure, -pressure, 0.0)
    start = [k0 * xx, yy, k0 * zz, xy] if stress is None else list(stress)
    if len(start) != 4:
        raise CaseError("stress has four components: xx, yy, zz, xy [Pa]")
    e0 = math.nan if void_ratio is None else void_ratio
    if path is not None:
        if strain is not None or load is not None:
            raise CaseError("give either a path, or the strain or load of a test")
        name, table = ("path", _csv_of(path)) if isinstance(path, Mapping) else (os.fspath(path), "")
        columns, fault = soil.path(name, table, start, undrained, increments or 0, duration, e0)
    else:
        if test not in _core.element_tests():
            raise CaseError(f"there is no test `{test}`: give one of {', '.join(_core.element_tests())}")
        given = strain if load is None else load
        if given is None or (strain is not None and load is not None):
            raise CaseError("give either strain or load: the turning points of the test")
        points = numpy.atleast_1d(numpy.asarray(given, dtype=float)).tolist()
        columns, fault = soil.test(test, start, undrained, points if load is None else [],
                                  points if strain is None else [], increments or INCREMENTS, duration, e0)
    if fault:
        warnings.warn(f"the soil `{material}` does not follow the path to its end: {fault}", stacklevel=3)
    return ElementTest(material, columns, fault)
