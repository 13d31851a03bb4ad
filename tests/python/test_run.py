"""A run folder read back: terp.open."""

import importlib.util
import pathlib
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

import support
import synthetic

import h5py
import numpy as np
import terp


class Convergence(unittest.TestCase):
    def test_is_the_dictionary_of_its_file_or_says_what_is_missing(self):
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(terp.RunError, "give the folder that `terp converge` wrote"):
                terp.convergence(folder)
            path = pathlib.Path(folder) / "convergence.json"
            path.write_text('{"sequences": [{"name": "as given", "answer": "depends", "quantities": []}]}',
                            encoding="utf-8")
            self.assertEqual(terp.convergence(folder)["sequences"][0]["name"], "as given")
            path.write_text("{", encoding="utf-8")
            with self.assertRaisesRegex(terp.RunError, "cannot be read"):
                terp.convergence(folder)


class Depends(unittest.TestCase):
    def test_is_the_dictionary_of_its_file(self):
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(terp.RunError, "depends.json is not there"):
                terp.depends(folder)
            (pathlib.Path(folder) / "depends.json").write_text('{"turns_on": ["k0"]}', encoding="utf-8")
            self.assertEqual(terp.depends(folder)["turns_on"], ["k0"])


class RunFolder(unittest.TestCase):
    def setUp(self):
        self.run_ = terp.open(support.synthetic_run("mpm_gp", 2))

    def test_times_are_those_of_the_frames(self):
        np.testing.assert_array_equal(self.run_.times, synthetic.TIMES)

    def test_a_field_belongs_to_its_own_frame(self):
        start = synthetic.lattice(0.1)
        for k in (0, 3, len(synthetic.TIMES) - 1):
            total, plastic = synthetic.strains(start, synthetic.TIMES[k], "mpm_gp", 2)
            np.testing.assert_array_equal(self.run_.field("eps_deviatoric", k), total.astype("f4"))
            np.testing.assert_array_equal(self.run_.frame(k)["eps_eq_p"], plastic.astype("f4"))
            self.assertEqual(self.run_.field("eps_deviatoric", k).dtype, np.float64)

    def test_places_are_two_columns_and_move(self):
        start = synthetic.lattice(0.1)
        np.testing.assert_allclose(self.run_.field("position", 0), start, atol=1e-12)
        np.testing.assert_array_equal(self.run_.frame(-1).x, synthetic.places(start, 4.0, 2))

    def test_a_frame_reads_a_field_once(self):
        frame = self.run_.frame(2)
        self.assertIs(frame["su"], frame["su"])
        self.assertEqual(frame.time, 1.0)

    def test_at_gives_the_nearest_frame(self):
        self.assertEqual([self.run_.at(t) for t in (-1.0, 0.74, 0.76, 2.5, 99.0)], [0, 1, 2, 5, 8])

    def test_nearest_breaks_ties_to_lower_x_then_lower_y(self):
        places = self.run_.field("position", 0)
        np.testing.assert_allclose(places[self.run_.nearest(7.62, 0.07)], (7.65, 0.05))
        np.testing.assert_allclose(places[self.run_.nearest(1.0, 1.0)], (0.95, 0.95))

    def test_nearest_looks_at_the_places_of_its_time(self):
        row = self.run_.nearest(7.65, 0.05)
        x, y = synthetic.places(synthetic.lattice(0.1), 4.0, 2)[row]
        self.assertGreater(x, 9.0)
        self.assertEqual(self.run_.nearest(x, y, 4.0), row)
        self.assertNotEqual(self.run_.nearest(x, y, 0.0), row)

    def test_nearest_looks_at_soil_alone(self):
        row = self.run_.nearest(7.65, 0.05)
        with support.without_soil([row]) as run:
            self.assertEqual(len(run.frame(0).x), len(self.run_.frame(0).x))
            self.assertNotEqual(run.nearest(7.65, 0.05), row)
        with support.without_soil(slice(None)) as run, self.assertRaisesRegex(terp.RunError, "no soil at t = 0 s"):
            run.nearest(7.65, 0.05)

    def test_material_cell_or_volume_says_where_there_is_soil(self):
        self.assertTrue(self.run_.frame(0).soil.all(), "these frames have none of them")
        for sign, gone in (("material", -1.0), ("volume", 0.0)):
            with support.without_soil([3, 5], sign, gone) as run:
                np.testing.assert_array_equal(np.flatnonzero(~run.frame(-1).soil), [3, 5])

    def test_a_series_is_one_row_of_all_frames(self):
        row = 700
        for name in ("su", "stress", "position"):
            series = self.run_.series(name, row)
            np.testing.assert_array_equal(series, [frame[name][row] for frame in self.run_])
            self.assertEqual(len(series), len(self.run_))

    def test_a_row_or_time_that_is_none_is_refused(self):
        for row in (-1, len(self.run_.field("position", 0))):
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
        for name, words in (("stress", "ask for one of them: stress.xx, stress.yy"), ("stress.xz",
                                                                                      "has no component `xz`"),
                            ("sress.xx", "Did you mean `stress`?"), ("su.xx", "has no component `xx`")):
            with self.assertRaisesRegex(terp.RunError, words):
                frame.scalar(name)

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

    def test_the_verdict_on_the_water_is_that_of_the_summary(self):
        self.assertIsNone(self.run_.flood)
        summary = {"flood": {"verdict": "damaged", "freeboard": 0.4}}
        run = terp.open(self.run_.folder)
        run.__dict__["summary"] = summary
        self.assertEqual(run.flood["verdict"], "damaged")

    def test_the_case_text_is_that_of_case_toml(self):
        self.assertEqual(self.run_.case_text, synthetic.case_text("mpm_gp", 2))
        self.assertTrue(self.run_.finished)

    def test_units_of_fields_are_those_of_the_file_and_columns_have_theirs(self):
        self.assertEqual(self.run_.units, {"position": "m", **synthetic.UNITS})
        names = ("su", "stress.xy", "eps_eq_p", "time", "kinetic", "front_x")
        self.assertEqual([self.run_.unit(name) for name in names], ["Pa", "Pa", "-", "s", "J per m", "m"])
        self.assertEqual(self.run_.components["stress"], ("xx", "yy", "zz", "xy"))
        with self.assertRaisesRegex(terp.RunError, "no field or column `pressur`. Did you mean `pressure`"):
            self.run_.unit("pressur")

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
        with unittest.mock.patch.dict("sys.modules", pandas=None), self.assertRaisesRegex(terp.RunError,
                                                                                          "install python3-pandas"):
            terp.to_pandas(self.run_.ledger)


