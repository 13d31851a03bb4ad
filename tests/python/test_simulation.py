"""A run in memory, driven from Python: the same bits as the program, views, threads, errors."""

import ast
import concurrent.futures
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import tomllib
import unittest

import support

import numpy as np
import samples
import terp

ROOT = support.HERE.parents[1]
PROGRAM = os.environ.get("TERP")
CASE = ROOT / "cases" / "column_collapse" / "model_2.toml"
COARSE = {"mesh.cell": 0.25, "time.end": 0.3, "output.fields.every": 0.1}
try:
    from terp import _core  # noqa: F401
except ImportError:
    _core = None


@unittest.skipUnless(_core, "the compiled part of the package was not built")
class SimulationInMemory(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.case = terp.Case(CASE, COARSE)
        cls.solved = terp.Simulation(cls.case)
        cls.solved.run()

    def same_bits(self, other):
        for name in ("position", "velocity", "stress", "eps_eq_p", "su"):
            self.assertEqual(self.solved.field(name).tobytes(), other.field(name).tobytes(), name)

    def test_steps_in_parts_and_threads_give_the_same_bits(self):
        parts = terp.Simulation(self.case, threads=2)
        parts.step(7)
        parts.run(until=0.1)
        self.assertAlmostEqual(parts.time, 0.1, delta=parts.dt)
        parts.run()
        self.assertTrue(parts.has_ended)
        self.same_bits(parts)

    @unittest.skipUnless(PROGRAM, "TERP names no program")
    def test_its_folder_is_that_of_the_program(self):
        with tempfile.TemporaryDirectory() as scratch:
            there, here = pathlib.Path(scratch) / "program", pathlib.Path(scratch) / "python"
            changes = [word for key, value in COARSE.items() for word in ("--set", f"{key}={value}")]
            subprocess.run([PROGRAM, "run", str(CASE), "-q", "-j", "1", "-o", str(there), *changes], check=True)
            terp.Simulation(self.case, output=here).run()
            self.assertEqual(sorted(p.name for p in there.rglob("*")), sorted(p.name for p in here.rglob("*")))
            for name in ("ledger.csv", "history.csv", "case.toml", "frames/points_00003.vtkhdf", "mesh.vtkhdf"):
                self.assertEqual((there / name).read_bytes(), (here / name).read_bytes(), name)
            self.assertTrue(terp.open(here).finished)
            with self.assertRaisesRegex(terp.RunError, "force"):
                terp.Simulation(self.case, output=here)

    @unittest.skipUnless(PROGRAM, "TERP names no program")
    def test_the_program_goes_on_where_a_run_was_closed_by_an_error(self):
        def fails(run):
            if run.time > 0.05:
                raise KeyError("mine")
        with tempfile.TemporaryDirectory() as scratch:
            whole, part = pathlib.Path(scratch) / "whole", pathlib.Path(scratch) / "part"
            terp.Simulation(self.case, output=whole).run()
            with self.assertRaises(KeyError), terp.Simulation(self.case, output=part) as run:
                run.run(every=0.07, call=fails)
            del run  # and with it the lock of the folder
            self.assertFalse(terp.open(part).finished)
            subprocess.run([PROGRAM, "resume", "-q", str(part)], check=True)
            for name in ("ledger.csv", "history.csv", "frames/points_00003.vtkhdf"):
                self.assertEqual((whole / name).read_bytes(), (part / name).read_bytes(), name)

    def test_a_run_that_stops_itself_says_why_and_leaves_no_checkpoint_of_its_fault(self):
        with tempfile.TemporaryDirectory() as folder:
            with (self.assertRaisesRegex(terp.SolveError, "(?i)step|energy|wall"),
                  terp.Simulation(self.case, output=folder) as run):
                run.start()
                run.set_field("velocity", run.field("velocity") + np.array([1e5, 0, 0]))
                run.run()
            self.assertEqual(list(pathlib.Path(folder).glob("checkpoint_*")), [])
            self.assertEqual(len(list(pathlib.Path(folder).glob("failed_*"))), 1)

    def test_a_dictionary_is_a_case(self):
        keys = tomllib.loads(CASE.read_text())
        keys["mesh"]["cell"], keys["time"]["end"] = COARSE["mesh.cell"], np.float64(COARSE["time.end"])
        run = terp.Simulation(keys)
        run.run()
        self.same_bits(run)
        self.assertEqual(tomllib.loads(terp.Case(keys).text)["material"], keys["material"])

    def test_the_text_of_a_file_is_a_case(self):
        run = terp.Simulation(terp.Case.from_text(CASE.read_text()).changed(COARSE))
        run.run()
        self.same_bits(run)
        with self.assertRaisesRegex(terp.CaseError, "text:1:8: "):
            terp.Case.from_text("time = { end = 1.0")
        with self.assertRaisesRegex(terp.CaseError, "from_text takes the text of a case"):
            terp.Case(CASE.read_text())

    def test_wrong_arguments_are_refused(self):
        for wrong in (0, -1, 100000):
            with self.assertRaisesRegex(terp.CaseError, f"{wrong} is out of range; allowed are 1 to 1024"):
                terp.Simulation(self.case, threads=wrong)
        with self.assertRaisesRegex(TypeError, "mesh_of is another Simulation, not Case"):
            terp.Simulation(self.case, mesh_of=self.case)
        with self.assertRaisesRegex(ValueError, "not nan"):
            self.solved.run(until=float("nan"))
        with self.assertRaisesRegex(terp.CaseError, "a dictionary by dotted key"):
            terp.Case(CASE, ["mesh.cell=0.5"])

    def test_a_function_is_called_once_a_step_at_most(self):
        run, steps = terp.Simulation(self.case), []
        run.run(until=0.05, every=1e-9, call=lambda s: steps.append(s.n_steps))
        self.assertEqual(steps, list(range(run.n_steps + 1)))

    def test_a_function_is_called_at_times_and_may_end_the_run(self):
        times = []
        run = terp.Simulation(self.case)
        run.run(every=0.1, call=lambda s: times.append(s.time))
        np.testing.assert_allclose(times, [0, 0.1, 0.2, 0.3], atol=run.dt)
        self.same_bits(run)
        for goes_on in (lambda s: s.time < 0.15, lambda s: s.field("position").max() > 0 and np.bool_(s.time < 0.15)):
            ends = terp.Simulation(self.case)
            ends.run(every=0.1, call=goes_on)
            self.assertAlmostEqual(ends.time, 0.2, delta=ends.dt)

    def test_blocks_are_views_of_all_points(self):
        run = terp.Simulation(self.case)
        run.step(3)
        views = run.blocks("velocity")
        self.assertEqual(sum(len(v) for v in views), run.n_points)
        numbers = np.concatenate(run.blocks("id")).astype(int)
        np.testing.assert_array_equal(np.concatenate(views), run.field("velocity")[numbers][:, :2])
        before = views[0].copy()
        run.step(20)
        self.assertFalse(np.array_equal(before, views[0]), "a view shows the present")
        with self.assertRaises(ValueError):
            views[0][0] = 1.0
        saved = run.save()
        with self.assertRaisesRegex(BufferError, "delete them"):
            run.restore(saved)
        del run
        self.assertTrue(np.isfinite(views[0]).all(), "a view keeps the memory that it shows")

    def test_it_goes_back_to_a_saved_state(self):
        run = terp.Simulation(self.case)
        run.run(until=0.15)
        saved = run.save()
        run.run()
        run.restore(saved)
        self.assertAlmostEqual(run.time, 0.15, delta=run.dt)
        run.run()
        self.same_bits(run)

    def test_a_run_with_files_does_not_go_back(self):
        with tempfile.TemporaryDirectory() as folder, terp.Simulation(self.case, output=folder) as run:
            run.step(3)
            saved = run.save()
            with self.assertRaisesRegex(terp.CaseError, "files, which do not go back"):
                run.restore(saved)
            other = terp.Simulation(self.case)
            other.restore(saved)
            self.assertEqual(other.time, run.time)

    def test_it_says_which_points_are_soil(self):
        run = terp.Simulation(terp.Case.from_text(samples.DUG))
        run.start()
        for body, there in ((samples.FILL, True), (samples.BERM, False), (samples.STONE, True)):
            self.assertEqual(set(run.soil[body]), {there})
        run.run()
        for body, there in ((samples.GROUND, True), (samples.FILL, False), (samples.BERM, True),
                            (samples.STONE, False)):
            self.assertEqual(set(run.soil[body]), {there})
        self.assertEqual(run.field("stress").shape, (len(run.soil), 4))

    def test_fields_can_be_set(self):
        run = terp.Simulation(self.case)
        run.start()
        velocity = run.field("velocity")
        velocity[:, 0] = 0.5
        run.set_field("velocity", velocity)
        np.testing.assert_array_equal(run.field("velocity"), velocity)
        with self.assertRaisesRegex(terp.CaseError, "were given"):
            run.set_field("velocity", velocity[:5])
        for wrong in (velocity.T, velocity.ravel(), velocity[:, :, None], velocity[:, :2]):
            with self.assertRaisesRegex(terp.CaseError, r"were given\n  Its shape is \(\d+, 3\)"):
                run.set_field("velocity", wrong)
        for wrong in (velocity + 1j, velocity.astype(str), np.full(velocity.shape, None),
                      np.ma.masked_array(velocity, mask=velocity > 0)):
            with self.assertRaisesRegex(terp.CaseError, "real numbers are needed"):
                run.set_field("velocity", wrong)
        with self.assertRaisesRegex(terp.CaseError, "the plastic strain of material point 0 is below zero"):
            run.set_field("eps_eq_p", -np.ones(run.n_points))
        np.testing.assert_array_equal(run.field("velocity"), velocity, "nothing was set")
        velocity[7, 0] = np.nan
        with self.assertRaisesRegex(terp.CaseError, "material point 7 is not a finite number"):
            run.set_field("velocity", velocity)

    def test_many_run_at_once_on_one_mesh(self):
        def solve(eta):
            run = terp.Simulation(self.case.changed({"material.clay.eta": eta}), mesh_of=self.solved)
            run.run()
            return run.field("eps_eq_p")
        etas = range(20, 60, 2)
        with concurrent.futures.ThreadPoolExecutor(len(etas)) as pool:
            at_once = list(pool.map(solve, etas))
        for eta, field in zip(etas, at_once):
            np.testing.assert_array_equal(field, solve(eta))
        with self.assertRaisesRegex(terp.CaseError, r"another mesh: mesh.cell \(\[0.25, 0.25\], now \[0.2, 0.2\]\)"):
            terp.Simulation(self.case.changed({"mesh.cell": 0.2}), mesh_of=self.solved)

    def test_the_stubs_have_every_name(self):
        def named(entries):
            entries = [e for e in entries if not isinstance(e, (ast.Import, ast.ImportFrom, ast.Expr, ast.Assign))]
            return {e.target.id if isinstance(e, ast.AnnAssign) else e.name for e in entries}
        module = ast.parse((pathlib.Path(terp.__file__).parent / "_core.pyi").read_text())
        stubs = {"": named(module.body)}
        stubs |= {c.name: named(c.body) for c in module.body if isinstance(c, ast.ClassDef)}
        for name, known in stubs.items():
            there = getattr(_core, name) if name else _core
            self.assertEqual({n for n in dir(there) if not n.startswith("_")}, known - {"__init__"}, name)

    def test_two_threads_cannot_drive_one(self):
        run = terp.Simulation(self.case.changed({"mesh.cell": 0.1}))
        first = threading.Thread(target=run.run)
        first.start()
        while run.n_steps == 0:
            time.sleep(0.001)
        with self.assertRaisesRegex(RuntimeError, "in use by another thread"):
            run.step()
        self.assertFalse(run.has_ended)
        self.assertGreater(run.time, 0.0)
        for read in (lambda: run.summary, lambda: run.stage, lambda: run.blocks("velocity"), run.save):
            with self.assertRaisesRegex(RuntimeError, "in use by another thread"):
                read()
        first.join()
        self.assertTrue(run.has_ended)

    def test_errors_have_the_words_of_the_program(self):
        with self.assertRaisesRegex(terp.CaseError, "(?s)unknown key `cel`.*Did you mean `cell`"):
            self.case.changed({"mesh.cel": 1})
        with self.assertRaisesRegex(terp.CaseError, "dictionary:2"):
            terp.Case({"mesh": {"cell": "wide"}})
        with self.assertRaisesRegex(terp.CaseError, "no field of this name"):
            self.solved.field("strees")
        with self.assertRaisesRegex(terp.CaseError, "a set cannot stand in a case"):
            terp.Case({"mesh": {"cell": {1}}})
        with self.assertRaisesRegex(terp.CaseError, "no such file|cannot be read|not found"):
            terp.Case("nowhere.toml")

    def test_control_c_ends_it_and_it_goes_on(self):
        run = terp.Simulation(self.case.changed({"mesh.cell": 0.1, "time.end": 30.0}))
        threading.Timer(1.0, os.kill, (os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            run.run()
        self.assertFalse(run.has_ended)
        before = run.n_steps
        run.step()
        self.assertEqual(run.n_steps, before + 1)


class WithoutTheCompiledPart(unittest.TestCase):
    def test_results_can_be_read_and_simulations_say_what_is_missing(self):
        words = ("import sys; sys.modules['terp._core'] = None; import terp\n"
                 "print(terp.open)\n"
                 "try: terp.Simulation\n"
                 "except ImportError as error: print(error)")
        told = subprocess.run([sys.executable, "-c", words], capture_output=True, text=True, check=True,
                              env={**os.environ, "PYTHONPATH": str(ROOT / "python")}).stdout
        self.assertIn("function open", told)
        self.assertIn("needs the compiled part", told)
