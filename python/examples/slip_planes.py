#!/usr/bin/python3
"""Bishop's and Spencer's factors on the slip planes that an imported case names, and the lowest circle and plane.

    python3 python/examples/slip_planes.py section/case.toml [--search]

Reads case.toml alone: outlines, weights, water, loads of the last stage, strengths. It shares no code with the solver,
so it says whether a difference from a stored factor lies in what was read or in the mechanism that was found.
Slices are vertical and 0.25 m wide. Cohesion and friction are those of the case: an import has reduced them to slip
planes.
"""
import argparse
import math
import re
import tomllib
from pathlib import Path

import numpy as np

UNITS = {"Pa": 1.0, "kPa": 1e3, "MPa": 1e6, "kN/m3": 1e3}


def number(value):
    """In Pa or N/m3 of a number or a text with a unit."""
    if isinstance(value, (int, float)):
        return float(value)
    digits, unit = value.split()
    return float(digits) * UNITS[unit]


def height(line, x):
    places = np.array(line)
    return np.interp(x, places[:, 0], places[:, 1])


def inside(polygon, x, z):
    """Which places lie in a polygon."""
    result = np.zeros(x.shape, bool)
    for (ax, az), (bx, bz) in zip(polygon, polygon[1:] + polygon[:1]):
        if az != bz:
            result ^= ((az > z) != (bz > z)) & (x < ax + (z - az) / (bz - az) * (bx - ax))
    return result


class Table:
    """Values on a grid of places, linear between them."""

    def __init__(self, path):
        rows = np.genfromtxt(path, delimiter=",", skip_header=1)
        self.x, self.z = np.unique(rows[:, 0]), np.unique(rows[:, 1])
        values = np.full((len(self.x), len(self.z)), np.nan)
        values[np.searchsorted(self.x, rows[:, 0]), np.searchsorted(self.z, rows[:, 1])] = rows[:, 2]
        for column in values:
            known = np.isfinite(column)
            if known.any():
                column[~known] = np.interp(self.z[~known], self.z[known], column[known])
        known = np.isfinite(values[:, 0])
        for row in values.T:
            row[~known] = np.interp(self.x[~known], self.x[known], row[known])
        self.values = values

    def at(self, x, z):
        i = np.clip(np.searchsorted(self.x, x) - 1, 0, len(self.x) - 2)
        j = np.clip(np.searchsorted(self.z, z) - 1, 0, len(self.z) - 2)
        a = np.clip((x - self.x[i]) / (self.x[i + 1] - self.x[i]), 0, 1)
        b = np.clip((z - self.z[j]) / (self.z[j + 1] - self.z[j]), 0, 1)
        v = self.values
        return (1 - b) * ((1 - a) * v[i, j] + a * v[i + 1, j]) + b * ((1 - a) * v[i, j + 1] + a * v[i + 1, j + 1])


