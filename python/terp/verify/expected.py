"""What a verification case expects: expected.toml, read and checked. What its keys mean: docs/verification_cases.md.

First each table is read entry by entry, then quantities and runs are checked against each other. A key that a kind
ignores is refused, because the author may rely on it. Not for: evaluating formulas (solve).
"""

import re
import tomllib
from types import SimpleNamespace

from terp.errors import CaseError
from terp.verify.formula import did_you_mean

KINDS = ("field", "point", "ledger", "summary", "formula", "order", "footing", "extrapolated", "mesh_error")
SERIES = ("point", "ledger", "footing")
COMPARING = ("order", "extrapolated", "mesh_error")  # the runs of a scheme; a single run does not measure them
ERRORS = ("rms_error", "max_error")  # norms, which are themselves the number that is judged
OF_TIMES = ("at", "last", "period", "frequency", "arrival")
REDUCTIONS = (*ERRORS, "mean", "sum", "max", "min", *OF_TIMES)
BOUNDS = ("tolerance", "relative", "at_least", "at_most")
TAKEN = ("pi", "end", "dt", "gci", "factor", "stable_at", "not_stable_at")
FACTORS = (0.01, 100.0, 1e-4, 1.0)  # least and greatest factor and bracket of `terp stability`

_FORMULA, _TEXT, _LABEL, _TEXTS, _FLAG, _TABLE = "formula", "text", "label", "texts", "flag", "table"
_QUANTITY = dict.fromkeys(("value", "reference", "where", "scale", "time", "from", "to", "threshold", "order", *BOUNDS),
                          _FORMULA)
_QUANTITY |= dict.fromkeys(("unit", "source", "shown", "red", "regression", "as", "of", "over"), _TEXT)
_QUANTITY |= {"name": _LABEL, "kind": KINDS, "reduce": REDUCTIONS, "at": "place", "runs": _TEXTS, "red_runs": _TEXTS,
              "differences": _FLAG}
_RUN = {"name": _LABEL, "case": _TEXT, "schemes": _TEXTS, "set": _TEXTS, "constants": _TABLE, "long": "long",
        "stability": "bracket", "seconds": "number", "least_depth": "number", "seepage": "place"}
_FILE = {"title": _TEXT, "constants": _TABLE, "run": "tables", "quantity": "tables"}
_RENAMED = {"from": "start", "to": "stop", "as": "alias"}  # words of Python


def _is_text(value):
    return isinstance(value, str)


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _is_formula(value):
    return is_number(value) or (_is_text(value) and value != "")


def _is_texts(value):
    return isinstance(value, list) and all(map(_is_text, value))


def _is_bracket(value):
    if not (isinstance(value, list) and len(value) == 3 and all(map(is_number, value))):
        return False
    least, greatest, finest, widest = FACTORS
    return least <= value[0] < value[1] <= greatest and finest <= value[2] <= widest


# Kinds of values: which fit, what is wanted, what stands for one that is not given. A tuple of words is a kind, too.
_VALUES = {
    _TEXT: (_is_text, "text in quotes", ""),
    _LABEL: (_is_text, "text in quotes", ""),
    _FLAG: (lambda v: isinstance(v, bool), "true or false", False),
    _TEXTS: (_is_texts, "a list of texts", []),
    _FORMULA: (_is_formula, "a number, or a formula in quotes", ""),
    _TABLE: (lambda v: isinstance(v, dict), "a table", {}),
    "tables": (lambda v: isinstance(v, list), "a list of tables, [[...]]", []),
    "place": (lambda v: isinstance(v, list) and len(v) == 2 and all(map(_is_formula, v)), "a place: [x, y] in m", None),
    "number": (lambda v: is_number(v) and v >= 0, "a number, 0 or more", None),
    "long": (lambda v: isinstance(v, bool) or _is_texts(v), "true or false, or a list of schemes", False),
    "bracket": (_is_bracket, "[from, to, tolerance] of the factor: {:g} <= from < to <= {:g}, tolerance from {:g} to "
                "{:g}".format(*FACTORS), None),
}


