"""Pictures of a run: a field, the named points, the ledger. Each call draws into axes of matplotlib and returns them.

    plot.field(run, "su", 2.5).figure.savefig("su.png")

The paper's figures are put together from the same parts (sections.py, curves.py).
"""

from __future__ import annotations

import os
import pathlib
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt
from matplotlib import patheffects
from matplotlib.animation import FuncAnimation, writers
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PathCollection, PolyCollection
from matplotlib.colors import Normalize
from matplotlib.markers import MarkerStyle
from matplotlib.transforms import Affine2D

from terp import style
from terp.errors import RunError, unknown
from terp.results import Frame, Results

if TYPE_CHECKING:
    from terp.run import Run
    from terp.simulation import Simulation
    from terp.studies import Study

STRAINED = 0.06        # strain that counts as having sheared: 95 % of the softening of the paper's soil
QUANTILE = 0.75        # of the strain of the sheared points in the last frame, where the colour scale ends: the thin
                       # basal layer shears ten times as much as the slip surfaces and would leave those dark
OUTLIERS = 0.01        # share of the points at either end of any other field that the colour scale leaves out
SIDES = (2.0, 1.15)    # of a square over the lattice spacing: the large ones lie below, in the gaps of stretched soil
BESIDE = {"loc": "center left", "bbox_to_anchor": (1.01, 0.5)}  # of the legend
SOILS = ("#d8c08a", "#9c8f7a", "#7a5c43", "#b7b08c", "#a9746e", "#8fa3ad", "#c7a27c", "#6f7f5f")
EVENTS = {"P_I": "P(I)", "P_F": "P(F)", "P_F_after_I": "P(F|I)"}
SAMPLE = 200           # points whose neighbours are measured to find the lattice spacing


def field(run: Results, name: str, time: float | None = None, panel: Any = None,
          limits: tuple[float, float] | None = None) -> Any:
    """A field of all material points at `time` [s] (default: the last frame), over the first outlines of the bodies.

    name: as Frame.scalar has it, e.g. "eps_eq_p", "stress.yy", "velocity". limits: of the colours, in the unit
    of the colour bar (stress in kPa). Points whose material has no such field are grey.
    """
    frame = run.frame(run.at(time) if time is not None else -1)
    norm = norm_of_limits(run, name, limits) if limits else colour_norm([frame], name)
    with style.house_style():
        place = {"ax": panel, "shrink": 0.6}
        if panel is None:
            panel, bar = section_page(window_around([frame.x[frame.soil], run.first_places, *body_outlines(run.case)]))
            place = {"cax": bar}
        outlines(panel, run.case)
        squares(panel, frame, name, norm)
        panel.set(xlabel="x (m)", ylabel="y (m)", title=f"$t$ = {frame.time:g} s")
        colour_bar(panel.figure, norm, [frame], name, **place)
    return panel


def history(run: Results, column: str, points: Sequence[str] | None = None, panel: Any = None) -> Any:
    """A column of history.csv over time, a line for each of the named points (default: all)."""
    with style.house_style():
        panel = panel or chart_page()
        history_lines(panel, run, column, points or run.history_points)
        panel.set(xlabel="time (s)", ylabel=label_of(run, column, in_two_lines=True))
        panel.legend(**BESIDE)
    return panel


def ledger(run: Results, columns: str | Sequence[str], panel: Any = None) -> Any:
    """Columns of ledger.csv over time, e.g. ["kinetic", "elastic", "plastic"]; all of one unit."""
    columns = [columns] if isinstance(columns, str) else list(columns)
    for column in columns:
        _check_column(column, run.ledger, run.place("ledger.csv"))
    if len({run.unit(column) for column in columns}) > 1:
        raise RunError("columns of one picture have one unit, not "
                       + ", ".join(f"{column} [{run.unit(column)}]" for column in columns))
    factor, unit = style.in_print(run.unit(columns[0]))
    with style.house_style():
        panel = panel or chart_page()
        for column, (colour, dashes) in zip(columns, style.lines_of(columns)):
            panel.plot(run.ledger["time"], factor * run.ledger[column], color=colour, ls=dashes, label=column)
        panel.set(xlabel="time (s)", ylabel=label_of(run, columns[0]) if len(columns) == 1 else f"({unit})")
        if len(columns) > 1:
            panel.legend(**BESIDE)
    return panel


