"""The commands of the program as functions: check, stability, study, converge, assess, compare, explain, import_stix.

Each calls the program, which is the one engine of them all, and reads the files that it writes. Options are those of
the command line, with `_` for `-`: terp.stability(case, cells=[2, 1]) is `terp stability CASE --cells 2,1`.
A case is a terp.Case, a path or a dictionary.
"""

from __future__ import annotations

import concurrent.futures
import contextlib
import json
import os
import pathlib
import tempfile
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from terp.answers import Answer, Check, Comparison, Convergence, Reach, Section, Stability, Still
from terp.errors import CaseError, RunError
from terp.program import Progress, call, case_file, option_words, shown
from terp.run import Run
from terp.studies import Study, read_csv
from terp.toml import toml_text

if TYPE_CHECKING:
    from terp.simulation import Case

Folder = str | os.PathLike[str]


def check(case: Case | Folder | Mapping[str, Any], changes: Mapping[str, Any] | None = None, *,
          threads: int | None = None, program: Folder | None = None) -> Check:
    """What would run: facts, warnings, a picture. Solves nothing. Raises CaseError for a case that cannot be run."""
    with case_file(case, changes) as words, tempfile.TemporaryDirectory() as scratch:
        picture = pathlib.Path(scratch) / "section.svg"
        ended = call(["check", *words, "--picture", str(picture), *option_words({"threads": threads})],
                     program=program)
        svg = picture.read_text(encoding="utf-8")
    text = "\n".join(line for line in ended.text.splitlines() if not line.startswith("picture in "))
    return Check(text, ended.messages, svg, _case(case, changes))


def stability(case: Case | Folder | Mapping[str, Any], changes: Mapping[str, Any] | None = None, *,
              output: Folder | None = None, progress: Progress = None, program: Folder | None = None,
              **options: Any) -> Stability:
    """The factor of safety by strength reduction. output: a folder that keeps the files of the search; None: none does.
    Ctrl-C leaves the trials so far in `output`: open_stability reads them."""
    with case_file(case, changes) as words, _folder(output) as folder:
        ended = call(["stability", *words, "-o", str(folder), *option_words(options)], program=program,
                     progress=progress, accepts=(0, 1))
        if not (folder / "stability.json").is_file():
            raise RunError(ended.messages.strip() or "the search was stopped before its first trial")
        return _read_stability(folder, ended.messages if output else ended.messages.replace(f"{folder}: ", ""))


def open_stability(folder: Folder) -> Stability:
    """What `terp stability` left in a folder."""
    return _read_stability(pathlib.Path(folder), "")


def converge(case: Case | Folder | Mapping[str, Any], cells: Iterable[float],
             changes: Mapping[str, Any] | None = None, *, output: Folder | None = None, progress: Progress = None,
             program: Folder | None = None, **options: Any) -> Convergence:
    """The case on several sizes of cells [m]: does the mesh matter? output: a folder that keeps the runs; the same call
    goes on there after Ctrl-C, and solves no size twice."""
    with case_file(case, changes) as words, _folder(output) as folder:
        ended = call(["converge", *words, "-o", str(folder), "--cells", ",".join(f"{cell!r}" for cell in cells),
                      *option_words(options)], program=program, progress=progress)
        return Convergence(read_json(folder / "convergence.json", "converge"), ended.messages)


def study(source: Folder | Mapping[str, Any], output: Folder, *, case: Case | Folder | Mapping[str, Any] | None = None,
          executor: concurrent.futures.Executor | None = None, parts: int | None = None, progress: Progress = None,
          program: Folder | None = None, **options: Any) -> Study:
    """Solves a study, or goes on with it, and returns its report.

    source: a study file, or a dictionary with the keys of one; case: the case of a dictionary, if not under its key.
    output: the folder of the study, which keeps what is solved; after Ctrl-C the same call goes on there.
    executor: any of concurrent.futures, of mpi4py.futures, or Dask's client.get_executor(): it solves `parts` of the
    study at once (default: the number of processors), which write to the one folder. It must see the file system of
    this process. Without it the program uses threads (option `threads`)."""
    with _study_file(source, case, output) as path:
        if executor is None:
            call(["study", "run", path, "-o", os.fspath(output), *option_words(options)], program=program,
                 progress=progress)
        else:
            _solve_parts(path, output, executor, parts or os.cpu_count() or 1, program, progress, options)
    return Study(output)


def assess(files: Folder | Iterable[Folder], output: Folder, *, progress: Progress = None,
           program: Folder | None = None, **options: Any) -> Reach:
    """All sections of a reach: D-Stability files, case files, folders with a case.toml. output: the folder of the
    reach; the same call goes on there after Ctrl-C, and keeps the sections that are solved."""
    paths = [files] if isinstance(files, (str, os.PathLike)) else list(files)
    if options.get("estimate"):
        raise ValueError("an estimate has no results: `terp assess --estimate` prints it")
    words = ["assess", *(os.fspath(path) for path in paths), "-o", os.fspath(output), *option_words(options)]
    ended = call(words, program=program, progress=progress, accepts=(0, 3))
    folder = pathlib.Path(output)
    return Reach(read_json(folder / "reach.json", "assess"), ended.text, ended.messages, folder,
                 read_csv(folder / "reach.csv"))


