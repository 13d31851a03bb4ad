"""Read the results of Terp runs.

    import terp

    run = terp.open("runs/model_2")
    frame = run.frame(run.at(2.5))        # the frame nearest to t = 2.5 s
    frame["eps_eq_p"]                     # numpy array, shape [n_points], read when first asked for
    run.history_of("A")["su"]             # undrained shear strength of point A over time [Pa]

    from terp import plot
    plot.field(run, "eps_eq_p", 2.5).figure.savefig("slip.png")

Described in docs/python.md. The paper's figures: `python3 -m terp.figures`; a field at some times:
`python3 -m terp.sections`; runs compared in numbers: the program itself, `terp compare`.
"""

import json
import pathlib

from terp.errors import RunError
from terp.run import Frame, Mesh, Run
from terp.tables import to_pandas

__all__ = ["Frame", "Mesh", "Run", "RunError", "convergence", "open", "to_pandas"]


def open(folder):  # noqa: A001 (terp.open is meant to read like the built-in)
    """The run whose results lie in `folder`, as a terp.Run. Files are read when they are asked for."""
    return Run(folder)


def convergence(folder):
    """What `terp converge` found in `folder`: its convergence.json (docs/formats.md) as a dictionary. Raises RunError
    if there is none."""
    path = pathlib.Path(folder) / "convergence.json"
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError as error:
        raise RunError(f"{path} is not there: give the folder that `terp converge` wrote") from error
    except ValueError as error:
        raise RunError(f"{path} cannot be read: {error}") from error
