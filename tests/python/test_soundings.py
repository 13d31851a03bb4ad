"""Strength from cone penetration tests, GEF and BRO, against sums by hand."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from terp import RunError
from terp.soundings import from_bro, from_gef, read_sounding

GEF = """#GEFID= 1, 1, 0
#COLUMN= 4
#COLUMNINFO= 1, m, penetration length, 1
#COLUMNINFO= 2, MPa, cone resistance, 2
#COLUMNINFO= 3, m, corrected depth, 11
#COLUMNINFO= 4, MPa, pore pressure u2, 6
#COLUMNVOID= 2, -1
#MEASUREMENTVAR= 3, 0.75, -, net surface area quotient
#TESTID= S12
#ZID= 31000, 1.50, 0.01
#EOH=
0.52 0.30 0.50 0.04 !
0.56 0.34 0.54 0.04 !
1.02 -1 1.00 0.05 !
2.04 0.01 2.00 0.00 !
"""

VALUES = ["0", "0", "0", "0", *["-999999"] * 21]


def bro(rows):
    """A BRO file with depth, cone resistance and pressure of each row."""
    lines = []
    for depth, cone, pressure in rows:
        row = list(VALUES)
        row[0], row[1], row[3], row[22] = str(depth + 0.01), str(depth), str(cone), str(pressure)
        lines.append(",".join(row))
    return ("<a:CPT_O xmlns:a='a' xmlns:c='c'><a:broId>CPT000000001</a:broId><c:offset uom='m'>-0.5</c:offset>"
            "<c:coneSurfaceQuotient>0.8</c:coneSurfaceQuotient>"
            f"<c:values>{';'.join(lines)};</c:values></a:CPT_O>").encode()


class Soundings(unittest.TestCase):
    def test_gef_gives_the_strength_of_a_hand_sum(self):
        test = from_gef(GEF, "s.gef")
        self.assertEqual((test.name, test.level, test.area_ratio), ("S12", 1.5, 0.75))
        levels, values = test.strength(nkt=15.0, unit_weight=16e3, step=0.5)
        # q_t = 0.31 and 0.35 MPa, sigma_v = 8.00 and 8.64 kPa; the soft place at 2 m and the void have no strength
        self.assertEqual(list(levels), [0.75])
        self.assertAlmostEqual(values[0], ((310e3 - 8.00e3) + (350e3 - 8.64e3)) / 2 / 15.0, places=6)

    def test_bro_gives_the_same(self):
        test = from_bro(bro([(0.5, 0.3, 0.04), (0.9, 0.4, -999999)]), "s.xml")
        self.assertEqual((test.name, test.level), ("CPT000000001", -0.5))
        levels, values = test.strength(nkt=10.0, unit_weight=20e3, step=0.4)
        self.assertAlmostEqual(levels[0], -0.5 - 0.6)
        self.assertAlmostEqual(values[0], (0.3e6 + 0.04e6 * 0.2 - 10e3) / 10.0, places=6)
        self.assertAlmostEqual(values[1], (0.4e6 - 18e3) / 10.0, places=6)

    def test_units_separators_and_signs_are_those_of_the_file(self):
        plain = from_gef(GEF, "s.gef").strength(step=0.5)[1]
        cut = GEF.replace("#COLUMN= 4", "#COLUMNSEPARATOR= ,\n#COLUMN= 4").split("#EOH=\n")
        with_commas = cut[0] + "#EOH=\n" + cut[1].replace(" !", "!").replace(" ", ",")
        self.assertEqual(list(from_gef(with_commas, "s.gef").strength(step=0.5)[1]), list(plain))
        in_bar = GEF.replace("2, MPa, cone", "2, bar, cone").replace(" 0.30 0.50", " 3.0 0.50")
        self.assertAlmostEqual(from_gef(in_bar, "s.gef").cone[0], 300e3)
        downwards = re.sub(r"^(\S+) (\S+) (\S+) (\S+) !$", r"\1 \2 -\3 \4 !", GEF, flags=re.M)
        self.assertEqual(list(from_gef(downwards, "s.gef").depth), [0.5, 0.54, 1.0, 2.0])
        for wrong in (GEF.replace("m, corrected", "yard, corrected"), GEF.replace("0.75", "75"),
                      GEF.replace("#COLUMN= 4", "#PROCEDURECODE= GEF-BORE-Report, 1, 0, 0")):
            with self.assertRaises(RunError):
                from_gef(wrong, "s.gef")

    def test_what_is_no_test_is_refused(self):
        for text in ("#GEFID= 1\n", GEF.replace("#ZID= 31000, 1.50, 0.01\n", ""), GEF.replace(", 2\n", ", 99\n")):
            with self.assertRaises(RunError):
                from_gef(text, "s.gef")
        for data in (b"<a", b"<a/>", bro([])):
            with self.assertRaises(RunError):
                from_bro(data, "s.xml")
        with self.assertRaises(RunError):
            from_gef(GEF, "s.gef").strength(nkt=0.0)

    def test_the_command_writes_a_table_that_a_case_takes(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder)
            (path / "s.gef").write_text(GEF)
            done = subprocess.run([sys.executable, "-m", "terp.soundings", "s.gef", "-o", "su.csv"], cwd=path,
                                  env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}, capture_output=True,
                                  text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("1 values of S12", done.stdout)
            self.assertEqual((path / "su.csv").read_text().splitlines()[0], "x,y,value")
            self.assertEqual(read_sounding(path / "s.gef").name, "S12")


if __name__ == "__main__":
    unittest.main()
