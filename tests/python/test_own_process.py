"""Runs in a process of their own: what a law of a library does to them, and to Python."""

import os
import pathlib
import shutil
import signal
import tempfile
import threading
import time
import unittest

import support  # noqa: F401 (finds the package)

import numpy as np
import terp
from samples import COLUMN

try:
    from terp import _core  # noqa: F401
except ImportError:
    _core = None
LIBRARY = pathlib.Path(os.environ.get("TERP", "")).parent / "tests" / "laws" / "wrong_umat.so"
ELASTIC, CRASHES, ENDS = 0, 3, 6  # what wrong_umat.c may do
LAW = """\
[time]
end = 0.2
[mesh]
size = [4.0, 2.0]
cell = 0.5
[[body]]
material = "clay"
box = [[0.0, 0.0], [2.0, 1.0]]
[material.clay]
model = "library"
library = "law.so"
interface = "umat"
parameters = [2e6, 0.3, {kind}, 0.12, -1.0, 0.0]
state = {{ calls = 3.0 }}
density = 1990.0
shear_modulus = 2e6
poisson_ratio = 0.3
[forces]
gravity = [0.0, -9.81]
[boundary]
bottom = "fixed"
"""


@unittest.skipUnless(_core and LIBRARY.is_file(), "the compiled part or the laws of the tests were not built")
class LawOfALibrary(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        shutil.copy(LIBRARY, self.folder / "law.so")

    def case(self, kind):
        return terp.Case.from_text(LAW.format(kind=kind), folder=self.folder)

    def test_one_that_ends_the_program_ends_its_run_alone(self):
        run = terp.Simulation(self.case(ENDS))
        run.run(until=0.1)
        self.assertGreater(run.field("velocity").min(axis=0)[1], -2.0)
        with self.assertRaisesRegex(terp.SolveError, "^the law of material `clay` ended the program .STOP, XIT or"):
            run.run()
        with self.assertRaisesRegex(terp.SolveError, "ended the program"):
            run.time

    def test_one_that_crashes_ends_its_run_alone(self):
        run = terp.Simulation(self.case(CRASHES))
        with self.assertRaisesRegex(terp.SolveError, r"ended with signal 11 \(Segmentation fault\)"):
            run.run()

    def test_the_bits_are_those_of_this_process(self):
        here, there = (terp.Simulation(self.case(ELASTIC), own_process=own) for own in (False, None))
        self.assertNotEqual(type(here._run), type(there._run))
        for run in here, there:
            run.run(until=0.15)
        self.assertEqual(here.field("stress").tobytes(), there.field("stress").tobytes())
        self.assertEqual(here.units, there.units)
        np.testing.assert_array_equal(here.ledger["kinetic"], there.ledger["kinetic"])
        with self.assertRaisesRegex(terp.CaseError, "own_process=False"):
            there.blocks("velocity")
        with self.assertRaisesRegex(terp.CaseError, "shares no mesh"):
            terp.Simulation(self.case(ELASTIC), mesh_of=there)


@unittest.skipUnless(_core, "the compiled part of the package was not built")
class OwnProcess(unittest.TestCase):
    def test_errors_states_and_settings_come_through(self):
        run = terp.Simulation(terp.Case.from_text(COLUMN), own_process=True, vary=["su_peak"])
        run.set_field("su_peak", 2 * run.field("su_peak"))
        saved = run.save()
        run.run(every=0.1, call=lambda s: s.time < 0.25)
        self.assertAlmostEqual(run.time, 0.3, delta=run.dt)
        run.restore(saved)
        self.assertEqual((run.time, saved.time, saved.step), (0.0, 0.0, 0))
        with self.assertRaisesRegex(terp.CaseError, "no field of this name"):
            run.field("strees")

    def test_control_c_ends_it_and_it_goes_on(self):
        case = terp.Case.from_text(COLUMN, {"mesh.cell": 0.1, "time.end": 1000.0, "output.checkpoint.every": 0.01})
        with tempfile.TemporaryDirectory() as folder:
            run = terp.Simulation(case, output=folder, own_process=True)

            def interrupt():
                while not list(pathlib.Path(folder).glob("checkpoint_*")):  # it is on its way
                    time.sleep(0.01)
                os.kill(os.getpid(), signal.SIGINT)
            with self.assertRaises(KeyboardInterrupt):
                threading.Thread(target=interrupt).start()
                run.run()
            before = run.n_steps
            self.assertGreater(before, 2)
            run.step()
            self.assertEqual(run.n_steps, before + 1)
            run.close()
            del run


if __name__ == "__main__":
    unittest.main()
