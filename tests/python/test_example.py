"""The example of a dike of one's own, as the manual has it, on coarse cells."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import support

import numpy as np
import terp
from PIL import Image

SCRIPT = support.HERE.parents[1] / "python" / "examples" / "own_dike.py"
try:
    from terp import _core  # noqa: F401
except ImportError:
    _core = None


@unittest.skipUnless(os.environ.get("TERP") and _core, "TERP names no program, or the compiled part was not built")
class OwnDike(unittest.TestCase):
    def test_it_runs_as_the_manual_says(self):
        self.assertLessEqual(len(SCRIPT.read_text(encoding="utf-8").splitlines()), 40)
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch) / "dike"
            env = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
            said = subprocess.run([sys.executable, str(SCRIPT), str(folder), "2.0", "6"], capture_output=True,
                                  text=True, check=True, env=env).stdout
            self.assertRegex(said, r"^factor of safety [01]\.\d\d\nterp.Study\(.*: 6 realisations, P\(I\) 0\.\d")
            for name in ("section.png", "mechanism.png", "flood_after_slide.png"):
                with Image.open(folder / name) as image:
                    self.assertGreater(len(np.unique(np.array(image.convert("L")))), 20, name)
            with Image.open(folder / "slide.gif") as film:
                self.assertGreater(film.n_frames, 5)
            study = terp.open_study(folder / "study")
            curve = study.over_level
            heights = study.table["residual_height"][study.table["slide"] == 1]
            np.testing.assert_allclose(curve["P"], [np.mean(heights < level) for level in curve["level"]], atol=1e-12)
            panel = study.plot()
            self.assertEqual(panel.get_xlabel(), "level of the water (m)")
            np.testing.assert_array_equal(panel.lines[0].get_ydata(), curve["P"])
            with self.assertRaisesRegex(terp.RunError, "has no load: only F_after_I"):
                study.plot("I")


if __name__ == "__main__":
    unittest.main()
