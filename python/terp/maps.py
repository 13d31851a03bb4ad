"""Figures 2 to 5: the deformed body, coloured by a strain, at the paper's times; (a) MPM-Mixed, (b) MPM-GP."""

import dataclasses

import numpy as np
from matplotlib import patheffects
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from terp import style
from terp.pairs import SCHEME_TITLES

TIME_TOLERANCE = 0.01  # a frame this near to the wanted time counts as of that time [s]
STRAINED = 0.06        # strain that counts as having sheared: 95 % of the softening of the paper's soil
QUANTILE = 0.75        # of the strain of the sheared points in the last frame, where the colour scale ends: the thin
                       # basal layer shears ten times as much as the slip surfaces and would leave those dark
SIDES = (2.0, 1.15)    # of a square over the lattice spacing: the large ones lie below, in the gaps of stretched soil
SAMPLE = 200           # points whose neighbours are measured to find the lattice spacing

LEFT, RIGHT, GAP = 9.0, 2.5, 4.0          # margins and space between the columns [mm]
TOP, ROW_GAP, BELOW, BAR, BAR_TEXT = 5.0, 2.2, 9.5, 2.6, 12.0  # title, between rows, x axis, bar, its text [mm]


@dataclasses.dataclass(frozen=True)
class MapFigure:
    """What one such figure shows."""

    field: str          # "eps_deviatoric" or "eps_eq_p"
    label: str          # of the colour bar
    times: tuple        # [s], one row each
    points: str = ""    # names of the points drawn as dots
    limit: float = None  # end of the colour scale; None: from the frames


def draw_map_figure(pair, what):
    """The figure, or None if neither run has a frame at any of the times; and a list of notes on what is missing."""
    frames = [[frame_at(run, time) for run in pair.runs] for time in what.times]
    notes = missing_frames(pair, what.times, frames)
    rows = [(time, row) for time, row in zip(what.times, frames) if any(row)]
    if not rows:
        return None, notes
    present = [frame for _, row in rows for frame in row if frame]
    limits = body_limits(present)
    last = [next(filter(None, column), None) for column in zip(*(row for _, row in reversed(rows)))]
    values_end = what.limit or colour_limit(last, what.field)
    norm = Normalize(0.0, values_end)
    figure, panels, bar = lay_out(len(rows), limits)
    for (time, row), row_panels in zip(rows, panels):
        for run, frame, panel in zip(pair.runs, row, row_panels):
            fill_panel(panel, time, run, frame, what, norm)
    finish_axes(panels)
    over = any(np.nanmax(frame[what.field]) > values_end for frame in present)
    figure.colorbar(ScalarMappable(norm, style.STRAIN_MAP), cax=bar, orientation="horizontal", label=what.label,
                    extend="max" if over else "neither", ticks=style.scale_ticks(values_end))
    return figure, notes


def frame_at(run, time):
    """The frame of `time` [s], or None if the run has none."""
    if len(run.times) == 0:
        return None
    frame = run.frame(run.at(time))
    return frame if abs(frame.time - time) <= TIME_TOLERANCE else None


def missing_frames(pair, times, frames):
    """One sentence for each run that lacks a frame."""
    notes = []
    for column, run in enumerate(pair.runs):
        missing = [f"{time:g}" for time, row in zip(times, frames) if row[column] is None]
        if missing:
            end = f"its last frame is at {run.times[-1]:g} s" if len(run.times) else "it has no frame at all"
            notes.append(f"{run.folder} has no frame at t = {', '.join(missing)} s ({end})")
    return notes


def body_limits(frames):
    """Axes limits that hold every point of every frame, from (0, 0): x end, y end [m]."""
    x_end = max(frame.x[:, 0].max() for frame in frames)
    y_end = max(frame.x[:, 1].max() for frame in frames)
    return np.ceil(x_end * 2 + 0.2) / 2, np.ceil(y_end * 10 + 0.5) / 10


def colour_limit(frames, field):
    """End of the colour scale: the upper quartile of the strain of the points that have sheared, rounded up; None frames are left out."""
    values = np.concatenate([frame[field] for frame in frames if frame])
    values = values[np.isfinite(values)]
    sheared = values[values > STRAINED]
    if len(sheared):
        return style.round_up(np.quantile(sheared, QUANTILE))
    return style.round_up(values.max() or 1.0) if len(values) else 1.0


