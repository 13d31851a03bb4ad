"""What the commands of this package share: how they end, and how they name pairs of runs."""

import argparse
import sys
from collections.abc import Callable

from terp.errors import RunError


def exit_status(action: Callable[[], None]) -> int:
    """Runs the action. 0: done; 2: a run is missing or does not fit; 1: a file could not be written. Reports why."""
    try:
        action()
    except RunError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"error: cannot write: {error}", file=sys.stderr)
        return 1
    return 0


def runs_parser(program: str, description: str) -> argparse.ArgumentParser:
    """A command line that takes one or two pairs of run folders."""
    parser = argparse.ArgumentParser(prog=program, description=description)
    parser.add_argument("runs", nargs="+", metavar="RUN",
                        help="run folders: RUN_MIXED RUN_GP, or MIXED_1 GP_1 MIXED_2 GP_2 for both models")
    return parser
