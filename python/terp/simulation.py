"""Cases and runs in memory, from the compiled part of the package: docs/python.md."""

import json
import math
import operator
import os
import pathlib
from collections.abc import Callable, Mapping

import numpy
import numpy.typing

from terp import _core
from terp.errors import CaseError
from terp.toml import toml_text, toml_value

MOST_THREADS = 1024  # as of the program


class _Text(str):
    """The text of a case, not its path."""


class Case:
    """A case: the path of a case file, or a dictionary with the keys of one; Case.from_text takes TOML.

    changes: values by dotted key, as `--set` takes them: {"material.clay.eta": 40, "mesh.cell": "0.5 m"}.
    folder: of a dictionary; where the files lie that it names.
    Raises CaseError with the program's message, which says where, what, and what to do."""

    def __init__(self, source: str | os.PathLike | dict, changes: dict | None = None, folder: str = "."):
        if not isinstance(changes, (Mapping, type(None))):
            raise CaseError('changes are a dictionary by dotted key: {"mesh.cell": 0.5}')
        if isinstance(source, str) and "\n" in source:
            raise CaseError("a path has one line; terp.Case.from_text takes the text of a case")
        self._set(source, folder, dict(changes or {}))

    @classmethod
    def from_text(cls, text: str, changes: dict | None = None, folder: str = ".") -> "Case":
        """A case from the text of a case file. folder: where the files lie that it names."""
        case = cls.__new__(cls)
        case._set(_Text(text), folder, dict(changes or {}))
        return case

    def _set(self, source, folder, changes):
        self._source, self._folder, self._changes = source, folder, changes
        words = [f"{key}={toml_value(value)}" for key, value in self._changes.items()]
        if isinstance(source, _Text):
            self._file = _core.read_case_text(source, str(pathlib.Path(folder) / "text"), words)
        elif isinstance(source, (str, os.PathLike)):
            self._file = _core.read_case(os.fspath(source), words)
        elif isinstance(source, dict):
            self._file = _core.read_case_text(toml_text(source), str(pathlib.Path(folder) / "dictionary"), words)
        else:
            raise CaseError(f"a case is a path or a dictionary, not {type(source).__name__}")

    def changed(self, changes: dict) -> "Case":
        """The same case with further changes; this one stays as it is."""
        case = Case.__new__(Case)
        case._set(self._source, self._folder, {**self._changes, **changes})
        return case

    @property
    def text(self) -> str:
        """The case as TOML, with its changes."""
        return self._file.text

    @property
    def title(self) -> str:
        return self._file.title

    @property
    def warnings(self) -> str:
        """What `terp check` would say of the case alone; empty if nothing."""
        return self._file.warnings


def _is_false(answer) -> bool:
    """Of a comparison of numbers of numpy, too, whose False is another object."""
    return isinstance(answer, (bool, numpy.bool_)) and not answer


