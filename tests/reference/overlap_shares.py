"""Shares of points that count in all sub-cells around them: method.shares = "overlap", decision 0042.

A point is a square in the local coordinates of its cell. The lines xi, eta = -1, 0, 1 cut it into parts. A part beyond
a side lies in another cell, in the sub-cell of the node that its own sub-cell has: across this side, or the corner.
"""
import numpy as np

SIGNS = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])  # of xi, eta in the sub-cell of each corner of a cell


def half_sides(volume, cell_volume):
    """Half the side of each point's square in local coordinates; both volumes of t = 0."""
    return np.minimum(np.sqrt(volume / cell_volume), 1.0)


def taken_shares(volume, cell, cell_volume):
    """Part [n_cells] of what others leave in a cell that it takes: all, once its points fill an eighth (0066)."""
    own = np.bincount(cell, volume, minlength=len(cell_volume))
    return np.minimum(1.0, 8.0 * own / cell_volume)


def overlap_shares(cells, cell, xi, half, taken, met):
    """Shares [n, n_cells, 4]. cells: their nodes [n_cells, 4]; cell, xi, half: of each point; taken: of each cell; met:
    counts branches."""
    shares = np.zeros((len(xi), len(cells), 4))
    occupied = set(cell.tolist())
    met["point as large as its cell"] += np.count_nonzero(half == 1)
    for p, e in enumerate(cell):
        for corner, sign in enumerate(SIGNS):
            # parts of the square's side on the corner's side of the centre line, within the cell and beyond it
            inside, beyond = (length_in(sign * xi[p], half[p], start) for start in (0, 1))
            for area, across in ((inside[0] * inside[1], []), (beyond[0] * inside[1], [0]),
                                 (inside[0] * beyond[1], [1]), (beyond[0] * beyond[1], [0, 1])):
                places, what = sub_cells_at(cells, occupied, taken, e, corner, across)
                met[what] += area > 0
                for to, part in places:
                    shares[p, to, list(cells[to]).index(cells[e][corner])] += area * part
                    met["share of a cell with little soil"] += area > 0 and taken[to] < 1
    return shares


def length_in(centre, half, start):
    """Part of the length 2 half about a centre that lies in [start, start + 1], per axis."""
    return np.maximum(0, np.minimum(centre + half, start + 1) - np.maximum(centre - half, start)) / (2 * half)


def sub_cells_at(cells, occupied, taken, e, corner, across):
    """Cells that take what lies across the given axes at a corner of cell e, with their parts; a name of the case."""
    if not across:
        return [(e, 1.0)], "share in its cell"
    sides = [across_side(cells, e, corner, axis) for axis in across]
    nearest, there = [k for k in sides if k in occupied], sides[0]
    if len(across) == 2:
        around = [k for k in range(len(cells)) if cells[e][corner] in cells[k]]
        rest = [k for k in around if k not in [e, *sides]]
        there = rest[0] if None not in sides and len(around) == 4 else None
    name = "side" if len(across) == 1 else "corner"
    back = [place for k in nearest for place in ((k, taken[k] / len(nearest)), (e, (1 - taken[k]) / len(nearest)))]
    if there in occupied and nearest:  # a corner is reached by way of a side
        rest = [(e, 1.0)] if len(across) == 1 else back
        return [(there, taken[there])] + [(k, (1 - taken[there]) * part) for k, part in rest], f"share across a {name}"
    case = "no partner" if there is None else "no way there" if there in occupied else "a cell without points"
    return back or [(e, 1.0)], f"{name} with {case}: back to " + (f"{len(nearest)} sides" if nearest else "its cell")


def across_side(cells, e, corner, axis):
    """The cell beyond the side of xi (axis 0) or eta (1) at a corner, or None."""
    other = next(k for k in range(4) if SIGNS[k][axis] == SIGNS[corner][axis] and k != corner)
    side = {cells[e][corner], cells[e][other]}
    return next((k for k in range(len(cells)) if k != e and side <= set(cells[k])), None)
