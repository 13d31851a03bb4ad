"""A run of the program itself, read while it is going and after: what Terp writes is what this package reads."""

import base64
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
from xml.etree import ElementTree

import support

import h5py
import numpy as np
import samples
import terp
from terp import plot

ROOT = support.HERE.parents[1]
PROGRAM = os.environ.get("TERP")
CASE = ROOT / "cases" / "column_collapse" / "model_2.toml"
SETTINGS = ("mesh.cell=0.25", "time.end=0.6", "output.fields.every=0.05", "output.mesh=true")


@unittest.skipUnless(PROGRAM, "TERP names no program")
class RunOfTheProgram(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name) / "run"
        command = [PROGRAM, "run", str(CASE), "-o", str(cls.folder), "-q", "-j", "1"]
        process = subprocess.Popen(command + [word for setting in SETTINGS for word in ("--set", setting)])
        try:
            cls.seen = cls.watch(process)
        finally:
            process.kill()  # if watching failed
            process.wait()
        if process.returncode != 0:
            raise AssertionError(f"terp ended with status {process.returncode}")
        cls.run_ = terp.open(cls.folder)

    @classmethod
    def watch(cls, process):
        """[(frames, ledger rows)] as they were seen while the program ran; every field of the last frame is read."""
        seen = []
        while process.poll() is None:
            if not all((cls.folder / name).exists() for name in ("frames/points_00000.vtkhdf", "ledger.csv",
                                                                 "summary.json")):
                continue
            run = terp.open(cls.folder)
            for name in run.fields if len(run) else ():
                run.field(name, -1)
            seen.append((len(run), len(run.ledger)))
        return seen

    def test_frames_only_grow_while_the_run_is_going(self):
        self.assertEqual(self.seen, sorted(self.seen))
        self.assertGreater(len(self.seen), 0)

    def test_it_ends_with_all_frames(self):
        self.assertTrue(self.run_.finished)
        np.testing.assert_allclose(self.run_.times, np.arange(0.0, 0.601, 0.05), atol=self.run_.summary["dt"])
        self.assertEqual(self.run_.case_text, self.run_.summary["case"])

    def test_a_vtu_file_has_the_soil_with_names_of_components(self):
        frame = self.run_.frame(5)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "frame.vtu"
            frame.write_vtu(path)
            root = ElementTree.parse(path).getroot()
        arrays = {array.get("Name"): array for array in root.iter("DataArray")}

        def values(name, kind):
            data = base64.b64decode(arrays[name].text)
            self.assertEqual(int.from_bytes(data[:8], "little"), len(data) - 8)
            return np.frombuffer(data[8:], kind)
        stress = arrays["stress"]
        self.assertEqual([stress.get(f"ComponentName{k}") for k in range(4)], ["xx", "yy", "zz", "xy"])
        np.testing.assert_array_equal(values("stress", "<f4").reshape(-1, 4), frame["stress"][frame.soil])
        places = values("Points", "<f8").reshape(-1, 3)
        np.testing.assert_array_equal(places[:, :2], frame.x[frame.soil])
        self.assertEqual(root.find(".//Piece").get("NumberOfCells"), str(len(places)))
        np.testing.assert_array_equal(values("offsets", "<i8"), np.arange(1, len(places) + 1))
        self.assertEqual(set(values("types", "<u1")), {1})
        self.assertEqual(float(arrays["TimeValue"].text), frame.time)
        self.assertEqual(set(self.run_.fields) - set(arrays), {"position"})

    def test_a_field_is_that_of_the_file(self):
        k = 7
        with h5py.File(self.folder / "frames" / f"points_{k:05}.vtkhdf") as file:
            root = file["VTKHDF"]
            for name in root["PointData"]:
                np.testing.assert_array_equal(self.run_.field(name, k), root["PointData"][name][:])
            np.testing.assert_array_equal(self.run_.field("position", k), root["Points"][:, :2])

    def test_places_are_the_start_plus_the_displacement(self):
        first, last = self.run_.frame(0), self.run_.frame(-1)
        np.testing.assert_allclose(first.x + last["displacement"][:, :2], last.x, atol=1e-6)  # of single precision

    def test_every_field_and_column_has_a_unit(self):
        self.assertEqual(self.run_.unit("stress"), "Pa")
        self.assertEqual(self.run_.unit("velocity"), "m/s")
        self.assertEqual(self.run_.components["stress"], ("xx", "yy", "zz", "xy"))
        for table in (self.run_.history, self.run_.ledger):
            for column in table.dtype.names:
                self.assertTrue(self.run_.unit(column), column)

    def test_the_nearest_point_is_the_one_that_the_history_follows(self):
        for name, (x, y) in self.run_.case["output"]["history"]["points"].items():
            rows = self.run_.history_of(name)
            self.assertEqual(self.run_.nearest(x, y), rows["id"][0])
            np.testing.assert_allclose(self.run_.series("eps_eq_p", self.run_.nearest(x, y))[-1], rows["eps_eq_p"][-1])

    def test_the_mesh_is_the_one_whose_cells_the_points_name(self):
        mesh, frame = self.run_.mesh, self.run_.frame(-1)
        corners = mesh.nodes[mesh.cells[frame["cell"].astype(int)]]  # [n_points, 4, 2]
        self.assertEqual(len(mesh.cells), self.run_.summary["cells"])
        self.assertTrue(np.all(corners.min(axis=1) <= frame.x) and np.all(frame.x <= corners.max(axis=1)))

    def test_the_mesh_carries_the_mass_and_momentum_of_the_ledger(self):
        mesh, ledger = self.run_.mesh, self.run_.ledger
        np.testing.assert_array_equal(mesh.times, self.run_.times)
        self.assertEqual(mesh.units, {"mass": "kg per m", "velocity": "m/s", "pressure": "Pa"})
        for k, time in enumerate(mesh.times):
            row = ledger[np.argmin(np.abs(ledger["time"] - time))]
            mass, velocity = mesh.field("mass", k), mesh.field("velocity", k)
            np.testing.assert_allclose(mass.sum(), row["mass"], rtol=1e-12)
            np.testing.assert_allclose(mass @ velocity[:, :2], (row["momentum_x"], row["momentum_y"]), rtol=1e-9,
                                       atol=1e-9)

    def test_the_pressure_of_a_cell_is_that_of_its_points(self):
        frame, pressure = self.run_.frame(-1), self.run_.mesh.field("pressure", -1)
        cell, volume = frame["cell"].astype(int), frame["volume"]
        of_points = frame["stress"][:, :3].mean(axis=1)
        filled = np.bincount(cell, volume, len(pressure))
        np.testing.assert_array_equal(np.isnan(pressure), filled == 0)
        mean = np.bincount(cell, volume * of_points, len(pressure))[filled > 0] / filled[filled > 0]
        np.testing.assert_allclose(pressure[filled > 0], mean, rtol=1e-6)  # fields of points: single precision

    def test_the_example_runs(self):
        pictures = self.folder / "pictures"
        script = ROOT / "python" / "examples" / "first_look.py"
        done = subprocess.run([sys.executable, script, self.folder, pictures], capture_output=True, text=True,
                              env={**os.environ, "PYTHONPATH": str(ROOT / "python")})
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("13 frames to t = 0.6", done.stdout)
        self.assertEqual(sorted(path.name for path in pictures.iterdir()), ["energies.png", "field.png", "points.png"])


