"""The paper's figures 1 to 9 from runs of Terp, as PNG and PDF.

    python3 -m terp.figures RUN_MIXED RUN_GP -o DIR
    python3 -m terp.figures MIXED_1 GP_1 MIXED_2 GP_2 -o DIR

A pair of model 1 (no softening) gives figures 2 and 3; a pair of model 2 gives figures 1 and 4 to 9.
Exit status: 0 drawn, 2 a run is missing or does not fit, 1 anything else.
"""

import functools
import sys
from pathlib import Path

from terp import curves, geometry, sections, style
from terp.command import exit_status, runs_parser
from terp.pairs import POINTS_A_TO_F, POINTS_G_TO_J, read_pairs

TIMES_MODEL_1 = (1.0, 2.0, 4.0)            # figures 2 and 3 [s]
TIMES_MODEL_2 = (0.0, 0.5, 1.0, 2.5, 4.0)  # figures 4 and 5 [s]


def figures_of(pair, limit=None):
    """{number: function that draws it}: each returns the figure (or None) and notes on what is missing."""
    def section(field, times, points=""):
        return functools.partial(sections.draw_sections, pair.runs, sections.Section(field, times, points, limit))

    if pair.model == 1:
        return {2: section("eps_deviatoric", TIMES_MODEL_1), 3: section("eps_eq_p", TIMES_MODEL_1)}
    points = POINTS_A_TO_F + POINTS_G_TO_J
    return {
        1: functools.partial(geometry.draw_geometry, pair),
        4: section("eps_deviatoric", TIMES_MODEL_2, points),
        5: section("eps_eq_p", TIMES_MODEL_2, points),
        6: functools.partial(curves.draw_strain_curves, pair, POINTS_A_TO_F),
        7: functools.partial(curves.draw_strain_curves, pair, POINTS_G_TO_J),
        8: functools.partial(curves.draw_strength_curves, pair, POINTS_A_TO_F),
        9: functools.partial(curves.draw_strain_and_strength_curves, pair, POINTS_G_TO_J),
    }


def draw_figures(pairs, folder, limit=None, say=print):
    """Draw every figure of these pairs into `folder`. Returns the paths written, in the order of the figures."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    jobs = {number: job for pair in pairs for number, job in figures_of(pair, limit).items()}
    paths = []
    for number, job in sorted(jobs.items()):
        with style.house_style():
            figure, notes = job()
            written = style.save_figure(figure, folder / f"figure_{number}") if figure else []
        say(f"figure {number}  {written[0]} and .pdf" if written else f"figure {number}  not drawn")
        for note in notes:
            say(f"          note: {note}")
        paths += written
    return paths


def main(arguments=None):
    parser = runs_parser("python3 -m terp.figures", "Draw the paper's figures: 2 and 3 from runs of model 1, "
                         "1 and 4 to 9 from runs of model 2.")
    parser.add_argument("-o", "--output", required=True, metavar="DIR", help="where the figures go")
    parser.add_argument("--max-strain", type=float, metavar="VALUE",
                        help="end of the colour scale of figures 2 to 5 (default: from the last frame of each figure)")
    options = parser.parse_args(arguments)
    return exit_status(lambda: draw_figures(read_pairs(options.runs), options.output, options.max_strain))


if __name__ == "__main__":
    sys.exit(main())
