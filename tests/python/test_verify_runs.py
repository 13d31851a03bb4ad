"""Verification cases solved by the program: what each kind of quantity measures, and the command line."""

import contextlib
import io
import math
import os
import signal
import subprocess
import sys
import time
import unittest

import support

import terp
from test_verify import CASES, Sample
from terp.verify import __main__ as command
from terp.verify.expected import read_expected
from terp.verify.measures import RunNumbers
from terp.verify.solve import Program, _end_of, list_jobs, solve

PROGRAM = os.environ.get("TERP")
HEAD = 'title = "Flight"\n[constants]\nV = { key = "body[0].velocity[0]" }\n'


def quantity(lines):
    return f'[[quantity]]\nsource = "Newton"\n{lines}\n'


@unittest.skipUnless(PROGRAM, "TERP names no program")
class Measures(Sample):
    """A block that flies freely, where the value of each kind of quantity is known."""

    def solve(self, *quantities, runs="", head=HEAD):
        file = read_expected(self.write(head + runs + "".join(map(quantity, quantities))))
        return solve(list_jobs(file, True, True)[0], Program(PROGRAM))

    def find(self, *quantities):
        solved = self.solve(*quantities)
        self.assertEqual(solved.fault, "")
        return solved.findings

    def test_a_field_at_a_time_is_held_against_its_formula(self):
        path, mean, last = self.find(
            'name = "path"\nvalue = "x-x0"\ntime = 0.2\nreduce = "max_error"\nreference = "V*t"\ntolerance = "1e-9*V"',
            'name = "mean"\nvalue = "x0"\nwhere = "x0 < 1"\nreduce = "mean"\nreference = 0.75\ntolerance = 1',
            'name = "last"\nvalue = "ux"\nreference = "V*end"\nscale = "V"\ntolerance = 1')
        self.assertLess(path.value, 1e-12)
        self.assertTrue(math.isnan(path.reference))
        self.assertEqual((path.bounds["tolerance"], path.scheme), (2e-9, "mpm_gp"))
        self.assertAlmostEqual(mean.value, 0.75, 12)
        self.assertAlmostEqual(mean.reference, 0.75, 12)
        self.assertLess(last.value, 1e-12)

    def test_a_point_is_followed_from_where_it_started_and_its_reference_reduced_alike(self):
        way = 'kind = "point"\nat = [0.6, 0.1]\nvalue = "x"\nreference = "x0+V*t"\ntolerance = 1e-9\nname = '
        found = self.find(f'{way}"a"\ntime = 0.3', *(f'{way}"{reduce}"\nreduce = "{reduce}"'
                                                     for reduce in ("mean", "max", "min", "sum", "last")))
        for f, value in zip(found, (1.225, 1.125, 1.625, 0.625, 6.75, 1.625)):  # frames 0, 0.1, ..., 0.5
            self.assertEqual(f.fault, "")
            self.assertAlmostEqual(f.value, value, 9)
            self.assertAlmostEqual(f.reference, value, 9)
        arrival, = self.find(f'{way}"b"\nreduce = "arrival"\nthreshold = 1')
        self.assertIn("`t` is not known here", arrival.fault)

    def test_ledger_summary_and_formulas_of_earlier_quantities(self):
        one, = self.find('name = "p"\nas = "p"\nkind = "ledger"\nvalue = "momentum_x"\ntime = "end"',  # no row
                         'name = "n"\nas = "n"\nkind = "summary"\nvalue = "points"',
                         'name = "per point"\nkind = "formula"\nvalue = "p/n"\nreference = "2000/16*V"\n'
                         'relative = 1e-12')
        self.assertAlmostEqual(one.value, 250.0, 9)
        self.assertEqual(one.reference, 250.0)

    def test_a_footing_is_the_first_of_the_case(self):
        found = self.find('name = "push"\nkind = "footing"\nvalue = "reaction_y"\nreduce = "max"\nat_least = 1')
        self.assertIn("there is no footing in this case", found[0].fault)
        with open(self.folder / "footings.csv", "w") as file:
            file.write("time,footing,work\n0,a,1\n0,b,2\n0.5,a,3\n0.5,b,4\n")
        rows = RunNumbers(self.folder).footing
        self.assertEqual({name: list(values) for name, values in rows.items()}, {"t": [0.0, 0.5], "work": [1.0, 3.0]})

    def test_what_cannot_be_measured_is_refused_at_its_line_and_costs_no_other(self):
        path, mass = "reference = 0\nvalue = ", 'kind = "ledger"\nvalue = "mass"\nat_least = 1\n'
        error, mean = path + '"x"\nreduce = "max_error"\n', 'value = "x"\nreduce = "mean"\n'
        rows = {
            mass + 'time = "end"': "",
            mass + 'reduce = "arrival"\nthreshold = 1e9': "",  # never, but looked for
            path + '"ux"\ntime = 0.25\ntolerance = 1': "there is no frame at 0.25 s\n  The nearest is at 0.2 s. Let "
                                                       "output.fields.every of the case divide the time.",
            mass + "time = 0.6": "there is no row at 0.6 s\n  There are ",
            mass + 'reduce = "max"\nfrom = 0.4\nto = 0.2': "there is no row from 0.4 to 0.2 s",
            'kind = "point"\nvalue = "x"\nreference = 0\ntolerance = 1\ntime = 0.3\nat = [3.0, 0.1]':
                "there is no soil at x = 3 m, y = 0.1 m",
            path + '"uz"\ntolerance = 1': "this formula cannot be evaluated\n  `uz` is not known here. Names: V, ",
            path + '"ux"\ntolerance = 1\nwhere = "x0 > 99"': "no point is `where` this says",
            error + "tolerance = -0.1": "`tolerance` must be a finite number, 0 or more",
            error + 'tolerance = "1/0"': "Got inf.",
            error + 'tolerance = 1\nscale = "-V"': "`scale` must be a finite number, greater than 0",
            mean + 'at_least = "sqrt(-V)"': "`at_least` must be a finite number\n",
            'kind = "formula"\nvalue = "2*p"\nat_least = 1': "`p` is not known here",
            mean + 'at_least = "V"': "",
        }
        found = self.find(*(f'name = "{k}"\n{lines}' for k, lines in enumerate(rows)))
        self.assertEqual(len(found), len(rows))
        text = (self.folder / "expected.toml").read_text().splitlines()
        for f, (lines, said) in zip(found, rows.items()):
            self.assertEqual(f.fault == "", said == "", f.fault)
            self.assertIn(said, f.fault)
            if f.fault:
                number = int(f.fault.split("expected.toml:")[1].split(":")[0])
                self.assertIn(text[number - 1], [*lines.splitlines(), "[[quantity]]"])

    def test_a_constant_does_not_hide_what_is_measured(self):
        one, = self.find('name = "p"\nvalue = "x"\nas = "y"\nreduce = "mean"',
                         'name = "q"\nvalue = "y"\nreduce = "mean"\nat_least = 0')
        self.assertIn("`y` is a constant and the name of what stands here", one.fault)

    def test_one_value_that_is_no_number_makes_the_largest_none(self):
        for f in self.find('name = "a"\nvalue = "sqrt(x0-1)"\nreduce = "max"\nat_least = 0',
                           'name = "b"\nvalue = "x0"\nwhere = "sqrt(x0-1)"\nreduce = "mean"\nat_least = 0'):
            self.assertEqual(f.fault, "")
            self.assertTrue(math.isnan(f.value))

    def test_constants_are_numbers_of_the_case_as_it_ran_and_formulas_of_those_above(self):
        value = 'name = "a"\nvalue = "a"\nreduce = "mean"\nat_least = 0'
        for constants, expected in (('a = "end/dt"\n', 0.5), ('a = { key = "body[0].points_per_cell" }\n', 2.0),
                                    ('E = { key = "material.rock.shear_modulus" }\na = "2*E"\n', 6e6)):
            solved = self.solve(value, head=f'title = "x"\n[constants]\n{constants}',
                                runs='[[run]]\nset = ["material.rock.shear_modulus=3e6"]\n')
            f, dt = solved.findings[0], solved.findings[0].constants["dt"]
            self.assertAlmostEqual(f.value, expected / dt if expected == 0.5 else expected, 9)
        for constants, said in (('a = { key = "time.courant" }', "the case says nothing of `time.courant`"),
                                ('a = { key = "material.rock.model" }', "`material.rock.model` is not a number"),
                                ('a = "2*rho"', "expected.toml:3: this formula cannot be evaluated")):
            self.assertIn(said, self.solve(value, head=f'title = "x"\n[constants]\n{constants}\n').fault)

    def test_the_end_is_that_of_the_stages_and_none_where_it_has_a_unit(self):
        value = 'name = "a"\nvalue = "end"\nreduce = "mean"\nat_least = 0'
        solved = self.solve(value, runs='[[run]]\nset = ["time.end=\\"0.5 s\\""]\n')
        self.assertTrue(math.isnan(solved.findings[0].value))
        self.assertEqual(_end_of({"stage": [{"duration": 0.1}, {"at_most": 0.2}]}), 0.3)
        self.assertEqual(_end_of({"time": {"until": "at_rest", "at_most": 4}}), 4.0)

    def test_a_run_that_stops_itself_or_is_refused_is_a_fault(self):
        for change, said in (("body[0].velocity=[1e9,0.0]", "error: "), ("mesh.cell=-1", "mesh.cell")):
            self.assertIn(said, self.solve(runs=f'[[run]]\nset = ["{change}"]\n').fault)

    def test_a_factor_of_safety_takes_the_place_of_the_run(self):
        file = read_expected(CASES / "slope_60" / "expected.toml")
        job = list_jobs(file, True, False)[0]
        job.run.stability = [1.4, 1.55, 0.1]
        solved = solve(job, Program(PROGRAM))
        self.assertEqual(solved.fault, "")
        self.assertTrue(1.4 < solved.findings[0].value < 1.55)
        file.quantities[0].kind = "summary"
        self.assertIn("quantities of kind `formula` only", solve(job, Program(PROGRAM)).findings[0].fault)

    def test_fields_have_the_precision_of_the_solver(self):
        subprocess.run([PROGRAM, "run", self.write(HEAD).parent / "case.toml", "-o", self.folder / "run", "-q",
                        "--exact-fields"], check=True)
        run = terp.open(self.folder / "run")
        u, v = run.field("displacement", 1)[:, 0], run.field("velocity", 1)[:, 0]
        self.assertLess(abs(u - run.times[1] * v).max(), 1e-14)