class Simulation:
    """A run in memory. It begins when it is first asked for a step.

    case: a Case, or what makes one. threads: of this run; the results have the same bits on any number.
    output: a folder for the files that `terp run` writes, for terp.open, `terp report` and `terp resume`; None: no
    files. force: remove the run that lies there. mesh_of: a Simulation of the same mesh, which is then shared.

    Several simulations can run at once, each in a thread of its own. Raises CaseError for a case that cannot be set
    up, SolveError where the run stops itself, RunError for files. Ctrl-C ends a run after the step that it is in."""

    def __init__(self, case: Case | str | os.PathLike | dict, threads: int = 1,
                 output: str | os.PathLike | None = None, force: bool = False, mesh_of: "Simulation | None" = None):
        self.case = case if isinstance(case, Case) else Case(case)
        if not isinstance(mesh_of, (Simulation, type(None))):
            raise TypeError(f"mesh_of is another Simulation, not {type(mesh_of).__name__}")
        if not 1 <= operator.index(threads) <= MOST_THREADS:
            raise CaseError(f"threads: {threads} is out of range; allowed are 1 to {MOST_THREADS}")
        self._run = _core.Simulation(self.case._file, threads, mesh_of and mesh_of._run,
                                     "" if output is None else os.fspath(output), force)

    def start(self) -> None:
        """Finds the initial stress. The first step does it, too; after it, fields can be set."""
        self._run.start()

    def step(self, n: int = 1) -> None:
        """Makes n steps, beyond the end of the case if n says so."""
        self._run.step(n)

    def advance_to(self, time: float) -> None:
        """Makes steps up to the first one at or after `time` [s], which may lie beyond the end of the case."""
        self._run.advance_to(time)

    def run(self, until: float = float("inf"), every: float | None = None,
            call: Callable[["Simulation"], object] | None = None) -> None:
        """Solves to the end of the case, or to `until` [s]. call: a function that is given this simulation now, then
        every `every` seconds of its time, and at the end; where it returns False the run ends there."""
        if (every is None) != (call is None):
            raise ValueError("give both `every` and `call`, or none of them")
        if math.isnan(until):
            raise ValueError("until must be a time, not nan")
        if call is None:
            self._run.run_until(until)
            return
        if not every > 0:
            raise ValueError(f"every must be a time above 0, not {every}")
        self.start()
        first, k = self.time, 0
        while not _is_false(call(self)) and not self.has_ended and self.time < until:
            k = max(k, math.floor((self.time - first) / every)) + 1  # a step may be longer than `every`
            self._run.run_until(min(first + k * every, until))

    def field(self, name: str) -> numpy.ndarray:
        """A field of all points: "position", "velocity", "stress", "eps_eq_p", ...; shape [n_points] or
        [n_points, n_components], sorted by number of the point, SI units. NaN where a material has no such variable.
        `field(name)[soil]` leaves out the points of which there is no soil."""
        return self._run.field(name)

    @property
    def soil(self) -> numpy.ndarray:
        """Which points are soil now, shape [n_points]. False: the body of the point is not placed yet or was removed,
        or the point left through an open side."""
        return self.field("material") >= 0

    def set_field(self, name: str, values: numpy.typing.ArrayLike) -> None:
        """Sets velocity, stress, strain, volume or a variable of the laws; shape and order as field() gives them.
        Does what start() does before, which would set some of them."""
        self.start()
        given, shape = numpy.ma.asarray(values), self.field(name).shape
        if given.dtype.kind not in "buif" or numpy.ma.is_masked(given):
            raise CaseError(f"{name}: real numbers are needed, none of them masked; got {given.dtype}")
        if given.shape != shape:
            raise CaseError(f"{name}: values of shape {given.shape} were given\n"
                            f"  Its shape is {shape}, sorted by number of the point.")
        self._run.set_field(name, numpy.asarray(given, dtype=float))

    def blocks(self, name: str) -> list[numpy.ndarray]:
        """A row of the points without a copy: views of memory, one for each block of points of a cell, which change as
        the run goes on. Points move between blocks: ask again after steps. Read-only. Names: those of checkpoints."""
        return self._run.blocks(name)

    def save(self) -> _core.SavedState:
        """The state, for restore()."""
        return self._run.save()

    def restore(self, state: _core.SavedState) -> None:
        """Back to a saved state of this case, also of another Simulation of it. Laws may have other parameters. Raises
        CaseError in a run with files, which do not go back."""
        self._run.restore(state)

    def close(self) -> None:
        """Ends the files of a run that is not at its end: its summary, and a checkpoint for `terp resume`. `with` does
        it, too."""
        self._run.finish()

    def __enter__(self) -> "Simulation":
        return self

    def __exit__(self, *error) -> None:
        self.close()

    @property
    def summary(self) -> dict:
        """What summary.json says of the run as it is, as a dictionary: docs/formats.md."""
        return json.loads(self._run.summary)

    @property
    def flood(self) -> dict | None:
        """The verdict on the water, summary["flood"]; None without a water level, or before the first step."""
        return self.summary["flood"]

    @property
    def warnings(self) -> str:
        """What `terp check` would say of the section; empty if nothing."""
        return self.case.warnings + self._run.warnings

    @property
    def time(self) -> float:
        """[s]"""
        return self._run.time

    @property
    def end_time(self) -> float:
        """At which the case ends at the latest [s]."""
        return self._run.end_time

    @property
    def has_ended(self) -> bool:
        return self._run.has_ended

    @property
    def stage(self) -> str:
        """Name of the stage that it is in; empty without stages."""
        return self._run.stage

    @property
    def n_steps(self) -> int:
        """Made so far."""
        return self._run.n_steps

    @property
    def dt(self) -> float:
        """Time step [s]."""
        return self._run.dt

    @property
    def n_points(self) -> int:
        return self._run.n_points

    @property
    def nodes(self) -> numpy.ndarray:
        """Of the background mesh [m], shape [n_nodes, 2]; a view, read-only."""
        return self._run.nodes

    @property
    def cells(self) -> numpy.ndarray:
        """Nodes of each cell, counter-clockwise, shape [n_cells, 4]; a view, read-only."""
        return self._run.cells
