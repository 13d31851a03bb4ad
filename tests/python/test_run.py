"""A run folder read back: terp.open."""

import pathlib
import tempfile
import unittest

import support
import synthetic

import h5py
import numpy as np
import terp


class RunFolder(unittest.TestCase):
    def setUp(self):
        self.run_ = terp.open(support.synthetic_run("mpm_gp", 2))

    def test_times_are_those_of_the_frames(self):
        np.testing.assert_array_equal(self.run_.times, synthetic.TIMES)

    def test_a_field_belongs_to_its_own_frame(self):
        start = synthetic.lattice(0.1)
        for k in (0, 3, len(synthetic.TIMES) - 1):
            total, plastic = synthetic.strains(start, synthetic.TIMES[k], "mpm_gp", 2)
            np.testing.assert_array_equal(self.run_.field("eps_deviatoric", k), total)
            np.testing.assert_array_equal(self.run_.frame(k)["eps_eq_p"], plastic)

    def test_places_are_two_columns_and_move(self):
        start = synthetic.lattice(0.1)
        np.testing.assert_allclose(self.run_.field("x", 0), start, atol=1e-12)
        np.testing.assert_array_equal(self.run_.frame(-1).x, synthetic.places(start, 4.0, 2))

    def test_a_frame_reads_a_field_once(self):
        frame = self.run_.frame(2)
        self.assertIs(frame["su"], frame["su"])
        self.assertEqual(frame.time, 1.0)

    def test_at_gives_the_nearest_frame(self):
        self.assertEqual([self.run_.at(t) for t in (-1.0, 0.74, 0.76, 2.5, 99.0)], [0, 1, 2, 5, 8])

    def test_nearest_point_breaks_ties_to_lower_x_then_lower_y(self):
        places = self.run_.field("x", 0)
        np.testing.assert_allclose(places[self.run_.nearest_point(7.62, 0.07)], (7.65, 0.05))
        np.testing.assert_allclose(places[self.run_.nearest_point(1.0, 1.0)], (0.95, 0.95))

    def test_data_offsets_of_a_field_are_honoured(self):
        with tempfile.TemporaryDirectory() as folder:
            with h5py.File(pathlib.Path(folder) / "results.vtkhdf", "w") as file:
                file["VTKHDF/Points"] = np.arange(18.0).reshape(6, 3)
                file["VTKHDF/NumberOfPoints"] = [2, 4]
                file["VTKHDF/Steps/Values"] = [0.0, 1.0]
                file["VTKHDF/Steps/PointOffsets"] = [0, 2]
                file["VTKHDF/PointData/material"] = [7, 8, 5, 6, 7, 8, 9]
                file["VTKHDF/Steps/PointDataOffsets/material"] = [0, 3]
            run = terp.open(folder)
            self.assertEqual(run.field("material", 1).tolist(), [6, 7, 8, 9])
            self.assertEqual(run.field("x", 1)[0].tolist(), [6.0, 7.0])

    def test_history_is_a_structured_array(self):
        rows = self.run_.history_of("B")
        self.assertEqual(rows.dtype.names[:4], ("time", "point", "id", "x"))
        self.assertTrue(np.all(np.diff(rows["time"]) > 0))
        self.assertEqual(rows["su"][0], 8000.0)
        self.assertEqual(self.run_.history_points, list("ABCDEFGHIJ"))

    def test_ledger_keeps_what_is_not_a_number(self):
        self.assertTrue(np.isnan(self.run_.ledger["crest_x"]).all())
        self.assertEqual(self.run_.ledger["step"].dtype, np.int64)

    def test_summary_and_case_are_dictionaries(self):
        self.assertEqual(self.run_.summary["scheme"], "mpm_gp")
        self.assertEqual(self.run_.case["material"]["clay"]["su_residual"], 2000.0)

    def test_units_are_si(self):
        self.assertEqual((self.run_.unit("su"), self.run_.unit("eps_eq_p"), terp.UNITS["time"]), ("Pa", "-", "s"))


class MissingThings(unittest.TestCase):
    def message(self, action):
        with self.assertRaises(terp.RunError) as caught:
            action()
        return str(caught.exception)

    def test_a_missing_folder_is_named(self):
        self.assertEqual(self.message(lambda: terp.open("no/such")), "there is no run folder no/such")

    def test_a_missing_file_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            run = terp.open(folder)
            for name, action in (("summary.json", lambda: run.summary), ("history.csv", lambda: run.history),
                                 ("results.vtkhdf", lambda: run.times)):
                self.assertEqual(self.message(action), f"{folder} has no {name}; has the run been solved to its end?")

    def test_damaged_files_are_named(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("summary.json", "results.vtkhdf"):
                (pathlib.Path(folder) / name).write_text("not this")
            (pathlib.Path(folder) / "history.csv").write_text("time,point\n0.0,A\n0.0\n")
            run = terp.open(folder)
            self.assertIn("summary.json cannot be read", self.message(lambda: run.summary))
            self.assertIn("results.vtkhdf cannot be read as VTKHDF", self.message(lambda: run.times))
            self.assertIn("history.csv cannot be read", self.message(lambda: run.history))
            with h5py.File(pathlib.Path(folder) / "results.vtkhdf", "w") as file:
                file.create_group("VTKHDF")
            self.assertIn("results.vtkhdf lacks a part of the format", self.message(lambda: run.times))

    def test_an_unknown_field_gets_the_closest_name(self):
        run = terp.open(support.synthetic_run())
        self.assertIn("no field `eps_eqp`. Did you mean `eps_eq_p`?", self.message(lambda: run.field("eps_eqp", 0)))
        self.assertIn("no point `Z`", self.message(lambda: run.history_of("Z")))

    def test_a_frame_beyond_the_end_is_an_index_error(self):
        with self.assertRaisesRegex(IndexError, "has 9 frames; there is no frame 9"):
            terp.open(support.synthetic_run()).frame(9)


if __name__ == "__main__":
    unittest.main()
