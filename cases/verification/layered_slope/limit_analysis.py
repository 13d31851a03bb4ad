#!/usr/bin/env python3
"""Bounds of limit analysis for clay in layers (plane strain, phi_u = 0): finite elements and linear programming.

usage: limit_analysis.py slope RATIO ROWS BOTTOM TOP    RATIO of strengths in a layer between levels [m], rows per m
       limit_analysis.py footing RATIO ROWS DEPTH       q/S_u of a rough strip 2 m wide; strength RATIO below a depth

Upper: velocities linear in each triangle, with a jump at every edge (Sloan and Kleeman 1995). Lower: stresses linear
in each triangle, with a jump along every edge (Sloan 1988). The circle of Tresca is a polygon of SIDES sides, outside
it for the upper bound and inside it for the lower one, so both are strict. Needs SciPy (Debian: python3-scipy).
"""
import sys

import numpy as np
from scipy.optimize import linprog
from scipy.sparse import coo_matrix

SIDES = 24
ANGLES = 2.0 * np.pi * np.arange(SIDES) / SIDES


class Mesh:
    """Quadrilaterals of four triangles each, between curves."""

    def __init__(self):
        self.nodes, self.cells, self.known = [], [], {}

    def node(self, x, y):
        key = (round(x, 6), round(y, 6))
        if key not in self.known:
            self.known[key] = len(self.nodes)
            self.nodes.append((x, y))
        return self.known[key]

    def quad(self, corners):
        (x1, y1), (x2, y2), (x3, y3), (x4, y4) = corners
        along = np.linalg.solve([[x3 - x1, x2 - x4], [y3 - y1, y2 - y4]], [x2 - x1, y2 - y1])[0]
        middle = self.node(x1 + along * (x3 - x1), y1 + along * (y3 - y1))
        q = [self.node(*p) for p in corners]
        self.cells += [(q[k], q[(k + 1) % 4], middle) for k in range(4)]

    def block(self, xs, bottom, top, shares):
        """Columns at xs, cut at shares of their height; the last may have none."""
        def at(x, share):
            return x, bottom(x) + share * (top(x) - bottom(x))
        for x, next_x in zip(xs[:-1], xs[1:]):
            for s, next_s in zip(shares[:-1], shares[1:]):
                if top(next_x) - bottom(next_x) < 1e-9:
                    self.cells.append([self.node(*p) for p in (at(x, s), at(next_x, s), at(x, next_s))])
                else:
                    self.quad([at(x, s), at(next_x, s), at(next_x, next_s), at(x, next_s)])

    def edges(self):
        """(node, node) -> triangles beside it."""
        beside = {}
        for e, tri in enumerate(self.cells):
            for k in range(3):
                beside.setdefault(tuple(sorted((tri[k], tri[(k + 1) % 3]))), []).append(e)
        return beside

    def gradients(self, e):
        """Derivatives of the shape functions by x and y, and the area."""
        (x1, y1), (x2, y2), (x3, y3) = (self.nodes[k] for k in self.cells[e])
        double = (x2 - x1) * (y3 - y1) - (x3 - x1) * (y2 - y1)
        by_x, by_y = (y2 - y3, y3 - y1, y1 - y2), (x3 - x2, x1 - x3, x2 - x1)
        return [b / double for b in by_x], [b / double for b in by_y], 0.5 * double

    def corner(self, e, node, width):
        """First unknown of a node of a triangle."""
        return width * (3 * e + list(self.cells[e]).index(node))

    def frame(self, a, b):
        """Length, along and across an edge, its middle."""
        p, q = np.array(self.nodes[a]), np.array(self.nodes[b])
        length = np.hypot(*(q - p))
        t = (q - p) / length
        return length, t, np.array([-t[1], t[0]]), 0.5 * (p + q)


class Rows:
    """A sparse matrix and its right side, row by row."""

    def __init__(self):
        self.i, self.j, self.v, self.right = [], [], [], []

    def add(self, columns, values, right):
        self.i += [len(self.right)] * len(columns)
        self.j += list(columns)
        self.v += list(values)
        self.right.append(right)

    def matrix(self, n):
        return coo_matrix((self.v, (self.i, self.j)), shape=(len(self.right), n)).tocsr(), np.array(self.right)


