"""Figure 1: the body in its background mesh, the boundary conditions and the named points, all from the case."""

import numpy as np
from matplotlib.patches import Circle, ConnectionPatch, Polygon, Rectangle

from terp import plot, style
from terp.errors import RunError

LEFT, RIGHT, TOP, BELOW = 9.0, 2.5, 1.0, 8.0  # margins [mm]
WALL = 0.32            # room for the walls' symbols around the mesh [m of the drawing]
SOIL, MESH, INK = "#ead9b5", "#cfcfcf", "#222222"


def draw_geometry(pair):
    """The figure and an empty list of notes."""
    case = pair.gp.case
    require_rectangle(pair.gp)
    box = mesh_box(case)
    figure, panel = lay_out(box)
    draw_mesh(panel, case, box)
    corners = plot.body_outlines(case)[0]
    draw_soil(panel, corners)
    for side in ("left", "right", "bottom", "top"):
        draw_side(panel, box, side, case.get("boundary", {}).get(side, "free"))
    draw_dimensions(panel, corners, box)
    draw_named_points(panel, named_points(pair.gp), corners)
    draw_cell_inset(panel, case, corners, box)
    return figure, []


def require_rectangle(run):
    """Figure 1 draws a rectangular mesh and a body given in the case."""
    mesh = run.case.get("mesh", {})
    missing = [f"`{key}` in [mesh]" for key in ("size", "cell") if key not in mesh]
    missing += [] if run.case.get("body") else ["[[body]]"]
    if missing:
        raise RunError(f"figure 1 needs {' and '.join(missing)}, which the case of {run.folder} does not give")


def mesh_box(case):
    """Corners of the background mesh [m]: x0, y0, x1, y1."""
    (x0, y0), (width, height) = case["mesh"].get("origin", (0.0, 0.0)), case["mesh"]["size"]
    return x0, y0, x0 + width, y0 + height


def cell_size(case):
    """Width and height of a cell [m]."""
    return np.broadcast_to(np.asarray(case["mesh"]["cell"], dtype=float), 2)


def named_points(run):
    """(name, x, y) [m]: as the case wishes them, else where history.csv starts."""
    wished = run.case.get("output", {}).get("history", {}).get("points", {})
    if wished:
        return [(name, *place) for name, place in wished.items()]
    starts = [run.history_of(name)[0] for name in run.history_points]
    return [(row["point"], row["x"], row["y"]) for row in starts]


def lay_out(box):
    """Figure over both columns and one panel with equal aspect, in metres."""
    x0, y0, x1, y1 = box[0] - WALL, box[1] - 2.2 * WALL, box[2] + WALL, box[3] + 0.15
    width = style.TWO_COLUMNS - LEFT - RIGHT
    height = width * (y1 - y0) / (x1 - x0)
    figure = style.new_figure(style.TWO_COLUMNS, TOP + height + BELOW)
    panel = style.add_panel(figure, LEFT, TOP, width, height)
    panel.set(xlim=(x0, x1), ylim=(y0, y1), xlabel="x (m)", ylabel="y (m)", aspect="equal",
              xticks=np.arange(box[0], box[2] + 0.01, 2), yticks=np.arange(box[1], box[3] + 0.01, 1))
    panel.spines[["left", "bottom"]].set_visible(False)
    return figure, panel


def draw_mesh(panel, case, box):
    """The lines of the background mesh."""
    dx, dy = cell_size(case)
    panel.vlines(np.arange(box[0], box[2] + dx / 2, dx), box[1], box[3], color=MESH, lw=0.2, zorder=2)
    panel.hlines(np.arange(box[1], box[3] + dy / 2, dy), box[0], box[2], color=MESH, lw=0.2, zorder=2)


def draw_soil(panel, corners):
    panel.add_patch(Polygon(corners, facecolor=SOIL, edgecolor="none", zorder=1))
    panel.add_patch(Polygon(corners, facecolor="none", edgecolor=INK, lw=0.9, zorder=3))


def describe_side(side):
    """(kind, words) of one side of the mesh: kind is "roller", "contact", "free" or "other"."""
    if isinstance(side, str):
        return (side if side in ("roller", "free") else "other"), side
    if "contact" in side:
        adhesion, friction = side.get("adhesion", 0.0), side.get("friction", 0.0)
        words = ["contact", f"adhesion {adhesion / 1e3:g} kPa"] + ([f"friction {friction:g}"] if friction else [])
        return "contact", ", ".join(words)
    return "other", ", ".join(f"{key} {value}" for key, value in side.items())


def draw_side(panel, box, side, condition):
    """A hatched wall; circles in front of it where the soil may slide freely."""
    kind, words = describe_side(condition)
    if kind == "free":
        return
    gap = 0.13 if kind == "roller" else 0.0  # m of the drawing, for the circles
    wall_rectangle(panel, box, side, gap)
    if kind == "roller":
        for x, y in roller_places(box, side, gap):
            panel.add_patch(Circle((x, y), gap / 2, facecolor="white", edgecolor=INK, lw=0.6, zorder=4))
    name_side(panel, box, side, words)