class RunThatIsGoing(unittest.TestCase):
    """A run folder as it looks between and during writes."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name) / "run"
        synthetic.write_run(self.folder, times=synthetic.TIMES[:3], spacing=0.5)
        self.run_ = terp.open(self.folder)

    def test_a_frame_that_is_being_written_is_not_seen(self):
        synthetic.frame_file(self.folder, 2).rename(self.folder / "frames" / "points_00002.vtkhdf.tmp")
        self.assertEqual(self.run_.times.tolist(), [0.0, 0.5])
        self.assertEqual(self.run_.frame(-1).time, 0.5)
        self.assertEqual(len(self.run_.series("su", 0)), 2)
        self.assertFalse(self.run_.finished)

    def test_frames_that_are_missing_or_damaged_are_named_and_left_out(self):
        first, second = (synthetic.frame_file(self.folder, k) for k in (0, 1))
        first.unlink()
        second.write_bytes(second.read_bytes()[:500])
        with self.assertWarns(UserWarning) as caught:
            self.assertEqual(self.run_.times.tolist(), [1.0])
        texts = [str(warning.message) for warning in caught.warnings]
        self.assertIn("lacks frame 0 of the points", texts[0])
        self.assertIn(f"left out: {second} cannot be read as VTKHDF", texts[1])

    def test_a_flipped_bit_in_a_field_is_an_error_that_names_the_frame(self):
        path = synthetic.frame_file(self.folder, 1)
        with h5py.File(path) as file:
            at = file["VTKHDF/PointData/su"].id.get_chunk_info(0).byte_offset
        content = bytearray(path.read_bytes())
        content[at + 5] ^= 4
        path.write_bytes(content)
        self.assertEqual(len(self.run_.field("su", 0)), 64)
        with self.assertRaisesRegex(terp.RunError, "points_00001.vtkhdf cannot be read as VTKHDF"):
            self.run_.field("su", 1)

    def test_a_frame_of_another_run_is_refused(self):
        x = synthetic.lattice(0.5)
        synthetic.write_frame(synthetic.frame_file(self.folder, 3), 3, 1.5, x, {}, case="fedcba9876543210")
        with self.assertRaisesRegex(terp.RunError, "points_00003.vtkhdf is of a run of another case"):
            self.run_.times

    def test_refresh_sees_what_was_added(self):
        before = self.run_.times, len(self.run_.ledger)
        start = synthetic.lattice(0.5)
        synthetic.write_frames(self.folder, start, "mpm_gp", 2, synthetic.TIMES[:5])
        synthetic.write_ledger(self.folder / "ledger.csv", 2.0)
        self.assertEqual((len(self.run_.times), len(self.run_.ledger)), (len(before[0]), before[1]))
        self.assertEqual(len(self.run_.refresh().times), 5)
        self.assertEqual(self.run_.ledger["time"][-1], 2.0)

    def test_a_row_that_is_being_written_is_left_out(self):
        n = len(self.run_.ledger)
        with (self.folder / "ledger.csv").open("a") as file:
            file.write("1.1,1815,1,2,3")
        self.assertEqual(len(self.run_.refresh().ledger), n)


class MissingThings(unittest.TestCase):
    def test_a_python_without_numpy_is_named(self):
        words = "import sys; sys.modules['numpy'] = None; import terp"
        done = subprocess.run([sys.executable, "-c", words], capture_output=True, text=True, check=False)
        self.assertIn(f"numpy is missing in {sys.executable}; Debian's package python3-numpy is for /usr/bin/python3",
                      done.stderr)

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
                                 ("frames", lambda: run.times)):
                self.assertEqual(self.message(action),
                                 f"{folder} has no {name}; is it the folder of a run, and has that run begun?")

    def test_a_run_of_an_earlier_terp_is_refused_with_the_version(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "results.vtkhdf").touch()
            self.assertRegex(self.message(lambda: terp.open(folder).times),
                             r"an earlier terp \(VTKHDF 2.0\); this one reads one file per frame")

    def test_damaged_files_are_named(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("summary.json", "mesh.vtkhdf"):
                (pathlib.Path(folder) / name).write_text("not this")
            (pathlib.Path(folder) / "history.csv").write_text("time,point\n0.0,A\n0.0\n")
            run = terp.open(folder)
            self.assertIn("summary.json cannot be read", self.message(lambda: run.summary))
            self.assertIn("mesh.vtkhdf cannot be read as VTKHDF", self.message(lambda: run.mesh))
            self.assertIn("history.csv cannot be read", self.message(lambda: run.history))
            with h5py.File(pathlib.Path(folder) / "mesh.vtkhdf", "w") as file:
                file.create_group("VTKHDF").attrs["Version"] = (3, 1)
            self.assertIn("mesh.vtkhdf is of VTKHDF version 3.1; this terp reads version 1",
                          self.message(lambda: run.mesh))
            with h5py.File(pathlib.Path(folder) / "mesh.vtkhdf", "w") as file:
                file.create_group("VTKHDF")
            self.assertIn("mesh.vtkhdf lacks a part of the format", self.message(lambda: run.mesh))

    def test_a_history_that_was_cut_is_refused(self):
        with tempfile.TemporaryDirectory() as scratch:
            folder = synthetic.write_run(pathlib.Path(scratch) / "run", times=np.array([0.0, 4.0]))
            self.assertEqual(terp.open(folder).history_of("B")["time"][-1], 4.0)
            path = folder / "history.csv"
            lines = path.read_text().splitlines(keepends=True)
            path.write_text("".join(lines[:-30]))
            self.assertRegex(self.message(lambda: terp.open(folder).history),
                             r"history.csv was cut: the rows of point A end at t = 3.94 s, the run at 4 s; copy the")

    def test_tables_that_were_altered_are_refused(self):
        with tempfile.TemporaryDirectory() as scratch:
            folder = synthetic.write_run(pathlib.Path(scratch) / "run", times=np.array([0.0, 4.0]))
            text = (folder / "history.csv").read_bytes()
            with h5py.File(folder / "checkpoint_000006600.h5", "w") as file:
                file.attrs["time"] = 4.0
                # FNV-1a of these bytes, one after the other
                value = 0xCBF29CE484222325
                for byte in text:
                    value = ((value ^ byte) * 0x100000001B3) % 2**64
                file["tables"] = np.frombuffer(f"history.csv = {value:016x}\n".encode(), np.uint8)
            self.assertEqual(len(terp.open(folder).history_points), 10)
            (folder / "history.csv").write_bytes(text.replace(b"-20000", b"-20001", 1))
            self.assertIn("history.csv is not what the run wrote: rows up to t = 4 s were altered",
                          self.message(lambda: terp.open(folder).history))

    def test_frames_that_may_not_be_read_are_named(self):
        run = terp.open(support.synthetic_run())
        with unittest.mock.patch("os.listdir", side_effect=PermissionError(13, "Permission denied")):
            self.assertRegex(self.message(lambda: len(run)), r"frames cannot be read: Permission denied$")

    def test_an_unknown_field_gets_the_closest_name(self):
        run = terp.open(support.synthetic_run())
        self.assertIn("no field `eps_eqp`. Did you mean `eps_eq_p`?", self.message(lambda: run.field("eps_eqp", 0)))
        self.assertIn("no point `Z`", self.message(lambda: run.history_of("Z")))

    def test_a_frame_beyond_the_end_is_an_index_error(self):
        with self.assertRaisesRegex(IndexError, "has 9 frames; there is no frame 9"):
            terp.open(support.synthetic_run()).frame(9)


if __name__ == "__main__":
    unittest.main()