if __name__ == "__main__":
    unittest.main()


@unittest.skipUnless(PROGRAM, "TERP names no program")
class RunWithBodiesThatComeAndGo(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name) / "run"
        case = cls.folder.with_suffix(".toml")
        case.write_text(samples.DUG)
        cls.program("run", case, "-o", cls.folder, "-j", "1", "-q")
        cls.run_ = terp.open(cls.folder)

    @staticmethod
    def program(*arguments):
        subprocess.run([PROGRAM, *map(str, arguments)], check=True, capture_output=True)

    def test_a_frame_says_which_of_its_points_are_soil(self):
        first, last = self.run_.frame(0), self.run_.frame(-1)
        for rows, at_first, at_last in ((samples.GROUND, True, True), (samples.FILL, True, False),
                                        (samples.BERM, False, True), (samples.STONE, True, False)):
            self.assertEqual(set(first.soil[rows]), {at_first})
            self.assertEqual(set(last.soil[rows]), {at_last})
        self.assertEqual(len(last.x), len(first.x), "a row is the same point in every frame")
        np.testing.assert_array_equal(last.soil, last["volume"] > 0)

    def test_a_picture_shows_the_soil_alone(self):
        for time, x in ((0.0, self.run_.frame(0)), (1.0, self.run_.frame(-1))):
            panel = plot.field(self.run_, "stress.yy", time)
            np.testing.assert_array_equal(panel.collections[0].get_offsets(), x.x[x.soil])
        outlined = [tuple(line.get_xydata().max(axis=0)) for line in panel.lines]
        self.assertEqual(outlined, [(4.0, 2.0), (3.0, 3.0), (0.5, 4.0)], "the berm is not there at the start")

    def test_an_export_has_the_rows_of_the_soil_alone(self):
        self.program("export", self.folder, "--field", "material")
        for k in (0, -1):
            frame = self.run_.frame(k)
            name = f"frame_{k % len(self.run_):05}.csv"
            rows = np.genfromtxt(self.folder / "csv" / name, delimiter=",", names=True)
            np.testing.assert_array_equal(rows["id"], np.flatnonzero(frame.soil))
            np.testing.assert_array_equal(rows["material"], frame["material"][frame.soil])
