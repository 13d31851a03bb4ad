"""What a run in memory says of itself, and what a case is as a value of Python."""

import copy
import os
import pathlib
import pickle
import tempfile
import unittest

import support

import numpy as np
import terp
from samples import COLUMN
from terp import plot

ROOT = support.HERE.parents[1]
CASE = ROOT / "cases" / "column_collapse" / "model_2.toml"
COARSE = {"mesh.cell": 0.25, "time.end": 0.3, "output.fields.every": 0.1}
try:
    from terp import _core  # noqa: F401
except ImportError:
    _core = None


@unittest.skipUnless(_core, "the compiled part of the package was not built")
class CaseAsAValue(unittest.TestCase):
    def setUp(self):
        self.case = terp.Case(CASE, COARSE)

    def test_it_is_read_by_dotted_key(self):
        self.assertEqual(self.case["mesh.cell"], 0.25)
        self.assertEqual(self.case["body[0].material"], "clay")
        self.assertEqual(self.case['material."clay".eta'], 50.0)
        self.assertIn("boundary.left", self.case)
        self.assertNotIn("mesh.polygon", self.case)
        self.assertEqual(self.case.get("mesh.polygon", "none"), "none")
        with self.assertRaisesRegex(KeyError, "does not give `forces.damping.viscous`; terp.explain"):
            self.case["forces.damping.viscous"]

    def test_equal_are_the_same_keys(self):
        self.assertEqual(self.case, terp.Case.from_text(CASE.read_text(), COARSE))
        self.assertEqual(len({self.case, terp.Case(CASE, COARSE)}), 1)
        self.assertNotEqual(self.case, self.case.changed({"mesh.cell": 0.5}))
        self.assertNotEqual(self.case, "mesh")

    def test_files_that_it_names_are_of_its_folder(self):
        text = COLUMN.replace("su_peak = 6.0e3", 'su_peak = { csv = "su.csv" }')
        self.assertNotEqual(text, COLUMN)
        with tempfile.TemporaryDirectory() as one, tempfile.TemporaryDirectory() as two:
            for folder in one, two:
                (pathlib.Path(folder) / "su.csv").write_text("x,y,value\n0,0,8e3\n1,1,9e3\n", encoding="utf-8")
            self.assertNotEqual(terp.Case.from_text(text, folder=one), terp.Case.from_text(text, folder=two))
            self.assertEqual(terp.Case.from_text(text, folder=one), pickle.loads(
                pickle.dumps(terp.Case.from_text(text, folder=one))))

    def test_copies_and_pickles_solve_to_the_same_bits(self):
        solved = terp.Simulation(self.case)
        solved.run(until=0.1)
        for other in copy.copy(self.case), copy.deepcopy(self.case), pickle.loads(pickle.dumps(self.case)):
            self.assertEqual(other, self.case)
            self.assertEqual(other.name, "model_2")
            run = terp.Simulation(other)
            run.run(until=0.1)
            self.assertEqual(run.field("stress").tobytes(), solved.field("stress").tobytes())


