"""How the figures look: sizes in print, fonts, colours, line styles, and how a figure is laid out and saved.

Everything is placed in millimetres of print, so that text and lines have the stated size on paper.
"""

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import matplotlib
from matplotlib.figure import Figure

TWO_COLUMNS = 175.0  # width of a figure over both columns of the page [mm]
POINTS_PER_MM = 72.0 / 25.4
PNG_DPI = 220
PDF_DPI = 600  # of what is rasterised inside the PDF

# Colours of Okabe and Ito (2008), told apart with any colour vision; the dashes tell them apart without colour.
LINES = {
    "A": ("#000000", "-"), "B": ("#E69F00", (0, (6, 1.6))), "C": ("#56B4E9", "-"), "D": ("#009E73", (0, (2.4, 1.2))),
    "E": ("#D55E00", (0, (6, 1.4, 1.2, 1.4))), "F": ("#0072B2", (0, (1.1, 1.1))),
    "G": ("#000000", "-"), "H": ("#D55E00", (0, (6, 1.6))), "I": ("#0072B2", (0, (2.4, 1.2))),
    "J": ("#E69F00", (0, (6, 1.4, 1.2, 1.4))),
}
COLOURS = ("#000000", "#D55E00", "#0072B2", "#009E73", "#E69F00", "#56B4E9")
OTHER_LINES = [(colour, dashes) for dashes in ("-", (0, (4, 1.4))) for colour in COLOURS]
COLOUR_MAP = "viridis"

GREY = "#6b6b6b"
NO_VALUE = "#c9ced3"    # of points whose material lacks the field

RC = {
    "font.family": "sans-serif", "font.size": 8, "axes.labelsize": 8, "axes.titlesize": 8.5,
    "xtick.labelsize": 7.5, "ytick.labelsize": 7.5, "legend.fontsize": 8, "mathtext.fontset": "dejavusans",
    "axes.linewidth": 0.6, "xtick.major.width": 0.6, "ytick.major.width": 0.6, "xtick.major.size": 2.4,
    "ytick.major.size": 2.4, "xtick.major.pad": 2.2, "ytick.major.pad": 2.2, "axes.labelpad": 2.5,
    "axes.spines.top": False, "axes.spines.right": False, "lines.linewidth": 1.2, "lines.dash_capstyle": "butt",
    "legend.frameon": False, "hatch.linewidth": 0.5, "pdf.fonttype": 42,
}

INCREMENTS = r"$\sum\sqrt{\frac{1}{2}\,\mathrm{d}\mathbf{e}_p:\mathrm{d}\mathbf{e}_p}$"


def words_of(name: str) -> tuple[str, str, str]:
    """(words, symbol, definition) of a quantity, with the norm of a strain (Eq. (6)); of others the name alone."""
    known = {"eps_deviatoric": ("total deviatoric strain", r"$\sqrt{\frac{1}{2}\,\mathbf{e}:\mathbf{e}}$", ""),
             "eps_eq_p": ("plastic deviatoric strain", r"$\varepsilon_{eq,p}$", f" = {INCREMENTS}"),
             "su": ("undrained shear strength", "$S_u$", "")}
    return known.get(name, (name, "", ""))


def lines_of(names: Sequence[str]) -> list[tuple[str, Any]]:
    """(colour, dashes) of the line of each name: those of the paper's points if these are unique, else others."""
    own = [LINES.get(name) for name in names]
    plain = [OTHER_LINES[n % len(OTHER_LINES)] for n in range(len(own))]
    known = [line for line in own if line is not None]
    return known if len(known) == len(own) == len(set(known)) else plain


def in_print(unit: str) -> tuple[float, str]:
    """(factor, unit) in which a quantity of this SI unit is printed: stress in kPa, energy in kJ."""
    return {"Pa": (1e-3, "kPa"), "J per m": (1e-3, "kJ per m")}.get(unit, (1.0, unit))


def new_figure(width: float, height: float) -> Figure:
    """An empty figure of this size in print [mm]."""
    return Figure(figsize=(width / 25.4, height / 25.4))


def add_panel(figure: Figure, left: float, top: float, width: float, height: float) -> Any:
    """Axes whose upper left corner lies `left` and `top` mm from that of the figure [mm]."""
    w, h = (size * 25.4 for size in figure.get_size_inches())
    return figure.add_axes([left / w, 1 - (top + height) / h, width / w, height / h])


def panel_grid(figure: Figure, shape: tuple[int, int], corner: tuple[float, float], size: tuple[float, float],
               gaps: tuple[float, float]) -> list[list[Any]]:
    """Panels [n_rows][n_columns]; corner: left, top of the first; size: width, height; gaps: columns, rows [mm]."""
    (left, top), (width, height), (gap, row_gap) = corner, size, gaps
    return [[add_panel(figure, left + column * (width + gap), top + row * (height + row_gap), width, height)
             for column in range(shape[1])] for row in range(shape[0])]


def save_figure(figure: Figure, path: Path) -> list[Path]:
    """Write PATH.png and PATH.pdf; the same input gives the same bytes. Returns both paths."""
    png, pdf = path.with_suffix(".png"), path.with_suffix(".pdf")
    figure.savefig(png, dpi=PNG_DPI, metadata={"Software": None})
    figure.savefig(pdf, dpi=PDF_DPI, metadata={"CreationDate": None})
    return [png, pdf]


def house_style() -> Any:
    """Context in which figures are drawn and saved."""
    return matplotlib.rc_context(RC)


def round_up(value: float) -> float:
    """The next number of the kind a colour bar ends well with: 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten."""
    if not value > 0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(value))
    steps = (1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10)
    return next(step * power for step in steps if value <= step * power * (1 + 1e-9))


def scale_ticks(end: float) -> list[float]:
    """Ticks from 0 to `end`, in steps of 1, 2 or 5 times a power of ten where that divides it."""
    for n in (5, 4, 6, 3):
        mantissa = end / n / 10.0 ** math.floor(math.log10(end / n) + 1e-9)
        if min(abs(mantissa - plain) for plain in (1, 2, 5)) < 1e-6:
            return [end * k / n for k in range(n + 1)]
    return [end * k / 5 for k in range(6)]