def wall_rectangle(panel, box, side, gap):
    """The wall's hatching and its face."""
    x0, y0, x1, y1 = box
    depth = 0.16  # m of the drawing
    face, corner, size = {
        "left": (((x0 - gap,) * 2, (y0, y1)), (x0 - gap - depth, y0), (depth, y1 - y0)),
        "right": (((x1 + gap,) * 2, (y0, y1)), (x1 + gap, y0), (depth, y1 - y0)),
        "bottom": (((x0, x1), (y0 - gap,) * 2), (x0, y0 - gap - depth), (x1 - x0, depth)),
        "top": (((x0, x1), (y1 + gap,) * 2), (x0, y1 + gap), (x1 - x0, depth)),
    }[side]
    panel.add_patch(Rectangle(corner, *size, facecolor="none", edgecolor=INK, lw=0, hatch="//////", zorder=1))
    panel.plot(*face, color=INK, lw=0.9, zorder=4, clip_on=False)


def roller_places(box, side, gap):
    """Centres of the circles along a side [m]."""
    x0, y0, x1, y1 = box
    if side in ("left", "right"):
        x = x0 - gap / 2 if side == "left" else x1 + gap / 2
        return [(x, y) for y in np.linspace(y0 + 0.15, y1 - 0.15, 8)]
    y = y0 - gap / 2 if side == "bottom" else y1 + gap / 2
    return [(x, y) for x in np.linspace(x0 + 0.15, x1 - 0.15, 40)]


def name_side(panel, box, side, words):
    """The boundary condition in words, just inside a side wall or below the base."""
    x0, y0, x1, y1 = box
    if side in ("left", "right"):
        x, align = (x0 + 0.1, "left") if side == "left" else (x1 - 0.1, "right")
        panel.text(x, y1 - 0.1, words, ha=align, va="top", fontsize=7.5, bbox=_paper(), zorder=6)
    elif side == "bottom":
        panel.text((x0 + x1) / 2, y0 - 0.36, words, ha="center", va="top", fontsize=7.5)


def draw_dimensions(panel, corners, box):
    """Width above and height beside the body."""
    (x0, y0), (x1, y1) = corners.min(axis=0), corners.max(axis=0)
    above, beside = min(y1 + 0.25, box[3] - 0.1), x1 + 0.45
    arrow = {"arrowstyle": "<->", "lw": 0.6, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 6}
    panel.annotate("", (x0, above), (x1, above), arrowprops=arrow, zorder=5)
    panel.annotate("", (beside, y0), (beside, y1), arrowprops=arrow, zorder=5)
    panel.text((x0 + x1) / 2, above, f"{x1 - x0:g} m", ha="center", va="center", bbox=_paper(), zorder=6)
    panel.text(beside, (y0 + y1) / 2, f"{y1 - y0:g} m", ha="center", va="center", bbox=_paper(), zorder=6)


def draw_named_points(panel, points, corners):
    """Dots with letters inside the body; of close neighbours one letter above, the next below."""
    low, high = corners[:, 1].min() + 0.3, corners[:, 1].max() - 0.3
    above, x_before = True, None
    for name, x, y in sorted(points, key=lambda point: (point[1], -point[2])):
        above = not above if x_before is not None and abs(x - x_before) < 0.4 else True
        above = (above or y < low) and y < high
        x_before = x
        panel.plot(x, y, "o", ms=2.6, color="black", zorder=7)
        panel.annotate(name, (x, y), (0, 2.2 if above else -2.4), textcoords="offset points", ha="center",
                       va="bottom" if above else "top", fontsize=8, zorder=7)


def draw_cell_inset(panel, case, corners, box):
    """One cell of the body, enlarged, with its material points."""
    dx, dy = cell_size(case)
    n_x, n_y = case["body"][0].get("points_per_cell", (5, 5))
    side = 0.42 * (box[3] - box[1])
    (_, y1), x1 = corners.max(axis=0), corners.max(axis=0)[0]
    left, low = x1 + 0.30 * (box[2] - x1), box[1] + 0.36 * (box[3] - box[1])
    panel.add_patch(Rectangle((left, low), side, side * dy / dx, facecolor=SOIL, edgecolor=INK, lw=0.9, zorder=5))
    xi, eta = (np.arange(n_x) + 0.5) / n_x, (np.arange(n_y) + 0.5) / n_y
    grid = np.stack(np.meshgrid(left + side * xi, low + side * dy / dx * eta), axis=-1).reshape(-1, 2)
    panel.plot(*grid.T, ".", ms=2.2, color=INK, zorder=6)
    cell = np.array([x1 - 3 * dx, y1 - 6 * dy])
    panel.add_patch(Rectangle(cell, dx, dy, facecolor="none", edgecolor=INK, lw=0.9, zorder=5))
    for corner, end in ((cell + (dx, dy), (left, low + side * dy / dx)), (cell + (dx, 0), (left, low))):
        panel.add_artist(ConnectionPatch(corner, end, "data", lw=0.4, color=style.GREY, zorder=4))
    words = f"cell {dx:g} m × {dy:g} m,\n{n_x} × {n_y} material points"
    panel.text(left + side + 0.15, low + side * dy / dx / 2, words, ha="left", va="center", fontsize=7.5, bbox=_paper(),
               zorder=6)


def _paper():
    """A white ground behind text that crosses the mesh."""
    return {"facecolor": "white", "edgecolor": "none", "pad": 1.2}
