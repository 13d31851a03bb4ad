"""What tests of whole cases read from the history of the named points."""

import sys
import unittest
from pathlib import Path

import support

import terp

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cases"))
from named_points import regained, softening_time  # noqa: E402 (not a package)


class NamedPoints(unittest.TestCase):
    def test_only_mixed_regains_strength(self):
        self.assertIn("C", regained(terp.open(support.synthetic_run("mpm_mixed", 2))))
        self.assertEqual(regained(terp.open(support.synthetic_run("mpm_gp", 2))), [])

    def test_softening_time_is_the_first_row_beyond_six_percent(self):
        run = terp.open(support.synthetic_run("mpm_gp", 2))
        rows, time = run.history_of("E"), softening_time(run, "E")
        self.assertTrue((rows["eps_eq_p"][rows["time"] < time] <= 0.06).all())
        self.assertGreater(rows["eps_eq_p"][rows["time"] == time], 0.06)

    def test_a_point_that_never_softens_has_none(self):
        self.assertIsNone(softening_time(terp.open(support.synthetic_run("mpm_gp", 2, 1.0)), "J"))


if __name__ == "__main__":
    unittest.main()
