"""Rows of the ledger: each number against its reference.

Quantities that compare runs are computed here, from all findings of one scheme. A fault costs its own row and no other:
whatever cannot be measured or evaluated becomes a failed row with the reason.
"""

import math
from dataclasses import dataclass

from terp.errors import CaseError
from terp.verify.measures import Scope
from terp.verify.solve import Finding, read_bounds

# Verdicts. A row passes if it agrees with a reference from outside Terp; it is a regression row if it agrees with no
# more than what Terp itself gave, red if it does not agree and the case says why, FAIL if nobody has said why.
PASS, REGRESSION, RED, FAIL = "pass", "regression", "red", "FAIL"
SAFETY = 1.25  # on the distance from an extrapolated limit: P. J. Roache, J. Fluids Eng. 116 (1994) 405-413
LEAST_ORDER, MOST_ORDER = 0.5, 2.0  # the observed order is taken between them


@dataclass
class Row:
    """Ready to be shown."""

    run: str
    quantity: str
    reference: str = "-"
    terp: str = "no result"
    error: str = "-"
    tolerance: str = "-"
    verdict: str = FAIL
    source: str = ""
    remark: str = ""  # why it is red or a regression row, or what went wrong
    declared_red: bool = False
    declared_regression: bool = False
    used: float = -1.0  # share of the bound that is used [-], 1 at the bound; negative: the bound has no size

    @property
    def agrees_though_red(self):
        return self.declared_red and self.verdict in (PASS, REGRESSION)


def judge(file, runs):
    """Rows of one case from all its runs, (Job, Solved): faults of runs, then quantities in the order of the file."""
    rows = [Row(_run_text(job.run.name, job.scheme), "the run", remark=solved.fault)
            for job, solved in runs if solved.fault]
    findings = [finding for _, solved in runs for finding in solved.findings]
    for q in file.quantities:
        if q.compares_runs:
            try:
                rows += [_to_row(finding) for finding in _compare_runs(q, findings)]
            except CaseError as error:
                rows.append(Row(f"over {q.over}", q.name, remark=str(error)))
        rows += [Row(_run_text(f.run, f.scheme), q.name, remark=f.fault) if f.fault else _to_row(f)
                 for f in findings if f.quantity is q]
    return rows


def _run_text(run, scheme):
    return f"{run}, {scheme}" if run else scheme


def _number(value, unit):
    if math.isnan(value):
        return "never"
    return f"{value:.4g} {unit}" if unit else f"{value:.4g}"


def _error_of(f):
    """The error to be judged: for a norm the norm itself; with `relative` over the reference."""
    if f.quantity.is_error:
        return f.value
    distance = abs(f.value - f.reference)
    if math.isnan(f.bounds["relative"]):
        return distance
    return distance / abs(f.reference) if f.reference else math.inf if distance else math.nan


def _held(f):
    """(part, whole): the row agrees if the first is at most the second."""
    bounds = f.bounds
    if not math.isnan(bounds["at_least"]):
        return bounds["at_least"], f.value
    if not math.isnan(bounds["at_most"]):
        return f.value, bounds["at_most"]
    return _error_of(f), bounds["tolerance"] if math.isnan(bounds["relative"]) else bounds["relative"]


def _declared_red(q, run, scheme):
    return bool(q.red) and (not q.red_runs or any(name in (run, scheme, f"{run}, {scheme}") for name in q.red_runs))


def _why_none(q):
    if q.kind == "order":
        return "no order: the errors of the runs, or their sizes, are equal or none"
    if q.kind == "extrapolated":
        return "no limit: the differences of successive runs do not fall"
    return {"arrival": "the threshold was not reached", "period": "there are no two upward crossings of zero",
            "frequency": "there are no two upward crossings of zero"}.get(
                q.reduce, "the formula, or a quantity in it, is not a finite number")


def _shown(f):
    """(reference, terp, error, tolerance) as texts."""
    q, bounds = f.quantity, f.bounds
    if q.is_error:
        reference = q.reference or "0"
        terp = f"{'rms' if q.reduce == 'rms_error' else 'largest'} error {f.value:.3g}"
    else:
        reference = "-" if math.isnan(f.reference) else _number(f.reference, q.unit)
        terp = _number(f.value, q.unit)
    reference = q.shown or reference
    for key, word in (("at_least", "at least"), ("at_most", "at most")):
        if not math.isnan(bounds[key]):
            return reference, terp, "-", f"{word} {bounds[key]:.3g}"
    if not math.isnan(bounds["relative"]):
        return reference, terp, f"{100.0 * _error_of(f):.2g} %", f"{100.0 * bounds['relative']:.3g} %"
    return reference, terp, f"{_error_of(f):.2g}", f"{bounds['tolerance']:.3g}"


