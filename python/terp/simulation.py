"""Cases and runs in memory, from the compiled part of the package: docs/python.md."""

from __future__ import annotations

import json
import math
import operator
import os
import pathlib
import re
import tomllib
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any, cast

import numpy
import numpy.typing

from terp import _core
from terp.errors import CaseError, RunError
from terp.own_process import Remote
from terp.results import Frame, Results
from terp.tables import table_of
from terp.toml import toml_text, toml_value

MOST_THREADS = 1024  # as of the program


class Case(Mapping[str, Any]):
    """A case: the path of a case file, or a dictionary with the keys of one; Case.from_text takes TOML.

    changes: values by dotted key, as `--set` takes them: {"material.clay.eta": 40, "mesh.cell": "0.5 m"}.
    folder: of a dictionary; where the files lie that it names.
    A case does not change. It is read by dotted key, case["mesh.cell"], case["body[0].polygon"], and can be compared,
    copied and pickled. Raises CaseError with the program's message, which says where, what, and what to do."""

    def __init__(self, source: str | os.PathLike[str] | Mapping[str, Any], changes: Mapping[str, Any] | None = None,
                 folder: str = "."):
        if not isinstance(changes, (Mapping, type(None))):
            raise CaseError('changes are a dictionary by dotted key: {"mesh.cell": 0.5}')
        if isinstance(source, str) and "\n" in source:
            raise CaseError("a path has one line; terp.Case.from_text takes the text of a case")
        given = dict(changes or {})
        if isinstance(source, Case):
            self._set(source.source, source.path, {**source.changes, **given})
            self.is_file = source.is_file
        elif isinstance(source, (str, os.PathLike)):
            self._set(None, os.fspath(source), given)
        elif isinstance(source, Mapping):
            self._set(toml_text(source), str(pathlib.Path(folder) / "dictionary"), given)
        else:
            raise CaseError(f"a case is a path or a dictionary, not {type(source).__name__}")

    @classmethod
    def from_text(cls, text: str, changes: Mapping[str, Any] | None = None, folder: str = ".") -> Case:
        """A case from the text of a case file. folder: where the files lie that it names."""
        return case_of(text, str(pathlib.Path(folder) / "text"), dict(changes or {}))

    is_file: bool             # in this process: a pickled one may have been changed since
    source: str               # its text before the changes
    path: str
    changes: dict[str, Any]

    def _set(self, source: str | None, path: str, changes: dict[str, Any]) -> None:
        """source: None: that of the file."""
        words = [f"{key}={toml_value(value)}" for key, value in changes.items()]
        self._file = _core.read_case(path, words) if source is None else _core.read_case_text(source, path, words)
        self.is_file = source is None
        self.source = pathlib.Path(self._file.path).read_text(encoding="utf-8") if source is None else source
        self.path, self.changes = self._file.path, changes
        self._keys: dict[str, Any] = tomllib.loads(self._file.text)

    def changed(self, changes: Mapping[str, Any]) -> Case:
        """The same case with further changes; this one stays as it is."""
        return Case(self, changes)

    @property
    def unchanged(self) -> Case:
        """The same without its changes."""
        case = case_of(self.source, self.path, {})
        case.is_file = self.is_file
        return case

    def __getitem__(self, key: str) -> Any:
        """What the case says of a key, as it stands there; KeyError where it leaves the key to its default. A file has
        the name that its copy gets in a run folder."""
        value: Any = self._keys
        for part in re.findall(r'"[^"]*"|[^.\[\]"]+|\[\d+\]', key):
            try:
                value = value[int(part[1:-1]) if part[0] == "[" else part.strip('"')]
            except (KeyError, IndexError, TypeError):
                raise KeyError(f"the case does not give `{key}`; terp.explain({key!r}) says its default") from None
        return value

    def __iter__(self) -> Iterator[str]:
        return iter(self._keys)

    def __len__(self) -> int:
        return len(self._keys)

    def __eq__(self, other: object) -> bool:
        """The same keys and values, and the same folder of the files that they name."""
        if not isinstance(other, Case):
            return NotImplemented
        return self._keys == other._keys and (not self._file.names_files or self.folder.resolve()
                                              == other.folder.resolve())

    def __hash__(self) -> int:
        return hash(json.dumps(self._keys, sort_keys=True, default=str))

    def __copy__(self) -> Case:
        return self

    def __deepcopy__(self, memo: object) -> Case:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        return case_of, (self.source, os.path.abspath(self.path), self.changes)

    def __repr__(self) -> str:
        return f"<terp case {self._file.name}: {self.title}>" if self.title else f"<terp case {self._file.name}>"

    @property
    def text(self) -> str:
        """The case as TOML, with its changes."""
        return self._file.text

    @property
    def title(self) -> str:
        return self._file.title

    @property
    def name(self) -> str:
        """Of its file, without .toml; or that of the folder of a case.toml."""
        return self._file.name

    @property
    def folder(self) -> pathlib.Path:
        """Where the files lie that it names."""
        return pathlib.Path(self.path).parent

    @property
    def names_files(self) -> bool:
        """Whether it names files: with its text alone it cannot be solved elsewhere."""
        return self._file.names_files

    @property
    def warnings(self) -> str:
        """What `terp check` would say of the case alone; empty if nothing."""
        return self._file.warnings


