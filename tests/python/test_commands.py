"""The commands of the program as functions: what they answer, how they end, and who does the work."""

import concurrent.futures
import os
import pathlib
import pickle
import signal
import stat
import sys
import tempfile
import threading
import time
import types
import unittest
import unittest.mock

import support

import numpy as np
import terp
from samples import COLUMN
from terp import program

SAMPLES = support.HERE.parent / "import" / "dstability" / "samples"
STUDY = {"random": [{"key": "material.clay.su_peak", "distribution": "lognormal", "mean": "8 kPa", "cov": 0.4}],
         "estimator": {"kind": "monte_carlo"}, "stop": {"number": 12}, "events": {"volume": 1.0, "displacement": 0.05}}
try:
    from terp import _core  # noqa: F401
except ImportError:
    _core = None


class Commands(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not (os.environ.get("TERP") and _core):
            raise unittest.SkipTest("TERP names no program, or the compiled part was not built")
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name)
        cls.case = terp.Case.from_text(COLUMN)


class Answers(Commands):
    def test_a_check_has_facts_a_picture_and_warnings(self):
        check = terp.check(self.case)
        facts = dict(check.table.tolist())
        self.assertEqual(facts["points"], "32")
        self.assertEqual(facts["mesh"], "30 cells, 44 nodes")
        self.assertIn("few points per cell", check.warnings)
        self.assertIn("few points per cell", repr(check))
        html = check._repr_html_()
        self.assertIn("<svg", html)
        self.assertIn("<td>points</td><td>32</td>", html)
        self.assertEqual(check.plot().get_xlim()[0], 0.0)
        self.assertEqual(set(check.profile(1.1)["su_peak"]), {6e3})

    def test_changes_and_files_and_dictionaries_are_cases(self):
        path = self.folder / "column.toml"
        path.write_text(COLUMN, encoding="utf-8")
        for case, changes in ((path, {"mesh.cell": 0.5}), (terp.Case(path), {"mesh.cell": 0.5}),
                              (self.case.changed({"mesh.cell": 0.5}), None), (dict(self.case), {"mesh.cell": 0.5}),
                              (terp.Case(path, {"mesh.cell": 0.5}), None)):
            self.assertEqual(dict(terp.check(case, changes).table.tolist())["points"], "128")

    def test_a_case_that_names_files_is_checked_in_its_folder(self):
        (self.folder / "su.csv").write_text("x,y,value\n0,0,8e3\n1,1,9e3\n", encoding="utf-8")
        case = terp.Case.from_text(COLUMN.replace("6.0e3", '{ csv = "su.csv" }'), {"material.clay.eta": 6.0},
                                   folder=self.folder)
        before = sorted(self.folder.iterdir())
        self.assertEqual(dict(terp.check(case).table.tolist())["points"], "32")
        self.assertEqual(sorted(self.folder.iterdir()), before, "the file of the case is gone")
        study = terp.study({**STUDY, "random": [{**STUDY["random"][0], "key": "forces.damping.local", "mean": 0.1}],
                            "stop": {"number": 2}}, self.folder / "of_files", case=case)
        self.assertEqual(study.results["solved"], 2)

    def test_a_case_that_is_wrong_is_told_as_by_the_program(self):
        with self.assertRaisesRegex(terp.CaseError, "(?s)^--set mesh.cel=1: unknown key `cel`.*Did you mean `cell`"):
            path = self.folder / "wrong.toml"
            path.write_text(COLUMN, encoding="utf-8")
            terp.check(path, {"mesh.cel": 1})
        with self.assertRaisesRegex(terp.CaseError, "nothing to explain about `mesh.cel`"):
            terp.explain("mesh.cel")
        self.assertIn("width and height of a cell", repr(terp.explain("mesh.cell")))

    def test_stability_has_a_factor_trials_and_a_mechanism(self):
        lines = []
        found = terp.stability(self.case, tolerance=0.05, progress=lines.append)
        self.assertLess(found.bounds[0], found.bounds[1])
        self.assertAlmostEqual(found.factor, found["factor_of_safety"])
        self.assertTrue(any(line.startswith("factor ") for line in lines), lines)
        self.assertEqual(set(found.table["verdict"]), {"stable", "failed"})
        self.assertTrue(np.all(np.diff(found.table["factor"]) >= 0))
        panel = found.plot()
        self.assertIn("factor", panel.get_title())
        self.assertEqual(len(panel.lines[-1].get_xdata()), len(found["mechanism"]["slip_surface"]))
        self.assertIn("<svg", found._repr_html_())
        kept = pickle.loads(pickle.dumps(found))
        self.assertEqual((kept.factor, repr(kept), dict(kept)), (found.factor, repr(found), dict(found)))
        kept.plot("shear_increment")

    def test_stability_is_kept_in_a_folder(self):
        found = terp.stability(self.case, output=self.folder / "search", tolerance=0.1)
        self.assertEqual(terp.open_stability(self.folder / "search").factor, found.factor)
        with self.assertRaisesRegex(terp.RunError, "Use --force to replace it"):
            terp.stability(self.case, output=self.folder / "search")

    def test_convergence_is_a_table_and_a_picture(self):
        found = terp.converge(self.case, [1.0, 0.5, 0.25], output=self.folder / "cells")
        self.assertEqual(found.table.dtype.names[-3:], ("1 m", "0.5 m", "0.25 m"))
        row = found.table[found.table["quantity"] == "front_x"][0]
        panel = found.plot("front_x")
        np.testing.assert_array_equal(panel.lines[0].get_ydata(), [row["1 m"], row["0.5 m"], row["0.25 m"]])
        with self.assertRaisesRegex(terp.RunError, "Did you mean `front_x`"):
            found.plot("front_y")
        self.assertEqual(dict(terp.convergence(self.folder / "cells")), dict(found))
        self.assertIn("as given", repr(found))

    def test_runs_are_compared(self):
        for name, eta in (("one", 5.0), ("two", 9.0)):
            terp.Simulation(self.case.changed({"material.clay.eta": eta}), output=self.folder / name).run()
        found = terp.compare(terp.open(self.folder / "one"), self.folder / "two")
        row = found.table[found.table["quantity"] == "volume that moved"][0]
        self.assertLess(row["one"], row["two"])
        self.assertIn("material.clay.eta", found._repr_html_())

    def test_a_section_of_d_stability_becomes_a_case(self):
        listed = terp.import_stix(SAMPLES / "tutorial-2023.stix")
        self.assertIsNone(listed.case)
        self.assertIn(("High Water", "SpencerGenetic"), listed.table[["label", "method"]].tolist())
        made = terp.import_stix(SAMPLES / "tutorial-2023.stix", self.folder / "section", scenario=1, cell=2.0)
        self.assertEqual(made.case["mesh.cell"][1], 2.0)
        self.assertIn("#", made.report)

    def test_sections_are_assessed(self):
        home = self.folder / "plain"
        home.mkdir()
        (home / "case.toml").write_text(COLUMN, encoding="utf-8")
        lines = []
        reach = terp.assess(home, self.folder / "reach", sections=1, progress=lines.append)
        self.assertTrue(any(line.startswith("[1/1] plain") for line in lines), lines)
        self.assertEqual(reach.table["section"].tolist(), ["plain"])
        self.assertEqual(reach.table["state"].tolist(), ["solved"])
        self.assertEqual(reach["sections"][0]["state"], "solved")
        self.assertTrue(reach.page.is_file())
        self.assertIn("<td>plain</td>", reach._repr_html_())