class Section:
    """Stresses and strengths of the last stage on columns 0.25 m apart, every 0.05 m of height."""

    def __init__(self, path, width=0.25, step=0.05):
        self.folder, self.step, self.width = Path(path).parent, step, width
        self.case = tomllib.loads(Path(path).read_text())
        (x0, z0), (wide, high) = self.case["mesh"]["origin"], self.case["mesh"]["size"]
        self.x, self.z = np.arange(x0 + width / 2, x0 + wide, width), np.arange(z0 + step / 2, z0 + high, step)
        self.grid = np.meshgrid(self.x, self.z, indexing="ij")
        self.soils = list(self.case["material"])
        self.soil = np.full(self.grid[0].shape, -1)
        for body in self.case["body"]:
            here = inside(body["polygon"], *self.grid)
            for hole in body.get("holes", []):
                here &= ~inside(hole, *self.grid)
            self.soil[here] = self.soils.index(body["material"])
        weights = np.array([number(self.case["material"][soil]["density"]) for soil in self.soils] + [0.0])[self.soil]
        self.weight = np.cumsum(weights[:, ::-1] * step, axis=1)[:, ::-1] - weights * step / 2
        self.ground = np.array([self.z[np.nonzero(c >= 0)[0][-1]] + step / 2 if (c >= 0).any() else z0
                                for c in self.soil])
        self.read_stages()
        pressure, free = self.water[self.last]
        self.total = self.weight + free[:, None] + self.load[:, None]
        self.pressure = np.minimum(pressure, self.total)
        self.cohesion, self.friction = np.zeros(self.total.shape), np.zeros(self.total.shape)
        for k, soil in enumerate(self.soils):
            self.set_strength(self.case["material"][soil], self.soil == k)

    def read_stages(self):
        given = self.case.get("water", {})
        situations = {s["name"]: s for s in given.get("situation", [])} | {"start": given}
        loads = {load["name"]: dict(load, pressure=number(load["pressure"])) for load in self.case.get("load", [])}
        self.last = "start"
        for stage in self.case.get("stage", []):
            self.last = stage.get("water", self.last)
            for key, value in stage.get("set", {}).items():
                if found := re.match(r"load\.(.*)\.pressure", key):
                    loads[found[1]]["pressure"] = number(value)
        self.load = sum((np.where((self.x >= q["from"]) & (self.x <= q["to"]), q["pressure"], 0.0)
                         for q in loads.values()), np.zeros(len(self.x)))
        self.water = {name: self.pore_pressure(situation, number(given.get("unit_weight", 9810.0)))
                      for name, situation in situations.items()}

    def pore_pressure(self, water, gamma):
        """Pressures, and that of free water on the ground [Pa]."""
        if "pressure" in water:
            table = Table(self.folder / water["pressure"]["csv"])
            return np.maximum(table.at(*self.grid), 0), np.maximum(table.at(self.x, self.ground), 0)
        pressure = np.zeros(self.grid[0].shape)
        if "phreatic_line" not in water:
            return pressure, np.zeros(len(self.x))
        surface = height(water["phreatic_line"], self.x)
        begin = np.minimum(surface, self.ground)
        heads = water.get("head_lines", {})
        lines = [(height(r["line"], self.x), surface if r["head"] == "phreatic" else height(heads[r["head"]], self.x))
                 for r in water.get("reference_lines", [])]
        for i, top in enumerate(begin):
            levels = [(top, gamma * (surface[i] - top))]
            levels += sorted(((r[i], gamma * (h[i] - r[i])) for r, h in lines if r[i] <= top + 1e-9), reverse=True)
            z, u = np.array(levels[::-1]).T
            pressure[i] = np.interp(self.z, z, u) + gamma * np.maximum(z[0] - self.z, 0)
            pressure[i][self.z > top] = 0
        return pressure, gamma * np.maximum(surface - self.ground, 0)

    def effective(self, water):
        pressure, free = self.water[water]
        total = self.weight + free[:, None]
        return total - np.minimum(pressure, total)

    def set_strength(self, soil, here):
        if soil["model"] == "mohr_coulomb":
            self.cohesion[here] = number(soil["cohesion"])
            angle = soil["friction_angle"]
            if isinstance(angle, dict):  # of a film at the top of an aquifer
                angle = Table(self.folder / angle["csv"]).at(self.grid[0][here], self.grid[1][here])
            self.friction[here] = np.tan(np.radians(angle))
        elif not isinstance(soil["su_peak"], dict):
            self.cohesion[here] = number(soil["su_peak"])
        elif "table" in soil["su_peak"]:
            stress, su = np.array([[number(v) for v in row] for row in soil["su_peak"]["table"]]).T
            self.cohesion[here] = np.interp(self.effective(soil["su_peak"].get("water", "start"))[here], stress, su)
        else:
            law = soil["su_peak"]["shansep"]
            stress = np.maximum(self.effective(law.get("water", "start"))[here], 1.0)
            if "pop" in law:
                yields = self.effective("start")[here] + number(law["pop"])
            else:
                yields = Table(self.folder / law["yield_stress"]["csv"]).at(self.grid[0][here], self.grid[1][here])
            su = law["S"] * stress * (yields / stress) ** law["m"]
            self.cohesion[here] = np.maximum(su, number(law.get("minimum", 0.0)))

    def at(self, field, i, z):
        """Linear in z within a soil."""
        place = (z - self.z[0]) / self.step
        j = np.clip(place.astype(int), 0, len(self.z) - 2)
        share = np.where(self.soil[i, j] == self.soil[i, j + 1], place - j, np.round(place - j))
        return (1 - share) * field[i, j] + share * field[i, j + 1]

    def slices(self, line):
        """Weight [N/m], slope of the foot against the motion, pressure, strength."""
        i = np.nonzero((self.x > line[0][0]) & (self.x < line[-1][0]))[0]
        i = i[height(line, self.x[i]) < self.ground[i] - 1e-3]
        x, z, b = self.x[i], height(line, self.x[i]), self.width
        angle = np.arctan((height(line, x + b / 2) - height(line, x - b / 2)) / b)
        weight, way = b * self.at(self.total, i, z), 1.0
        if np.sum(weight * np.sin(angle)) < 0:  # it moves to the right
            way, angle = -1.0, -angle
        return {"x": way * x, "z": z, "b": b, "angle": angle, "weight": weight,
                "u": self.at(self.pressure, i, z), "c": self.at(self.cohesion, i, z),
                "t": self.at(self.friction, i, z)}


