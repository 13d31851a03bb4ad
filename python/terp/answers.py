"""What the commands of the program answer, as objects: texts, tables, numbers and pictures.

Each prints as the program does, and as a table or picture in a notebook. They hold all that they show, so that they can
be pickled, and outlive their files.
"""

from __future__ import annotations

import html
import math
import pathlib
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from terp.errors import RunError
from terp.results import Frame, Results

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from terp.simulation import Case

Table = npt.NDArray[Any]
"""A structured array; terp.to_pandas makes a data frame of it."""


class Answer:
    """What a command printed (`text`), and its warnings (`warnings`)."""

    def __init__(self, text: str, warnings: str = "") -> None:
        self.text = text.rstrip()
        self.warnings = warnings.strip()

    def __repr__(self) -> str:
        return f"{self.text}\n\n{self.warnings}" if self.warnings else self.text

    def _repr_html_(self) -> str:
        return self._shown() + _pre(self.warnings)

    def _shown(self) -> str:
        return _pre(self.text)


class JsonAnswer(Answer, Mapping[str, Any]):
    """An answer with the file of the program for programs: it is a dictionary of that, too."""

    def __init__(self, results: dict[str, Any], text: str, warnings: str = "") -> None:
        super().__init__(text, warnings)
        self.results = results

    def __getitem__(self, key: str) -> Any:
        return self.results[key]

    def __iter__(self) -> Any:
        return iter(self.results)

    def __len__(self) -> int:
        return len(self.results)

    def __reduce__(self) -> tuple[Any, ...]:
        return _with_state, (type(self), self.__dict__)


def _with_state(kind: type[Any], state: dict[str, Any]) -> Any:
    made: Any = object.__new__(kind)
    made.__dict__.update(state)
    return made


class Check(Answer):
    """What `terp check` says of a case: facts, warnings, a picture of the section."""

    def __init__(self, text: str, warnings: str, svg: str, case: Case | None) -> None:
        super().__init__(text, warnings)
        self.svg = svg
        self.case = case

    @property
    def table(self) -> Table:
        """The facts, a row of name and value each, in the order of the text."""
        lines = [line for line in self.text.splitlines()[1:] if line.startswith("  ") and line[2:3].strip()
                 and not line.startswith("  profile at")]
        rows = [(line[2:16].strip(), line[17:].strip()) for line in lines]
        return np.array(rows, [("name", "U24"), ("value", f"U{max((len(value) for _, value in rows), default=1)}")])

    def profile(self, x: float) -> Table:
        """Stress, stiffness and strength down the line at x [m]: Simulation.profile."""
        from terp.simulation import Simulation
        return Simulation(self._case()).profile(x)

    def plot(self, panel: Axes | None = None) -> Axes:
        """The section: soils and cells."""
        from terp import plot
        from terp.simulation import Simulation
        return plot.section(Simulation(self._case()), panel)

    def _case(self) -> Case:
        if self.case is None:
            raise ImportError("a section is drawn by the compiled part of the package, which is not here")
        return self.case

    def _shown(self) -> str:
        return self.svg + html_table(self.table)


class Stability(JsonAnswer):
    """What `terp stability` found: factor of safety, mechanism, trials. Keys are those of stability.json."""

    def __init__(self, results: dict[str, Any], text: str, warnings: str, svg: str, still: Still | None) -> None:
        super().__init__(results, text, warnings)
        self.svg, self.still = svg, still

    @property
    def factor(self) -> float:
        """Factor of safety [-]; NaN: none was found."""
        return _number(self.results["factor_of_safety"])

    @property
    def bounds(self) -> tuple[float, float]:
        """Factors at which the soil stands and does not [-]."""
        return _number(self.results["stable_at"]), _number(self.results["not_stable_at"])

    @property
    def table(self) -> Table:
        """The trials by factor: verdict, and the last displacement [m] and force out of balance over weight [-]."""
        rows = [(trial["factor"], trial["verdict"], *(trial[name][-1] if trial[name] else math.nan
                                                      for name in ("displacement", "out_of_balance")))
                for trial in self.results["trials"]]
        return np.sort(np.array(rows, [("factor", float), ("verdict", "U16"), ("displacement", float),
                                       ("out_of_balance", float)]), order="factor")

    def plot(self, field: str = "displacement_increment", panel: Axes | None = None) -> Axes:
        """The mechanism at failure: what moved, or shear_increment, in the last window of the trial that failed."""
        from terp import plot, style
        if self.still is None:
            raise RunError("no trial failed: there is no mechanism to draw")
        panel = plot.field(self.still, field, panel=panel)
        if line := (self.results.get("mechanism") or {}).get("slip_surface"):
            panel.plot(*np.transpose(line), color="black", lw=1.2, zorder=5)
        with style.house_style():
            panel.set_title(f"factor {self.factor:.3f}")
        return panel

    def _shown(self) -> str:
        return _pre(self.text.partition("\n")[0]) + self.svg + html_table(self.table)


