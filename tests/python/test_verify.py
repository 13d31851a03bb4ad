"""The ledger of verification cases: what expected.toml may say, what is measured, how it is judged, what is printed."""

import math
import pathlib
import tempfile
import unittest

import support

import numpy as np
from terp.errors import CaseError, RunError
from terp.verify import cases, ledger, measures
from terp.verify.expected import Quantity, Table, read_expected
from terp.verify.formula import FormulaError, evaluate
from terp.verify.judge import FAIL, PASS, RED, REGRESSION, Row, extrapolate, judge, log_slope, observed_order
from terp.verify.solve import Finding, Solved, list_jobs

CASES = support.HERE.parents[1] / "cases" / "verification"
GOOD = """title = "Flight"
[constants]
V = { key = "body[0].velocity[0]" }
twice = "2*V"
[[run]]
name = "a"
schemes = ["mpm_gp", "mpm_mixed"]
set = ["time.end=0.2"]
seconds = 3
[[run]]
name = "b"
long = true
[[quantity]]
name = "path"
value = "ux"
reduce = "max_error"
reference = "V*t"
tolerance = 1e-9
runs = ["a"]
source = "Newton"
"""
FLYING = """scheme = "mpm_gp"
[time]
end = 0.5
[mesh]
size = [4.0, 1.0]
cell = 0.5
[[body]]
material = "rock"
box = [[0.5, 0.0], [1.5, 1.0]]
points_per_cell = 2
velocity = [2.0, 0.0]
[material.rock]
model = "linear_elastic"
density = 2000.0
shear_modulus = 1.0e6
poisson_ratio = 0.25
[output]
fields = { every = 0.1 }
"""  # a block that moves by 2 m/s


