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

import synthetic  # noqa: E402


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


def call(main, *arguments):
    """(exit status, standard output, standard error) of a command's main()."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            status = main([str(argument) for argument in arguments])
        except SystemExit as stop:
            status = stop.code
    return status, out.getvalue(), err.getvalue()