def case_of(source: str, path: str, changes: dict[str, Any]) -> Case:
    """A case from its text, as one of that path."""
    case = Case.__new__(Case)
    case._set(source, path, changes)
    return case


def _is_false(answer: object) -> bool:
    """Of a comparison of numbers of numpy, too, whose False is another object."""
    return isinstance(answer, (bool, numpy.bool_)) and not answer


class _Present(Frame):
    """The points as they are; what was not read is gone once the run has gone on."""

    def __init__(self, run: Simulation) -> None:
        super().__init__(run, 0)
        self._n_steps = run.n_steps

    def _read(self, name: str) -> numpy.typing.NDArray[Any]:
        run: Any = self.run
        if run.n_steps != self._n_steps:
            raise RunError(f"the simulation has gone on from t = {self.time:g} s: ask it for its frame again")
        return super()._read(name)


class Simulation(Results):
    """A run in memory. It begins when it is first asked for a step.

    case: a Case, or what makes one. threads: of this run; the results have the same bits on any number.
    output: a folder for the files that `terp run` writes, for terp.open, `terp report` and `terp resume`; None: no
    files. force: remove the run that lies there. mesh_of: a Simulation of the same mesh, which is then shared.
    vary: names of parameters of laws, such as "su_peak", of which points have values of their own: set_field sets
    them. own_process: the run is in a process of its own, so that a law that calls STOP or crashes raises SolveError;
    None: if the case has a law of a library.

    Several simulations can run at once, each in a thread of its own. Raises CaseError for a case that cannot be set
    up, SolveError where the run stops itself, RunError for files. Ctrl-C ends a run after the step that it is in."""

    def __init__(self, case: Case | str | os.PathLike[str] | Mapping[str, Any], threads: int = 1,
                 output: str | os.PathLike[str] | None = None, force: bool = False,
                 mesh_of: Simulation | None = None, vary: Iterable[str] = (), own_process: bool | None = None):
        given = case if isinstance(case, Case) else Case(case)
        if isinstance(vary, str):
            raise TypeError(f"vary is a list of names: [{vary!r}]")
        if names := list(vary):
            given = given.changed(given._file.changes_to_vary(names))
        self._case = given
        if not isinstance(mesh_of, (Simulation, type(None))):
            raise TypeError(f"mesh_of is another Simulation, not {type(mesh_of).__name__}")
        if not 1 <= operator.index(threads) <= MOST_THREADS:
            raise CaseError(f"threads: {threads} is out of range; allowed are 1 to {MOST_THREADS}")
        folder = "" if output is None else os.fspath(output)
        if own_process is None:
            laws = given.get("material", {}).values()
            own_process = mesh_of is None and any(law.get("model") == "library" for law in laws)
        self._run: _core.Simulation
        if own_process:
            if mesh_of is not None:
                raise CaseError("a run in a process of its own shares no mesh: leave mesh_of or own_process out")
            self._run = cast(_core.Simulation,
                             Remote((given.source, given.path, given.changes), threads, folder, force))
        else:
            if mesh_of is not None and isinstance(mesh_of._run, Remote):
                raise CaseError("mesh_of: that simulation is in a process of its own, which shares no mesh\n"
                                "  Give it own_process=False.")
            self._run = _core.Simulation(given._file, threads, mesh_of._run if mesh_of else None, folder, force)

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
            call: Callable[[Simulation], object] | None = None) -> None:
        """Solves to the end of the case, or to `until` [s]. call: a function that is given this simulation now, then
        every `every` seconds of its time, and at the end; where it returns False the run ends there."""
        if (every is None) != (call is None):
            raise ValueError("give both `every` and `call`, or none of them")
        if math.isnan(until):
            raise ValueError("until must be a time, not nan")
        if call is None or every is None:
            self._run.run_until(until)
            return
        if not every > 0:
            raise ValueError(f"every must be a time above 0, not {every}")
        self.start()
        first, k = self.time, 0
        while not _is_false(call(self)) and not self.has_ended and self.time < until:
            k = max(k, math.floor((self.time - first) / every)) + 1  # a step may be longer than `every`
            self._run.run_until(min(first + k * every, until))

    def field(self, name: str) -> numpy.typing.NDArray[numpy.float64]:
        """A field of all points: "position", "velocity", "stress", "eps_eq_p", ...; shape [n_points] or
        [n_points, n_components], sorted by number of the point, SI units. NaN where a material has no such variable.
        `field(name)[soil]` leaves out the points of which there is no soil. `units` and `components` list them all. A
        parameter of a law goes by its key, "su_peak", too; frames call it "parameter_su_peak"."""
        try:
            return self._run.field(name)
        except CaseError:
            if (full := self._full_name(name)) == name:
                raise
            return self._run.field(full)

    def values(self, name: str, k: int = -1) -> numpy.typing.NDArray[numpy.float64]:
        """field(name): of a run in memory there is one frame, the present."""
        return self.field(name)

    def frame(self, k: int = -1) -> Frame:
        """All points as they are, as terp.Run has its frames."""
        if k not in (0, -1):
            raise IndexError(f"a run in memory has one frame, the present; there is no frame {k}")
        return _Present(self)

    @property
    def case(self) -> Case:
        """Its case, which does not change."""
        return self._case

    def place(self, file: str = "") -> str:
        return f"{file} of this simulation" if file else "this simulation"

    @property
    def times(self) -> numpy.typing.NDArray[numpy.float64]:
        """The present [s], shape [1]."""
        return numpy.array([self.time])

    @property
    def first_places(self) -> numpy.typing.NDArray[numpy.float64]:
        soil = self.soil
        moved: numpy.typing.NDArray[numpy.float64] = self.field("displacement")[soil, :2]
        return self.field("position")[soil] - moved

    @property
    def units(self) -> dict[str, str]:
        """{field: unit}, with "position"."""
        return {name: unit for name, unit, _, _ in self._run.fields()}

    @property
    def components(self) -> dict[str, tuple[str, ...]]:
        """{field: names of its components}, e.g. ("xx", "yy", "zz", "xy"); scalars are left out."""
        names = {2: ("x", "y"), 3: ("x", "y", "z"), 4: ("xx", "yy", "zz", "xy")}
        return {name: names[n] for name, _, n, _ in self._run.fields() if n > 1}

    def table(self, name: str) -> numpy.typing.NDArray[Any]:
        """A table of the run so far as a structured array: "ledger", "history", "footings", ...; those of its files.
        After restore() the rows from before it."""
        return table_of(self._run.table(name))

    @property
    def ledger(self) -> numpy.typing.NDArray[Any]:
        """Energies, mass, momentum, front and crest over time, as terp.Run has it."""
        return self.table("ledger")

    @property
    def history(self) -> numpy.typing.NDArray[Any]:
        """Named points over time, as terp.Run has it."""
        return self.table("history")

    def profile(self, x: float) -> numpy.typing.NDArray[Any]:
        """Stress, stiffness and strength down the line at x [m], as `terp check --profile` prints them, in SI units: a
        row for each cell that the line crosses. Of a run at its start."""
        rows = self._run.profile(float(x))
        strengths = list(dict.fromkeys(name for row in rows for name in row[8]))
        columns = ["depth", "y", "material", "stress", "pore", "last_stress", "yield_stress", "shear_modulus"]
        table = numpy.empty(len(rows), [(name, "U64" if name == "material" else float)
                                        for name in columns + strengths])
        for k, row in enumerate(rows):
            table[k] = (*row[:8], *(row[8].get(name, math.nan) for name in strengths))
        return table

    def _full_name(self, name: str) -> str:
        """That of the field of a parameter."""
        return f"parameter_{name}" if f"parameter_{name}" in self.units else name

    @property
    def soil(self) -> numpy.typing.NDArray[numpy.bool_]:
        """Which points are soil now, shape [n_points]. False: the body of the point is not placed yet or was removed,
        or the point left through an open side."""
        return self.field("material") >= 0

    def set_field(self, name: str, values: numpy.typing.ArrayLike) -> None:
        """Sets velocity, stress, strain, volume, a variable of the laws, or a parameter that `vary` or the case lets
        differ from point to point; shape and order as field() gives them.

        Parameters are set before the initial stress is found, if nothing was asked of the run yet. Those that the case
        finds from one by a ratio, as `sensitivity` and `stiffness_ratio` do from su_peak, change in proportion. For
        all else, start() is done first, which would set some of it."""
        name = self._full_name(name)
        fields = {field: is_parameter for field, _, _, is_parameter in self._run.fields()}
        if not fields.get(name):
            self.start()
        if name not in fields:
            for_all = f'terp.Simulation(case, vary=["{name}"])'
            raise CaseError(f"{name}: points have no field of this name\n  A parameter of a law has one value for all "
                            f"points, unless they are given values of their own: {for_all}.")
        given: Any = numpy.ma.asarray(values)  # type: ignore[no-untyped-call]
        shape = self.field(name).shape
        if given.dtype.kind not in "buif" or numpy.ma.getmaskarray(given).any():  # type: ignore[no-untyped-call]
            raise CaseError(f"{name}: real numbers are needed, none of them masked; got {given.dtype}")
        if given.shape != shape:
            raise CaseError(f"{name}: values of shape {given.shape} were given\n"
                            f"  Its shape is {shape}, sorted by number of the point.")
        self._run.set_field(name, numpy.asarray(given, dtype=float))

    def blocks(self, name: str) -> list[numpy.typing.NDArray[numpy.float64]]:
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

    def __repr__(self) -> str:
        return f"<terp simulation of {self.case.name}, t = {self.time:g} of {self.end_time:g} s>"

    def __enter__(self) -> Simulation:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    @property
    def summary(self) -> dict[str, Any]:
        """What summary.json says of the run as it is, as a dictionary: docs/formats.md."""
        summary: dict[str, Any] = json.loads(self._run.summary)
        return summary

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
    def nodes(self) -> numpy.typing.NDArray[numpy.float64]:
        """Of the background mesh [m], shape [n_nodes, 2]; a view, read-only."""
        return self._run.nodes

    @property
    def cells(self) -> numpy.typing.NDArray[numpy.int32]:
        """Nodes of each cell, counter-clockwise, shape [n_cells, 4]; a view, read-only."""
        return self._run.cells