def bishop(s):
    """F = sum (c b + (W - u b) tan phi) / m_alpha over sum W sin alpha."""
    drive, factor = np.sum(s["weight"] * np.sin(s["angle"])), 1.0
    if drive <= 0:
        return math.inf
    for _ in range(60):
        m = np.maximum(np.cos(s["angle"]) + s["t"] * np.sin(s["angle"]) / factor, 0.1)
        found = np.sum((s["c"] * s["b"] + (s["weight"] - s["u"] * s["b"]) * s["t"]) / m) / drive
        if abs(found - factor) < 1e-6:
            break
        factor = found
    return found


def spencer(s):
    """F and the slope of the forces between slices, by balance of forces and of moments; not a number: none found."""
    cos, sin, length = np.cos(s["angle"]), np.sin(s["angle"]), s["b"] / np.cos(s["angle"])
    x, z = s["x"] - s["x"].mean(), s["z"] - s["z"].mean()

    def unbalanced(factor, slope):
        tangent = s["t"] / factor
        q = s["weight"] * sin - s["c"] * length / factor - (s["weight"] * cos - s["u"] * length) * tangent
        q /= np.cos(s["angle"] - slope) + np.sin(s["angle"] - slope) * tangent
        return np.array([q.sum(), 0.1 * (q * (x * np.sin(slope) - z * np.cos(slope))).sum()])

    now, h = np.array([np.clip(bishop(s), 0.3, 20.0), 0.1]), 1e-5
    for _ in range(200):
        r = unbalanced(*now)
        slopes = np.column_stack([(unbalanced(*(now + h * e)) - r) / h for e in np.eye(2)])
        change = -np.linalg.solve(slopes, r)
        now = now + change * min(1.0, 0.2 / np.abs(change).max())
        if np.abs(change).max() < 1e-8:
            return now[0]
    return math.nan


def circle(section, centre, radius):
    """The lower arc from ground to ground; None: it does not come out within the section."""
    i = np.nonzero(np.abs(section.x - centre[0]) < radius)[0]
    z = centre[1] - np.sqrt(radius**2 - (section.x[i] - centre[0]) ** 2)
    below = np.concatenate([[False], z < section.ground[i], [False]])
    starts, ends = np.nonzero(below[1:] > below[:-1])[0], np.nonzero(below[:-1] > below[1:])[0]
    if len(starts) == 0:
        return None
    k = np.argmax(ends - starts)
    a, b = starts[k] - 1, ends[k] + 1
    if a < 0 or b > len(i) or b - a < 10 or z[a:b].min() < section.z[0]:
        return None
    return np.column_stack([section.x[i[a:b]], z[a:b]])