class Quantity(SimpleNamespace):
    """One [[quantity]]: its keys, those not given empty; formulas are texts. `from` is `start`, `to` `stop`, `as`
    `alias`."""

    @property
    def compares_runs(self):
        return self.kind in COMPARING

    @property
    def is_error(self):
        return self.reduce in ERRORS

    @property
    def is_auxiliary(self):
        """Only others use it: it has no row."""
        return not any(getattr(self, bound) for bound in BOUNDS)

    @property
    def needs_limit(self):
        return self.kind in ("extrapolated", "mesh_error")

    @property
    def least_runs(self):
        """The fewest runs of a scheme that determine it: two for an order of errors, three for a limit."""
        return 3 if not self.order and (self.differences or self.needs_limit) else 2

    def is_of(self, run):
        """Whether it is of the run of that name."""
        return not self.runs or run in self.runs


class Table:
    """A table of the file, for messages with its line."""

    def __init__(self, file, name="", number=0):
        self.file, self.name, self.number = file, name, number

    def refuse(self, what, detail="", key=None):
        detail = f"\n  {detail}" if detail else ""
        raise CaseError(f"error: {self.file.path}:{self._line(key)}: {what}{detail}\n")

    def _line(self, key):
        lines = self.file.text.splitlines()
        heads = [k for k, line in enumerate(lines) if re.match(rf"\[+ *{re.escape(self.name)} *\]", line)]
        start = heads[self.number] + 1 if self.name and self.number < len(heads) else 0
        for k, line in enumerate(lines[start:], start + 1):
            if key and re.match(rf'\s*"?{re.escape(key)}"?\s*=', line):
                return k
            if re.match(r"\[+ *\w", line):
                break
        return max(start, 1)

    def read(self, values, kinds):
        """The values of a table by the kinds of its keys, with those that are not given."""
        if not isinstance(values, dict):
            self.refuse("a table must stand here", f"Got {values!r}.")
        for key in values:
            if key not in kinds:
                self.unknown(key, kinds, key)
        return {key: self._value(key, values[key], kind) if key in values else _VALUES.get(kind, ("",))[-1]
                for key, kind in kinds.items()}

    def unknown(self, word, known, key):
        self.refuse(f"`{word}` is not known here", f"{did_you_mean(word, known)} Allowed: {', '.join(known)}".strip(),
                    key)

    def _value(self, key, value, kind):
        fits, wanted, _ = _VALUES[_TEXT if isinstance(kind, tuple) else kind]
        if not fits(value):
            self.refuse(f"`{key}` must be {wanted}", f"Got {value!r}.", key)
        if kind == _LABEL and not value.isprintable():
            self.refuse(f"`{key}` must be one line of text without control characters", f"Got {value!r}.", key)
        if isinstance(kind, tuple) and value not in kind:
            self.unknown(value, kind, key)
        if kind == "place":
            return [_formula(x) for x in value]
        return _formula(value) if kind == _FORMULA else value


def _formula(value):
    """Its text; of a number as the program writes it: 0.0 is 0."""
    return value if isinstance(value, str) else repr(value).removesuffix(".0")


def _read_constants(table, values):
    """[(name, formula or None, key or None)] in the order of the file."""
    constants = []
    for name, value in values.items():
        _check_word(table, name, name)
        if isinstance(value, dict):
            key = table.read(value, {"key": _TEXT})["key"]
            if not key:
                table.refuse("`key` is missing", "See docs/verification_cases.md.", name)
            constants.append((name, None, key))
        elif _is_formula(value):
            constants.append((name, _formula(value), None))
        else:
            table.refuse(f"`{name}` must be {_VALUES[_FORMULA][1]}", f"Got {value!r}.", name)
    return constants


def _check_word(table, word, key):
    """A name that formulas may use."""
    if not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", word):
        table.refuse(f"`{word}` is no name for a formula", "Letters, digits and _ make one, a letter first.", key)
    if word in TAKEN:
        table.refuse(f"`{word}` has a meaning of its own in formulas",
                     "Take another name; see docs/verification_cases.md.", key)


def _read_run(table, values):
    run = SimpleNamespace(**table.read(values, _RUN), place=table)
    run.case, run.constants = run.case or "case.toml", _read_constants(table, run.constants)
    run.seconds = 1.0 if run.seconds is None else run.seconds
    for scheme in run.schemes:
        if run.schemes.count(scheme) > 1:
            table.refuse(f"`{scheme}` is in `schemes` already", "Each scheme is one run.", "schemes")
    for scheme in run.long if isinstance(run.long, list) else []:
        if scheme not in run.schemes:
            table.refuse(f"`{scheme}` is not in `schemes` of this run",
                         "Name those of its schemes whose run is long, or write `long = true` for all.", "long")
    return run


