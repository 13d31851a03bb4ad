"""The paper's figures 1 to 9 from runs of Terp, as PNG and PDF.

    python3 -m terp.figures RUN_MIXED RUN_GP -o DIR
    python3 -m terp.figures MIXED_1 GP_1 MIXED_2 GP_2 -o DIR

A pair of model 1 (no softening) gives figures 2 and 3; a pair of model 2 gives figures 1 and 4 to 9.
Exit status: 0 drawn, 2 a run is missing or does not fit, 1 anything else.
"""

import functools
import sys
from pathlib import Path

from terp import curves, geometry, maps, style
from terp.pairs import POINTS_A_TO_F, POINTS_G_TO_J, read_pairs, runs_parser, total_strain_norm
from terp.run import RunError

TIMES_MODEL_1 = (1.0, 2.0, 4.0)            # figures 2 and 3 [s]
TIMES_MODEL_2 = (0.0, 0.5, 1.0, 2.5, 4.0)  # figures 4 and 5 [s]


def figures_of(pair, limit=None):
    """{number: function that draws it}: each returns the figure (or None) and notes on what is missing."""
    total = functools.partial(maps.MapFigure, "eps_deviatoric", style.total_strain_label(total_strain_norm(pair.gp)))
    plastic = functools.partial(maps.MapFigure, "eps_eq_p", style.plastic_strain_label())
    map_of = functools.partial(functools.partial, maps.draw_map_figure, pair)
    if pair.model == 1:
        return {2: map_of(total(TIMES_MODEL_1, limit=limit)), 3: map_of(plastic(TIMES_MODEL_1, limit=limit))}
    points = POINTS_A_TO_F + POINTS_G_TO_J
    return {
        1: functools.partial(geometry.draw_geometry, pair),
        4: map_of(total(TIMES_MODEL_2, points, limit)),
        5: map_of(plastic(TIMES_MODEL_2, points, limit)),
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
    try:
        draw_figures(read_pairs(options.runs), options.output, options.max_strain)
    except RunError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"error: cannot write the figures: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