def section(simulation: Simulation, panel: Any = None) -> Any:
    """The section of a run in memory: soils by colour, the cells of the mesh, outlines of the bodies."""
    names = list(simulation.case["material"])
    soil = simulation.soil
    numbers, x = simulation.field("material")[soil].astype(int), simulation.field("position")[soil]
    with style.house_style():
        panel = panel or section_page(window_around([simulation.nodes]), bar=False)[0]
        corners = simulation.nodes[simulation.cells]
        panel.add_collection(PolyCollection(corners, facecolors="none", edgecolors=style.GREY, linewidths=0.15,
                                            zorder=3))
        side = SIDES[0] * lattice_spacing(x) * points_per_metre(panel)
        for number in np.unique(numbers):
            here = numbers == number
            panel.scatter(*x[here].T, s=side**2, marker="s", linewidths=0, color=SOILS[number % len(SOILS)],
                          rasterized=True, zorder=2, label=names[number] if number < len(names) else str(number))
        outlines(panel, simulation.case)
        panel.set(xlabel="x (m)", ylabel="y (m)", title=simulation.case.title)
        panel.legend(loc="upper center", bbox_to_anchor=(0.5, -0.24), ncol=6, markerscale=4 / max(side, 1e-3))
    return panel


def fragility(study: Study, events: str | Sequence[str] = ("F_after_I",), panel: Any = None) -> Any:
    """Probabilities over the level of the load, with their bounds: of "I" (a slide), "F" (a flood), "F_after_I" (a
    flood where it slides). Of a study without a load, and as a line through the levels of one that is a water level:
    P(F|I) by the ground that the slides left (docs/probability.md)."""
    events = [events] if isinstance(events, str) else list(events)
    has_load = "levels" in study.results
    if not has_load and events != ["F_after_I"]:
        raise RunError(f"{study.folder} has no load: only F_after_I is known at other levels of the water")
    if not has_load and not study.results.get("flood_after_slide_over_level"):
        raise RunError(f"{study.folder} has no curve: nothing slid, or no water is judged (docs/flood.md)")
    with style.house_style():
        panel = panel or chart_page()
        for event, (colour, dashes) in zip(events, style.lines_of(events)):
            if f"P_{event}" not in EVENTS:
                raise unknown(event, [name[2:] for name in EVENTS], "event", study.folder)
            look = {"color": colour, "ls": dashes, "label": EVENTS[f"P_{event}"]}
            if event == "F_after_I" and study.results.get("flood_after_slide_over_level"):
                curve = study.over_level
                panel.fill_between(curve["level"], curve["low"], curve["high"], color=colour, alpha=0.15, linewidth=0)
                panel.plot(curve["level"], curve["P"], **look)
                look = {"color": colour, "ls": "none"}
            if has_load:
                levels = study.levels[np.isfinite(study.levels[f"P_{event}"])]
                p, low, high = (levels[f"P_{event}{end}"] for end in ("", "_low", "_high"))
                panel.errorbar(levels["level"], p, [p - low, high - p], marker="o", ms=3, elinewidth=0.6, **look)
        panel.set(xlabel=study.results["load"] if has_load else "level of the water (m)", ylabel="probability",
                  ylim=(-0.03, 1.03))
        if panel.get_legend_handles_labels()[1]:
            panel.legend(**BESIDE)
    return panel