def lowest_circle(section, least_depth=2.0):
    """Over three grids of centres and depths, each around the lowest of the one before. Arcs below more than a metre of
    free water, whose push is not in the balance, do not count."""
    top, low = section.ground.max(), section.z[0]
    ground = np.column_stack([section.x, section.ground])
    wet = np.column_stack([section.x, section.water[section.last][1]])
    ranges = [(section.x[0], section.x[-1], 20), (top + 1, top + 50, 14), (low, top, 24)]
    best = (math.inf, None, None)
    for _ in range(3):
        for xc in np.linspace(*ranges[0]):
            for zc in np.linspace(*ranges[1]):
                for base in np.linspace(*ranges[2]):
                    line = circle(section, (xc, zc), zc - base)
                    if line is None or height(wet, line[:, 0]).max() > 1e4:
                        continue
                    if (height(ground, line[:, 0]) - line[:, 1]).max() < least_depth:
                        continue
                    factor = bishop(section.slices(line))
                    if 0.05 < factor < best[0]:
                        best = (factor, line, (xc, zc, base))
        if best[1] is None:
            break
        ranges = [(c - (b - a) / n, c + (b - a) / n, 7) for c, (a, b, n) in zip(best[2], ranges)]
    return best[:2]


def lowest_plane(section):
    """Down from the crest, along the top of a soil, and up again: the lowest factor of Spencer of such planes, on any
    side of the crest, that no metre of free water pushes on. The level part runs within a step below the border."""
    crest = section.x[np.argmax(section.ground)]
    ground, wet = (np.column_stack([section.x, y]) for y in (section.ground, section.water[section.last][1]))
    borders = set()
    for column in section.soil[:: max(len(section.x) // 20, 1)]:
        borders |= {round(z, 2) for z in section.z[:-1][(column[1:] != column[:-1]) & (column[1:] >= 0)]}
    best = (math.inf, None)
    for way in (1.0, -1.0):
        for level in (b for b in borders if section.z[0] < b < section.ground.min()):
            for entry in crest - way * np.linspace(-3.0, 6.0, 4):
                for down in (45.0, 60.0):
                    first = entry + way * (height(ground, entry) - level) / math.tan(math.radians(down))
                    for length in np.linspace(5.0, 60.0, 23):
                        for up in (20.0, 30.0, 40.0):
                            last = first + way * length
                            end = last + way * (height(ground, last) - level) / math.tan(math.radians(up))
                            if not section.x[0] < end < section.x[-1] or (end - last) * way < 0:
                                continue
                            line = [(entry, height(ground, entry)), (first, level), (last, level),
                                    (end, height(ground, end))]
                            if max(height(wet, x) for x, _ in line) > 1e4:
                                continue
                            factor = spencer(section.slices(line[:: int(way)]))
                            if 0.05 < factor < best[0]:
                                best = (factor, line)
    return best


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("case", help="case.toml of an imported section")
    parser.add_argument("--search", action="store_true", help="look for the lowest circle that is 2 m deep or deeper")
    parser.add_argument("--planes", action="store_true", help="look for the lowest plane of three parts, too")
    arguments = parser.parse_args()
    section = Section(arguments.case)
    for plane in section.case.get("reference", {}).get("slip_planes", []):
        slices = section.slices(plane["line"])
        print(f"{plane['name']}, {plane.get('method', '')}: {plane.get('factor_of_safety', '-')}; here "
              f"Bishop {bishop(slices):.3f}, Spencer {spencer(slices):.3f}")
    if arguments.search:
        factor, line = lowest_circle(Section(arguments.case, width=0.5))
        print("no circle" if line is None else f"lowest circle of Bishop {factor:.3f}, from ({line[0][0]:.1f}, "
              f"{line[0][1]:.1f}) to ({line[-1][0]:.1f}, {line[-1][1]:.1f}) m, lowest at {line[:, 1].min():.1f} m")
    if arguments.planes:
        factor, line = lowest_plane(Section(arguments.case, width=0.5))
        print("no plane" if line is None else f"lowest plane of Spencer {factor:.3f}, from ({line[0][0]:.1f}, "
              f"{line[0][1]:.1f}) along z = {line[1][1]:.2f} from {line[1][0]:.1f} to {line[2][0]:.1f} m, out at "
              f"x = {line[3][0]:.1f} m")


if __name__ == "__main__":
    main()
