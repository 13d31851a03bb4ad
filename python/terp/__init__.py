"""Read the results of Terp runs.

    import terp

    run = terp.open("runs/model_2")
    k = run.at(2.5)                       # the frame nearest to t = 2.5 s
    eps = run.field("eps_eq_p", k)        # numpy array, shape [n_points]
    run.history_of("A")["su"]             # undrained shear strength of point A over time [Pa]

The figures of the paper: `python3 -m terp.figures`; the two schemes side by side: `python3 -m terp.table`.
The files themselves are described in docs/formats.md.
"""

from terp.run import UNITS, Frame, Run, RunError

__all__ = ["UNITS", "Frame", "Run", "RunError", "open"]


def open(folder):  # noqa: A001 (terp.open is meant to read like the built-in)
    """The run whose results lie in `folder`, as a terp.Run. Files are read when they are asked for."""
    return Run(folder)
