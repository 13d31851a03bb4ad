"""The number of one quantity from the folder of a run, and what its reference gives in the same way.

A field is one frame, a series one formula over the frames or the rows of a table. Sums run in the order of the points
or rows, as in the program. Not for: quantities that compare runs (judge), bounds (solve).
"""

import csv
import functools
import math

import numpy as np

import terp
from terp.verify.expected import SERIES
from terp.verify.formula import FormulaError, evaluate

COMPONENTS = {name: (field, k) for field, names in (
    ("velocity", ("vx", "vy")), ("displacement", ("ux", "uy")), ("stress", ("sxx", "syy", "szz", "sxy")),
    ("strain", ("exx", "eyy", "ezz", "exy"))) for k, name in enumerate(names)}
MOST_SPACINGS = 2.0  # from a place to its point; in soil 0.71 of a square lattice, more where cells are stretched


class Scope:
    """What the formulas of one run may name: constants, and what stands where the formula does."""

    def __init__(self, constants):
        self.constants = dict(constants)

    def evaluate(self, table, key, text, variables=(), column=None):
        """Value of a formula that stands at a key of a table. Raises CaseError with the place."""
        try:
            return evaluate(text, self.constants, variables, column)
        except FormulaError as error:
            table.refuse("this formula cannot be evaluated", str(error), key)

    def number(self, q, key, text, otherwise=math.nan):
        """A formula without variables; `otherwise` if it is not given."""
        return float(self.evaluate(q.place, key, text)) if text else otherwise

    def scale(self, q):
        value = self.number(q, "scale", q.scale, 1.0)
        if not (math.isfinite(value) and value > 0.0):
            q.place.refuse("`scale` must be a finite number, greater than 0", f"Got {value:g}.", "scale")
        return value


class RunNumbers:
    """A run folder as columns of named numbers, read when a formula names them, and kept."""

    def __init__(self, folder):
        self.run = terp.open(folder)
        self._kept = {}

    @functools.cached_property
    def names(self):
        """Names of a material point."""
        components = self.run.components
        names = ["t", "x", "y", *(name for name, (field, _) in COMPONENTS.items() if field in components)]
        names += ["x0", "y0"] if "displacement" in components else []
        names += ["p"] if "stress" in components else []
        return names + [field for field in self.run.fields if not components.get(field)]

    @functools.cached_property
    def numbers(self):
        """Single numbers of summary.json; null is nan."""
        numbers = {name: math.nan if value is None else float(value) for name, value in self.run.summary.items()
                   if value is None or isinstance(value, (int, float)) and not isinstance(value, bool)}
        softened = self.run.summary["softened_fraction"]
        return numbers | {"softened_fraction": softened[-1]["fraction"] if softened else math.nan}

    def of_frame(self, k, name):
        """A name of all points in frame k, shape [n_points]."""
        return self.run.times[k] if name == "t" else _column(self._reader(self.run.field, k), name)

    def of_point(self, row, name):
        """A name of one point in all frames, shape [n_frames]."""
        return self.run.times if name == "t" else _column(self._reader(self.run.series, row), name)

    def _reader(self, read, number):
        def get(field):
            key = (read.__name__, field, number)
            if key not in self._kept:
                self._kept[key] = read(field, number)
            return self._kept[key]
        return get

    @functools.cached_property
    def ledger(self):
        return self._rows("ledger.csv")

    @functools.cached_property
    def footing(self):
        return self._rows("footings.csv")

    def _rows(self, name):
        """{column: numbers} of a table, `time` as `t`; of several rows of one time the first. Empty: there is none."""
        path = self.run.folder / name
        if not path.exists():
            return {}
        with open(path, encoding="utf-8", newline="") as file:
            head, *rows = csv.reader(file)
        firsts = list({row[0]: row for row in reversed(rows)}.values())[::-1]
        columns = dict(zip(head, zip(*firsts)))
        return {"t" if name == "time" else name: np.array(values, float) for name, values in columns.items()
                if name != "footing"}


def _column(get, name):
    """get(field): shape [n] or [n, n_components]."""
    if name in ("x", "y"):
        return get("position")[:, "xy".index(name)]
    if name in ("x0", "y0"):
        k = ("x0", "y0").index(name)
        return get("position")[:, k] - get("displacement")[:, k]
    if name == "p":
        stress = get("stress")
        return (stress[:, 0] + stress[:, 1] + stress[:, 2]) / 3.0
    if name in COMPONENTS:
        field, k = COMPONENTS[name]
        return get(field)[:, k]
    return get(name).astype(float)


