"""The figures: which are drawn, what they show, what is said when something is missing."""

import pathlib
import tempfile
import unittest

import support

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from terp import curves, figures, geometry, plot, sections, style
from terp.pairs import read_pair

style.PNG_DPI = style.PDF_DPI = 50  # tests look at what is drawn, not at how finely


def pair_of(model=2, end=4.0):
    return read_pair(support.synthetic_run("mpm_mixed", model, end), support.synthetic_run("mpm_gp", model, end))


def folders(model, end=4.0):
    return [support.synthetic_run(scheme, model, end) for scheme in ("mpm_mixed", "mpm_gp")]


def drawn(folder):
    return sorted(path.name for path in pathlib.Path(folder).iterdir())


def names_of(*numbers):
    return sorted(f"figure_{number}.{kind}" for number in numbers for kind in ("png", "pdf"))


class Command(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.out = pathlib.Path(scratch.name) / "deep" / "figures"

    def test_two_pairs_give_all_nine_figures_in_any_order_of_the_models(self):
        status, said, _ = support.call(figures.main, *folders(2), *folders(1), "-o", self.out)
        self.assertEqual(status, 0)
        self.assertEqual(drawn(self.out), names_of(*range(1, 10)))
        self.assertNotIn("note", said)

    def test_model_1_gives_figures_2_and_3(self):
        self.assertEqual(support.call(figures.main, *folders(1), "-o", self.out)[0], 0)
        self.assertEqual(drawn(self.out), names_of(2, 3))

    def test_a_short_run_is_drawn_and_the_missing_times_are_named(self):
        status, said, _ = support.call(figures.main, *folders(2, 1.0), "-o", self.out)
        self.assertEqual(status, 0)
        self.assertIn("has no frame at t = 2.5, 4 s (its last frame is at 1 s)", said)
        self.assertIn("history.csv ends at t = 1 s, the case at 4 s", said)
        self.assertEqual(drawn(self.out), names_of(1, *range(4, 10)))

    def test_a_figure_without_any_frame_is_not_drawn_and_the_run_goes_on(self):
        status, said, _ = support.call(figures.main, *folders(1, 0.5), "-o", self.out)
        self.assertEqual(status, 0)
        self.assertIn("figure 2  not drawn", said)
        self.assertEqual(drawn(self.out), [])

    def test_bad_pairs_end_with_status_2(self):
        mixed, gp = folders(2)
        for runs, words in (((gp, mixed), "the two runs are swapped"), ((mixed, mixed), "but mpm_gp is needed here"),
                            ((mixed, folders(1)[1]), "a pair is one case solved with both schemes"),
                            ((mixed, gp, mixed, gp), "both pairs are model 2"), ((mixed,), "give two run folders"),
                            ((mixed, "no/such"), "there is no run folder no/such")):
            status, _, error = support.call(figures.main, *runs, "-o", self.out)
            self.assertEqual(status, 2, error)
            self.assertIn(words, error)

    def test_an_output_folder_that_cannot_be_made_ends_with_status_1(self):
        self.out.parent.mkdir()
        self.out.write_text("in the way")
        status, _, error = support.call(figures.main, *folders(1), "-o", self.out)
        self.assertEqual(status, 1)
        self.assertIn("cannot write", error)


class Sections(unittest.TestCase):
    def draw(self, pair, **options):
        return sections.draw_sections(pair.runs, sections.Section("eps_eq_p", (0.0, 1.0, 4.0), "ABCDEFGHIJ", **options))

    def test_panels_share_limits_scale_and_equal_aspect(self):
        figure, _ = self.draw(pair_of())
        width, height = figure.get_size_inches()
        panels = figure.axes[:6]
        self.assertEqual(len({(panel.get_xlim(), panel.get_ylim()) for panel in panels}), 1)
        for panel in panels:
            box = panel.get_position()
            metres = np.diff(panel.get_xlim())[0] / np.diff(panel.get_ylim())[0]
            self.assertAlmostEqual(box.width * width / (box.height * height), metres, places=9)
        self.assertEqual(len({c.norm.vmax for panel in panels for c in panel.collections}), 1)

    def test_every_point_lies_inside_the_panels(self):
        pair = pair_of()
        figure, _ = self.draw(pair)
        end = max(run.field("position", k).max() for run in pair.runs for k in range(len(run.times)))
        self.assertGreater(figure.axes[0].get_xlim()[1], end)

    def test_dots_move_with_the_soil(self):
        run = pair_of().gp
        start, end = (dict((name, x) for name, x, _ in plot.places_at(run, t, "AJ")) for t in (0.0, 4.0))
        self.assertAlmostEqual(start["A"], 7.55, places=6)
        self.assertGreater(end["A"], 9.0)

    def test_the_colour_scale_ends_at_a_rounded_quantile_or_where_it_is_told(self):
        pair = pair_of()
        values = np.concatenate([run.field("eps_eq_p", 8) for run in pair.runs])
        limit = plot.colour_norm([run.frame(8) for run in pair.runs], "eps_eq_p").vmax
        quartile = np.quantile(values[values > 0.06], 0.75)  # of the points that have sheared
        self.assertGreaterEqual(limit, quartile)
        self.assertLess(limit, 2.0 * quartile)
        figure, _ = self.draw(pair, limit=0.3)
        self.assertEqual(figure.axes[0].collections[0].norm.vmax, 0.3)

    def test_round_up_gives_the_next_plain_number(self):
        for value, expected in ((0.0, 1.0), (0.11, 0.15), (1.0, 1.0), (2.2, 2.5), (7.0, 8.0), (93.0, 100.0)):
            self.assertAlmostEqual(style.round_up(value), expected)

    def test_scale_ticks_are_plain_and_end_at_the_end(self):
        steps = {1.0: 0.2, 1.5: 0.5, 2.0: 0.5, 2.5: 0.5, 3.0: 0.5, 0.4: 0.1, 6.0: 1.0, 0.08: 0.02}
        for end, step in steps.items():
            ticks = style.scale_ticks(end)
            self.assertAlmostEqual(ticks[1], step)
            self.assertAlmostEqual(ticks[-1], end)

    def test_squares_are_about_as_wide_as_the_lattice_and_reach_over_gaps(self):
        figure = Figure(figsize=(1.0, 1.0), dpi=100)
        panel = figure.add_axes([0, 0, 1, 1])
        panel.set(xlim=(0, 10), ylim=(0, 10))  # 10 pixels per metre
        panel.set_axis_off()
        x = np.array([(2.0, 5.0), (3.0, 5.0), (7.0, 5.0)])
        panel.add_collection(plot.Squares(panel, x, 1.0, facecolors=["red", "blue", "lime"]))
        canvas = FigureCanvasAgg(figure)
        canvas.draw()
        row = np.asarray(canvas.buffer_rgba())[49, :, :3].tolist()
        of = {name: [k for k, pixel in enumerate(row) if pixel == colour] for name, colour in
              (("red", [255, 0, 0]), ("blue", [0, 0, 255]), ("lime", [0, 255, 0]))}
        for name, left, right in (("red", 10, 25), ("blue", 25, 40), ("lime", 60, 80)):
            self.assertEqual(len(of[name]), of[name][-1] - of[name][0] + 1, f"{name} is in one piece")
            self.assertAlmostEqual(of[name][0], left, delta=1, msg=name)
            self.assertAlmostEqual(of[name][-1] + 1, right, delta=1, msg=name)

    def test_lattice_spacing_is_the_distance_of_neighbours(self):
        self.assertAlmostEqual(plot.lattice_spacing(pair_of().gp.field("position", 0)), 0.1)


class Curves(unittest.TestCase):
    def test_both_columns_have_one_scale_and_a_line_per_point(self):
        figure, _ = curves.draw_strain_curves(pair_of(), "ABCDEF")
        self.assertEqual(len({(panel.get_xlim(), panel.get_ylim()) for panel in figure.axes}), 1)
        self.assertEqual([len(panel.lines) for panel in figure.axes], [6, 6, 6, 6])

    def test_strength_is_in_kilopascal(self):
        figure, _ = curves.draw_strength_curves(pair_of(), "AB")
        self.assertAlmostEqual(figure.axes[0].lines[0].get_ydata()[0], 8.0)

    def test_line_styles_tell_the_points_of_a_figure_apart(self):
        for names in ("ABCDEF", "GHIJ"):
            self.assertEqual(style.lines_of(names), [style.LINES[name] for name in names])
        for names in ("ABCDEF", "GHIJ", "ABCDEFGHIJ", ("toe", "crest"), ("A", "toe")):
            self.assertEqual(len(set(style.lines_of(names))), len(names))


class Paper(unittest.TestCase):
    def test_no_text_is_cut_off_or_below_seven_points(self):
        for pair in (pair_of(1), pair_of(2)):
            for number, job in figures.figures_of(pair).items():
                with style.house_style():
                    figure, _ = job()
                    self.assertEqual(support.texts_cut_off(figure), [], f"figure {number}")
                for text in support.texts_of(figure):
                    self.assertGreaterEqual(text.get_fontsize(), 7.0)


class Geometry(unittest.TestCase):
    def test_sides_are_described_in_words(self):
        for condition, expected in (("roller", ("roller", "roller")), ("free", ("free", "free")),
                                    ({"contact": "bilateral", "adhesion": 8e3}, ("contact", "contact, adhesion 8 kPa")),
                                    ({"contact": "separating", "adhesion": 0.0, "friction": 0.3},
                                     ("contact", "contact, adhesion 0 kPa, friction 0.3"))):
            self.assertEqual(geometry.describe_side(condition), expected)

    def test_a_polygon_body_is_drawn_too(self):
        corners = plot.body_outlines({"body": [{"polygon": [[0, 0], [4, 0], [2, 3]]}, {"box": [[0, 0], [2, 1]]}]})
        self.assertEqual([polygon.tolist() for polygon in corners],
                         [[[0, 0], [4, 0], [2, 3]], [[0, 0], [2, 0], [2, 1], [0, 1]]])


if __name__ == "__main__":
    unittest.main()