@unittest.skipUnless(_core, "the compiled part of the package was not built")
class ResultsInMemory(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.case = terp.Case(CASE, COARSE)
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.run_ = terp.Simulation(cls.case, output=pathlib.Path(scratch.name) / "run")
        cls.run_.run()
        cls.files = terp.open(pathlib.Path(scratch.name) / "run")

    def test_tables_are_those_of_the_files(self):
        for here, there in ((self.run_.ledger, self.files.ledger), (self.run_.history, self.files.history)):
            self.assertEqual(here.dtype.names, there.dtype.names)
            self.assertGreater(len(here), 3)
            for name in here.dtype.names:
                np.testing.assert_array_equal(here[name], there[name], name)
        np.testing.assert_array_equal(self.run_.history_of("B")["su"], self.files.history_of("B")["su"])
        with self.assertRaisesRegex(terp.CaseError, "(?s)no table `legder`.*ledger, "):
            self.run_.table("legder")

    def test_fields_units_and_components_are_those_of_the_frames(self):
        self.assertLessEqual(set(self.files.fields), set(self.run_.fields))
        for name in self.files.fields:
            self.assertEqual(self.run_.unit(name), self.files.unit(name))
            self.assertEqual(self.run_.components.get(name, ()), self.files.components.get(name, ()), name)
        last, now = self.files.frame(-1), self.run_.frame()
        np.testing.assert_array_equal(now.x, last.x)
        np.testing.assert_allclose(now.scalar("stress.xy"), last.scalar("stress.xy"), rtol=1e-6, atol=1e-3)

    def test_it_is_drawn_as_the_last_frame_is(self):
        here, there = (plot.field(run, "eps_eq_p") for run in (self.run_, self.files))
        self.assertEqual(here.get_xlim(), there.get_xlim())
        self.assertEqual(len(here.collections), len(there.collections))
        np.testing.assert_array_equal(here.collections[0].get_offsets(), there.collections[0].get_offsets())
        self.assertEqual(here.collections[0].get_sizes(), there.collections[0].get_sizes())
        plot.ledger(self.run_, ["kinetic", "plastic"]), plot.history(self.run_, "su")

    def test_tables_go_back_with_the_state(self):
        run = terp.Simulation(self.case)
        start = run.save()
        run.run(until=0.15)
        saved, rows = run.save(), len(run.ledger)
        run.run()
        run.restore(saved)
        self.assertEqual(len(run.ledger), rows)
        run.run()
        np.testing.assert_array_equal(run.ledger["time"], self.run_.ledger["time"])
        run.restore(start)
        self.assertEqual(len(run.ledger), 0)
        run.run()
        np.testing.assert_array_equal(run.ledger["kinetic"], self.run_.ledger["kinetic"])

    def test_a_frame_of_the_past_is_gone(self):
        run = terp.Simulation(self.case)
        frame = run.frame()
        x = frame.x
        run.step()
        self.assertIs(frame.x, x, "what was read is kept")
        with self.assertRaisesRegex(terp.RunError, "has gone on"):
            frame["stress"]
        with self.assertRaisesRegex(IndexError, "one frame, the present"):
            run.frame(3)

    def test_a_profile_goes_down_the_section(self):
        profile = terp.Simulation(self.case).profile(1.1)
        self.assertEqual(len(profile), 8)
        np.testing.assert_allclose(profile["su_peak"], 8e3)
        np.testing.assert_allclose(profile["depth"] + profile["y"], 2.0)
        np.testing.assert_allclose(profile["stress"], 9.81 * 1990 * profile["depth"], rtol=1e-6)

    def test_blocks_that_stay_are_made_once(self):
        run = terp.Simulation(self.case)
        run.step()
        first = run.blocks("velocity")
        self.assertTrue(all(a is b for a, b in zip(first, run.blocks("velocity"))))
        before = [view.copy() for view in first]
        run.step()
        self.assertTrue(any(not np.array_equal(a, b) for a, b in zip(before, first)))
        self.assertEqual(sum(map(len, run.blocks("velocity"))), run.n_points)


@unittest.skipUnless(_core, "the compiled part of the package was not built")
class ParametersOfPoints(unittest.TestCase):
    def setUp(self):
        self.case = terp.Case.from_text(COLUMN)  # su_peak 6 kPa, sensitivity 2

    def test_values_of_ones_own_are_those_of_a_case_with_this_field(self):
        mine = terp.Simulation(self.case, vary=["su_peak"])
        mine.set_field("su_peak", 9e3 - 1e3 * mine.field("position")[:, 1])
        given = terp.Simulation(self.case.changed({"material.clay.su_peak": "9e3 - 1e3*y"}))
        for run in mine, given:
            run.run()
        self.assertGreater(mine.field("eps_eq_p").max(), 0.01)
        for name in "parameter_su_residual", "eps_eq_p", "stress":  # the residual strength by the sensitivity
            np.testing.assert_allclose(mine.field(name), given.field(name), rtol=1e-9, atol=1e-9)

    def test_a_case_with_numbers_that_vary_has_the_results_of_the_numbers(self):
        one, other = terp.Simulation(self.case), terp.Simulation(self.case, vary=["su_peak", "eta"])
        for run in one, other:
            run.run()
        np.testing.assert_allclose(one.field("stress"), other.field("stress"), rtol=1e-9)

    def test_what_cannot_vary_is_refused(self):
        with self.assertRaisesRegex(terp.CaseError, r"(?s)no law of the case lets `density` vary.*su_peak"):
            terp.Simulation(self.case, vary=["density"])
        with self.assertRaisesRegex(TypeError, r"\['su_peak'\]"):
            terp.Simulation(self.case, vary="su_peak")
        with self.assertRaisesRegex(terp.CaseError, r'values of their own: terp.Simulation\(case, vary=\["eta"\]\)'):
            terp.Simulation(self.case).set_field("eta", 1.0)

    def test_a_value_that_the_law_refuses_changes_nothing(self):
        run = terp.Simulation(self.case, vary=["su_peak"])
        before = run.field("su_peak")
        wrong = before.copy()
        wrong[3] = -1.0
        with self.assertRaisesRegex(terp.CaseError, "outside of its range at some point"):
            run.set_field("su_peak", wrong)
        np.testing.assert_array_equal(run.field("su_peak"), before)


if __name__ == "__main__":
    unittest.main()
