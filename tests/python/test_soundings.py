"""Strength from cone penetration tests, GEF and BRO, against sums by hand."""

import math
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest
import warnings

from terp import RunError
from terp.soundings import from_bro, from_gef, notes_of, read_sounding

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

    def test_quantities_in_another_unit_than_the_file_says_are_named(self):
        rows = "".join(f"{0.02 * k:.2f} {0.4 + 0.01 * k:.3f} {0.02 * k:.2f} 0.03 !\n" for k in range(1, 200))
        head = GEF.split("#EOH=\n")[0] + "#EOH=\n"

        def notes(old="", new="", of=rows):
            test = from_gef(head.replace(old, new) + of, "s.gef")
            return [note for note in notes_of(test, test.strength()[0]) if "another one" in note]

        self.assertEqual(notes(), [])
        self.assertIn("rows are 0.2 mm of depth apart", notes("m, corrected", "cm, corrected")[0])
        self.assertIn("199 rows q_t is less than the weight", notes("MPa, cone", "kPa, cone")[0])
        self.assertIn("in 199 of 199 rows u_2 is above q_c", notes(of=rows.replace(" 0.03 !", " 30 !"))[0])

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

    def test_a_depth_follows_from_length_and_inclination(self):
        rods = GEF.replace("m, corrected depth, 11", "degrees, inclination, 8")
        leaning = re.sub(r"^(\S+) (\S+) (\S+) (\S+) !$", r"\1 \2 60 \4 !", rods, flags=re.M)
        with self.assertRaisesRegex(RunError, "incline by 60 degrees"):
            from_gef(leaning, "s.gef")
        test = from_gef(leaning.replace(" 60 ", " 20 "), "s.gef")
        self.assertAlmostEqual(test.depth[-1], 2.04 * math.cos(math.radians(20.0)), places=9)
        self.assertIn("found from the inclination, 1.92 m for 2.04 m of rods", test.notes[0])
        test = from_gef(rods.replace(", 8\n", ", 99\n"), "s.gef")
        self.assertEqual(test.depth[-1], 2.04)
        self.assertIn("length of the rods", test.notes[0])
        rows = bro([(-999999, 0.3, 0.04), (-999999, 0.4, 0.04)]).decode().replace("-999998.99", "5").split(";")
        rows = [row if k > 1 else ",".join([*row.split(",")[:-10], "60", *row.split(",")[-9:]])
                for k, row in enumerate(rows)]
        with self.assertRaisesRegex(RunError, "incline by 60"):
            from_bro(";".join(rows).encode(), "s.xml")

    def test_the_datum_is_that_of_the_file(self):
        self.assertEqual(from_gef(GEF, "s.gef").datum, "NAP")
        self.assertEqual(from_gef(GEF.replace("31000", "32000"), "s.gef").datum, "datum 32000 (#ZID)")
        row = bro([(0.5, 0.3, 0.04)])
        self.assertIn("does not name", from_bro(row, "s.xml").datum)
        named = row.replace(b"<c:cone", b"<c:verticalDatum>NAP</c:verticalDatum><c:cone")
        self.assertEqual(from_bro(named, "s.xml").datum, "NAP")

    def test_what_a_user_should_know_is_a_note(self):
        def notes(text):
            test = from_gef(text, "s.gef")
            return " ".join(notes_of(test, test.strength(step=0.5)[0]))

        self.assertEqual(notes(GEF), "1 of 4 rows have no depth or no cone resistance")
        self.assertIn("no u_2: q_t was taken as q_c", notes(GEF.replace("u2, 6", "u2, 99")))
        some = GEF.replace("#COLUMNVOID= 2, -1", "#COLUMNVOID= 4, 0.04")
        self.assertIn("2 of 4 rows have no u_2", notes(some))
        deep = re.sub(r"^(0\.\S+) (\S+) (\S+) (\S+) !$", r"1\1 \2 1\3 \4 !", GEF, flags=re.M)
        self.assertIn("m below the ground at 1.50 m", notes(deep))
        with self.assertRaisesRegex(RunError, "less than a vacuum"):
            from_gef(GEF.replace("0.05 !", "-999 !"), "s.gef")

    def test_what_is_no_test_is_refused(self):
        for text in ("#GEFID= 1\n", GEF.replace("#ZID= 31000, 1.50, 0.01\n", ""), GEF.replace(", 2\n", ", 99\n")):
            with self.assertRaises(RunError):
                from_gef(text, "s.gef")
        for data in (b"<a", b"<a/>", bro([])):
            with self.assertRaises(RunError):
                from_bro(data, "s.xml")
        for options, words in (({"nkt": 0.0}, "N_kt is 0"), ({"unit_weight": -17e3}, "weight is -17 kN/m3"),
                               ({"step": -0.2}, "step of the depth is -0.2 m")):
            with self.assertRaisesRegex(RunError, words):
                from_gef(GEF, "s.gef").strength(**options)

    def test_damaged_files_are_read_or_refused(self):
        """Bytes changed, pieces doubled, taken out or moved: TERP_FUZZ_INPUTS=100000 tries more."""
        seeds = [(GEF, lambda text: from_gef(text, "s.gef")),
                 (bro([(0.5, 0.3, 0.04), (0.9, 0.4, -999999)]).decode(), lambda text: from_bro(text.encode(), "s.xml"))]
        chance = random.Random(1)
        n_read = 0
        for k in range(int(os.environ.get("TERP_FUZZ_INPUTS", "600"))):
            text, read = seeds[k % 2]
            for _ in range(chance.randrange(1, 4)):
                a, b = sorted(chance.randrange(len(text) + 1) for _ in range(2))
                b = min(b, a + 30)
                other = chance.choice([text[a:b] * 2, "", chance.choice("0123456789-+.e,;!#=<>&\n\0 \u00e9"), "1e300",
                                       "nan", "-inf", text[:20]])
                text = text[:a] + other + text[b:]
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                try:
                    test = read(text)
                    levels, _ = test.strength()
                    n_read += 1
                    if len(levels):
                        notes_of(test, levels)
                except RunError:
                    pass
        self.assertGreater(n_read, 20)

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
