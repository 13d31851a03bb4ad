"""Meshes of the table: rectangles, quadrilaterals with nodes moved at random, and polygons that gmsh fills.

Not for meshes of a user: `terp explain mesh`. All lengths in m.
"""
import numpy as np

KINDS = ("rectangle", "quads", "polygon")
LEAST_CORNER = 0.15  # sine times sides of the sharpest corner of a moved cell, as a part of a square cell


def moved_grid(columns, rows, amount, random, level_rows=(), kept=()):
    """Nodes of a grid of unit cells [row, column, xy], each moved by up to `amount` in x and in y.

    Nodes on the sides slide along them, those of `level_rows` along their row; `kept` nodes (column, row) stay. A move
    that would make a corner too sharp is drawn again.
    """
    nodes = np.stack(np.meshgrid(np.arange(columns + 1.0), np.arange(rows + 1.0)), axis=2)
    for j in range(rows + 1):
        for i in range(columns + 1):
            place = nodes[j, i].copy()
            free = np.array([0 < i < columns, 0 < j < rows and j not in level_rows]) & ((i, j) not in kept)
            for _ in range(50):
                nodes[j, i] = place + free * [random.uniform(-amount, amount) for _ in range(2)]
                if sharpest_corner(nodes, i, j) > LEAST_CORNER:
                    break
            else:
                nodes[j, i] = place
    return nodes


def sharpest_corner(nodes, i, j):
    """Least cross product of two sides at a corner [-], of the cells around node (i, j)."""
    rows, columns = nodes.shape[0] - 1, nodes.shape[1] - 1
    least = 1.0
    for b in range(max(j - 1, 0), min(j + 1, rows)):
        for a in range(max(i - 1, 0), min(i + 1, columns)):
            ring = [nodes[b, a], nodes[b, a + 1], nodes[b + 1, a + 1], nodes[b + 1, a]]
            for k in range(4):
                u, w = ring[(k + 1) % 4] - ring[k], ring[k - 1] - ring[k]
                least = min(least, u[0] * w[1] - u[1] * w[0])
    return least


def write_msh(path, nodes):
    """A grid of nodes [row, column, xy] as MSH 4.1 with the sides bottom, right, top, left."""
    rows, columns = nodes.shape[0] - 1, nodes.shape[1] - 1
    number = np.arange(1, (rows + 1) * (columns + 1) + 1).reshape(rows + 1, columns + 1)
    low, high = nodes.min(axis=(0, 1)), nodes.max(axis=(0, 1))
    extent = f"{low[0]} {low[1]} 0 {high[0]} {high[1]} 0"
    sides = [number[0], number[:, -1], number[-1][::-1], number[:, 0][::-1]]
    lines = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$PhysicalNames", "4"]
    lines += [f'1 {k} "{name}"' for k, name in enumerate(("bottom", "right", "top", "left"), 1)]
    lines += ["$EndPhysicalNames", "$Entities", "0 4 1 0"]
    lines += [f"{k} {extent} 1 {k} 0" for k in range(1, 5)] + [f"1 {extent} 0 4 1 2 3 4", "$EndEntities"]
    lines += ["$Nodes", f"1 {number.size} 1 {number.size}", f"2 1 0 {number.size}"]
    lines += [str(n) for n in range(1, number.size + 1)]
    lines += [f"{x:.17g} {y:.17g} 0" for x, y in nodes.reshape(-1, 2)]
    elements, blocks = 0, []
    for k, side in enumerate(sides, 1):
        blocks.append(f"1 {k} 1 {len(side) - 1}")
        for a, b in zip(side, side[1:]):
            elements += 1
            blocks.append(f"{elements} {a} {b}")
    blocks.append(f"2 1 3 {rows * columns}")
    for j in range(rows):
        for i in range(columns):
            elements += 1
            ring = number[j, i], number[j, i + 1], number[j + 1, i + 1], number[j + 1, i]
            blocks.append(" ".join(map(str, (elements, *ring))))
    lines += ["$EndNodes", "$Elements", f"5 {elements} 1 {elements}", *blocks, "$EndElements"]
    path.write_text("\n".join(lines) + "\n")
