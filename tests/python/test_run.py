"""A run folder read back: terp.open."""

import importlib.util
import pathlib
import tempfile
import threading
import time
import unittest
import unittest.mock

import support
import synthetic

import h5py
import numpy as np
import terp
from terp.vtkhdf import VtkhdfFile


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

    def test_nearest_breaks_ties_to_lower_x_then_lower_y(self):
        places = self.run_.field("x", 0)
        np.testing.assert_allclose(places[self.run_.nearest(7.62, 0.07)], (7.65, 0.05))
        np.testing.assert_allclose(places[self.run_.nearest(1.0, 1.0)], (0.95, 0.95))

    def test_nearest_looks_at_the_places_of_its_time(self):
        row = self.run_.nearest(7.65, 0.05)
        x, y = synthetic.places(synthetic.lattice(0.1), 4.0, 2)[row]
        self.assertGreater(x, 9.0)
        self.assertEqual(self.run_.nearest(x, y, 4.0), row)
        self.assertNotEqual(self.run_.nearest(x, y, 0.0), row)

    def test_a_series_is_one_row_of_all_frames(self):
        row = 700
        for name in ("su", "stress", "id", "x"):
            series = self.run_.series(name, row)
            np.testing.assert_array_equal(series, [frame[name][row] for frame in self.run_])
            self.assertEqual(len(series), len(self.run_))

    def test_a_row_or_time_that_is_none_is_refused(self):
        for row in (-1, len(self.run_.field("x", 0))):
            with self.assertRaisesRegex(IndexError, "there is no row"):
                self.run_.series("su", row)
        with self.assertRaises(ValueError):
            self.run_.at(float("nan"))
        with self.assertRaises(ValueError):
            self.run_.nearest(float("nan"), 0.0)

    def test_a_scalar_is_a_field_a_component_or_the_size_of_a_vector(self):
        frame = self.run_.frame(4)
        np.testing.assert_array_equal(frame.scalar("su"), frame["su"])
        np.testing.assert_array_equal(frame.scalar("stress.yy"), frame["stress"][:, 1])
        np.testing.assert_allclose(frame.scalar("displacement"), np.hypot(*frame["displacement"].T[:2]))
        for name, words in (("stress", "ask for one of them: stress.xx, stress.yy"),
                            ("stress.xz", "has no component `xz`"),
                            ("sress.xx", "Did you mean `stress`?"), ("su.xx", "has no component `xx`")):
            with self.assertRaisesRegex(terp.RunError, words):
                frame.scalar(name)

    def test_data_offsets_of_a_field_are_honoured(self):
        with tempfile.TemporaryDirectory() as folder:
            with h5py.File(pathlib.Path(folder) / "results.vtkhdf", "w") as file:
                file["VTKHDF/Points"] = np.arange(18.0).reshape(6, 3)
                file["VTKHDF/NumberOfPoints"] = [2, 4]
                file["VTKHDF/Steps/Values"] = [0.0, 1.0]
                file["VTKHDF/Steps/PointOffsets"] = [0, 2]
                file["VTKHDF/Steps/PartOffsets"] = [0, 1]
                file["VTKHDF/Steps"].attrs["NSteps"] = 2
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

    def test_the_case_text_is_that_of_case_toml(self):
        self.assertEqual(self.run_.case_text, synthetic.case_text("mpm_gp", 2))
        self.assertTrue(self.run_.finished)

    def test_units_of_fields_are_those_of_the_file_and_columns_have_theirs(self):
        self.assertEqual(self.run_.units, {"x": "m", **synthetic.UNITS})
        names = ("su", "stress.xy", "eps_eq_p", "time", "kinetic", "front_x")
        self.assertEqual([self.run_.unit(name) for name in names], ["Pa", "Pa", "-", "s", "J per m", "m"])
        self.assertEqual(self.run_.components["stress"], ("xx", "yy", "zz", "xy"))
        with self.assertRaisesRegex(terp.RunError, "no field or column `pressur`. Did you mean `pressure`"):
            self.run_.unit("pressur")

    def test_every_column_of_the_tables_has_a_unit(self):
        for table in (self.run_.history, self.run_.ledger):
            for column in table.dtype.names:
                self.run_.unit(column)

    def test_the_mesh_is_nodes_and_cells(self):
        mesh = self.run_.mesh
        self.assertEqual((mesh.nodes.shape, mesh.cells.shape), ((17 * 4, 2), (48, 4)))
        np.testing.assert_array_equal(mesh.nodes[mesh.cells[0]], [(0, 0), (1, 0), (1, 1), (0, 1)])
        self.assertEqual(len(mesh.times), 0)
        with self.assertRaisesRegex(terp.RunError, "mesh.vtkhdf has no field `pressure`. It has: none"):
            mesh.field("pressure", 0)

    def test_a_table_becomes_a_data_frame_where_pandas_is(self):
        if importlib.util.find_spec("pandas"):
            frame = terp.to_pandas(self.run_.ledger)
            self.assertEqual(list(frame.columns), list(self.run_.ledger.dtype.names))
            np.testing.assert_array_equal(frame["time"].to_numpy(), self.run_.ledger["time"])
        without_pandas = unittest.mock.patch.dict("sys.modules", pandas=None)
        with without_pandas, self.assertRaisesRegex(terp.RunError, "install python3-pandas"):
            terp.to_pandas(self.run_.ledger)