def lay_out(n_rows, limits):
    """Figure, panels [n_rows][2] with equal aspect, and the axes of the colour bar."""
    width = (style.TWO_COLUMNS - LEFT - RIGHT - GAP) / 2
    height = width * limits[1] / limits[0]
    bar_top = TOP + n_rows * (height + ROW_GAP) + BELOW
    figure = style.new_figure(style.TWO_COLUMNS, bar_top + BAR + BAR_TEXT)
    panels = [[style.add_panel(figure, LEFT + column * (width + GAP), TOP + row * (height + ROW_GAP), width, height)
               for column in range(2)] for row in range(n_rows)]
    for panel in sum(panels, []):
        panel.set(xlim=(0, limits[0]), ylim=(0, limits[1]))
    bar = style.add_panel(figure, style.TWO_COLUMNS * 0.27, bar_top, style.TWO_COLUMNS * 0.46, BAR)
    return figure, panels, bar


def fill_panel(panel, time, run, frame, what, norm):
    """One body at one time, its points and the time."""
    panel.text(0.99, 0.92, f"$t$ = {time:g} s", transform=panel.transAxes, ha="right", va="top", fontsize=8)
    if frame is None:
        panel.text(0.5, 0.45, f"no frame at $t$ = {time:g} s", transform=panel.transAxes, ha="center", color=style.GREY)
        return
    draw_body(panel, frame, run, what.field, norm)
    draw_points(panel, run, frame.time, what.points, named=time == what.times[0])


def draw_body(panel, frame, run, field, norm):
    """Every material point as a square of about the lattice spacing, over the outline of the body at rest."""
    start = run.field("x", 0)
    spacing = lattice_spacing(start)
    corner = start.max(axis=0) + spacing / 2
    panel.plot([0, corner[0], corner[0]], [corner[1], corner[1], 0], color=style.GREY, lw=0.5, ls=(0, (4, 2)), zorder=1)
    x_begin, x_end = panel.get_xlim()
    width = panel.get_position().width * panel.figure.get_size_inches()[0] * 72.0
    for side in np.array(SIDES) * spacing * width / (x_end - x_begin):  # [pt]
        panel.scatter(frame.x[:, 0], frame.x[:, 1], s=side**2, c=frame[field], cmap=style.STRAIN_MAP, norm=norm,
                      marker="s", linewidths=0, antialiased=False, rasterized=True, zorder=2)


def draw_points(panel, run, time, names, named):
    """The named points as black dots with a white rim, at their places at `time`; their names if `named`."""
    above = True
    for name, x, y in places_at(run, time, names):
        panel.plot(x, y, "o", ms=2.6, mfc="black", mec="white", mew=0.45, zorder=4, clip_on=False)
        if named:
            label = panel.annotate(name, (x, y), (0, 3.0 if above else -3.2), textcoords="offset points", ha="center",
                                   va="bottom" if above else "top", fontsize=7, color="white", zorder=5)
            label.set_path_effects([patheffects.withStroke(linewidth=1.2, foreground="black")])
        above = not above


def places_at(run, time, names):
    """(name, x, y) of the named points at `time` [s], from history.csv; points it lacks are left out."""
    places = []
    for name in names:
        if name in run.history_points:
            rows = run.history_of(name)
            places.append((name, np.interp(time, rows["time"], rows["x"]), np.interp(time, rows["time"], rows["y"])))
    return places


def lattice_spacing(x):
    """Usual distance of a point to its nearest neighbour [m]; x has shape [n_points, 2]."""
    if len(x) < 2:
        return 0.02
    sample = x[np.linspace(0, len(x) - 1, min(SAMPLE, len(x))).astype(int)]
    distances = [np.partition(np.hypot(*(x - place).T), 1)[1] for place in sample]
    return float(np.median(distances))


def finish_axes(panels):
    """Tick labels on the outside only, titles above, axis names in metres."""
    for panel, scheme, letter in zip(panels[0], ("mpm_mixed", "mpm_gp"), "ab"):
        panel.set_title(f"({letter}) {SCHEME_TITLES[scheme]}", loc="left", pad=3)
    for panel in sum(panels, []):
        panel.set_xticks(np.arange(0, panel.get_xlim()[1] + 0.01, 2))
        panel.set_yticks(np.arange(0, panel.get_ylim()[1] + 0.01, 1))
        panel.tick_params(labelbottom=panel in panels[-1], labelleft=panel in [row[0] for row in panels])
    for panel in panels[-1]:
        panel.set_xlabel("x (m)")
    for row in panels:
        row[0].set_ylabel("y (m)")