def convergence(sequences: Sequence[Mapping[str, Any]], quantity: str, panel: Any = None) -> Any:
    """A quantity over the size of the cells, a line for each sequence of convergence.json; dashed: its limit."""
    with style.house_style():
        panel = panel or chart_page()
        for sequence, (colour, dashes) in zip(sequences, style.lines_of([s["name"] for s in sequences])):
            for found in sequence["quantities"]:
                if found["name"] != quantity:
                    continue
                sizes = [run["size"] for run in sequence["runs"]]
                panel.plot(sizes, np.array(found["values"], float), "o", color=colour, ls=dashes, ms=3,
                           label=sequence["name"])
                if found["limit"] is not None:
                    panel.axhline(found["limit"], color=colour, ls="--", lw=0.6)
                unit = "" if found["unit"] == "-" else f" ({found['unit']})"
                panel.set(xlabel="size of the cells (m)", ylabel=found["label"] + unit)
        panel.set_xlim(left=0)
        panel.legend(**BESIDE)
    return panel


def animate(run: Run, name: str, file: str | os.PathLike[str] | None = None, limits: tuple[float, float] | None = None,
            every: int = 1, per_second: float = 10, dpi: int = 120) -> Film:
    """The frames of a run as a film of a field, with one colour bar for all.

    file: a path that ends in .gif (by python3-pil) or .mp4 (by ffmpeg); without it the film shows itself in a
    notebook. limits: as of field(). every: of the frames only each so many; per_second: frames of the film.
    """
    frames = [run.frame(k) for k in range(0, len(run.times), every)]
    if not frames:
        raise RunError(f"{run.place()} holds no frame")
    norm = norm_of_limits(run, name, limits) if limits else colour_norm(frames, name)
    with style.house_style():
        panel, bar = section_page(window_around([*(frame.x[frame.soil] for frame in frames), *body_outlines(run.case)]))
        colour_bar(panel.figure, norm, frames, name, cax=bar)
        outlines(panel, run.case)
        panel.set(xlabel="x (m)", ylabel="y (m)")
    moving: list[Any] = []

    def draw(frame: Frame) -> list[Any]:
        for artist in moving:
            artist.remove()
        before = set(panel.collections)
        squares(panel, frame, name, norm)
        moving[:] = [artist for artist in panel.collections if artist not in before]
        panel.set_title(f"$t$ = {frame.time:.2f} s")
        return moving

    film = Film(panel.figure, draw, frames=frames, interval=1000.0 / per_second, blit=False)
    if file is not None:
        film.save(file, writer=_writer_of(file, per_second), dpi=dpi)
    return film


class Film(FuncAnimation):  # type: ignore[misc]
    """A film, which a notebook shows with buttons."""

    def _repr_html_(self) -> str:
        return str(self.to_jshtml())


def _writer_of(file: str | os.PathLike[str], per_second: float) -> Any:
    kind = pathlib.Path(file).suffix
    if kind not in (".gif", ".mp4"):
        raise ValueError(f"a film ends in .gif or .mp4, not `{kind}`")
    writer = "pillow" if kind == ".gif" else "ffmpeg"
    if not writers.is_available(writer):
        raise RunError(f"{file} needs {'python3-pil' if kind == '.gif' else 'ffmpeg'}, which is not there: "
                       "sudo apt install it, or give a .gif")
    return writers[writer](fps=per_second)


# Parts of a picture


def chart_page() -> Any:
    """Axes for lines over time in a figure of their own, with room for the legend beside them."""
    return style.add_panel(style.new_figure(130.0, 62.0), 21.0, 3.0, 85.0, 48.0)


def section_page(window: Sequence[float], bar: bool = True) -> tuple[Any, Any]:
    """Axes of a new figure that show a window x0, y0, x1, y1 [m] with equal aspect, and those of its colour bar."""
    width = style.TWO_COLUMNS - 16.0
    height = width * (window[3] - window[1]) / (window[2] - window[0])
    figure = style.new_figure(style.TWO_COLUMNS, height + (31.0 if bar else 25.0))
    panel = style.add_panel(figure, 13.0, 6.0, width, height)
    panel.set(xlim=window[::2], ylim=window[1::2])
    if not bar:
        return panel, None
    return panel, style.add_panel(figure, 13.0 + 0.25 * width, height + 16.5, 0.5 * width, 2.6)