class RunThatIsGoing(unittest.TestCase):
    """A run folder as it looks between and during writes."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name) / "run"
        synthetic.write_run(self.folder, times=synthetic.TIMES[:3], spacing=0.5)
        self.run_ = terp.open(self.folder)

    def test_a_frame_counts_when_it_is_whole(self):
        with h5py.File(self.folder / "results.vtkhdf", "r+") as file:
            file["VTKHDF/Steps"].attrs["NSteps"] = 2  # the third is being written
        self.assertEqual(self.run_.times.tolist(), [0.0, 0.5])
        self.assertEqual(self.run_.frame(-1).time, 0.5)
        self.assertEqual(len(self.run_.series("su", 0)), 2)
        self.assertFalse(self.run_.finished)

    def test_refresh_sees_what_was_added(self):
        before = self.run_.times, len(self.run_.ledger)
        start = synthetic.lattice(0.5)
        synthetic.write_results(self.folder / "results.vtkhdf", start, "mpm_gp", 2, synthetic.TIMES[:5])
        synthetic.write_ledger(self.folder / "ledger.csv", 2.0)
        self.assertEqual((len(self.run_.times), len(self.run_.ledger)), (len(before[0]), before[1]))
        self.assertEqual(len(self.run_.refresh().times), 5)
        self.assertEqual(self.run_.ledger["time"][-1], 2.0)

    def test_a_row_that_is_being_written_is_left_out(self):
        n = len(self.run_.ledger)
        with (self.folder / "ledger.csv").open("a") as file:
            file.write("1.1,1815,1,2,3")
        self.assertEqual(len(self.run_.refresh().ledger), n)

    def test_a_reading_into_which_a_frame_came_is_repeated(self):
        results, longer = self.folder / "results.vtkhdf", self.folder / "longer.vtkhdf"
        for first_time in (lambda root: root["Steps"].attrs["NSteps"], lambda root: root["nothing"],
                           lambda root: root["Points"][:].reshape(2, 2)):
            synthetic.write_results(results, synthetic.lattice(0.5), "mpm_gp", 2, synthetic.TIMES[:3])
            synthetic.write_results(longer, synthetic.lattice(0.5), "mpm_gp", 2, synthetic.TIMES[:4])

            def n_steps(root):
                if not longer.exists():
                    return root["Steps"].attrs["NSteps"]
                longer.replace(results)
                return first_time(root)
            self.assertEqual(VtkhdfFile(results).read(n_steps), 4)

    def write_journal(self, head_before, changed=b""):
        """The journal of a frame that is added: the first page, the last bytes of it changed."""
        page = (self.folder / "results.vtkhdf").read_bytes()[:4096]
        page = page[:len(page) - len(changed)] + changed
        (self.folder / "results.vtkhdf.journal").write_bytes(b"terpjnl2" + bytes(8) + head_before + bytes(8) + page
                                                             + bytes(8))

    def test_a_reading_waits_while_a_frame_is_added(self):
        self.write_journal(bytes(64), b"new")
        journal = self.folder / "results.vtkhdf.journal"
        threading.Timer(0.1, journal.unlink).start()
        self.assertEqual(len(self.run_.times), 3)
        self.assertFalse(journal.exists())

    def test_a_reading_waits_however_long_it_has_read_before(self):
        results, longer, journal = (self.folder / name
                                    for name in ("results.vtkhdf", "longer.vtkhdf", "results.vtkhdf.journal"))
        synthetic.write_results(longer, synthetic.lattice(0.5), "mpm_gp", 2, synthetic.TIMES[:4])
        readings = []

        def read(_):
            readings.append(journal.exists())
            if len(readings) == 1:
                time.sleep(1.1)
                longer.replace(results)
                self.write_journal(bytes(64), b"new")
                threading.Timer(0.1, journal.unlink).start()
        VtkhdfFile(results).read(read)
        self.assertEqual(readings, [False, False])

    def test_a_run_that_was_killed_while_it_added_a_frame_is_told(self):
        self.write_journal(bytes(64), b"new")
        with self.assertRaisesRegex(terp.RunError, "was killed while it added a frame; `terp resume` ends that"):
            self.run_.times

    def test_a_journal_that_changes_nothing_is_passed_over(self):
        head = (self.folder / "results.vtkhdf").read_bytes()[:64]
        # each: everything is written, or nothing yet
        for write in (lambda: self.write_journal(bytes(64)), lambda: self.write_journal(head, b"new"),
                      lambda: (self.folder / "results.vtkhdf.journal").write_bytes(b"terpjnl2 and no more")):
            write()
            self.assertEqual(len(terp.open(self.folder).times), 3)


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
                                 ("case.toml", lambda: run.case), ("mesh.vtkhdf", lambda: run.mesh),
                                 ("results.vtkhdf", lambda: run.times)):
                self.assertEqual(self.message(action),
                                 f"{folder} has no {name}; is it the folder of a run, and has that run begun?")

    def test_a_newer_format_is_refused_with_its_version(self):
        with tempfile.TemporaryDirectory() as folder:
            with h5py.File(pathlib.Path(folder) / "results.vtkhdf", "w") as file:
                file.create_group("VTKHDF").attrs["Version"] = (3, 1)
            self.assertIn("results.vtkhdf is of VTKHDF version 3.1; this terp reads version 2",
                          self.message(lambda: terp.open(folder).times))

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