class Studies(Commands):
    def test_any_executor_solves_the_same_study(self):
        alone = terp.study(STUDY, self.folder / "alone", case=self.case)
        self.assertEqual(alone.results["realisations"], 12)
        self.assertIn("P(I) ", repr(alone))
        self.assertIn("<td>I</td>", alone._repr_html_())
        for kind in concurrent.futures.ThreadPoolExecutor, concurrent.futures.ProcessPoolExecutor:
            lines = []
            with kind(2) as executor:
                study = terp.study(STUDY, self.folder / kind.__name__, case=self.case, executor=executor, parts=3,
                                   progress=lines.append)
            self.assertEqual(sorted(lines), [f"{n} of 3 parts of the study are solved" for n in (1, 2, 3)])
            self.assertEqual(len(list((self.folder / kind.__name__).glob("part_*_of_3.rows"))), 3)
            self.assertEqual((self.folder / kind.__name__ / "results.csv").read_bytes(),
                             (self.folder / "alone" / "results.csv").read_bytes())
            self.assertEqual(study.slide, alone.slide)

    def test_an_executor_maps_what_is_no_study(self):
        cases = [self.case.changed({"material.clay.su_peak": su}) for su in (6e3, 12e3)]
        with concurrent.futures.ProcessPoolExecutor(2) as executor:
            weak, strong = executor.map(terp.stability, cases)
        self.assertAlmostEqual(strong.factor / weak.factor, 2.0, delta=0.1)

    def test_a_study_that_is_wrong_is_refused(self):
        with self.assertRaisesRegex(terp.CaseError, "the study has no case"):
            terp.study(STUDY, self.folder / "none")
        with self.assertRaisesRegex(terp.CaseError, "names its case"):
            terp.study(self.folder / "s.toml", self.folder / "none", case=self.case)
        with concurrent.futures.ThreadPoolExecutor(2) as executor, self.assertRaisesRegex(terp.CaseError, "stop"):
            terp.study({**STUDY, "stop": {}}, self.folder / "none", case=self.case, executor=executor, parts=2)
        self.assertEqual(list(self.folder.glob("none_study_*")), [])

    def test_control_c_keeps_what_is_solved(self):
        long = {**STUDY, "stop": {"number": 100000}}
        for executor in None, concurrent.futures.ThreadPoolExecutor(2):
            folder = self.folder / f"stopped_{executor is None}"

            def interrupt(folder=folder):
                while not any(path.stat().st_size > 2000 for path in folder.glob("part_*.rows")):
                    time.sleep(0.01)
                os.kill(os.getpid(), signal.SIGINT)
            threading.Thread(target=interrupt).start()
            with self.assertRaises(KeyboardInterrupt):
                terp.study(long, folder, case=self.case, executor=executor, parts=2 if executor else None)
            rows = sum(len(path.read_text().splitlines()) for path in folder.glob("part_*.rows"))
            self.assertGreater(rows, 10)