def squares(panel: Any, frame: Frame, name: str, norm: Normalize) -> None:
    """The soil: every material point as a square of about the lattice spacing, coloured by a field; grey where it has
    none."""
    spacing = lattice_spacing(frame.run.first_places)
    values, x = frame.scalar(name)[frame.soil], frame.x[frame.soil]
    here = np.isfinite(values)
    coloured = Squares(panel, x[here], spacing, cmap=style.COLOUR_MAP, norm=norm)
    coloured.set_array(values[here])
    grey = Squares(panel, x[~here], spacing, facecolors=[style.NO_VALUE])
    for drawn in [coloured] if here.all() else [grey, coloured]:
        panel.add_collection(drawn, autolim=False)
    if len(x):
        panel.update_datalim([x.min(axis=0), x.max(axis=0)])
        panel.autoscale_view()


class Squares(PathCollection):  # type: ignore[misc]
    """Squares in the order of SIDES, as one image of the pixels of the panel: matplotlib draws so many one by one."""

    def __init__(self, panel: Any, x: npt.NDArray[np.float64], spacing: float, **look: Any) -> None:
        sides = np.array(SIDES) * spacing * points_per_metre(panel)
        super().__init__([MarkerStyle("s").get_path()], sides[:1]**2, offsets=x, offset_transform=panel.transData,
                         linewidths=0, zorder=2, **look)
        self.spacing = spacing

    def draw(self, renderer: Any) -> None:
        if not self.get_visible() or not len(self.get_offsets()):
            return
        self.update_scalarmappable()
        box, pixels = self.axes.bbox, renderer.get_image_magnification()
        to_pixels = self.get_offset_transform() + Affine2D().translate(-box.x0, -box.y0).scale(pixels)
        places = to_pixels.transform(self.get_offsets())
        spacing = self.spacing * abs(to_pixels.transform([(1.0, 0.0)]) - to_pixels.transform([(0.0, 0.0)]))[0, 0]
        colours = (255 * self.get_facecolor()).round().astype(np.uint8).view(np.uint32)[:, 0]  # one, or of each
        image = np.zeros((round(box.height * pixels), round(box.width * pixels)), np.uint32)
        for side in SIDES:
            _stamp(image, places, colours, max(1, round(side * spacing)))
        context = renderer.new_gc()
        self._set_gc_clip(context)
        renderer.draw_image(context, round(box.x0), round(box.y0), image.view(np.uint8).reshape(*image.shape, 4))
        context.restore()
        self.stale = False


def _stamp(image: npt.NDArray[np.uint32], places: npt.NDArray[np.float64], colours: npt.NDArray[np.uint32],
           side: int) -> None:
    """Squares of `side` pixels around places; a pixel has the colour of a place that is near."""
    height, width = image.shape
    corner = np.floor(places - (side - 1) / 2).astype(int) + side
    inside = ((corner >= 0) & (corner < (width + side, height + side))).all(axis=1)
    padded = np.zeros((height + 2 * side, width + 2 * side), np.uint32)
    padded[side:-side, side:-side] = image
    first = corner[inside] @ (1, padded.shape[1])
    colours = colours[inside] if len(colours) > 1 else colours
    offsets = np.stack(np.meshgrid(range(side), range(side)), axis=-1).reshape(-1, 2)
    for offset in offsets[np.argsort(-np.abs(offsets - (side - 1) / 2).max(axis=1), kind="stable")]:
        padded.reshape(-1)[first + offset @ (1, padded.shape[1])] = colours
    image[:] = padded[side:-side, side:-side]


def points_per_metre(panel: Any) -> float:
    """Typographic points on paper of a metre along x."""
    x_begin, x_end = panel.get_xlim()
    return float(panel.get_position().width * panel.figure.get_size_inches()[0] * 72.0 / (x_end - x_begin))