# Keys that not every quantity looks at: which do, and whose they are.
_USES = {
    "value": (lambda q: not q.compares_runs,
              "not for order, extrapolated, mesh_error, which take the numbers of the quantity in `of`"),
    "as": (lambda q: not q.compares_runs, "not for order, extrapolated, mesh_error"),
    "reduce": (lambda q: q.kind == "field" or q.kind in SERIES,
               "for field, point, ledger, footing: the other kinds are one number already"),
    "where": (lambda q: q.kind == "field", "for the points of a field"),
    "at": (lambda q: q.kind == "point", "for a point; points of a field are chosen by `where`"),
    "time": (lambda q: q.kind == "field" or (q.kind in SERIES and q.reduce == "at"),
             'for a field, and for a series with reduce = "at"'),
    "from": (lambda q: q.kind in SERIES, "for series: point, ledger, footing"),
    "to": (lambda q: q.kind in SERIES, "for series: point, ledger, footing"),
    "threshold": (lambda q: q.kind in SERIES and q.reduce == "arrival", 'for a series with reduce = "arrival"'),
    "scale": (lambda q: not q.compares_runs and q.is_error, 'for reduce = "rms_error" or "max_error"'),
    "of": (lambda q: q.compares_runs, "for order, extrapolated, mesh_error"),
    "over": (lambda q: q.compares_runs, "for order, extrapolated, mesh_error"),
    "differences": (lambda q: q.kind == "order", "for order"),
    "order": (lambda q: q.kind == "extrapolated", "for extrapolated"),
    "red_runs": (lambda q: q.red, "for a quantity that is `red`"),
    "regression": (lambda q: not q.is_auxiliary, "for a quantity that is judged"),
}


def _read_quantity(table, values):
    read = table.read(values, _QUANTITY)
    q = Quantity(**{_RENAMED.get(key, key): value for key, value in read.items()}, place=table)
    q.kind = q.kind or "field"
    default = "at" if q.kind in SERIES or q.kind == "order" else "rms_error" if q.kind == "field" else "last"
    q.reduce = q.reduce or default
    required = {"name": True, "value": not q.compares_runs, "of": q.compares_runs, "over": q.compares_runs,
                "threshold": q.reduce == "arrival", "at": q.kind == "point"}
    for key, is_required in required.items():
        if is_required and key not in values:
            table.refuse(f"`{key}` is missing", "See docs/verification_cases.md.")
    if "as" in values:
        _check_word(table, values["as"], "as")
    for key, (is_used, whose) in _USES.items():
        if key in values and not is_used(q):
            table.refuse(f"`{key}` has no effect on a quantity of kind `{q.kind}` here", f"It is {whose}.", key)
    if q.kind == "field" and q.reduce in OF_TIMES:
        table.refuse(f"a field has no `{q.reduce}`", "It is at one time. Allowed: rms_error, max_error, mean, sum, "
                     "max, min. A curve over time is a point, ledger or footing.", "reduce")
    _check_judgement(table, q)
    if "regression" in values and not q.regression:
        table.refuse("`regression` must be why no value from outside Terp holds it", "Got ''.", "regression")
    return q


def _check_judgement(table, q):
    """A bound on one side, or a reference with a tolerance."""
    given = [bound for bound in BOUNDS if getattr(q, bound)]
    if not given and q.alias and not q.compares_runs:
        return
    if len(given) != 1:
        table.refuse("one of `tolerance`, `relative`, `at_least`, `at_most` must be given", f"Got {len(given)}.")
    if (q.tolerance or q.relative) and not q.reference:
        table.refuse("`reference` is missing", "A tolerance needs it.")
    if q.is_error and q.relative:
        table.refuse("an error takes `tolerance`, not `relative`", "Use `scale`.", "relative")
    if not q.source:
        table.refuse("`source` is missing", "Say where the reference comes from.")


def _share_a_run(a, b):
    return not a.runs or not b.runs or bool(set(a.runs) & set(b.runs))