class TheProgram(Commands):
    def test_it_is_found_or_what_to_do_is_said(self):
        self.assertEqual(program.find_program("here"), "here")
        self.assertEqual(program.find_program(), os.environ["TERP"])
        with (unittest.mock.patch.dict(os.environ, {"TERP": "", "PATH": ""}),
              unittest.mock.patch.object(terp, "__path__", [str(self.folder / "a" / "b")])):
            with self.assertRaisesRegex(terp.RunError, "name it by the environment variable TERP"):
                program.find_program()
        with self.assertRaisesRegex(terp.RunError, "cannot start `no_terp`"):
            terp.explain("mesh.cell", program="no_terp")

    def test_exit_statuses_are_errors(self):
        for status, error in ((1, terp.RunError), (2, terp.CaseError), (3, terp.SolveError)):
            path = self.folder / f"ends_{status}"
            path.write_text(f"#!/bin/sh\necho warning: first >&2\necho error: mine >&2\nexit {status}\n")
            path.chmod(path.stat().st_mode | stat.S_IXUSR)
            with self.assertRaisesRegex(error, "^mine$"):
                program.call(["run"], program=path)

    def test_progress_is_one_line_in_a_notebook(self):
        shown = []
        handle = types.SimpleNamespace(update=lambda data, raw: shown.append(data["text/plain"]))
        display = types.SimpleNamespace(display=lambda data, raw, display_id: handle)
        with unittest.mock.patch.dict(sys.modules, {"ipykernel": types.ModuleType("ipykernel"),
                                                    "IPython": types.ModuleType("IPython"),
                                                    "IPython.display": display}):
            terp.stability(self.case, tolerance=0.2)
            self.assertTrue(shown[-1].startswith("factor "), shown)
            shown.clear()
            terp.stability(self.case, tolerance=0.2, progress=False)
        self.assertEqual(shown, [])


if __name__ == "__main__":
    unittest.main()
