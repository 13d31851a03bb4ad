"""A run in a process of its own, so that a law of a library that calls STOP, or crashes, ends that one alone.

The two processes talk over a socket: (method or property, arguments) there, (whether it went well, answer) back. The
child runs main(), in a session of its own, so that Ctrl-C reaches the parent alone.
"""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import weakref
from multiprocessing.connection import Connection
from typing import IO, Any, NamedTuple

from terp.errors import CaseError, SolveError

PROPERTIES = ("summary", "warnings", "has_ended", "time", "end_time", "n_steps", "dt", "stage", "n_points", "nodes",
              "cells")


class SavedThere(NamedTuple):
    """A state that the process keeps."""

    number: int
    time: float
    step: int


class Remote:
    """What terp._core.Simulation does, in another process."""

    def __init__(self, case: tuple[str, str, dict[str, Any]], threads: int, output: str, force: bool) -> None:
        here, there = socket.socketpair()
        self._said: IO[bytes] = tempfile.TemporaryFile()
        with there:
            self._process = subprocess.Popen(
                [sys.executable, "-c", "from terp.own_process import main; main()", str(there.fileno())],
                pass_fds=(there.fileno(),), stdin=subprocess.DEVNULL, stderr=self._said, start_new_session=True,
                env={**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)})
        self._connection = Connection(here.detach())
        self._lock = threading.Lock()
        weakref.finalize(self, _end, self._connection, self._process, self._said)
        self._ask("make", case, threads, output, force)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        if name in PROPERTIES:
            return self._ask(name)
        return lambda *arguments: self._ask(name, *arguments)

    def blocks(self, name: str) -> Any:
        raise CaseError(f"blocks({name!r}): the memory of a run in a process of its own cannot be seen from here\n"
                        "  Ask field(), or give terp.Simulation(..., own_process=False).")

    def _ask(self, name: str, *arguments: Any) -> Any:
        if not self._lock.acquire(blocking=False):
            raise RuntimeError("this simulation is in use by another thread: give each thread one of its own")
        try:
            self._connection.send((name, arguments))
            good, answer = self._receive()
        except (EOFError, OSError):
            raise SolveError(self._last_words()) from None
        finally:
            self._lock.release()
        if good:
            return answer
        raise answer

    def _receive(self) -> tuple[bool, Any]:
        while True:
            try:
                answer: tuple[bool, Any] = self._connection.recv()
                return answer
            except KeyboardInterrupt:  # the answer of the process is then one, after its step
                self._process.send_signal(signal.SIGINT)

    def _last_words(self) -> str:
        status = self._process.wait()
        self._said.seek(0)
        said = self._said.read().decode("utf-8", "replace").strip().removeprefix("error: ")
        how = f"signal {-status} ({signal.strsignal(-status)})" if status < 0 else f"status {status}"
        return said or f"the process of the run ended with {how}, as a law of a library may do it"


def _end(connection: Connection, process: subprocess.Popen[bytes], said: IO[bytes]) -> None:
    connection.close()
    process.wait()
    said.close()


class _Child:
    """The run, and the states that were saved of it."""

    def __init__(self) -> None:
        self.run: Any = None
        self.saved: list[Any] = []

    def answer(self, name: str, arguments: tuple[Any, ...]) -> Any:
        from terp import _core
        from terp.simulation import case_of
        if name == "make":
            case, threads, output, force = arguments
            self.run = _core.Simulation(case_of(*case)._file, threads, None, output, force)
            return None
        if name == "save":
            self.saved.append(self.run.save())
            return SavedThere(len(self.saved) - 1, self.saved[-1].time, self.saved[-1].step)
        if name == "restore":
            return self.run.restore(self.saved[arguments[0].number])
        found = getattr(self.run, name)
        return found(*arguments) if callable(found) else found


def main() -> None:
    """Answers until the parent closes the socket."""
    connection, child = Connection(int(sys.argv[1])), _Child()
    while True:
        try:
            name, arguments = connection.recv()
        except KeyboardInterrupt:  # it came after the last answer
            continue
        except (EOFError, OSError):
            return
        try:
            answer = True, child.answer(name, arguments)
        except BaseException as error:
            answer = False, error
        connection.send(answer)

