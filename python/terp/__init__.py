"""Solve cases of Terp, and read the results of runs.

    import terp

    run = terp.open("runs/model_2")
    frame = run.frame(run.at(2.5))        # the frame nearest to t = 2.5 s
    frame["eps_eq_p"]                     # numpy array, shape [n_points], read when first asked for
    run.history_of("A")["su"]             # undrained shear strength of point A over time [Pa]

    from terp import plot
    plot.field(run, "eps_eq_p", 2.5).figure.savefig("slip.png")

With the compiled part of the package a run is an object:

    simulation = terp.Simulation("cases/dike/dike.toml", threads=2)
    simulation.run(every=1.0, call=lambda s: print(s.time, s.field("eps_eq_p").max()))
    simulation.flood                      # the verdict on the water

Described in docs/python.md. The paper's figures: `python3 -m terp.figures`; a field at some times:
`python3 -m terp.sections`; runs compared in numbers: the program itself, `terp compare`.
"""

from __future__ import annotations

import importlib.util
import os
import pathlib
import pkgutil
import sys
from typing import Any

for _needed in ("numpy", "h5py", "matplotlib"):
    if importlib.util.find_spec(_needed) is None:
        raise ModuleNotFoundError(
            f"{_needed} is missing in {sys.executable}; Debian's package python3-{_needed} is for /usr/bin/python3, "
            "and for environments that were made by `python3 -m venv --system-site-packages`", name=_needed)

from terp.answers import Check, Comparison, Convergence, Reach, Section, Stability
from terp.commands import (assess, check, compare, converge, explain, import_stix, open_stability, read_json,
                           stability, study)
from terp.errors import CaseError, RunError, SolveError
from terp.results import Frame
from terp.run import Mesh, Run
from terp.studies import Event, Study
from terp.tables import to_pandas

__all__ = ["Case", "CaseError", "Check", "Comparison", "Convergence", "Event", "Frame", "Mesh", "Reach", "Run",
           "RunError", "Section", "Simulation", "SolveError", "Stability", "Study", "animate", "assess", "check",
           "compare", "converge", "convergence", "depends", "element", "explain", "import_stix", "open",
           "open_stability", "open_study", "stability", "study", "to_pandas"]
__path__ = pkgutil.extend_path(__path__, __name__)  # the compiled part may lie in a build folder


def __getattr__(name: str) -> Any:
    """Case and Simulation, read when they are first asked for: results can be read without the compiled part."""
    if name == "__version__":
        return _version()
    if name not in ("Case", "Simulation"):
        raise AttributeError(f"module `terp` has no attribute `{name}`")
    try:
        from terp import simulation
    except ImportError as error:
        raise _no_compiled_part(name, error) from error
    return getattr(simulation, name)


def _no_compiled_part(name: str, error: ImportError) -> ImportError:
    return ImportError(f"terp.{name} needs the compiled part of the package, which is not here or is of another Python "
                       f"({error}). In a build of Terp it lies in build/python: put that folder into PYTHONPATH, too.")


def element(case: Any, material: str | None = None, test: str = "triaxial", **options: Any) -> Any:
    """A soil by itself on the path of a laboratory test, as a terp.elements.ElementTest: docs/element.md."""
    try:
        from terp import elements
    except ImportError as error:
        raise _no_compiled_part("element", error) from error
    return elements.element(case, material, test, **options)


def _version() -> str:
    """Of the compiled part; without it that of the installed package."""
    try:
        from terp import _core
        return _core.version
    except ImportError:
        from importlib import metadata
        try:
            return metadata.version("terp")
        except metadata.PackageNotFoundError:
            return "unknown"


def open(folder: str | os.PathLike[str]) -> Run:  # noqa: A001 (terp.open is meant to read like the built-in)
    """The run whose results lie in `folder`, as a terp.Run. Files are read when they are asked for."""
    return Run(folder)


def open_study(folder: str | os.PathLike[str]) -> Study:
    """The study whose results lie in `folder`, as a terp.Study. Raises RunError if there is no report of one."""
    return Study(folder)


def convergence(folder: str | os.PathLike[str]) -> Convergence:
    """What `terp converge` found in `folder`, as a terp.Convergence, which is a dictionary of its convergence.json
    (docs/formats.md), too. Raises RunError if there is none."""
    return Convergence(read_json(pathlib.Path(folder) / "convergence.json", "converge"))


def depends(folder: str | os.PathLike[str]) -> dict[str, Any]:
    """What `terp converge --what-decides` found in `folder`: its depends.json (docs/formats.md) as a dictionary, with
    `turns_on`, the names of the inputs that give another outcome. Raises RunError if there is none."""
    return read_json(pathlib.Path(folder) / "depends.json", "converge")


def animate(run: Run, field: str, file: str | os.PathLike[str] | None = None, **options: Any) -> Any:
    """Frames of a run as a film: terp.plot.animate."""
    from terp import plot
    return plot.animate(run, field, file, **options)