def measure(q, scope, numbers):
    """(value, reference); reference: nan for a norm, and where only a bound is given. Raises CaseError."""
    if q.kind in SERIES:
        return _of_series(q, scope, numbers)
    if q.kind == "field":
        return _of_field(q, scope, numbers)
    known = numbers.numbers if q.kind == "summary" else {}
    value = scope.evaluate(q.place, "value", q.value, known, known.get)
    return float(value), scope.number(q, "reference", q.reference)


def reduce_values(values, references, reduce, scale=1.0):
    """One number from arrays [n]; nan for reductions that need the times."""
    if len(values) == 0:
        return math.nan
    errors = np.abs(values - references) / scale if references is not None else np.zeros(0)
    n = len(values)
    of = {"rms_error": lambda: math.sqrt(_sum(errors * errors) / n), "max_error": lambda: np.max(errors, initial=0.0),
          "mean": lambda: _sum(values) / n, "sum": lambda: _sum(values), "max": lambda: np.max(values),
          "min": lambda: np.min(values), "last": lambda: values[-1]}
    return float(of[reduce]()) if reduce in of else math.nan


def _sum(values):
    """In their order."""
    return np.cumsum(values)[-1] if len(values) else 0.0


# A field

def _of_field(q, scope, numbers):
    k = _frame_of(q, scope, numbers)
    n = len(numbers.run.field("position", k))

    def values_of(key, text):
        values = scope.evaluate(q.place, key, text, numbers.names, lambda name: numbers.of_frame(k, name))
        return np.broadcast_to(values, n)
    counts = values_of("where", q.where or "1")
    keep = counts != 0.0
    if not keep.any():
        q.place.refuse("no point is `where` this says", key="where")
    values = np.where(np.isnan(counts), np.nan, values_of("value", q.value))[keep]  # unknown whether this point counts
    references, scale = values_of("reference", q.reference or "0")[keep], scope.scale(q)
    value = reduce_values(values, references, q.reduce, scale)
    has_reference = q.reference and not q.is_error
    return value, reduce_values(references, None, q.reduce, scale) if has_reference else math.nan


def _frame_of(q, scope, numbers):
    """Number of the frame at `time`; without it the last, as a run may end at rest before its latest end."""
    times = numbers.run.times
    if not q.time:
        return len(times) - 1
    time = scope.number(q, "time", q.time)
    k = int(np.argmin(np.abs(times - time)))
    if not abs(times[k] - time) <= 0.51 * max(numbers.numbers["dt"], 1e-9 * time):
        q.place.refuse(f"there is no frame at {time:g} s", f"The nearest is at {times[k]:g} s. Let output.fields.every "
                       "of the case divide the time.", "time")
    return k


# A series

def _of_series(q, scope, numbers):
    names, column, start = _columns_of(q, scope, numbers)
    times = column("t") if "t" in names else np.zeros(0)
    if len(times) == 0:
        q.place.refuse("there is no footing in this case" if q.kind == "footing" else "the run has no rows",
                       "A quantity of kind `footing` needs a [[footing]] in the case.")

    def values_of(key, text):
        return np.broadcast_to(scope.evaluate(q.place, key, text, names, column), len(times))
    value = values_of("value", q.value)
    reference = values_of("reference", q.reference) if q.is_error else None
    keep = _rows_of_interest(q, scope, times)
    times, value = times[keep], value[keep]
    number = _reduced(q, scope, times, value, None if reference is None else reference[keep])
    no_reference = q.is_error or not q.reference
    return number, math.nan if no_reference else _reference_of(q, scope, times, start)


def _columns_of(q, scope, numbers):
    """(names, column(name) over the times, initial place or nan)."""
    if q.kind != "point":
        rows = getattr(numbers, q.kind)
        return tuple(rows), rows.get, (math.nan, math.nan)
    row, start = _nearest(q, scope, numbers)
    return numbers.names, lambda name: numbers.of_point(row, name), start


