"""terp.open_study on a study that the program made, and on folders that hold none."""

import math
import os
import pathlib
import subprocess
import tempfile
import unittest

import support  # noqa: F401 (finds the package)

import numpy as np
import terp
from samples import COLUMN

PROGRAM = os.environ.get("TERP")
STUDY = """
case = "column.toml"
[[random]]
key = "material.clay.su_peak"
distribution = "lognormal"
mean = "8 kPa"
cov = 0.4
[estimator]
kind = "monte_carlo"
[stop]
number = 8
[events]
volume = 1.0
displacement = 0.05
"""
CURVE = STUDY + """
[fragility]
name = "weight"
levels = [0.3, 1.0, 2.0]
set = { "forces.gravity" = [0.0, "-9.81*h"] }
distribution = "uniform"
lowest = 0.3
highest = 2.0
"""


class FolderWithoutAStudy(unittest.TestCase):
    def test_says_what_to_do(self):
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(terp.RunError, "has no results.json: write it with `terp study report"):
                terp.open_study(folder)
            (pathlib.Path(folder) / "results.json").write_text("{", encoding="utf-8")
            with self.assertRaisesRegex(terp.RunError, "results.json cannot be read"):
                terp.open_study(folder)


@unittest.skipUnless(PROGRAM, "TERP names no program")
class StudyOfTheProgram(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name)
        (cls.folder / "column.toml").write_text(COLUMN, encoding="utf-8")
        cls.study = cls.made("plain", STUDY)
        cls.curve = cls.made("curve", CURVE)

    @classmethod
    def made(cls, name, text):
        (cls.folder / f"{name}.toml").write_text(text, encoding="utf-8")
        subprocess.run([PROGRAM, "study", "run", str(cls.folder / f"{name}.toml"), "-o", str(cls.folder / name), "-q",
                        "-j", "1"], check=True)
        return terp.open_study(cls.folder / name)

    def test_probabilities_are_those_of_the_table(self):
        table = self.study.table
        self.assertEqual(len(table), 8)
        solved = table["solved"] == 1
        self.assertAlmostEqual(self.study.slide.probability, np.mean(table["slide"][solved]))
        self.assertLess(self.study.slide.low, self.study.slide.probability)
        self.assertLess(self.study.slide.probability, self.study.slide.high)
        self.assertTrue(math.isnan(self.study.flood.probability), "no water is judged")
        self.assertEqual(self.study.inputs, ["material.clay.su_peak"])
        self.assertLess(self.study.sensitivities["material.clay.su_peak"][0], 0.0, "weaker soil slides")

    def test_a_curve_has_a_row_per_level(self):
        levels = self.curve.levels
        np.testing.assert_array_equal(levels["level"], [0.3, 1.0, 2.0])
        self.assertLess(levels["P_I"][0], levels["P_I"][2])
        self.assertAlmostEqual(sum(levels["weight"]), 1.0)
        over = self.curve.results["slide_over_levels"]["probability"]
        self.assertAlmostEqual(over, float(np.dot(levels["weight"], levels["P_I"])))
        self.assertTrue(math.isnan(self.curve.slide.probability), "a mean over levels is nobody's probability")
        with self.assertRaisesRegex(terp.RunError, "there is no .*fragility.csv"):
            self.study.levels

    def test_a_curve_is_drawn_with_its_bounds(self):
        panel = self.curve.plot(["I"])
        self.assertEqual(panel.get_xlabel(), self.curve.results["load"])
        np.testing.assert_array_equal(panel.lines[0].get_ydata(), self.curve.levels["P_I"])
        ends = np.array(panel.collections[0].get_segments())[:, :, 1].T
        np.testing.assert_allclose(ends, [self.curve.levels["P_I_low"], self.curve.levels["P_I_high"]])
        with self.assertRaisesRegex(terp.RunError, "no event `G`.* I, F, F_after_I"):
            self.curve.plot("G")
        with self.assertRaisesRegex(terp.RunError, "has no curve: nothing slid, or no water is judged"):
            self.study.plot()

    def test_a_table_has_rows_without_results(self):
        text = STUDY.replace("[[random]]", "[[field]]").replace('mean = "8 kPa"\n', "theta = [8.0, 4.0]\n").replace(
            'distribution = "lognormal"\n', "").replace("cov = 0.4", "cov = 0.3").replace("number = 8", "number = 12")
        (self.folder / "column.toml").write_text(COLUMN.replace("sensitivity = 2.0", "su_residual = 4.5e3"),
                                                 encoding="utf-8")
        failed = self.made("failed", "seed = 3\n" + text).table
        (self.folder / "column.toml").write_text(COLUMN, encoding="utf-8")
        text = STUDY.replace('"monte_carlo"', '"two_stage"\nfactor = 1.1\naudit = 0.1')
        skipped = self.made("skipped", text).table
        for table in failed, skipped:
            self.assertGreater(np.sum(table["solved"] == 1), 0)
            np.testing.assert_array_equal(np.isnan(table["slides"]), table["solved"] == 0)
            self.assertGreater(np.sum(table["solved"] == 0), 0)
        self.assertIn("skipped", skipped["screening"])

    def test_pairs_are_the_same_samples_on_both_levels(self):
        text = STUDY.replace('"monte_carlo"',
                             '"multilevel"\ncoarse = { "body[0].points_per_cell" = [1, 1] }\npairs = 3')
        study = self.made("levels", text)
        coarse, fine = study.pairs
        np.testing.assert_array_equal(fine["sample"], [0, 1, 2])
        np.testing.assert_array_equal(coarse["sample"], [0, 1, 2])
        self.assertEqual(set(coarse["resolution"]), {"coarse"})
        key = "material.clay.su_peak"
        np.testing.assert_array_equal(coarse[key], fine[key])
        np.testing.assert_array_equal(fine["max_eps_eq_p"], self.study.table["max_eps_eq_p"][:3])
        self.assertEqual(len(study.table), 8 + 3)
        self.assertEqual(study.results["multilevel"]["pairs"], 3)
        with self.assertRaisesRegex(terp.RunError, "is no study on two levels: its estimator is monte_carlo"):
            self.study.pairs

    def test_a_run_of_another_study_or_without_its_end_is_solved_again(self):
        text = STUDY.replace("number = 8", "number = 2")
        first = self.made("again", text).run_of(1, program=PROGRAM).summary["max_eps_eq_p"]
        mark = self.folder / "again" / "kept" / "1" / "of_study.txt"
        (self.folder / "again.toml").write_text("seed = 9\n" + text, encoding="utf-8")
        subprocess.run([PROGRAM, "study", "run", str(self.folder / "again.toml"), "-o", str(self.folder / "again"),
                        "-q", "--force"], check=True)
        self.assertFalse(mark.exists(), "of the study before")
        study = terp.open_study(self.folder / "again")
        second = study.run_of(1, program=PROGRAM).summary["max_eps_eq_p"]
        self.assertNotEqual(first, second)
        self.assertEqual(second, study.table["max_eps_eq_p"][1])
        mark.unlink()  # as of a run that was interrupted
        with self.assertRaisesRegex(terp.RunError, "cannot start `no_terp`"):
            study.run_of(1, program="no_terp")

    def test_a_realisation_is_solved_once_more(self):
        run = self.study.run_of(1, program=PROGRAM)
        self.assertEqual(run.summary["max_eps_eq_p"], self.study.table["max_eps_eq_p"][1])
        self.assertGreater(len(run.field("displacement", -1)), 0)
        with self.assertRaisesRegex(terp.RunError, "cannot start `no_terp`"):
            self.study.run_of(2, program="no_terp")
        with self.assertRaisesRegex(terp.RunError, "was not solved: --keep 99"):
            self.study.run_of(99, program=PROGRAM)


if __name__ == "__main__":
    unittest.main()
