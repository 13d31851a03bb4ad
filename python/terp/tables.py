"""The tables of a run, history.csv and ledger.csv, as numpy structured arrays or, if installed, pandas data frames."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from terp.errors import RunError

COLUMN_UNITS = {
    "time": "s", "step": "-", "stage": "-", "point": "-", "id": "-", "x": "m", "y": "m", "eps_deviatoric": "-",
    "eps_eq_p": "-", "su": "Pa", "pressure": "Pa", "eps_softening": "-", "kinetic": "J per m",
    "kinetic_nodal": "J per m", "elastic": "J per m", "pore_elastic": "J per m", "plastic": "J per m",
    "slip_work": "J per m", "gravity_work": "J per m", "damping_work": "J per m", "boundary_work": "J per m",
    "clamp_work": "J per m", "water_work": "J per m", "load_work": "J per m", "balance_work": "J per m",
    "relaxation_work": "J per m", "left_energy": "J per m", "numerical": "J per m", "transfer": "J per m",
    "pressure_reset": "J per m", "unexplained": "J per m", "water_supply": "J per m", "water_volume": "J per m",
    "mass": "kg per m", "mass_placed": "kg per m", "mass_removed": "kg per m", "momentum_x": "kg m/s per m",
    "momentum_y": "kg m/s per m", "clamped": "-", "left": "-", "front_x": "m", "crest_x": "m", "crest_y": "m",
    "front_left_x": "m", "crest_left_x": "m", "crest_left_y": "m", "moved_volume": "m^2", "v_max": "m/s",
    "v_999": "m/s", "residual_height": "m", "width_at_level": "m", "intact_width": "m",
}
"""Unit of each column; "per m" is per metre of thickness. The fields of the frames carry their own units."""

TEXT_COLUMNS = {"point"}
INTEGER_COLUMNS = {"id", "step", "stage", "clamped", "left"}


def read_table(path: Path) -> npt.NDArray[Any]:
    """A structured array with the columns of the file, without a last row that has no line end yet."""
    head, _, text = path.read_text(encoding="utf-8").partition("\n")
    dtype = np.dtype([(column, _column_type(column)) for column in head.strip().split(",")])
    rows = text[:text.rfind("\n") + 1].splitlines()
    if not rows:
        return np.empty(0, dtype)
    try:
        return np.loadtxt(rows, dtype=dtype, delimiter=",", comments=None, quotechar='"', ndmin=1)
    except ValueError as error:
        raise RunError(f"{path} cannot be read: {error}") from error


def table_of(columns: Sequence[tuple[str, str, Any]]) -> npt.NDArray[Any]:
    """A structured array of (name, unit, values), as read_table makes one of a file."""
    table = np.empty(len(columns[0][2]), np.dtype([(name, _column_type(name)) for name, _, _ in columns]))
    for name, _, values in columns:
        table[name] = values
    return table


def to_pandas(table: Any) -> Any:
    """A structured array, such as run.ledger, or an answer that has one as `table`, as a pandas DataFrame."""
    try:
        import pandas
    except ImportError as error:
        raise RunError("pandas is not there: install python3-pandas, or use the numpy array as it is") from error
    rows = getattr(table, "table", table)
    return pandas.DataFrame({name: rows[name] for name in rows.dtype.names})


def _column_type(name: str) -> Any:
    if name in TEXT_COLUMNS:
        return "U64"
    return np.int64 if name in INTEGER_COLUMNS else float
