"""One run of a verification case: the program solves it, and its quantities are measured.

Errors never leave this file: they become the fault of a finding, or of the whole run. Not for: verdicts (judge).
"""

import csv
import json
import math
import re
import subprocess
import tempfile
import threading
import time
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

from terp.errors import CaseError, RunError
from terp.verify.expected import BOUNDS, Quantity, is_number
from terp.verify.measures import RunNumbers, Scope, measure


@dataclass
class Job:
    """One [[run]] with one of its schemes; empty: that of the case."""

    file: object
    run: object
    scheme: str

    @property
    def title(self):
        return ", ".join(word for word in (self.file.path.parent.name, self.run.name, self.scheme) if word)


@dataclass
class Finding:
    """A quantity measured in one run, and the numbers that judge it; nan where there is none."""

    quantity: Quantity
    run: str
    scheme: str
    constants: dict = field(default_factory=dict)  # of the run
    value: float = math.nan
    reference: float = math.nan
    bounds: dict = field(default_factory=lambda: dict.fromkeys(BOUNDS, math.nan))
    fault: str = ""  # why it could not be measured; then the numbers have no meaning


@dataclass
class Solved:
    findings: list
    fault: str = ""  # why there are no findings
    seconds: float = 0.0


class Program:
    """The program `terp`, which threads call, and which another thread may stop."""

    def __init__(self, path):
        self.path = path
        self._lock, self._running, self._stopped = threading.Lock(), set(), False

    def __call__(self, *words):
        """Raises RunError with what the program says, if it does not end well."""
        with self._lock:
            if self._stopped:
                raise RunError("stopped")
            process = subprocess.Popen([self.path, *map(str, words)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                       text=True, errors="replace")
            self._running.add(process)
        said = process.communicate()[1]
        with self._lock:
            self._running.discard(process)
        if process.returncode != 0:
            raise RunError(said[said.find("error:"):] if "error:" in said else f"{said}ended with {process.returncode}")

    def stop(self):
        with self._lock:
            self._stopped = True
            for process in self._running:
                process.kill()


def list_jobs(file, with_short, with_long):
    """Runs of the case: each [[run]] with each of its schemes."""
    jobs = []
    for run in file.runs:
        for scheme in run.schemes or [""]:
            is_long = scheme in run.long if isinstance(run.long, list) else run.long
            if with_long if is_long else with_short:
                jobs.append(Job(file, run, scheme))
    return jobs


def solve(job, program):
    """Never raises but for interruptions."""
    start = time.monotonic()
    try:
        with tempfile.TemporaryDirectory(prefix="terp_verify_") as folder:
            solved = Solved(_solve_and_measure(job, program, Path(folder) / "run"))
    except (CaseError, RunError, OSError) as error:
        solved = Solved([], str(error))
    solved.seconds = time.monotonic() - start
    return solved


def read_bounds(scope, finding):
    """Fills in tolerance and bounds. Raises CaseError for one that is not finite, or a tolerance below 0."""
    q = finding.quantity
    for key in BOUNDS:
        if not (text := getattr(q, key)):
            continue
        value, is_tolerance = scope.number(q, key, text), key in ("tolerance", "relative")
        if not math.isfinite(value) or (is_tolerance and value < 0.0):
            q.place.refuse(f"`{key}` must be a finite number{', 0 or more' if is_tolerance else ''}", f"Got {value:g}.",
                           key)
        finding.bounds[key] = value


def _solve_and_measure(job, program, folder):
    if job.run.stability:
        return _find_factor(job, program, folder)
    if job.run.seepage:
        return _find_flow(job, program, folder)
    program("run", *_words(job, folder), "--exact-fields")
    numbers = RunNumbers(folder)
    scope = _make_scope(job, numbers.run.case, {"dt": numbers.numbers["dt"]})
    return _find(job, numbers.run.summary["scheme"], scope, lambda q: measure(q, scope, numbers))


def _find_factor(job, program, folder):
    """The search for a factor of safety takes the place of the run: of soil that carries tension."""
    start, stop, tolerance = job.run.stability
    depth = ["--least-depth", job.run.least_depth] if job.run.least_depth else []
    program("stability", *_words(job, folder), "--with-tension", "--from", start, "--to", stop, "--tolerance",
            tolerance, *depth)
    result = json.loads((folder / "stability.json").read_text(encoding="utf-8"))
    scope = _make_scope(job, tomllib.loads(result["case"]), {})
    measured = {name: math.nan if result[name] is None else result[name] for name in ("stable_at", "not_stable_at")}
    measured["factor"] = 0.5 * (measured["stable_at"] + measured["not_stable_at"])

    return _find(job, result["scheme"], scope, _formulas_alone(
        scope, measured, "a run for a factor of safety", "They may name factor, stable_at, not_stable_at."))


def _formulas_alone(scope, measured, what, names):
    """Measures quantities of numbers that no run folder holds."""
    def measure_formula(q):
        if q.kind != "formula":
            q.place.refuse(f"{what} has quantities of kind `formula` only", names)
        scope.constants.update(measured)
        return measure(q, scope, None)
    return measure_formula


def _find_flow(job, program, folder):
    """`terp seepage` takes the place of the run: flows out of the soil at the start by name, and a head."""
    x, y = job.run.seepage
    program("seepage", job.file.path.parent / job.run.case, "-o", folder, "-q", "--along", f"{x},{y},{x},{y}",
            *(word for change in job.run.set for word in ("--set", change)))
    case = tomllib.loads((folder / "case.toml").read_text(encoding="utf-8"))
    scope = _make_scope(job, case, {})
    with open(folder / "seepage.csv", encoding="utf-8", newline="") as file:
        measured = {"out_" + re.sub(r"\W+", "_", row["part"]): float(row["outflow_m2_per_s"])
                    for row in csv.DictReader(file) if row["situation"] == "start"}
    with open(folder / "along.csv", encoding="utf-8", newline="") as file:
        measured["head"] = next((float(row["head_m"]) for row in csv.DictReader(file)), math.nan)

    return _find(job, case.get("scheme", "mpm_gp"), scope, _formulas_alone(
        scope, measured, "a run of `terp seepage`", "They may name out_NAME of each part, and head."))


def _words(job, folder):
    """Arguments for the program: the case, its changes, one thread."""
    changes = job.run.set + ([f"scheme={job.scheme}"] if job.scheme else [])
    return [job.file.path.parent / job.run.case, "-o", folder, "-q", "-j", 1,
            *(word for change in changes for word in ("--set", change))]


def _find(job, scheme, scope, measure_one):
    """Findings in the order of the file, so that later formulas may use earlier values; without those of no row."""
    findings = []
    quantities = [q for q in job.file.quantities if not q.compares_runs and q.is_of(job.run.name)]
    constants = dict(scope.constants)
    for q in quantities:
        finding = Finding(q, job.run.name, scheme, constants)
        findings.append(finding)
        try:
            read_bounds(Scope(constants), finding)
            finding.value, finding.reference = measure_one(q)
            if q.alias:
                scope.constants[q.alias] = finding.value
        except CaseError as error:
            finding.fault = str(error)
    return [f for f in findings if f.fault or not f.quantity.is_auxiliary]


def _make_scope(job, case, known):
    """`end`, `dt`, constants of the file, then those of the run; each may use those before it."""
    scope = Scope({"end": _end_of(case), **known})
    for table, constants in ((job.file.place, job.file.constants), (job.run.place, job.run.constants)):
        for name, text, key in constants:
            scope.constants[name] = (_number_of(table, name, case, key) if key else
                                     float(scope.evaluate(table, name, text)))
    return scope


def _end_of(case):
    """The latest end of the run [s]: of stages their sum as the program rounds it; nan where one has a unit."""
    ends = [stage.get("at_most", stage.get("duration")) for stage in case.get("stage", [])]
    ends = ends or [case["time"].get("at_most", case["time"].get("end"))]
    if not all(map(is_number, ends)):
        return math.nan
    return float(f"{sum(ends):.12g}" if "stage" in case else ends[0])


def _number_of(table, name, case, key):
    """A number of the case as it ran, with the run's `set`, such as "body[0].velocity[0]"."""
    value = case
    for part in re.findall(r"[^.\[\]]+", key):
        try:
            value = value[int(part) if isinstance(value, list) else part]
        except (KeyError, IndexError, TypeError, ValueError):
            table.refuse(f"the case says nothing of `{key}`",
                         "A constant takes a number that case.toml or `set` gives.", name)
    if not is_number(value):
        table.refuse(f"`{key}` is not a number", "A constant takes a number without a unit: it is in SI.", name)
    return float(value)
