"""Synthetic runs that the tests share, and one command line called as a user calls it."""

import atexit
import contextlib
import functools
import io
import pathlib
import shutil
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "python")]

from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: E402
from matplotlib.text import Text  # noqa: E402

import numpy as np  # noqa: E402
import synthetic  # noqa: E402
import terp  # noqa: E402


@functools.cache
def _shared_folder():
    folder = tempfile.mkdtemp(prefix="terp_runs_")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return pathlib.Path(folder)


def synthetic_run(scheme="mpm_gp", model=2, end=4.0):
    """Folder of a coarse synthetic run, written once."""
    folder = _shared_folder() / f"{scheme}_{model}_{end:g}"
    if not folder.exists():
        synthetic.write_run(folder, scheme, model, synthetic.TIMES[synthetic.TIMES <= end])
    return folder


@contextlib.contextmanager
def without_soil(rows, sign="material", gone=-1.0):
    """A coarse synthetic run in whose frames some rows are no soil: the field `sign` is `gone` there, else 1. They hold
    huge values at the place of the row before; in the last frame 50 m away."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = synthetic.write_run(pathlib.Path(scratch) / "run", times=synthetic.TIMES[:3])
        start = synthetic.lattice(0.1)
        for k, t in enumerate(synthetic.TIMES[:3]):
            x = synthetic.places(start, t, 2)
            x[rows] = np.roll(x, 1, axis=0)[rows] + (50.0 if k == 2 else 0.0)
            fields = {**synthetic.fields_at(start, t, "mpm_gp", 2), sign: np.ones(len(start))}
            for name, values in fields.items():
                values[rows] = gone if name == sign else 1e9
            synthetic.write_frame(synthetic.frame_file(folder, k), k, t, x, fields)
        yield terp.open(folder)


def texts_of(figure):
    """All texts that are seen: without the labels of ticks beyond the limits, which are kept and not drawn."""
    axes = [axis for panel in figure.axes for axis in (panel.xaxis, panel.yaxis)]
    unseen = {tick.label1 for axis in axes for tick in axis.get_major_ticks()
              if not min(axis.get_view_interval()) <= tick.get_loc() <= max(axis.get_view_interval())}
    return [text for text in figure.findobj(Text) if text.get_visible() and text.get_text().strip()
            and text not in unseen]


def texts_cut_off(figure):
    """Texts of a drawn figure that do not lie on its paper."""
    renderer = FigureCanvasAgg(figure).get_renderer()
    figure.draw(renderer)
    paper = figure.bbox

    def inside(extent):
        return min(*extent.p0) >= 0 and extent.x1 <= paper.x1 and extent.y1 <= paper.y1
    return [text.get_text() for text in texts_of(figure) if not inside(text.get_window_extent(renderer))]


def call(main, *arguments):
    """(exit status, standard output, standard error) of a command's main()."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            status = main([str(argument) for argument in arguments])
        except SystemExit as stop:
            status = stop.code
    return status, out.getvalue(), err.getvalue()
