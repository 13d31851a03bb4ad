"""The errors that this package raises itself."""

import difflib
from collections.abc import Iterable


class RunError(Exception):
    """A run folder does not hold what was asked of it. The message says which file and what to do."""


class CaseError(ValueError):
    """A case cannot be run. The message is that of `terp check`: where, what, got and allowed, what to do."""


class SolveError(RuntimeError):
    """A run stopped itself. The message says at which point and step, and the likely cause."""


def unknown(name: str, known: Iterable[str], kind: str, place: object) -> RunError:
    """RunError for a name that `place` does not have, with the closest that it has."""
    close = difflib.get_close_matches(name, known, n=1)
    hint = f" Did you mean `{close[0]}`?" if close else ""
    return RunError(f"{place} has no {kind} `{name}`.{hint} It has: {', '.join(known) or 'none'}")