class Sample(unittest.TestCase):
    """A folder with a verification case, or several."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def write(self, expected, name=""):
        folder = self.folder / name
        folder.mkdir(exist_ok=True)
        (folder / "case.toml").write_text(FLYING)
        (folder / "expected.toml").write_text(expected)
        return folder / "expected.toml"

    def refusal(self, expected):
        try:
            read_expected(self.write(expected))
        except CaseError as error:
            return str(error)
        return ""


class Expected(Sample):
    def test_keeps_what_the_file_says(self):
        file = read_expected(self.write(GOOD))
        self.assertEqual(file.title, "Flight")
        self.assertEqual(file.constants, [("V", None, "body[0].velocity[0]"), ("twice", "2*V", None)])
        a, b = file.runs
        self.assertEqual((a.schemes, a.set, a.case, a.seconds), (["mpm_gp", "mpm_mixed"], ["time.end=0.2"], "case.toml",
                                                                 3))
        self.assertTrue(b.long)
        q, = file.quantities
        self.assertEqual((q.kind, q.reduce, q.tolerance, q.runs), ("field", "max_error", "1e-09", ["a"]))

    def test_what_is_wrong_is_refused_in_the_words_of_the_table(self):
        verdict, n_rows = "refused", 0
        for line in (support.HERE / "expected.wrong").read_text().splitlines():
            if line.startswith("@"):
                verdict = line.split()[-1]
            if not line or line[0] in "#@":
                continue
            n_rows += 1
            old, new, said = [part.replace("\\n", "\n") for part in line.split(" | ")] + [""] * (2 - line.count(" | "))
            with self.subTest(line=line):
                self.assertEqual(GOOD.count(old), 1 if old.strip() else GOOD.count(old))
                message = self.refusal(GOOD.replace(old, new) if old.strip() else GOOD + new)
                self.assertEqual(message == "", verdict == "accepted", message)
                self.assertIn(said, message)
        self.assertGreater(n_rows, 75)

    def test_only_one_run_needs_no_name(self):
        nameless = GOOD.replace('name = "a"\n', "").replace('name = "b"\n', "").replace('runs = ["a"]\n', "")
        self.assertIn("more than one run has no `name`", self.refusal(nameless))

    def test_a_folder_without_one_is_no_case(self):
        with self.assertRaisesRegex(CaseError, "there is no such file\n  A verification case is a folder"):
            read_expected(pathlib.Path("/nowhere/expected.toml"))

    def test_runs_are_each_with_each_scheme_short_or_long(self):
        def schemes(runs, *lengths):
            text = f'title = "x"\n[[run]]\nschemes = ["mpm_gp", "mpm_mixed"]\n{runs}'
            return [job.scheme for job in list_jobs(read_expected(self.write(text)), *lengths)]
        two, one_long = 'name = "a"\n[[run]]\nname = "b"\nlong = true\n', 'long = ["mpm_mixed"]\n'
        self.assertEqual(schemes(two, True, True), ["mpm_gp", "mpm_mixed", ""])
        self.assertEqual(schemes(two, True, False), ["mpm_gp", "mpm_mixed"])
        self.assertEqual(schemes(two, False, True), [""])
        self.assertEqual(schemes(one_long, True, False), ["mpm_gp"])
        self.assertEqual(schemes(one_long, False, True), ["mpm_mixed"])

    def test_at_most_a_tenth_of_the_rows_of_all_cases_hold_terp_against_itself(self):
        n_rows = n_regressions = 0
        for name in cases.choose(CASES, []):
            file = read_expected(CASES / name / "expected.toml")
            for q in file.quantities:
                n = 0 if q.is_auxiliary else self.count_rows(file, q)
                self.assertTrue(n > 0 or q.is_auxiliary, f"{name}: {q.name} has no row")
                n_rows += n
                n_regressions += n if q.regression else 0
        self.assertGreater(n_regressions, 0)
        self.assertFalse(ledger.too_many_regressions(n_regressions, n_rows), f"{n_regressions} of {n_rows}")

    @staticmethod
    def count_rows(file, q):
        """Rows when all runs are solved. A run without schemes counts as one of a scheme of its own."""
        measured = [m for m in file.quantities if (m.name == q.of if q.compares_runs else m is q)]
        runs = [job.scheme for m in measured for job in list_jobs(file, True, True)
                if m.is_of(job.run.name) and q.is_of(job.run.name)]
        if not q.compares_runs or q.kind == "mesh_error":
            return len(runs)
        return sum(runs.count(scheme) >= q.least_runs for scheme in set(runs))


class Formulas(unittest.TestCase):
    def test_are_evaluated_as_the_program_does(self):
        for text, value in {"-2^2": -4, "2^3^2": 512, "2^-1": 0.5, "a*a^2": 8, "1 < 2 && 3 > 4 || 1": 1,
                            "1 ? 2 : 0 ? 3 : 4": 2, "min(3,2,1)+max(1,2)": 3, "1/0": math.inf, "ln(0)": -math.inf,
                            "rint(2.5)": 3, "rint(-2.5)": -2, "mod(-1,3)": 2, "step(0)": 1, "avg(1,2)+sum(1,2)": 4.5,
                            "4*atan2(1,1)-pi": 0, "1.5e3+.5": 1500.5, "(1 == 1) != (2 <= 1)": 1, "exp(1e4)": math.inf,
                            "+a - -a": 4}.items():
            self.assertEqual(evaluate(text, {"a": 2.0}), value, text)
        self.assertEqual(evaluate("sin(a)*cos(a)^2/tan(a)", {"a": 0.7}),
                         math.sin(0.7) * math.pow(math.cos(0.7), 2) / math.tan(0.7))

    def test_what_is_no_number_makes_the_whole_none(self):
        for text in ("sqrt(-1)", "n > 1", "n == n ? 1 : 1", "max(1, n)"):
            self.assertTrue(math.isnan(evaluate(text, {"n": math.nan})), text)
        x = np.array([1.0, np.nan, 3.0])
        np.testing.assert_array_equal(evaluate("x > 2 ? a : 0", {"a": 5}, ["x"], lambda name: x), [0.0, np.nan, 5.0])

    def test_say_what_is_wrong(self):
        rows = {"0,5": "The comma at letter 2 separates no arguments of a function. The decimal point is `.`",
                "x0 = 1": "`=` at letter 4 compares nothing. Compare with `==`", "2*": "has no end", "(1": "has no end",
                "velocty": "`velocty` is not known here. Did you mean `velocity`? Names: velocity",
                "sine(1)": "There is no function `sine`. Did you mean `sin`?", "a.b": "`.` at letter 2 stands where",
                "sin(1,2)": "`sin` takes 1 argument, got 2", "2 3": "`3` at letter 3 stands where none may"}
        for text, said in rows.items():
            with self.assertRaises(FormulaError) as caught:
                evaluate(text, {"velocity": 1.0})
            self.assertIn(said, str(caught.exception))


def finding(value, reference=math.nan, run="coarse", scheme="mpm_gp", constants=None, **keys):
    """Of a quantity with these keys; a bound among them judges it."""
    q = Quantity(**{"name": "width", "kind": "summary", "reduce": "last", "unit": "", "source": "book", "shown": "",
                    "red": "", "regression": "", "red_runs": [], "runs": [], "reference": "", **keys})
    bounds = {key: keys.get(key, math.nan) for key in ("tolerance", "relative", "at_least", "at_most")}
    return Finding(q, run, scheme, constants or {}, value, reference, bounds)


def rows_of(findings, quantities=None, fault=""):
    file = type("File", (), {"quantities": quantities or [f.quantity for f in findings]})
    run = type("Run", (), {"name": "coarse"})
    return judge(file, [(type("Job", (), {"run": run, "scheme": "mpm_gp"}), Solved(findings, fault))])


class Judge(unittest.TestCase):
    def one(self, *numbers, **keys):
        return rows_of([finding(*numbers, **keys)])[0]

    def test_a_number_is_held_against_its_tolerance_or_bound(self):
        for value, reference, kind, bound, verdict, used in (
                (2.1, 2.0, "tolerance", 0.11, PASS, 0.1 / 0.11), (2.1, 2.0, "tolerance", 0.09, FAIL, 0.1 / 0.09),
                (-1.9, -2.0, "relative", 0.051, PASS, 0.05 / 0.051), (-1.9, -2.0, "relative", 0.04, FAIL, 0.05 / 0.04),
                (2.0, math.nan, "at_least", 2.0, PASS, 1.0), (1.99, math.nan, "at_least", 2.0, FAIL, 2.0 / 1.99),
                (1.99, math.nan, "at_most", 1.98, FAIL, 1.99 / 1.98), (2.0, math.nan, "at_least", -1.0, PASS, -1.0)):
            row = self.one(value, reference, **{kind: bound})
            self.assertEqual(row.verdict, verdict)
            self.assertAlmostEqual(row.used, used, 12)

    def test_a_row_says_the_error_in_the_unit_of_its_tolerance(self):
        row = self.one(2.1, 2.0, tolerance=0.09, unit="m")
        self.assertEqual((row.run, row.reference, row.terp, row.error, row.tolerance),
                         ("coarse, mpm_gp", "2 m", "2.1 m", "0.1", "0.09"))
        self.assertEqual(self.one(2.1, 2.0, relative=0.1).error, "5 %")
        row = self.one(0.0349, reduce="rms_error", reference="0", tolerance=0.04)
        self.assertEqual((row.reference, row.terp, row.error), ("0", "rms error 0.0349", "0.035"))

    def test_what_is_no_finite_number_never_passes(self):
        row = self.one(math.nan, 2.0, tolerance=1e9, red="slow")
        self.assertEqual((row.verdict, row.terp), (FAIL, "never"))
        self.assertEqual(row.remark, "the formula, or a quantity in it, is not a finite number")
        self.assertEqual(self.one(-math.inf, at_most=1.0).verdict, FAIL)
        self.assertEqual(self.one(math.inf, at_least=1.0).verdict, FAIL)
        never = self.one(math.nan, 1.0, tolerance=1.0, reduce="arrival")
        self.assertEqual(never.remark, "the threshold was not reached")

    def test_a_fault_is_a_row_that_fails_beside_the_others(self):
        bad, good = finding(math.nan, name="bad"), finding(2.0, 2.0, name="good", tolerance=0.1)
        bad.fault = "no point is `where` this says"
        rows = rows_of([bad, good])
        self.assertEqual([(r.quantity, r.verdict, r.remark) for r in rows],
                         [("bad", FAIL, "no point is `where` this says"), ("good", PASS, "")])
        row, = rows_of([], fault="it stopped")
        self.assertEqual((row.quantity, row.verdict, row.remark), ("the run", FAIL, "it stopped"))

    def test_a_red_row_that_the_case_declares_is_red_and_not_pass(self):
        def verdict(value, *red_runs):
            row = self.one(value, 2.0, tolerance=0.1, red="cells are too large", red_runs=list(red_runs))
            return row.verdict, row.remark, row.agrees_though_red
        self.assertEqual(verdict(3.0), (RED, "cells are too large", False))
        self.assertEqual(verdict(2.0), (PASS, "", True))
        for other in ("fine", "mpm_mixed", "coarse, mpm_mixed"):
            self.assertEqual(verdict(3.0, other)[0], FAIL)
        for own in ("coarse", "mpm_gp", "coarse, mpm_gp"):
            self.assertEqual(verdict(3.0, "fine", own)[0], RED)

    def test_a_regression_row_never_passes_and_fails_if_it_misses(self):
        def verdict(value, **keys):
            row = self.one(value, 2.0, tolerance=0.1, regression="nobody else has it", **keys)
            return row.verdict, row.remark
        self.assertEqual(verdict(2.0), (REGRESSION, "nobody else has it"))
        self.assertEqual(verdict(3.0), (FAIL, ""))
        self.assertEqual(verdict(3.0, red="coarse"), (RED, "coarse"))
        self.assertEqual(verdict(2.0, red="coarse")[0], REGRESSION)

    def compared(self, kind, shift, n=3, **keys):
        """Verdicts and numbers of a quantity that compares n runs, which tend to 5 + shift with the first order."""
        runs = [finding(5.0 + shift + h, name="load", tolerance=1.0, constants={"h": h}, reference=5.0)
                for h in (0.5, 0.25, 0.125)[:n]]
        for run in runs:
            run.quantity = runs[0].quantity
        table = Table(type("File", (), {"path": "expected.toml", "text": ""}))
        q = Quantity(**{**vars(runs[0].quantity), **dict.fromkeys(("at_least", "at_most", "relative", "order"), ""),
                        "name": "compared", "kind": kind, "reduce": "last", "of": "load", "over": "h", "place": table,
                        "differences": False, "reference": "5", "tolerance": "gci", **keys})
        return [(row.verdict, row.terp) for row in rows_of(runs, [runs[0].quantity, q]) if row.quantity == "compared"]

    def test_an_extrapolated_value_is_held_against_its_own_uncertainty(self):
        self.assertEqual(self.compared("extrapolated", 0.1), [(PASS, "5.1")])  # gci = 1.25 * 0.125
        self.assertEqual(self.compared("extrapolated", 0.2), [(FAIL, "5.2")])
        self.assertEqual(self.compared("extrapolated", 0.0, 2), [], "too few: no row")
        self.assertEqual(self.compared("extrapolated", 0.0, 2, order="1"), [(PASS, "5")])

    def test_a_run_may_err_by_what_refinement_shows_of_its_mesh(self):
        self.assertEqual([v for v, _ in self.compared("mesh_error", 0.0)], [PASS] * 3)
        self.assertEqual([v for v, _ in self.compared("mesh_error", 0.05)], [PASS, PASS, FAIL])

    def test_the_order_of_convergence_compares_runs_of_one_scheme(self):
        self.assertEqual(self.compared("order", 0.0, reference="", tolerance="", at_least="0.9"), [(PASS, "1")])
        self.assertEqual(self.compared("order", 0.5, tolerance="", differences=True, at_least="1.1"), [(FAIL, "1")])
        self.assertEqual(self.compared("order", 0.5, over="k")[0][0], FAIL, "the name is not known: a row of its own")

    def test_limits_and_orders_are_those_of_known_sequences(self):
        for order in (0.6, 1.0, 1.7):
            for x in ((0.5, 0.125, 0.25), (0.9, 0.3, 0.2)):
                limit, uncertainty = extrapolate([*x, 1.0], [3.0 - 0.4 * h**order for h in x] + [100.0])
                self.assertAlmostEqual(limit, 3.0, 11)
                self.assertAlmostEqual(uncertainty, 1.25 * 0.4 * min(x)**order, 11)
        self.assertAlmostEqual(extrapolate([0.25, 0.5, 1.0], [1.0, 1.0 + 1 / 64, 2.0 + 1 / 64])[0], 1 - 1 / 192, 12)
        for y in ([1.0, 1.1], [1.0, 1.3, 1.4], [1.0, 0.9, 1.4], [1.0, 1.0, 1.0]):
            self.assertTrue(math.isnan(extrapolate([0.25, 0.5, 1.0][:len(y)], y)[0]), y)
        self.assertEqual(extrapolate([0.25, 0.5, 1.0], [1.0, 1.0, 2.0]), (1.0, 0.0))
        self.assertAlmostEqual(log_slope([0.5, 0.25, 0.125], [8.0, 2.0, 0.5]), 2.0, 12)
        self.assertTrue(math.isnan(log_slope([0.5, 0.5], [8.0, 2.0])))
        self.assertAlmostEqual(observed_order([0.125, 0.5, 0.25], [7.125, 7.5, 7.25]), 1.0, 12)


class Series(unittest.TestCase):
    def test_gives_one_number(self):
        t, v = np.array([0.0, 1.0, 2.0, 3.0, 4.0]), np.array([-1.0, 1.0, -1.0, 3.0, 4.0])
        self.assertEqual(measures.value_at(t, v, 2.25), 0.0)
        self.assertTrue(math.isnan(measures.value_at(t, v, 5.0)))
        self.assertEqual(measures.period_of(t, v), 1.75)
        self.assertTrue(math.isnan(measures.period_of(t[:2], v[:2])))
        self.assertEqual(measures.arrival_of(t, v, 2.0), 2.5)
        self.assertEqual(measures.arrival_of(t, v, 1.0), 0.0)
        self.assertTrue(math.isnan(measures.arrival_of(t, v, 5.0)))
        for reduce, number in {"mean": 1.2, "sum": 6.0, "max": 4.0, "min": -1.0, "last": 4.0}.items():
            self.assertAlmostEqual(measures.reduce_values(v, None, reduce), number, 12)
        self.assertEqual(measures.reduce_values(v, v + 2.0, "rms_error", 4.0), 0.5)
        self.assertEqual(measures.reduce_values(v, t, "max_error"), 3.0)
        self.assertTrue(math.isnan(measures.reduce_values(np.array([1.0, np.nan]), None, "max")))


def row_that_passes(**keys):
    return Row(**{"run": "h = 1 m, mpm_gp", "quantity": "stress <zz>", "reference": "a|b", "terp": "2", "error": "0.1",
                  "tolerance": "0.2", "verdict": PASS, "source": "Euler", "used": 0.5, **keys})


def sample_rows(name="bar", remark="too coarse"):
    """Two rows that pass, two red of one reason, and one that fails without a reason."""
    red = row_that_passes(verdict=RED, remark=remark, used=1.5)
    return ledger.CaseRows(name, f"A {name}", [row_that_passes(), row_that_passes(quantity="strain", used=0.7), red,
                                               red, row_that_passes(verdict=FAIL)])


class Pages(unittest.TestCase):
    def test_counts_say_which_red_is_known(self):
        pages = [sample_rows()]
        self.assertEqual(ledger.counts_text(pages),
                         "5 rows: 2 pass, 3 red (2 known, with the reason) (1 not known: FAIL)")
        pages[0].rows[0].declared_red = True
        self.assertIn("(1 declared red, but agree)", ledger.counts_text(pages))
        self.assertIn("  ? stress <zz>, h = 1 m, mpm_gp: declared red in expected.toml, but agrees.",
                      ledger.text_table(pages[0]))
        self.assertEqual([ledger.too_many_regressions(2, n) for n in (20, 19)], [False, True])

    def test_the_tables_name_every_column_and_the_reasons(self):
        rows = sample_rows()
        text = ledger.text_table(rows)
        self.assertIn("bar: A bar\n  quantity     run              reference  Terp  error  tolerance  result  source\n",
                      text)
        self.assertIn("  stress <zz>  h = 1 m, mpm_gp  a|b        2     0.1    0.2        pass    Euler\n", text)
        self.assertIn("  ! stress <zz>: too coarse\n", text)
        page = ledger.markdown_page([rows], "How to read it.")
        self.assertIn("| stress \\<zz> | h = 1 m, mpm_gp | a\\|b | 2 | 0.1 | 0.2 | red | Euler |", page)
        self.assertIn("**Red.** stress \\<zz>: too coarse", page)

    def test_regression_rows_are_counted_apart_and_said(self):
        rows = sample_rows()
        rows.rows[1] = row_that_passes(verdict=REGRESSION, remark="no value", declared_regression=True)
        rows.rows[4].declared_regression = True
        self.assertIn("1 pass, 3 red, 1 regression (2 known", ledger.counts_text([rows]))
        text, page = ledger.text_table(rows), ledger.markdown_page([rows], "")
        self.assertIn("  = regression, no pass: stress <zz>: no value\n", text)
        self.assertIn(" FAIL: regression, misses  ", text)
        self.assertIn("**Regression.** stress \\<zz>: no value\n", page)
        short = ledger.overview_page(ledger.overview_of([rows]), "Head.")
        self.assertIn("| A bar | 5 | 3 (1 FAIL) | 1 | 50 % of 0.2: stress", short)
        self.assertTrue(short.endswith("\n## Regression\n\n- **bar**, 1 row: stress \\<zz>: no value\n"))
        self.assertEqual(ledger.overview_page(ledger.read_overview(short), "Head."), short)

    def test_the_short_page_has_one_line_per_case_and_each_reason_once(self):
        page = ledger.overview_page(ledger.overview_of([sample_rows()]), "How to read it.")
        self.assertTrue(page.endswith(
            "5 rows: 2 pass, 3 red, 0 regression.\n\nHow to read it.\n"
            "| case | | rows | red | regression | nearest to its bound |\n|---|---|---|---|---|---|\n"
            "| [bar](../cases/verification/bar/README.md) | A bar | 5 | 3 (1 FAIL) | 0 | 70 % of 0.2: strain, h = 1 m, "
            "mpm_gp |\n\n## Red\n\n- **bar**, 2 rows: stress \\<zz>: too coarse\n"), page)

    def test_a_case_that_is_not_solved_keeps_what_the_page_says(self):
        reason = "coarse" + " | and coarse" * 30
        both = [sample_rows("bar", reason), sample_rows("rod", "thin")]
        page = ledger.overview_page(ledger.overview_of(both), "Head.")
        self.assertTrue(all(len(line) <= 120 for line in page.splitlines() if line[:1] in "- "))
        self.assertEqual(ledger.overview_page(ledger.read_overview(page), "Head."), page)
        better = sample_rows("rod")
        better.rows = better.rows[:2]
        now = ledger.overview_page({**ledger.read_overview(page), **ledger.overview_of([better])}, "Head.")
        for part in ("7 rows: 4 pass, 3 red, 0 regression.", "| A rod | 2 | 0 | 0 |", "- **bar**"):
            self.assertIn(part, now)
        self.assertNotIn("thin", now)

    def test_the_published_page_is_read_as_it_was_written(self):
        page = (support.HERE.parents[1] / "docs" / "verification.md").read_text(encoding="utf-8")
        head = (CASES / "README.md").read_text(encoding="utf-8").partition("\n")[2][1:]
        self.assertEqual(ledger.overview_page(ledger.read_overview(page), head), page)


class Choice(Sample):
    def test_all_without_a_name_and_those_that_begin_alike(self):
        for name in ("bar", "column_1", "column_2"):
            self.write('title = "x"\n', name)
        (self.folder / "no_case").mkdir()
        self.assertEqual(cases.choose(self.folder, []), ["bar", "column_1", "column_2"])
        self.assertEqual(cases.choose(self.folder, ["column_2", "column*", "column_2"]), ["column_2", "column_1"])
        with self.assertRaisesRegex(RunError, "no verification case `colum_1`. Did you mean `column_1`.\n  Cases: bar"):
            cases.choose(self.folder, ["colum_1"])
        with self.assertRaisesRegex(RunError, "there are no verification cases: folders with an expected.toml"):
            cases.choose(self.folder / "bar", [])

    def test_those_of_the_source_are_found_from_the_package(self):
        self.assertEqual(cases.find_folder(), CASES)