def _to_row(f):
    q = f.quantity
    part, whole = _held(f)
    agrees = math.isfinite(f.value) and part <= whole
    row = Row(_run_text(f.run, f.scheme), q.name, *_shown(f), PASS, q.source)
    row.declared_red, row.declared_regression = _declared_red(q, f.run, f.scheme), bool(q.regression)
    if agrees:
        row.verdict, row.remark = (REGRESSION, q.regression) if q.regression else (PASS, "")
    elif not math.isfinite(f.value):  # a reason for red applies to a number, not to its absence
        row.verdict, row.remark = FAIL, _why_none(q)
    else:
        row.verdict, row.remark = (RED, q.red) if row.declared_red else (FAIL, "")
    row.used = part / whole if math.isfinite(part) and part >= 0.0 and whole > 0.0 else -1.0
    return row


# Quantities that compare the runs of a scheme

def _compare_runs(q, findings):
    """One finding per scheme, or one per run; none where too few runs were made."""
    result = []
    for scheme in dict.fromkeys(f.scheme for f in findings):
        runs = [f for f in findings
                if f.scheme == scheme and not f.fault and f.quantity.name == q.of and q.is_of(f.run)]
        sizes = [float(Scope(f.constants).evaluate(q.place, "over", q.over)) for f in runs]
        if len(sizes) >= q.least_runs:
            result += _compare(q, scheme, runs, sizes)
    return result


def _compare(q, scheme, runs, sizes):
    values = [f.value for f in runs]
    if q.kind == "order":
        order = observed_order(sizes, values) if q.differences else log_slope(sizes, [_error_of(f) for f in runs])
        return [_held_by_bounds(q, f"over {q.over}", scheme, order, runs[-1].constants)]
    if q.kind == "mesh_error":
        limit = extrapolate(sizes, values)[0]
        return [_held_by_bounds(q, f.run, scheme, f.value, {**f.constants, "gci": SAFETY * abs(f.value - limit)})
                for f in runs]
    constants = runs[-1].constants
    order = Scope(constants).number(q, "order", q.order) if q.order else None
    limit, uncertainty = extrapolate(sizes, values, order)
    return [_held_by_bounds(q, f"over {q.over}", scheme, limit, {**constants, "gci": uncertainty})]


def _held_by_bounds(q, run, scheme, value, constants):
    scope = Scope(constants)
    finding = Finding(q, run, scheme, constants, value, scope.number(q, "reference", q.reference))
    read_bounds(scope, finding)
    return finding


def log_slope(x, y):
    """Slope of the straight line through (log x, log y) with the least squares; nan with one x, or a y of 0."""
    if not all(value > 0.0 for value in (*x, *y)):
        return math.nan
    n = len(x)
    mean_x, mean_y = sum(math.log(value) / n for value in x), sum(math.log(value) / n for value in y)
    xx = sum((math.log(value) - mean_x) ** 2 for value in x)
    xy = sum((math.log(a) - mean_x) * (math.log(b) - mean_y) for a, b in zip(x, y))
    return xy / xx if xx > 0.0 else math.nan


def observed_order(x, y):
    """Order at which y tends to an unknown limit: slope of the differences of successive y, refined by one factor."""
    runs = sorted(zip(x, y))
    return log_slope([size for size, _ in runs[:-1]], [abs(b[1] - a[1]) for a, b in zip(runs, runs[1:])])


def extrapolate(x, y, order=None):
    """(limit of y as x tends to 0, its uncertainty), SAFETY times the distance from the finest run.

    From the three finest runs by their observed order, or from the two finest by an order that is given. nan with fewer
    runs, or where the differences do not fall.
    """
    runs = sorted(zip(x, y))
    if len(runs) < (3 if order is None else 2) or not 0.0 < runs[0][0] or len(set(x)) < len(x):
        return math.nan, math.nan
    if order is None:
        last, before = runs[1][1] - runs[0][1], runs[2][1] - runs[1][1]
        if last == 0.0:
            return (runs[0][1], 0.0) if before != 0.0 else (math.nan, math.nan)
        r21, r32 = runs[1][0] / runs[0][0], runs[2][0] / runs[1][0]
        if not before / last > math.log(r32) / math.log(r21):
            return math.nan, math.nan
        order = min(max(_order_of(before / last, r21, r32), LEAST_ORDER), MOST_ORDER)
    rest = (runs[0][1] - runs[1][1]) / (math.pow(runs[1][0] / runs[0][0], order) - 1.0)
    limit = runs[0][1] + rest
    return limit, SAFETY * abs(limit - runs[0][1])


def _order_of(quotient, r21, r32):
    """p > 0 of quotient = r21^p (r32^p - 1)/(r21^p - 1) (I. B. Celik et al., J. Fluids Eng. 130 (2008) 078001), whose
    right side grows with p from log r32/log r21."""
    if abs(r21 - r32) <= 1e-9 * r21:
        return math.log(quotient) / math.log(r21)
    low, high = 0.0, 64.0
    for _ in range(100):
        p = 0.5 * (low + high)
        right_side = math.pow(r21, p) * math.expm1(p * math.log(r32)) / math.expm1(p * math.log(r21))
        low, high = (p, high) if right_side < quotient else (low, p)
    return high