def path_is(reference, more=""):
    return (f'[[quantity]]\nname = "path"\nvalue = "ux"\nreduce = "mean"\nreference = {reference}\nunit = "m"\n'
            f'tolerance = 1e-9\nsource = "Newton"\n{more}')


@unittest.skipUnless(PROGRAM, "TERP names no program")
class Command(Sample):
    def add(self, name, lines):
        self.write(f'title = "Flight"\n{lines}', name)

    def verify(self, *words):
        """(status, standard output, standard error)."""
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            try:
                status = command.main(["--cases", str(self.folder), "-j", "2", *map(str, words)])
            except SystemExit as end:
                status = end.code
        return status, out.getvalue(), err.getvalue()

    def test_prints_the_rows_and_counts_and_returns_0_if_all_pass(self):
        self.add("flight", path_is(1.0))
        status, out, err = self.verify()
        self.assertEqual(status, 0)
        for part in ("flight: Flight\n", "path      mpm_gp  1 m        1 m   ", "\n1 rows: 1 pass, 0 red\n"):
            self.assertIn(part, out)
        self.assertRegex(err, r"^\[1/1\] flight  \d+\.\d s  ETA 0\.0 s\n$")

    def test_a_row_that_misses_fails_it_unless_the_case_declares_it_red(self):
        self.add("flight", path_is(1.1))
        status, out, _ = self.verify()
        self.assertEqual(status, 1)
        self.assertIn("  FAIL    Newton", out)
        self.assertIn("1 rows: 0 pass, 1 red (1 not known: FAIL)\n", out)
        self.add("flight", path_is(1.1, 'red = "it was slow"\n'))
        status, out, _ = self.verify()
        self.assertEqual(status, 0)
        self.assertIn("  ! path: it was slow\n", out)
        self.assertIn("1 rows: 0 pass, 1 red (1 known, with the reason)\n", out)

    def test_too_many_regression_rows_fail_a_ledger_of_all(self):
        self.add("flight", path_is(1.0, 'regression = "nobody else has it"\n'))
        self.assertEqual(self.verify()[0], 1)
        self.assertEqual(self.verify("flight")[0], 0)

    def test_writes_the_pages_and_keeps_the_cases_that_were_not_asked_for(self):
        self.add("flight", path_is(1.0))
        long, short = self.folder / "page.md", self.folder / "short.md"
        self.assertEqual(self.verify("--markdown", long, "--overview", short)[0], 0)
        self.assertIn("| path | mpm_gp | 1 m | 1 m |", long.read_text())
        self.assertIn("| Flight | 1 | 0 | ", short.read_text())
        self.add("fall", path_is(1.0))
        self.assertEqual(self.verify("fall", "--overview", short)[0], 0)
        for part in ("2 rows: 2 pass", "[fall]", "[flight]"):
            self.assertIn(part, short.read_text())

    def test_what_stands_in_the_way_is_said_before_anything_is_solved(self):
        self.add("flight", path_is(1.0))
        for page in (self.folder / "no" / "page.md", self.folder):
            status, _, err = self.verify("--markdown", page)
            self.assertEqual(status, 1)
            self.assertEqual(err, f"error: {page}: the page cannot be written; nothing was solved\n")
        self.assertEqual(self.verify("--terp", "/nowhere/terp")[2],
                         "error: cannot start `/nowhere/terp`. Give the path of the program with --terp\n")
        for words in (["--short", "--long"], ["--short", "--overview", "a.md"], ["-j", "0"]):
            self.assertEqual(self.verify(*words)[0], 2)

    def test_nothing_to_solve_or_to_judge_is_no_pass(self):
        self.add("flight", "[[run]]\nlong = true\n" + path_is(1.0))
        self.assertEqual(self.verify("--short")[::2],
                         (1, "error: there is nothing to solve: these cases have no short run\n"))
        self.add("flight", "")
        status, _, err = self.verify()
        self.assertEqual(status, 2)
        self.assertIn("there is no [[quantity]], so nothing would be judged", err)
        self.add("flight", path_is("V"))
        status, _, err = self.verify()
        self.assertEqual(status, 2)
        self.assertIn("expected.toml: this is not valid TOML: Invalid value (at line 6, column 13)", err)

    def test_a_broken_case_is_one_row_and_the_others_are_solved(self):
        self.add("broken", path_is('"V"'))
        self.add("empty", "")
        self.add("flight", path_is(1.0))
        status, out, _ = self.verify("flight", "broken", "fli*", "empty")  # named twice, solved once
        self.assertEqual(status, 1)
        for part in ("`V` is not known here", "there is no [[quantity]]", "empty: \n",
                     "3 rows: 1 pass, 2 red (2 not known: FAIL)"):
            self.assertIn(part, out)
        self.assertIn("cannot be read\n", self.verify("--list")[1])

    def test_lists_without_solving_and_chooses_by_name_and_length(self):
        self.add("short_one", path_is(1.0))
        self.add("long_one", "[[run]]\nlong = true\n" + path_is(1.0))
        self.assertEqual(self.verify("--list")[1], "long_one                      0 short and  1 long runs  Flight\n"
                         "short_one                     1 short and  0 long runs  Flight\n")
        for length, other in (("short", "long"), ("long", "short")):
            for words in ([f"--{length}"], [f"--{length}", "--list"]):
                out = self.verify(*words)[1]
                self.assertIn(f"{length}_one", out)
                self.assertNotIn(f"{other}_one", out)
        status, _, err = self.verify("shart_one")
        self.assertEqual(status, 1)
        self.assertEqual(err, "error: there is no verification case `shart_one`. Did you mean `short_one`?\n"
                         "  Cases: long_one, short_one\n")

    def test_an_interruption_ends_the_runs_and_judges_nothing(self):
        self.add("flight", '[[run]]\nset = ["time.end=1e5"]\n' + path_is(1.0))
        words = [sys.executable, "-m", "terp.verify", "--cases", self.folder, "--terp", PROGRAM]
        environment = {**os.environ, "PYTHONPATH": str(support.HERE.parents[1] / "python"), "TMPDIR": str(self.folder)}
        process = subprocess.Popen(words, env=environment, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        while not list(self.folder.glob("terp_verify_*/run/ledger.csv")) and process.poll() is None:
            time.sleep(0.02)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=60)
        self.assertEqual((process.returncode, out), (1, ""))
        self.assertIn("error: stopped before all cases were solved; nothing is said of the others\n", err)
        self.assertEqual(list(self.folder.glob("terp_verify_*")), [])
