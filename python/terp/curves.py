"""Figures 6 to 9: strains and strength of the named points over time; (a) MPM-Mixed, (b) MPM-GP."""

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator

from terp import plot, style
from terp.pairs import SCHEME_TITLES, strengths

LEFT, RIGHT, GAP = 20.0, 2.5, 6.0              # margins and space between the columns [mm]
TOP, HEIGHT, ROW_GAP, BELOW = 10.5, 36.0, 5.0, 9.0  # legend and title, a panel, space between rows, tick labels [mm]


def draw_strain_curves(pair, names):
    """Figures 6 and 7: total deviatoric strain above, plastic deviatoric strain below; one scale for all four."""
    columns = ("eps_deviatoric", "eps_eq_p")
    figure, panels = lay_out(2, names)
    draw_rows(pair, panels, columns, names)
    end = 1.05 * max(largest(pair, column, names) for column in columns)
    for row, column in zip(panels, columns):
        finish_row(row, plot.label_of(pair.gp, column, in_two_lines=True), end)
    return figure, missing_points(pair, names)


def draw_strength_curves(pair, names):
    """Figure 8: undrained shear strength."""
    figure, panels = lay_out(1, names)
    draw_rows(pair, panels, ("su",), names)
    finish_strength_row(pair, panels[0])
    return figure, missing_points(pair, names)


def draw_strain_and_strength_curves(pair, names):
    """Figure 9: plastic deviatoric strain above, undrained shear strength below."""
    figure, panels = lay_out(2, names)
    draw_rows(pair, panels, ("eps_eq_p", "su"), names)
    end = 1.05 * largest(pair, "eps_eq_p", names)
    finish_row(panels[0], plot.label_of(pair.gp, "eps_eq_p", in_two_lines=True), end)
    finish_strength_row(pair, panels[1])
    return figure, missing_points(pair, names)


def lay_out(n_rows, names):
    """Figure with a legend of the points above, and panels [n_rows][2]."""
    width = (style.TWO_COLUMNS - LEFT - RIGHT - GAP) / 2
    figure = style.new_figure(style.TWO_COLUMNS, TOP + n_rows * HEIGHT + (n_rows - 1) * ROW_GAP + BELOW)
    panels = style.panel_grid(figure, (n_rows, 2), (LEFT, TOP), (width, HEIGHT), (GAP, ROW_GAP))
    for panel, scheme, letter in zip(panels[0], ("mpm_mixed", "mpm_gp"), "ab"):
        panel.set_title(f"({letter}) {SCHEME_TITLES[scheme]}", loc="left", pad=4)
    handles = [Line2D([], [], color=colour, ls=dashes, label=name)
               for name, (colour, dashes) in zip(names, style.lines_of(names))]
    figure.legend(handles=handles, loc="upper center", ncol=len(names), handlelength=3.2, columnspacing=1.8,
                  borderaxespad=0.2)
    return figure, panels


def draw_rows(pair, panels, columns, names):
    """Row r shows column r of history.csv."""
    for row, column in zip(panels, columns):
        for run, panel in zip(pair.runs, row):
            plot.history_lines(panel, run, column, [name for name in names if name in run.history_points])


def finish_row(row, label, end):
    """Same limits in both panels of a row; names and tick labels on the outside."""
    last = max((line.get_xdata().max() for panel in row for line in panel.lines), default=1.0)
    for panel in row:
        panel.set(xlim=(0, last), ylim=(0, end or 1.0))
        panel.xaxis.set_major_locator(MaxNLocator(5, steps=[1, 2, 5, 10]))
        panel.grid(color="#e4e4e4", lw=0.5)
        panel.set_axisbelow(True)
        bottom = panel in lowest_row(panel.figure)
        panel.tick_params(labelbottom=bottom)
        panel.set_xlabel("time (s)" if bottom else "")
    row[0].set_ylabel(label)
    row[0].yaxis.set_label_coords(-0.11, 0.5)
    row[1].tick_params(labelleft=False)


def lowest_row(figure):
    """The panels at the foot of the figure."""
    foot = min(panel.get_position().y0 for panel in figure.axes)
    return [panel for panel in figure.axes if panel.get_position().y0 < foot + 1e-6]


def finish_strength_row(pair, row):
    """As finish_row, with the peak and the residual strength as thin lines."""
    peak, residual = (style.in_print("Pa")[0] * strength for strength in strengths(pair.gp))
    finish_row(row, plot.label_of(pair.gp, "su", in_two_lines=True), 1.12 * peak)
    for panel in row:
        for value in {peak, residual}:
            panel.axhline(value, color=style.GREY, lw=0.6, zorder=1)
    end = row[1].get_xlim()[1]
    row[1].annotate(r"$S_{u,p}$", (end, peak), (-1, 1.5), textcoords="offset points", ha="right", va="bottom",
                    color=style.GREY, fontsize=7.5)
    row[1].annotate(r"$S_{u,r}$", (end, residual), (-1, -1.5), textcoords="offset points", ha="right", va="top",
                    color=style.GREY, fontsize=7.5)


def largest(pair, column, names):
    """Largest finite value of a history column over the named points of both runs."""
    values = np.concatenate([run.history[column][np.isin(run.history["point"], list(names))] for run in pair.runs])
    return np.max(values, where=np.isfinite(values), initial=0.0)


def missing_points(pair, names):
    """One sentence for each run whose history lacks a point or ends before the case does."""
    notes = []
    for run in pair.runs:
        absent = [name for name in names if name not in run.history_points]
        if absent:
            notes.append(f"{run.folder / 'history.csv'} has no point {', '.join(absent)}")
        end = run.case.get("time", {}).get("end")
        last = run.history["time"].max(initial=0.0)
        if end and last < end - 0.05:
            notes.append(f"{run.folder / 'history.csv'} ends at t = {last:g} s, the case at {end:g} s")
    return notes