class Upper:
    """Least dissipation by velocities whose weight (or footing) has a power of 1."""

    def __init__(self, problem):
        self.p, self.mesh = problem, problem.mesh
        self.n_free = 6 * len(self.mesh.cells) + 1
        self.down = self.n_free - 1                    # speed of the footing
        self.cost, self.rows = [0.0] * self.n_free, Rows()

    def slip(self, columns, values, cost):
        """The sum of columns is the difference of two unknowns that are not negative, each with a cost."""
        n = len(self.cost)
        self.rows.add([*columns, n, n + 1], [*values, -1.0, 1.0], 0.0)
        self.cost += [cost, cost]

    def triangle(self, e):
        bx, by, area = self.mesh.gradients(e)
        vx = [6 * e + 2 * k for k in range(3)]
        v, lam = vx + [x + 1 for x in vx], list(range(len(self.cost), len(self.cost) + SIDES))
        self.rows.add(v, bx + by, 0.0)
        self.rows.add(v + lam, [0.5 * b for b in bx] + [-0.5 * b for b in by] + list(-np.cos(ANGLES)), 0.0)
        self.rows.add(v + lam, [0.5 * b for b in by] + [0.5 * b for b in bx] + list(-np.sin(ANGLES)), 0.0)
        self.cost += [2.0 * self.p.su[e] * area] * SIDES

    def edge(self, a, b, beside):
        length, t, n, middle = self.mesh.frame(a, b)
        side = self.p.side(middle)
        cost = 0.5 * length * min(self.p.su[e] for e in beside)
        for node in (a, b):
            at = [self.mesh.corner(e, node, 2) for e in beside]
            if len(at) == 2:
                columns = [at[0], at[0] + 1, at[1], at[1] + 1]
                self.rows.add(columns, [*n, *-n], 0.0)
                self.slip(columns, [*t, *-t], cost)
            elif side == "footing":
                self.rows.add([at[0] + 1, self.down], [1.0, 1.0], 0.0)
                self.slip([at[0]], [1.0], cost)
            elif side == "fixed":
                self.rows.add([at[0], at[0] + 1], n, 0.0)
                self.slip([at[0], at[0] + 1], t, cost)
            elif side == "roller":
                self.rows.add([at[0]], [1.0], 0.0)

    def solve(self):
        for e in range(len(self.mesh.cells)):
            self.triangle(e)
        for (a, b), beside in self.mesh.edges().items():
            self.edge(a, b, beside)
        vy = [6 * e + 2 * k + 1 for e in range(len(self.mesh.cells)) for k in range(3)]
        areas = [self.mesh.gradients(e)[2] for e in range(len(self.mesh.cells))]
        weight = [-self.p.gamma * area / 3.0 for area in areas for _ in range(3)]
        self.rows.add(vy + [self.down], weight + [self.p.width], 1.0)
        matrix, right = self.rows.matrix(len(self.cost))
        bounds = [(None, None)] * self.n_free + [(0.0, None)] * (len(self.cost) - self.n_free)
        return linprog(self.cost, A_eq=matrix, b_eq=right, bounds=bounds, method="highs-ipm").fun


