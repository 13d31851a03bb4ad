"""A field over the cross-section at some times, for any runs side by side, as PNG and PDF.

    python3 -m terp.sections RUN [RUN ...] -o FILE [--field eps_eq_p] [--times 0 5 20] [--window X0 Y0 X1 Y1]

Exit status: 0 drawn, 2 a run is missing or does not fit, 1 anything else.
"""

import argparse
import dataclasses
import sys
from pathlib import Path

import numpy as np
from matplotlib.ticker import MaxNLocator

from terp import plot, style
from terp.command import exit_status
from terp.errors import RunError
from terp.pairs import SCHEME_TITLES
from terp.run import Run

TIME_TOLERANCE = 0.01  # a frame this near to the wanted time counts as of that time [s]

LEFT, RIGHT, GAP = 11.0, 2.5, 4.0         # margins and space between the columns [mm]
TOP, ROW_GAP, BELOW, BAR, BAR_TEXT = 5.0, 2.2, 9.5, 2.6, 12.0  # title, between rows, x axis, bar, its text [mm]


@dataclasses.dataclass(frozen=True)
class Section:
    """What one such figure shows."""

    field: str            # as Frame.scalar has it: "eps_eq_p", "stress.yy"
    times: tuple          # [s], one row each
    points: str = ""      # names of the points drawn as dots
    limit: float = None   # end of the colour scale, from 0, in the unit of the colour bar; None: from the last frames
    window: tuple = None  # x0, y0, x1, y1 [m]; None: all points in all frames


def draw_sections(runs, what):
    """The figure, a row per time and a column per run (None without any frame), and notes on what is missing."""
    frames = [[frame_at(run, time) for run in runs] for time in what.times]
    notes = missing_frames(runs, what.times, frames)
    rows = [(time, row) for time, row in zip(what.times, frames) if any(row)]
    if not rows:
        return None, notes
    present = [frame for _, row in rows for frame in row if frame]
    last = [next(filter(None, column), None) for column in zip(*(row for _, row in reversed(rows)))]
    if grey := plot.without_value(present, what.field):
        notes.append(f"no {what.field} in {', '.join(grey)}: drawn grey")
    norm = (plot.norm_of_limits(present[0].run, what.field, (0.0, what.limit)) if what.limit
            else plot.colour_norm([frame for frame in last if frame], what.field))
    figure, panels, bar = lay_out(len(rows), len(runs), what.window or plot.window_of(present))
    for (time, row), row_panels in zip(rows, panels):
        for run, frame, panel in zip(runs, row, row_panels):
            fill_panel(panel, time, run, frame, what, norm)
    finish_axes(panels, runs)
    plot.colour_bar(figure, norm, present, what.field, cax=bar)
    return figure, notes


def frame_at(run, time):
    """The frame of `time` [s], or None if the run has none."""
    if len(run.times) == 0:
        return None
    frame = run.frame(run.at(time))
    return frame if abs(frame.time - time) <= TIME_TOLERANCE else None


def missing_frames(runs, times, frames):
    """One sentence for each run that lacks a frame."""
    notes = []
    for column, run in enumerate(runs):
        missing = [f"{time:g}" for time, row in zip(times, frames) if row[column] is None]
        if missing:
            end = f"its last frame is at {run.times[-1]:g} s" if len(run.times) else "it has no frame at all"
            notes.append(f"{run.folder} has no frame at t = {', '.join(missing)} s ({end})")
    return notes


def lay_out(n_rows, n_columns, window):
    """Figure, panels [n_rows][n_columns] with equal aspect, and the axes of the colour bar."""
    width = (style.TWO_COLUMNS - LEFT - RIGHT - GAP * (n_columns - 1)) / n_columns
    height = width * (window[3] - window[1]) / (window[2] - window[0])
    bar_top = TOP + n_rows * (height + ROW_GAP) + BELOW
    figure = style.new_figure(style.TWO_COLUMNS, bar_top + BAR + BAR_TEXT)
    panels = style.panel_grid(figure, (n_rows, n_columns), (LEFT, TOP), (width, height), (GAP, ROW_GAP))
    for panel in sum(panels, []):
        panel.set(xlim=window[::2], ylim=window[1::2])
    return figure, panels, style.add_panel(figure, style.TWO_COLUMNS * 0.27, bar_top, style.TWO_COLUMNS * 0.46, BAR)


def fill_panel(panel, time, run, frame, what, norm):
    """One body at one time, its points and the time."""
    panel.text(0.99, 0.92, f"$t$ = {time:g} s", transform=panel.transAxes, ha="right", va="top", fontsize=8)
    if frame is None:
        panel.text(0.5, 0.45, f"no frame at $t$ = {time:g} s", transform=panel.transAxes, ha="center", color=style.GREY)
        return
    plot.outlines(panel, run.case)
    plot.squares(panel, frame, what.field, norm)
    plot.dots(panel, run, frame.time, what.points, named=time == what.times[0])


def finish_axes(panels, runs):
    """Tick labels on the outside only, the schemes above, axis names in metres."""
    for n, (panel, run) in enumerate(zip(panels[0], runs)):
        scheme = run.summary["scheme"]
        letter = f"({chr(ord('a') + n)}) " if len(runs) > 1 else ""
        panel.set_title(letter + SCHEME_TITLES.get(scheme, scheme), loc="left", pad=3)
    for row in panels:
        for panel in row:
            panel.xaxis.set_major_locator(MaxNLocator(8, steps=[1, 2, 5, 10]))
            panel.yaxis.set_major_locator(MaxNLocator(4, steps=[1, 2, 5, 10]))
            panel.tick_params(labelbottom=row is panels[-1], labelleft=panel is row[0])
        row[0].set_ylabel("y (m)")
    for panel in panels[-1]:
        panel.set_xlabel("x (m)")


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="python3 -m terp.sections",
                                     description="Draw a field over the cross-section.")
    parser.add_argument("runs", nargs="+", metavar="RUN", help="run folders, drawn side by side")
    parser.add_argument("-o", "--output", required=True, metavar="FILE",
                        help="where the figure goes, without extension")
    parser.add_argument("--field", default="eps_eq_p",
                        help="a field of the frames, or a component: stress.yy (default: eps_eq_p)")
    parser.add_argument("--times", nargs="+", type=float, help="times in s (default: first, middle and last frame)")
    parser.add_argument("--window", nargs=4, type=float, metavar=("X0", "Y0", "X1", "Y1"),
                        help="part to draw in m (default: all)")
    options = parser.parse_args(arguments)
    return exit_status(lambda: draw(options))


def draw(options):
    """What the command does."""
    runs = [Run(folder) for folder in options.runs]
    known = runs[0].times
    if not len(known):
        raise RunError(f"{runs[0].folder} has no frame yet")
    times = options.times or sorted({known[0], known[len(known) // 2], known[-1]})
    with style.house_style():
        figure, notes = draw_sections(runs, Section(options.field, tuple(times), window=options.window))
        if figure is None:
            raise RunError("; ".join(notes))
        written = style.save_figure(figure, Path(options.output))
    print(f"{written[0]} and .pdf")
    for note in notes:
        print(f"note: {note}")


if __name__ == "__main__":
    sys.exit(main())
