"""A field over the cross-section at some times, for any runs side by side, as PNG and PDF.

    python3 -m terp.sections RUN [RUN ...] -o FILE [--field eps_eq_p] [--times 0 5 20] [--window X0 Y0 X1 Y1]

Materials that differ are told apart by a line around the place where each began. Exit status: 0 drawn, 2 a run is missing or does not
fit, 1 anything else.
"""

import argparse
import sys
from pathlib import Path

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from terp import style
from terp.maps import SIDES, colour_limit, frame_at, lattice_spacing
from terp.pairs import SCHEME_TITLES
from terp.run import Run, RunError

LEFT, RIGHT, GAP = 11.0, 2.5, 4.0          # margins and space between the columns [mm]
TOP, ROW_GAP, BELOW, BAR, BAR_TEXT = 5.0, 4.0, 9.5, 2.6, 12.0  # title, between rows, x axis, bar, its text [mm]


def draw_sections(runs, times, field, window=None):
    """The figure: one row for each time, one column for each run."""
    frames = [[frame_at(run, time) for run in runs] for time in times]
    present = [frame for row in frames for frame in row if frame]
    if not present:
        raise RunError(f"no run has a frame at t = {', '.join(f'{t:g}' for t in times)} s")
    window = window or window_of(present)
    norm = Normalize(0.0, colour_limit([row for row in frames[-1] if row] or present, field))
    figure, panels, bar = lay_out(len(times), len(runs), window)
    for time, row, row_panels in zip(times, frames, panels):
        for run, frame, panel in zip(runs, row, row_panels):
            panel.text(0.995, 0.95, f"$t$ = {time:g} s", transform=panel.transAxes, ha="right", va="top", fontsize=8)
            if frame:
                draw_points(panel, run, frame, field, norm)
    finish_axes(panels, runs)
    label = style.plastic_strain_label() if field == "eps_eq_p" else f"{field} ({runs[0].unit(field)})"
    over = any(np.nanmax(frame[field]) > norm.vmax for frame in present)
    figure.colorbar(ScalarMappable(norm, style.STRAIN_MAP), cax=bar, orientation="horizontal", label=label,
                    extend="max" if over else "neither", ticks=style.scale_ticks(norm.vmax))
    return figure


def window_of(frames):
    """x and y limits that hold every point of every frame [m]: x0, y0, x1, y1."""
    low = np.min([frame.x.min(axis=0) for frame in frames], axis=0)
    high = np.max([frame.x.max(axis=0) for frame in frames], axis=0)
    return (*np.floor(low), *np.ceil(high + 0.3))


def lay_out(n_rows, n_columns, window):
    """Figure, panels [n_rows][n_columns] with equal aspect, and the axes of the colour bar."""
    width = (style.TWO_COLUMNS - LEFT - RIGHT - GAP * (n_columns - 1)) / n_columns
    height = width * (window[3] - window[1]) / (window[2] - window[0])
    bar_top = TOP + n_rows * (height + ROW_GAP) + BELOW
    figure = style.new_figure(style.TWO_COLUMNS, bar_top + BAR + BAR_TEXT)
    panels = [[style.add_panel(figure, LEFT + column * (width + GAP), TOP + row * (height + ROW_GAP), width, height)
               for column in range(n_columns)] for row in range(n_rows)]
    for panel in sum(panels, []):
        panel.set(xlim=(window[0], window[2]), ylim=(window[1], window[3]))
    return figure, panels, style.add_panel(figure, style.TWO_COLUMNS * 0.27, bar_top, style.TWO_COLUMNS * 0.46, BAR)


def draw_points(panel, run, frame, field, norm):
    """Every material point as a square of about the lattice spacing, and the outlines of the materials at the start."""
    start = run.frame(0)
    spacing = lattice_spacing(start.x)
    for polygon in outlines(run.case):
        closed = np.vstack([polygon, polygon[:1]])
        panel.plot(closed[:, 0], closed[:, 1], color=style.GREY, lw=0.4, ls=(0, (4, 2)), zorder=3)
    x_begin, x_end = panel.get_xlim()
    width = panel.get_position().width * panel.figure.get_size_inches()[0] * 72.0
    for side in np.array(SIDES) * spacing * width / (x_end - x_begin):  # [pt]
        panel.scatter(frame.x[:, 0], frame.x[:, 1], s=side**2, c=frame[field], cmap=style.STRAIN_MAP, norm=norm,
                      marker="s", linewidths=0, antialiased=False, rasterized=True, zorder=2)


def outlines(case):
    """Polygons of the case's bodies, shape [n, 2] each; boxes too."""
    polygons = []
    for body in case.get("body", []):
        if "polygon" in body:
            polygons.append(np.array(body["polygon"], dtype=float))
        elif "box" in body:
            (x0, y0), (x1, y1) = body["box"]
            polygons.append(np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]]))
    return polygons


def finish_axes(panels, runs):
    """Tick labels on the outside only, the schemes above, axis names in metres."""
    for panel, run in zip(panels[0], runs):
        scheme = run.summary["scheme"]
        panel.set_title(SCHEME_TITLES.get(scheme, scheme), loc="left", pad=3)
    for row in panels:
        for panel in row:
            panel.tick_params(labelbottom=row is panels[-1], labelleft=panel is row[0])
        row[0].set_ylabel("y (m)")
    for panel in panels[-1]:
        panel.set_xlabel("x (m)")


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="python3 -m terp.sections", description="Draw a field over the cross-section.")
    parser.add_argument("runs", nargs="+", metavar="RUN", help="run folders, drawn side by side")
    parser.add_argument("-o", "--output", required=True, metavar="FILE", help="where the figure goes, without extension")
    parser.add_argument("--field", default="eps_eq_p", help="name of a field in results.vtkhdf (default: eps_eq_p)")
    parser.add_argument("--times", nargs="+", type=float, help="times in s (default: first, middle and last frame)")
    parser.add_argument("--window", nargs=4, type=float, metavar=("X0", "Y0", "X1", "Y1"), help="part to draw in m (default: all)")
    options = parser.parse_args(arguments)
    try:
        runs = [Run(folder) for folder in options.runs]
        known = runs[0].times
        times = options.times or sorted({known[0], known[len(known) // 2], known[-1]})
        with style.house_style():
            written = style.save_figure(draw_sections(runs, times, options.field, options.window), Path(options.output))
        print(f"{written[0]} and .pdf")
    except RunError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"error: cannot write the figure: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