def outlines(panel: Any, case: Mapping[str, Any]) -> None:
    """The bodies of the case at the start, as thin dashed lines."""
    for polygon in body_outlines(case):
        closed = np.vstack([polygon, polygon[:1]])
        panel.plot(closed[:, 0], closed[:, 1], color=style.GREY, lw=0.4, ls=(0, (4, 2)), zorder=3)


def history_lines(panel: Any, run: Results, column: str, names: Sequence[str]) -> None:
    """A column of history.csv over time, a line for each of the points `names`."""
    _check_column(column, run.history, run.place("history.csv"))
    for name, (colour, dashes) in zip(names, style.lines_of(names)):
        rows = run.history_of(name)
        panel.plot(rows["time"], style.in_print(run.unit(column))[0] * rows[column], color=colour, ls=dashes,
                   label=name)


def dots(panel: Any, run: Results, time: float, names: Iterable[str], named: bool) -> None:
    """The named points as black dots with a white rim, at their places at `time`; their names if `named`."""
    above = True
    for name, x, y in places_at(run, time, names):
        panel.plot(x, y, "o", ms=2.6, mfc="black", mec="white", mew=0.45, zorder=4, clip_on=False)
        if named:
            label = panel.annotate(name, (x, y), (0, 3.0 if above else -3.2), textcoords="offset points", ha="center",
                                   va="bottom" if above else "top", fontsize=7, color="white", zorder=5)
            label.set_path_effects([patheffects.withStroke(linewidth=1.2, foreground="black")])
        above = not above


def colour_bar(figure: Any, norm: Normalize, frames: Sequence[Frame], name: str, label: str | None = None,
               **place: Any) -> Any:
    """A horizontal colour bar with a pointed end where values lie beyond it."""
    factor, _ = style.in_print(frames[0].run.unit(name))
    values = [frame.scalar(name)[frame.soil] for frame in frames]
    below, above = any((v < norm.vmin).any() for v in values), any((v > norm.vmax).any() for v in values)
    extend = {(False, False): "neither", (True, False): "min", (False, True): "max", (True, True): "both"}[below, above]
    ticks = style.scale_ticks(norm.vmax) if norm.vmin == 0 else None
    bar = figure.colorbar(ScalarMappable(norm, style.COLOUR_MAP), orientation="horizontal", extend=extend, ticks=ticks,
                          label=label or label_of(frames[0].run, name), **place)
    if factor != 1.0:
        bar.ax.xaxis.set_major_formatter(lambda value, _: f"{factor * value:g}")
    return bar


# What the data say about a picture


def body_outlines(case: Mapping[str, Any]) -> list[npt.NDArray[np.float64]]:
    """Polygons of the bodies of a case that are there from the start, shape [n, 2] each [m]; boxes too."""
    placed_later = {name for stage in case.get("stage", []) for name in stage.get("place", [])}
    polygons = []
    for body in case.get("body", []):
        if body.get("name") in placed_later:
            continue
        if "polygon" in body:
            polygons.append(np.asarray(body["polygon"], dtype=float))
        elif "box" in body:
            (x0, y0), (x1, y1) = body["box"]
            polygons.append(np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], dtype=float))
    return polygons


def window_of(frames: Sequence[Frame]) -> tuple[float, ...]:
    """Limits around the soil of every frame [m]: x0, y0, x1, y1; outward to half metres in x, tenths in y."""
    return window_around([frame.x[frame.soil] for frame in frames])


def window_around(places: Sequence[npt.NDArray[np.float64]]) -> tuple[float, ...]:
    """The same around places, shape [n, 2] each."""
    steps = np.array([0.5, 0.1])
    x = np.concatenate(places)
    low, high = x.min(axis=0), x.max(axis=0)
    return (*np.floor(low / steps) * steps, *np.ceil(high / steps + (0.2, 0.5)) * steps)


