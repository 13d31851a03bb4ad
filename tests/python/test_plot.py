"""Pictures of a run: terp.plot and the command terp.sections."""

import pathlib
import re
import tempfile
import unittest

import support

import numpy as np
import matplotlib
import terp
from PIL import Image
from matplotlib.animation import writers
from matplotlib.figure import Figure
from terp import plot, sections


class Pictures(unittest.TestCase):
    def setUp(self):
        self.run_ = terp.open(support.synthetic_run("mpm_gp", 2))

    def test_a_field_is_drawn_at_its_time_with_its_values(self):
        panel = plot.field(self.run_, "eps_eq_p", 1.1)
        self.assertEqual(panel.get_title(), "$t$ = 1 s")
        frame = self.run_.frame(self.run_.at(1.0))
        np.testing.assert_array_equal(panel.collections[0].get_array(), frame["eps_eq_p"])
        np.testing.assert_array_equal(panel.collections[0].get_offsets(), frame.x)

    def test_the_last_frame_is_the_default_and_limits_are_kept(self):
        panel = plot.field(self.run_, "su", limits=(2.0, 8.0))  # kPa, as the bar says
        self.assertEqual(panel.get_title(), "$t$ = 4 s")
        self.assertEqual(panel.collections[0].get_clim(), (2000.0, 8000.0))
        self.assertEqual(panel.figure.axes[1].get_xlim(), (2000.0, 8000.0))
        self.assertEqual(plot.field(self.run_, "eps_eq_p", limits=(0.0, 2.0)).collections[0].get_clim(), (0.0, 2.0))

    def test_stress_is_in_kilopascal_on_the_bar(self):
        panel = plot.field(self.run_, "stress.yy")
        bar = panel.figure.axes[1]
        self.assertEqual(bar.get_xlabel(), "stress.yy (kPa)")
        self.assertEqual(bar.xaxis.get_major_formatter()(-4000.0, 0), "-4")

    def test_no_text_is_cut_off(self):
        for panel in (plot.field(self.run_, "eps_eq_p"), plot.history(self.run_, "eps_deviatoric"),
                      plot.ledger(self.run_, ["kinetic", "elastic"])):
            self.assertEqual(support.texts_cut_off(panel.figure), [])

    def test_every_point_lies_inside(self):
        panel = plot.field(self.run_, "su")
        x, y = self.run_.frame(-1).x.T
        self.assertTrue(panel.get_xlim()[0] <= x.min() and x.max() <= panel.get_xlim()[1])
        self.assertTrue(panel.get_ylim()[0] <= y.min() and y.max() <= panel.get_ylim()[1])

    def test_a_film_has_one_frame_per_frame_and_one_bar(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "run.gif"
            film = terp.animate(self.run_, "eps_eq_p", path, dpi=30)
            with Image.open(path) as image:
                self.assertEqual(image.n_frames, len(self.run_))
                image.seek(image.n_frames - 1)
                last = np.array(image.convert("RGB"))
                image.seek(0)
                self.assertGreater(np.mean(last != np.array(image.convert("RGB"))), 0.01)
        section, bar = film._fig.axes
        self.assertEqual(section.get_title(), "$t$ = 4.00 s")
        self.assertEqual(len(section.collections), 1, "the squares of one frame")
        self.assertIn("plastic deviatoric strain", bar.get_xlabel())

    def test_a_film_of_some_frames_shows_itself_in_a_notebook(self):
        film = terp.animate(self.run_, "su", every=4, limits=(2, 8), dpi=30)
        with matplotlib.rc_context({"savefig.dpi": 20, "figure.dpi": 20}):
            page = film._repr_html_()
        self.assertEqual(len(re.findall(r"frames\[\d+\] = ", page)), (len(self.run_) + 3) // 4)
        with self.assertRaisesRegex(ValueError, "ends in .gif or .mp4, not `.avi`"):
            terp.animate(self.run_, "su", "film.avi")
        if not writers.is_available("ffmpeg"):
            with self.assertRaisesRegex(terp.RunError, "film.mp4 needs ffmpeg, which is not there"):
                terp.animate(self.run_, "su", "film.mp4")

    def test_given_axes_are_drawn_into(self):
        panel = Figure().add_subplot()
        self.assertIs(plot.field(self.run_, "su", 1.0, panel), panel)
        panel = Figure().add_subplot()
        self.assertIs(plot.history(self.run_, "su", ["A"], panel), panel)

    def test_history_has_a_line_per_point_in_units_of_print(self):
        panel = plot.history(self.run_, "su", ["A", "J"])
        self.assertEqual([line.get_label() for line in panel.lines], ["A", "J"])
        np.testing.assert_allclose(panel.lines[1].get_ydata(), 1e-3 * self.run_.history_of("J")["su"])
        self.assertIn("kPa", panel.get_ylabel())
        self.assertEqual(len(plot.history(self.run_, "x").lines), 10)

    def test_the_ledger_takes_columns_of_one_unit(self):
        panel = plot.ledger(self.run_, ["kinetic", "plastic"])
        np.testing.assert_allclose(panel.lines[1].get_ydata(), 1e-3 * self.run_.ledger["plastic"])
        self.assertEqual(panel.get_ylabel(), "(kJ per m)")
        self.assertEqual(plot.ledger(self.run_, "front_x").get_ylabel(), "front_x (m)")
        with self.assertRaisesRegex(terp.RunError, r"one unit, not kinetic \[J per m\], front_x \[m\]"):
            plot.ledger(self.run_, ["kinetic", "front_x"])
        with self.assertRaisesRegex(terp.RunError, "no column `kinetik`. Did you mean `kinetic`"):
            plot.ledger(self.run_, "kinetik")

    def test_colours_leave_out_outliers_and_end_at_plain_numbers(self):
        class OneFrame:
            def __init__(self, values):
                self.values = np.asarray(values, dtype=float)
                self.soil = np.ones(len(values), dtype=bool)

            def scalar(self, _):
                return self.values

        def ends(values):
            norm = plot.colour_norm([OneFrame(values)], "velocity")
            return norm.vmin, norm.vmax

        plain = np.linspace(0.0, 0.99, 999)
        self.assertEqual(ends([*plain, 1e9]), (0.0, 1.0))
        self.assertEqual(ends([-1e9, *(3.0 * plain - 2.0), np.nan]), (-2.0, 1.0))
        self.assertEqual(ends(-plain), (-1.0, 0.0))
        self.assertEqual(ends([0.0, 0.0]), (0.0, 1.0))
        self.assertEqual(ends([np.nan]), (0.0, 1.0))


class WithoutValue:
    """A frame in which every other point is of a material without strength."""

    def __init__(self, frame):
        self.frame, self.run, self.x, self.soil = frame, frame.run, frame.x, frame.soil

    def scalar(self, name):
        values = np.array(self.frame.scalar(name))
        values[::2] = np.nan
        return values


class Soil(unittest.TestCase):
    def test_points_without_soil_are_in_no_part_of_a_picture(self):
        with support.without_soil(slice(1, None, 2)) as run:
            panel, whole = plot.field(run, "su"), plot.field(terp.open(support.synthetic_run("mpm_gp", 2)), "su", 1.0)
            frame = run.frame(-1)
            squares = panel.collections[0]
            np.testing.assert_array_equal(squares.get_offsets(), frame.x[::2])
            np.testing.assert_array_equal(squares.get_array(), frame["su"][::2])
            np.testing.assert_allclose(squares.get_sizes(), whole.collections[0].get_sizes())
            self.assertEqual(panel.get_xlim(), whole.get_xlim())
            self.assertEqual(panel.get_ylim(), (0.0, 2.1))
            self.assertEqual(squares.get_clim(), (0.0, 8000.0))
            self.assertEqual(plot.without_value([frame], "su"), [])
            figure, notes = sections.draw_sections([run], sections.Section("su", (1.0,)))
            np.testing.assert_array_equal(figure.axes[0].collections[0].get_offsets(), frame.x[::2])
            self.assertEqual(notes, [])

    def test_bodies_that_a_stage_places_have_no_outline(self):
        box = {"box": [[0, 0], [1, 1]]}
        case = {"body": [box, {**box, "name": "fill"}, {**box, "name": "berm"}],
                "stage": [{"name": "a"}, {"name": "b", "place": ["berm"], "remove": ["fill"]}]}
        self.assertEqual(len(plot.body_outlines(case)), 2)


class Sections(unittest.TestCase):
    def test_points_whose_material_lacks_the_field_are_grey_and_named(self):
        run = terp.open(support.synthetic_run("mpm_gp", 2))
        frame = WithoutValue(run.frame(-1))
        panel, _ = plot.section_page(plot.window_of([frame]))
        plot.squares(panel, frame, "su", plot.colour_norm([frame], "su"))
        grey, soil = panel.collections[:2]
        self.assertEqual(len(grey.get_offsets()), len(frame.x[::2]))
        self.assertEqual(len(soil.get_offsets()), len(frame.x[1::2]))
        self.assertEqual(plot.without_value([frame], "su"), ["clay" if "material" in run.units else "some points"])
        self.assertEqual(plot.without_value([run.frame(-1)], "su"), [])

    def test_the_command_draws_any_number_of_runs_at_any_times(self):
        runs = [support.synthetic_run(scheme) for scheme in ("mpm_mixed", "mpm_gp")]
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "picture"
            status, said, error = support.call(sections.main, runs[0], "-o", out)
            self.assertEqual((status, error), (0, ""))
            self.assertTrue(out.with_suffix(".png").exists() and out.with_suffix(".pdf").exists())
            status, said, _ = support.call(sections.main, *runs, "-o", out, "--field", "stress.xy", "--times",
                                           "1", "3.3")
            self.assertEqual(status, 0)
            self.assertIn("has no frame at t = 3.3 s", said)
            status, _, error = support.call(sections.main, runs[0], "-o", out, "--field", "eps_eqp")
            self.assertEqual(status, 2)
            self.assertIn("Did you mean `eps_eq_p`?", error)
            self.assertEqual(support.call(sections.main, runs[0], "-o", out, "--times", "77")[0], 2)

    def test_a_single_run_has_no_letter_and_several_have(self):
        runs = [terp.open(support.synthetic_run(scheme)) for scheme in ("mpm_mixed", "mpm_gp")]
        what = sections.Section("eps_eq_p", (1.0,))
        one, _ = sections.draw_sections(runs[:1], what)
        two, _ = sections.draw_sections(runs, what)
        self.assertEqual(one.axes[0].get_title("left"), "MPM-Mixed")
        self.assertEqual([panel.get_title("left") for panel in two.axes[:2]], ["(a) MPM-Mixed", "(b) MPM-GP"])


if __name__ == "__main__":
    unittest.main()