class Convergence(JsonAnswer):
    """What `terp converge` found. Keys are those of convergence.json."""

    def __init__(self, results: dict[str, Any], warnings: str = "") -> None:
        sentences = [f"{sequence['name']}: {sequence['answer']}" + "".join(
            f"\n  {quantity['sentence']}" for quantity in sequence["quantities"]) for sequence in results["sequences"]]
        super().__init__(results, "\n".join(sentences), warnings)

    @property
    def table(self) -> Table:
        """A row per quantity of the sequence as given: answer, order, limit, error, and its value on each size."""
        first = self.results["sequences"][0]
        sizes = [f"{run['cell']:g} m" for run in first["runs"]]
        rows = [(q["name"], q["unit"], q["answer"], *(_number(q[name]) for name in ("order", "limit", "error")),
                 *map(_number, q["values"])) for q in first["quantities"]]
        return np.array(rows, [("quantity", "U48"), ("unit", "U12"), ("answer", "U16"),
                               *((name, float) for name in ("order", "limit", "error", *sizes))])

    def plot(self, quantity: str, panel: Axes | None = None) -> Axes:
        """A quantity over the size of the cells, a line for each sequence; the dashed line is the estimated limit."""
        from terp import plot
        from terp.errors import unknown
        names = [q["name"] for q in self.results["sequences"][0]["quantities"]]
        if quantity not in names:
            raise unknown(quantity, names, "quantity", "this convergence")
        return plot.convergence(self.results["sequences"], quantity, panel)

    def _shown(self) -> str:
        answers = "".join(f"<p>{html.escape(s['name'])}: {html.escape(s['answer'])}</p>"
                          for s in self.results["sequences"])
        return answers + html_table(self.table)


class Comparison(JsonAnswer):
    """What `terp compare` says of runs. Keys are those of `terp compare --json`."""

    @property
    def table(self) -> Table:
        """A row per quantity, a column per run."""
        columns = [f"{name} ({k + 1})" if self.results["columns"].count(name) > 1 else name
                   for k, name in enumerate(self.results["columns"])]
        rows = [(row["label"], row["unit"], *map(_number, row["values"])) for row in self.results["rows"]]
        return np.array(rows, [("quantity", "U64"), ("unit", "U12"), *((name, float) for name in columns)])

    def _shown(self) -> str:
        return html_table(self.table) + _pre(self.text.partition("\n\n")[2])


class Reach(JsonAnswer):
    """What `terp assess` found of sections. Keys are those of reach.json."""

    def __init__(self, results: dict[str, Any], text: str, warnings: str, folder: pathlib.Path, table: Table) -> None:
        super().__init__(results, text, warnings)
        self.folder = folder
        self._table = table

    @property
    def table(self) -> Table:
        """reach.csv: a row per section. Columns and units: docs/assess.md."""
        return self._table

    @property
    def page(self) -> pathlib.Path:
        """index.html, for a browser."""
        return self.folder / "index.html"

    def _shown(self) -> str:
        names = [name for name in ("section", "state", "verdict", "factor", "residual_height_m", "freeboard_m", "hints")
                 if name in (self._table.dtype.names or ())]
        return html_table(self._table[names])


class Section(JsonAnswer):
    """What a file of D-Stability holds, with `case` the case that was made of it, and `report` what was doubted."""

    def __init__(self, results: dict[str, Any], text: str, warnings: str, case: Case | None, report: str) -> None:
        super().__init__(results, text, warnings)
        self.case, self.report = case, report

    @property
    def table(self) -> Table:
        """A row per calculation: numbers of its scenario and stage, from 1, method, stored factor of safety [-]."""
        rows = [(n, scenario["label"], calculation["stage"], calculation["method"],
                 _number((calculation.get("result") or {}).get("factor_of_safety")))
                for n, scenario in enumerate(self.results["scenarios"], 1) for calculation in scenario["calculations"]]
        return np.array(rows, [("scenario", int), ("label", "U64"), ("stage", int), ("method", "U32"),
                               ("factor_of_safety", float)])

    def _shown(self) -> str:
        return html_table(self.table) + _pre(self.report)


class Still(Results):
    """One frame of points that outlives its file, for pictures."""

    def __init__(self, frame: Frame, case: Mapping[str, Any]) -> None:
        self._place, self._case = frame.run.place(), dict(case)
        self._times = np.array([frame.time])
        self._units, self._components = dict(frame.run.units), dict(frame.run.components)
        self._values = {name: np.array(frame[name]) for name in self._units}
        self._first: npt.NDArray[np.float64] = frame.x[frame.soil]

    @property
    def times(self) -> npt.NDArray[np.float64]:
        return self._times

    @property
    def units(self) -> dict[str, str]:
        return self._units

    @property
    def components(self) -> dict[str, tuple[str, ...]]:
        return self._components

    @property
    def case(self) -> Mapping[str, Any]:
        return self._case

    @property
    def summary(self) -> dict[str, Any]:
        return {}

    @property
    def ledger(self) -> npt.NDArray[Any]:
        raise RunError(f"{self._place} is one frame, without a ledger")

    @property
    def history(self) -> npt.NDArray[Any]:
        raise RunError(f"{self._place} is one frame, without a history")

    def place(self, file: str = "") -> str:
        return f"{file} of {self._place}" if file else self._place

    def frame(self, k: int) -> Frame:
        return Frame(self, 0)

    def values(self, name: str, k: int) -> npt.NDArray[Any]:
        return self._values[name]

    @property
    def first_places(self) -> npt.NDArray[np.float64]:
        return self._first


# HTML


def html_table(table: Table, most: int = 60) -> str:
    """A structured array as an HTML table, with its first rows."""
    names: Sequence[str] = table.dtype.names or ()
    head = "".join(f"<th>{html.escape(name)}</th>" for name in names)
    rows = "".join("<tr>" + "".join(f"<td>{html.escape(_cell(row[name]))}</td>" for name in names) + "</tr>"
                   for row in table[:most])
    more = f"<p>{len(table) - most} more rows</p>" if len(table) > most else ""
    return f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>{more}"


def _cell(value: Any) -> str:
    if isinstance(value, (float, np.floating)):
        return "" if math.isnan(value) else f"{value:.6g}"
    return str(value)


def _pre(text: str) -> str:
    return f"<pre>{html.escape(text)}</pre>" if text else ""


def _number(value: float | str | None) -> float:
    """NaN: none, or a word such as the side that a slope faces."""
    return float(value) if isinstance(value, (int, float)) else math.nan