def _nearest(q, scope, numbers):
    """Row and initial place of the point nearest to `at`."""
    places = numbers.run.field("position", 0)
    at = [scope.number(q, "at", text) for text in q.at]
    distances = np.hypot(places[:, 0] - at[0], places[:, 1] - at[1])
    row = int(np.argmin(distances))
    others = np.hypot(*(places - places[row]).T)
    others[row] = np.inf
    if distances[row] > MOST_SPACINGS * (spacing := others.min()):
        q.place.refuse(f"there is no soil at x = {at[0]:g} m, y = {at[1]:g} m",
                       f"The nearest material point is {distances[row]:.3g} m away; its own neighbour {spacing:.3g} m. "
                       "Choose a place in a body at t = 0.", "at")
    return row, tuple(places[row])


def _time_of(q, scope):
    return scope.number(q, "time", q.time, scope.constants["end"])


def _rows_of_interest(q, scope, times):
    """Which rows lie from `from` to `to`. Raises CaseError where there is nothing to reduce: it would look like a
    missing arrival."""
    start, stop = scope.number(q, "from", q.start, 0.0), scope.number(q, "to", q.stop, math.inf)
    keep = (times >= start * (1.0 - 1e-9)) & (times <= stop * (1.0 + 1e-9))
    rows = f"There are {len(times)} rows, from {times[0]:g} to {times[-1]:g} s."
    if not keep.any():
        q.place.refuse(f"there is no row from {start:g} to {stop:g} s", rows, "from" if q.start else "to")
    time = _time_of(q, scope)
    if q.reduce == "at" and not _covers(times[keep], time):
        q.place.refuse(f"there is no row at {time:g} s", rows, "time")
    return keep


def _covers(times, time):
    round_off = 1e-9 * max(abs(times[0]), abs(times[-1]))
    return times[0] - round_off <= time <= times[-1] + round_off


def _reduced(q, scope, times, values, references):
    if q.reduce == "at":
        return value_at(times, values, _time_of(q, scope))
    if q.reduce == "period":
        return period_of(times, values)
    if q.reduce == "frequency":
        return 1.0 / period_of(times, values)
    if q.reduce == "arrival":
        return arrival_of(times, values, scope.number(q, "threshold", q.threshold))
    return reduce_values(values, references, q.reduce, scope.scale(q))


def _reference_of(q, scope, times, start):
    """The reference for the number of these rows: for a mean, sum, max or min the same of the reference at their
    times."""
    place = {"x0": start[0], "y0": start[1]}
    if q.reduce in ("period", "frequency", "arrival"):
        return float(scope.evaluate(q.place, "reference", q.reference, place, lambda name: np.float64(place[name])))
    t = np.array([_time_of(q, scope)]) if q.reduce == "at" else times[-1:] if q.reduce == "last" else times

    def column(name):
        return t if name == "t" else np.full(len(t), place[name])
    values = scope.evaluate(q.place, "reference", q.reference, {**place, "t": None}, column)
    values = np.broadcast_to(values, len(t))
    return float(values[-1]) if q.reduce in ("at", "last") else reduce_values(values, None, q.reduce)


def value_at(times, values, time):
    """Linear between the samples; nan outside."""
    if not _covers(times, time):
        return math.nan
    after = int(np.searchsorted(times, time))
    if after in (0, len(times)):
        return float(values[0 if after == 0 else -1])
    part = (time - times[after - 1]) / (times[after] - times[after - 1])
    return float(values[after - 1] + part * (values[after] - values[after - 1]))


def _time_of_value(times, k, value, a, b):
    return times[k] + (times[k + 1] - times[k]) * (value - a) / (b - a)


def period_of(times, values):
    """Mean time between upward crossings of zero, the first and the last interpolated [s]; nan with fewer than two."""
    crossings = np.flatnonzero((values[:-1] < 0.0) & (values[1:] >= 0.0))
    if len(crossings) < 2:
        return math.nan
    first, last = (_time_of_value(times, k, 0.0, values[k], values[k + 1]) for k in (crossings[0], crossings[-1]))
    return float((last - first) / (len(crossings) - 1))


def arrival_of(times, values, threshold):
    """When |value| first reaches the threshold, interpolated [s]; nan if never."""
    sizes = np.abs(values)
    reached = np.flatnonzero(sizes >= threshold)
    if len(reached) == 0:
        return math.nan
    k = reached[0]
    return float(times[0] if k == 0 else _time_of_value(times, k - 1, threshold, sizes[k - 1], sizes[k]))