def norm_of_limits(run: Results, name: str, limits: tuple[float, float]) -> Normalize:
    """A colour scale between two values in the unit of the colour bar."""
    factor, _ = style.in_print(run.unit(name))
    return Normalize(*(limit / factor for limit in limits))


def without_value(frames: Sequence[Frame], name: str) -> list[str]:
    """Names of the materials whose points have no value of a field in these frames.

    "some points" where the run has no field `material`.
    """
    lacking: set[str] = set()
    for frame in frames:
        lacks = frame.soil & ~np.isfinite(frame.scalar(name))
        if "material" in frame.run.units:
            names = list(frame.run.case["material"])
            lacking.update(names[int(k)] for k in np.unique(frame.scalar("material")[lacks]))
        elif lacks.any():
            lacking.add("some points")
    return sorted(lacking)


def colour_norm(frames: Sequence[Frame], name: str) -> Normalize:
    """A colour scale for a field of these frames, with plain numbers at its ends.

    A strain goes from 0 to the upper quartile of the points that have sheared; any other field leaves out its outliers.
    """
    values = np.concatenate([frame.scalar(name)[frame.soil] for frame in frames])
    values = values[np.isfinite(values)]
    if not len(values):
        return Normalize(0.0, 1.0)
    if name.startswith("eps_"):
        sheared = values[values > STRAINED]
        return Normalize(0.0, style.round_up(np.quantile(sheared, QUANTILE) if len(sheared) else values.max() or 1.0))
    low, high = np.quantile(values, (OUTLIERS, 1.0 - OUTLIERS))
    return Normalize(-style.round_up(-low) if low < 0 else 0.0,
                     style.round_up(high) if high > 0 else 0.0 if low < 0 else 1.0)


def lattice_spacing(x: npt.NDArray[np.float64]) -> float:
    """Usual distance of a point to its nearest neighbour [m]; x has shape [n_points, 2]."""
    if len(x) < 2:
        return 0.02
    sample = x[np.linspace(0, len(x) - 1, min(SAMPLE, len(x))).astype(int)]
    x = x[np.argsort(x[:, 0])]
    reach = 4.0 * np.sqrt(np.prod(np.ptp(x, axis=0)) / len(x))  # some spacings: further points are looked at if need be
    return float(np.median([_to_nearest(x, place, reach) for place in sample]))


def _to_nearest(x: npt.NDArray[np.float64], place: npt.NDArray[np.float64], reach: float) -> float:
    """Distance of the point at `place` to the nearest other of x, which ascends along its first column."""
    first, last = np.searchsorted(x[:, 0], (place[0] - reach, place[0] + reach))
    distances = np.hypot(*(x[first:last] - place).T)
    nearest = np.partition(distances, 1)[1] if last - first > 1 else np.inf
    return float(nearest) if nearest <= reach else float(np.partition(np.hypot(*(x - place).T), 1)[1])


def places_at(run: Results, time: float, names: Iterable[str]) -> list[tuple[str, float, float]]:
    """(name, x, y) of the named points at `time` [s], from history.csv; points it lacks are left out."""
    places = []
    for name in names:
        if name in run.history_points:
            rows = run.history_of(name)
            x, y = (float(np.interp(time, rows["time"], rows[axis])) for axis in "xy")
            places.append((name, x, y))
    return places


def label_of(run: Results, name: str, in_two_lines: bool = False) -> str:
    """A field or column in words, its symbol, its unit in print; in one line also how it is defined."""
    words, symbol, definition = style.words_of(name)
    unit = style.in_print(run.unit(name))[1]
    if symbol:
        words += f"\n{symbol}" if in_two_lines else f"  {symbol}{definition}"
    return words + (f" ({unit})" if unit != "-" else "")


def _check_column(column: str, table: npt.NDArray[Any], path: str) -> None:
    if column not in (table.dtype.names or ()):
        raise unknown(column, table.dtype.names or (), "column", path)