def _check_names(file):
    """Runs have unique names; those in `runs`, `red_runs` and `of` must exist."""
    names = [run.name for run in file.runs]
    for k, run in enumerate(file.runs):
        if run.name in names[:k]:
            run.place.refuse(f"there are two runs `{run.name}`" if run.name else "more than one run has no `name`",
                             "Where there is more than one, each needs a name of its own: the rows are told apart by "
                             "it.")
    schemes = {name: None for run in file.runs for scheme in run.schemes for name in (scheme, f"{run.name}, {scheme}")}
    quantities = [q.name for q in file.quantities]
    for q in file.quantities:
        for wanted, known, what in ((q.runs, names, "run"), (q.red_runs, [*names, *schemes], "run"),
                                    ([q.of] if q.compares_runs else [], quantities, "quantity")):
            for name in wanted:
                if name not in known:
                    q.place.refuse(f"there is no {what} `{name}`", f"There are: {', '.join(known)}")
        if q.compares_runs and any(other.name == q.of and other.compares_runs for other in file.quantities):
            q.place.refuse(f"`of` names `{q.of}`, which compares runs itself",
                           "Name a quantity that each run measures.")


def _check_doubles(file):
    """Quantities of one name differ in their runs, and one that `of` names is alone. `as` means one number in a run."""
    constants = {name for name, *_ in file.constants} | {name for run in file.runs for name, *_ in run.constants}
    for k, q in enumerate(file.quantities):
        for earlier in file.quantities[:k]:
            if earlier.name == q.name and _share_a_run(earlier, q):
                q.place.refuse(f"there are two quantities `{q.name}` of one run",
                               "Each needs a name of its own, or `runs` that the other has not.")
            if earlier.name == q.name and any(other.of == q.name for other in file.quantities):
                q.place.refuse(f"there are two quantities `{q.name}`, and an `of` names it",
                               "Give each a name of its own: `of` would mix their numbers.")
            if q.alias and q.alias == earlier.alias and _share_a_run(earlier, q):
                q.place.refuse(f'there are two quantities with as = "{q.alias}" in one run',
                               "Formulas that speak of it would mean the last.")
        if q.alias in constants:
            q.place.refuse(f'as = "{q.alias}" is a constant already', "Take another name.")


def _check_run_counts(file):
    """With too few runs a quantity would have no row, and nobody would notice."""
    for q in file.quantities:
        if not q.compares_runs:
            continue
        counts = {"": 0}  # of each scheme; "": that of the case, which may be any of them
        for measured in file.quantities:
            for run in file.runs:
                if measured.name == q.of and measured.is_of(run.name) and q.is_of(run.name):
                    for scheme in run.schemes or [""]:
                        counts[scheme] = counts.get(scheme, 0) + 1
        most = max(n + (counts[""] if scheme else 0) for scheme, n in counts.items())
        if most < q.least_runs:
            q.place.refuse(f"`{q.name}` needs {q.least_runs} runs of one scheme", f"`{q.of}` is measured in {most}.")


def read_expected(path):
    """Namespace with path, text, title, place (of the constants), constants, runs, quantities. Raises CaseError: the
    line, and what is wrong."""
    file = SimpleNamespace(path=path)
    try:
        file.text = path.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise CaseError(f"error: {path}: there is no such file\n  A verification case is a folder with case.toml and "
                        "expected.toml.\n") from None
    except (OSError, ValueError) as error:
        raise CaseError(f"error: {path}: {error}\n") from error
    try:
        root = tomllib.loads(file.text)
    except ValueError as error:
        raise CaseError(f"error: {path}: this is not valid TOML: {error}\n") from error
    file.place = Table(file, "constants")
    read = Table(file).read(root, _FILE)
    if not read["title"]:
        Table(file).refuse("`title` is missing", "See docs/verification_cases.md.")
    file.title, file.constants = read["title"], _read_constants(file.place, read["constants"])
    file.runs = [_read_run(Table(file, "run", k), table) for k, table in enumerate(read["run"] or [{}])]
    file.quantities = [_read_quantity(Table(file, "quantity", k), table) for k, table in enumerate(read["quantity"])]
    for check in (_check_names, _check_doubles, _check_run_counts):
        check(file)
    return file