def compare(*runs: Run | Folder, program: Folder | None = None) -> Comparison:
    """What differs between runs, the first against each of the others."""
    folders = [str(run.folder) if isinstance(run, Run) else os.fspath(run) for run in runs]
    words = call(["compare", *folders], program=program)
    numbers = call(["compare", *folders, "--json"], program=program)
    return Comparison(json.loads(numbers.text), words.text, words.messages)


def explain(topic: str, *, program: Folder | None = None) -> Answer:
    """A key or section of the case file, a law, a scheme, an output: meaning, unit, range, default."""
    return Answer(call(["explain", topic], program=program).text)


def import_stix(file: Folder, output: Folder | None = None, *, program: Folder | None = None,
                **options: Any) -> Section:
    """What a file of D-Stability holds. output: a folder, which gets the case of a stage (`case` of the answer)."""
    ended = call(["import", os.fspath(file), "--json"], program=program)
    results, text = json.loads(ended.text), call(["import", os.fspath(file)], program=program).text
    if output is None:
        return Section(results, text, ended.messages, None, "")
    made = call(["import", os.fspath(file), "-o", os.fspath(output), *option_words(options)], program=program)
    folder = pathlib.Path(output)
    report = (folder / "report.md").read_text(encoding="utf-8")
    return Section(results, text, made.messages, _case(folder / "case.toml", None), report)


def read_json(path: pathlib.Path, command: str) -> dict[str, Any]:
    """A file that a command wrote. Raises RunError."""
    try:
        results: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError as error:
        raise RunError(f"{path} is not there: give the folder that `terp {command}` wrote") from error
    except ValueError as error:
        raise RunError(f"{path} cannot be read: {error}") from error
    return results


# Parts of a study


def _solve_parts(path: str, output: Folder, executor: concurrent.futures.Executor, parts: int,
                 program: Folder | None, progress: Progress, options: dict[str, Any]) -> None:
    """Each part is a process of the program, started by a worker of the executor."""
    show = shown(progress)
    words = ["study", "run", os.path.abspath(path), "-o", os.path.abspath(output),
             *option_words({"threads": 1, **options})]
    with tempfile.TemporaryDirectory(dir=pathlib.Path(path).parent, prefix="parts_") as scratch:
        stop = os.path.join(os.path.abspath(scratch), "stop")
        futures = [executor.submit(solve_part, [*words, "--part", f"{k}/{parts}"], program, stop)
                   for k in range(1, parts + 1)]
        try:
            for n, future in enumerate(concurrent.futures.as_completed(futures), 1):
                future.result()
                if show:
                    show(f"{n} of {parts} parts of the study are solved")
        finally:  # after Ctrl-C, or where a part failed
            if not all(future.done() for future in futures):
                pathlib.Path(stop).touch()
                for future in futures:
                    future.cancel()
                concurrent.futures.wait(futures)


def solve_part(words: list[str], program: Folder | None, stop: str) -> None:
    """What a worker does."""
    if not os.path.exists(stop):
        call(words, program=program, stop=stop)


@contextlib.contextmanager
def _study_file(source: Folder | Mapping[str, Any], case: Case | Folder | Mapping[str, Any] | None,
                output: Folder) -> Iterator[str]:
    """A study that is no file is one meanwhile, beside its folder, with its case."""
    if isinstance(source, (str, os.PathLike)):
        if case is not None:
            raise CaseError("a study file names its case: give `case` with a dictionary")
        yield os.fspath(source)
        return
    keys = dict(source)
    if case is not None:
        keys["case"] = case
    if "case" not in keys:
        raise CaseError("the study has no case: terp.study(..., case=...)")
    beside = pathlib.Path(output).absolute()
    beside.parent.mkdir(parents=True, exist_ok=True)
    from terp.simulation import Case
    given = Case(keys["case"])
    with contextlib.ExitStack() as stack:
        here = pathlib.Path(stack.enter_context(tempfile.TemporaryDirectory(dir=beside.parent,
                                                                            prefix=f"{beside.name}_study_")))
        if given.names_files:  # they lie beside it
            path, = stack.enter_context(case_file(given.unchanged))
            keys["case"] = os.path.relpath(path, here)
            keys["set"] = {**given.changes, **keys.get("set", {})}
        else:
            keys["case"] = f"{given.name}_case.toml"
            (here / keys["case"]).write_text(given.text, encoding="utf-8")
        (here / f"{beside.name}.toml").write_text(toml_text(keys), encoding="utf-8")
        yield str(here / f"{beside.name}.toml")


# Parts


def _case(case: Any, changes: Mapping[str, Any] | None) -> Case | None:
    """None: without the compiled part."""
    try:
        from terp.simulation import Case
    except ImportError:
        return None
    return case if isinstance(case, Case) and not changes else Case(case, changes)


@contextlib.contextmanager
def _folder(output: Folder | None) -> Iterator[pathlib.Path]:
    if output is not None:
        yield pathlib.Path(output)
        return
    with tempfile.TemporaryDirectory() as scratch:
        yield pathlib.Path(scratch) / "results"


def _read_stability(folder: pathlib.Path, messages: str) -> Stability:
    import tomllib
    results = read_json(folder / "stability.json", "stability")
    text = (folder / "stability.txt").read_text(encoding="utf-8")
    picture, mechanism = folder / "mechanism.svg", folder / "mechanism"
    svg = picture.read_text(encoding="utf-8") if picture.is_file() else ""
    still = None
    if mechanism.is_dir():
        still = Still(Run(mechanism).frame(-1), tomllib.loads(results["case"]))
    return Stability(results, text, messages, svg, still)