class Lower:
    """Greatest multiple of the weight, or load of the footing, that stresses within the strength carry."""

    def __init__(self, problem):
        self.p, self.mesh = problem, problem.mesh
        self.n = 9 * len(self.mesh.cells) + 1          # sx, sy, txy of each corner, then the multiple of the weight
        self.goal, self.equal, self.less = np.zeros(self.n), Rows(), Rows()

    def triangle(self, e):
        bx, by, _ = self.mesh.gradients(e)
        sx, sy, txy = ([9 * e + 3 * k + m for k in range(3)] for m in range(3))
        self.equal.add(sx + txy, bx + by, 0.0)
        self.equal.add(txy + sy + [self.n - 1], bx + by + [-self.p.gamma], 0.0)
        for k in range(3):
            for c, s in zip(np.cos(ANGLES), np.sin(ANGLES)):
                self.less.add([sx[k], sy[k], txy[k]], [0.5 * c, -0.5 * c, s], self.p.su[e] * np.cos(np.pi / SIDES))

    def edge(self, a, b, beside):
        length, t, n, middle = self.mesh.frame(a, b)
        side = self.p.side(middle)
        normal = [n[0] ** 2, n[1] ** 2, 2.0 * n[0] * n[1]]
        shear = [n[0] * t[0], n[1] * t[1], n[0] * t[1] + n[1] * t[0]]
        for node in (a, b):
            at = [self.mesh.corner(e, node, 3) for e in beside]
            columns = [first + k for first in at for k in range(3)]
            if len(at) == 2:
                self.equal.add(columns, normal + [-x for x in normal], 0.0)
                self.equal.add(columns, shear + [-x for x in shear], 0.0)
            elif side == "footing":
                self.goal[columns] += 0.5 * length / self.p.width * np.array(normal)
            elif side != "fixed":
                self.equal.add(columns, shear, 0.0)
                if side == "free":
                    self.equal.add(columns, normal, 0.0)

    def solve(self):
        if self.p.gamma > 0.0:
            self.goal[-1] = -1.0
        for e in range(len(self.mesh.cells)):
            self.triangle(e)
        for (a, b), beside in self.mesh.edges().items():
            self.edge(a, b, beside)
        (equal, right), (less, most) = self.equal.matrix(self.n), self.less.matrix(self.n)
        found = linprog(self.goal, A_ub=less, b_ub=most, A_eq=equal, b_eq=right, bounds=[(None, None)] * self.n,
                        method="highs-ipm")
        return -found.fun if found.fun is not None else np.nan


class Slope:
    """The slope of case.toml: strengths in kPa, weight in kN/m3."""

    gamma, width = 19.62, 0.0

    def __init__(self, ratio, rows, bottom, top):
        def grid(*ends):
            parts = [np.linspace(a, b, max(1, round((b - a) * rows)) + 1) for a, b in zip(ends, ends[1:])]
            return np.unique(np.round(np.concatenate(parts), 6))
        self.mesh = Mesh()
        xs = grid(0.0, 14.0, 34.0, 48.0)
        self.mesh.block(xs, lambda x: 0.0, lambda x: 6.0, grid(0.0, bottom, top, 6.0) / 6.0)
        self.mesh.block(xs[xs < 34.1], lambda x: 6.0, lambda x: min(16.0, 23.0 - 0.5 * x), grid(0.0, 10.0) / 10.0)
        y = np.array(self.mesh.nodes)[np.array(self.mesh.cells)].mean(axis=1)[:, 1]
        self.su = np.where((y > bottom) & (y < top), ratio * 49.05, 49.05)

    @staticmethod
    def side(middle):
        if middle[1] < 1e-6:
            return "fixed"
        return "roller" if min(middle[0], 48.0 - middle[0]) < 1e-6 else "free"


class Footing:
    """The right half of a rough strip on 3 m of clay; strength 1 to a depth, then RATIO."""

    gamma, width = 0.0, 1.0

    def __init__(self, ratio, rows, depth):
        def grid(a, b):
            return np.linspace(a, b, max(1, round((b - a) * rows)) + 1)
        self.mesh = Mesh()
        levels = np.unique(np.round(np.concatenate([grid(0.0, 3.0 - depth), grid(3.0 - depth, 3.0)]), 6))
        self.mesh.block(grid(0.0, 5.0), lambda x: 0.0, lambda x: 3.0, levels / 3.0)
        y = np.array(self.mesh.nodes)[np.array(self.mesh.cells)].mean(axis=1)[:, 1]
        self.su = np.where(y > 3.0 - depth, 1.0, ratio)

    @staticmethod
    def side(middle):
        if middle[1] < 1e-6:
            return "fixed"
        if min(middle[0], 5.0 - middle[0]) < 1e-6:
            return "roller"
        return "footing" if middle[0] < 1.0 and middle[1] > 3.0 - 1e-6 else "free"


def main(arguments):
    problem = {"slope": Slope, "footing": Footing}[arguments[0]](*map(float, arguments[1:]))
    print(f"{' '.join(arguments)}: {len(problem.mesh.cells)} triangles, lower {Lower(problem).solve():.4f}, "
          f"upper {Upper(problem).solve():.4f}", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
