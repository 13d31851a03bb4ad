"""The one error that this package raises itself."""

import difflib


class RunError(Exception):
    """A run folder does not hold what was asked of it. The message says which file and what to do."""


def unknown(name, known, kind, place):
    """RunError for a name that `place` does not have, with the closest that it has."""
    close = difflib.get_close_matches(name, known, n=1)
    hint = f" Did you mean `{close[0]}`?" if close else ""
    return RunError(f"{place} has no {kind} `{name}`.{hint} It has: {', '.join(known) or 'none'}")
