"""Factors of slip planes by hand: a strip load on clay, turning about a centre above its edge."""
import importlib.util
import math
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SPEC = importlib.util.spec_from_file_location("slip_planes", ROOT / "python" / "examples" / "slip_planes.py")
slip_planes = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(slip_planes)

CASE = """
[mesh]
origin = [-20, -12]
size = [40, 16]
[[body]]
material = "clay"
polygon = [[-20, -12], [20, -12], [20, 0], [-20, 0]]
[material.clay]
model = "tresca_softening"
density = "16 kN/m3"
su_peak = %s
[water]
unit_weight = "10 kN/m3"
phreatic_line = [[-20, -1]]
[[load]]
name = "strip"
from = 0
to = 8
pressure = 0
[[stage]]
set = { "load.strip.pressure" = 40000 }
"""


def section(su):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "case.toml"
        path.write_text(CASE % su)
        return slip_planes.Section(path)


class SlipPlanes(unittest.TestCase):
    def test_a_circle_under_a_strip_load_has_the_factor_of_its_moments(self):
        clay, a, h = section('"10 kPa"'), 8.0, 6.0
        r = math.hypot(a, h)
        line = [[x / 10, h - math.sqrt(r * r - x * x / 100)] for x in range(-80, 81)]
        known = 10e3 * 2 * r * r * math.asin(a / r) / (40e3 * a * a / 2)
        slices = clay.slices(line)
        self.assertAlmostEqual(slip_planes.bishop(slices) / known, 1.0, delta=0.01)
        self.assertAlmostEqual(slip_planes.spencer(slices) / known, 1.0, delta=0.02)

    def test_shansep_follows_the_stress_without_the_load(self):
        clay = section('{ shansep = { S = 0.25, m = 0.8, pop = "20 kPa", minimum = "2 kPa" } }')
        stress = 16e3 * 5 - 10e3 * 4  # 5 m deep, the water at 1 m
        su = 0.25 * stress * ((stress + 20e3) / stress) ** 0.8
        k = [abs(z + 5.0) for z in clay.z].index(min(abs(z + 5.0) for z in clay.z))
        self.assertAlmostEqual(clay.cohesion[100, k] / su, 1.0, delta=0.01)


if __name__ == "__main__":
    unittest.main()
