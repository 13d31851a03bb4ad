"""The program `terp` as the functions of commands.py call it: where it is, its progress, its errors, Ctrl-C.

The program runs in a session of its own, so that Ctrl-C reaches Python alone. Python hands it on once, and waits until
what is solved is kept. A file `stop` does the same for programs that other processes wait for.
"""

from __future__ import annotations

import contextlib
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Iterator, Mapping
from typing import IO, TYPE_CHECKING, Any, NamedTuple

from terp.errors import CaseError, RunError, SolveError
from terp.toml import toml_value

if TYPE_CHECKING:
    from terp.simulation import Case

Progress = bool | Callable[[str], object] | None
"""True: show it; False: do not; None: show it in a notebook and on a terminal; or a function that is given lines."""

LOOK = 0.2  # between looks at the file `stop` [s]


class Ended(NamedTuple):
    """What a command printed, and what it said of warnings and progress."""

    status: int
    text: str
    messages: str


def find_program(program: str | os.PathLike[str] | None = None) -> str:
    """The path of `terp`: as given, $TERP, that of this package, or that of the system."""
    import terp
    if program is not None:
        return os.fspath(program)
    beside = [*(pathlib.Path(folder).parents[1] / "terp" for folder in terp.__path__),  # build/python/terp
              pathlib.Path(sys.prefix) / "bin" / "terp"]  # of a wheel
    for path in [os.environ.get("TERP"), *beside, shutil.which("terp")]:
        if path and os.access(path, os.X_OK) and os.path.isfile(path):
            return str(path)
    raise RunError("the program `terp` is not found: install it, or name it by the environment variable TERP")


def call(words: list[str], *, program: str | os.PathLike[str] | None = None, progress: Progress = False,
         stop: str | os.PathLike[str] | None = None, accepts: tuple[int, ...] = (0,)) -> Ended:
    """Runs the program. accepts: exit statuses that are an answer; others, and errors, raise what the program says.
    stop: a file; once it is there the program is asked to end."""
    show = shown(progress)
    quiet = [] if show else ["-q"] if words[0] in ("stability", "converge", "study", "run") else []
    try:
        process = subprocess.Popen([find_program(program), *words, *quiet], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True, encoding="utf-8", errors="replace",
                                   stdin=subprocess.DEVNULL, start_new_session=True)
    except OSError as error:
        raise RunError(f"cannot start `{program}`: {error.strerror}. Give the path of the program") from error
    texts: list[list[str]] = [[], []]
    of_text = show if words[0] == "assess" else None  # it prints its progress
    readers = [threading.Thread(target=_read, args=(stream, kept, show_line), daemon=True)
               for stream, kept, show_line in zip((process.stdout, process.stderr), texts, (of_text, show))]
    for reader in readers:
        reader.start()
    with process:
        asked_by = _wait(process, stop)
        for reader in readers:
            reader.join()
    ended = Ended(process.returncode, "".join(texts[0]), "".join(texts[1]))
    if asked_by == "Ctrl-C":
        raise KeyboardInterrupt
    if not asked_by and (ended.status not in accepts or (ended.status == 1 and "error: " in ended.messages)):
        _raise(ended)
    return ended


def _wait(process: subprocess.Popen[str], stop: str | os.PathLike[str] | None) -> str:
    """Until it has ended. Returns who asked for it: "Ctrl-C", "stop", or nobody."""
    asked_by = ""
    while True:
        try:
            process.wait(LOOK if stop and not asked_by else None)
            return asked_by
        except subprocess.TimeoutExpired:
            if stop and os.path.exists(stop):
                asked_by = "stop"
                process.send_signal(signal.SIGINT)
        except KeyboardInterrupt:  # the second one does not wait
            process.send_signal(signal.SIGTERM if asked_by else signal.SIGINT)
            asked_by = "Ctrl-C"


def _read(stream: IO[str], kept: list[str], show: Callable[[str], object] | None) -> None:
    for line in stream:
        kept.append(line)
        if show:
            show(line.rstrip("\n"))


def _raise(ended: Ended) -> None:
    said = ended.messages.strip() or ended.text.strip() or f"the program ended with status {ended.status}"
    begin = said.find("error:")
    said = said[max(begin, 0):].removeprefix("error: ")
    raise {2: CaseError, 3: SolveError}.get(ended.status, RunError)(said)


# Progress


def shown(progress: Progress) -> Callable[[str], object] | None:
    if callable(progress):
        return progress
    if progress is False:
        return None
    if in_notebook():
        return _notebook_line()
    return _terminal_line if progress or sys.stderr.isatty() else None


def in_notebook() -> bool:
    """Whether cells of a notebook are shown by IPython."""
    return "ipykernel" in sys.modules


def _notebook_line() -> Callable[[str], object]:
    """A line below the cell, renewed."""
    from IPython.display import display
    handle = display({"text/plain": ""}, raw=True, display_id=True)
    return lambda line: handle.update({"text/plain": line}, raw=True)


def _terminal_line(line: str) -> None:
    print(line, file=sys.stderr, flush=True)


# Cases


@contextlib.contextmanager
def case_file(case: Case | str | os.PathLike[str] | Mapping[str, Any], changes: Mapping[str, Any] | None = None,
              ) -> Iterator[list[str]]:
    """The words by which the program finds a case: its path and its changes. A case that is no file is one meanwhile,
    in its folder if it names files."""
    if isinstance(case, (str, os.PathLike)):
        yield [os.fspath(case), *set_words(changes or {})]
        return
    from terp.simulation import Case
    given = Case(case, changes)
    if given.is_file:
        yield [given.path, *set_words(given.changes)]
        return
    with contextlib.ExitStack() as stack:
        if given.names_files:
            text, words = given.source, set_words(given.changes)
            file = stack.enter_context(tempfile.NamedTemporaryFile("w", encoding="utf-8", suffix=".toml",
                                                                   prefix=f"{given.name}_", dir=given.folder))
            path = file.name
            file.write(text)
            file.flush()
        else:
            text, words = given.text, []
            path = str(pathlib.Path(stack.enter_context(tempfile.TemporaryDirectory())) / f"{given.name}.toml")
            pathlib.Path(path).write_text(text, encoding="utf-8")
        yield [path, *words]


def set_words(changes: Mapping[str, Any]) -> list[str]:
    """The options --set of changes."""
    return [word for key, value in changes.items() for word in ("--set", f"{key}={toml_value(value)}")]


def option_words(options: Mapping[str, Any]) -> list[str]:
    """Options of a command by their long names, `-` as `_`: {"cells": [2, 1], "associated": True}."""
    words = []
    for name, value in options.items():
        if value is None or value is False:
            continue
        words.append("--" + name.rstrip("_").replace("_", "-"))
        if value is not True:
            words.append(",".join(map(str, value)) if isinstance(value, (list, tuple)) else str(value))
    return words
