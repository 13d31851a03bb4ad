"""The table that sets the two schemes side by side."""

import re
import unittest

import support

import terp
from terp import table


class Table(unittest.TestCase):
    def lines(self, end=4.0):
        runs = [support.synthetic_run(scheme, 2, end) for scheme in ("mpm_mixed", "mpm_gp")]
        status, text, error = support.call(table.main, *runs)
        self.assertEqual((status, error), (0, ""))
        cells = [re.split(r" {2,}", line.strip()) for line in text.splitlines()]
        return {row[0]: row[1:] for row in cells if len(row) == 3}

    def test_numbers_of_both_runs_stand_side_by_side(self):
        rows = self.lines()
        self.assertEqual(rows["front at the end [m]"], ["13.20", "13.20"])
        self.assertEqual(rows["crest at the end [m]"], ["-", "4.10"])
        self.assertEqual(rows["softened volume at 2.5 s [%]"], ["12.5", "12.5"])
        self.assertEqual(rows["points whose eps_eq_p ever fell"], ["812", "0"])
        self.assertEqual(rows["million point-steps per second"], ["8.40", "8.40"])

    def test_only_mixed_regains_strength(self):
        mixed, gp = self.lines()["of A-J, regained S_u"]
        self.assertIn("C", mixed.split())
        self.assertEqual(gp, "none")

    def test_softening_time_is_the_first_row_beyond_six_percent(self):
        run = terp.open(support.synthetic_run("mpm_gp", 2))
        rows, time = run.history_of("E"), table.softening_time(run, "E")
        self.assertTrue((rows["eps_eq_p"][rows["time"] < time] <= 0.06).all())
        self.assertGreater(rows["eps_eq_p"][rows["time"] == time], 0.06)

    def test_a_point_that_never_softens_gets_a_dash(self):
        self.assertEqual(self.lines(1.0)["J: eps_eq_p > 0.06 from [s]"], ["-", "-"])

    def test_a_missing_run_ends_with_status_2(self):
        status, _, error = support.call(table.main, "no/such", "nor/this")
        self.assertEqual((status, error), (2, "error: there is no run folder no/such\n"))


if __name__ == "__main__":
    unittest.main()
