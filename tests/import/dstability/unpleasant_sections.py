#!/usr/bin/env python3
"""Sections as laser data and many hands leave them, written as D-Stability files, imported and checked.

    unpleasant_sections.py TERP [--number 10] [--seed 1] [--keep FOLDER]

Each section is drawn with known areas: 100 to 700 points of ground, layers that pinch out, lenses inside others,
ditches cut by excavations. Then it is made unpleasant: edges of 1 mm, vertices beside a neighbour's edge, repeated
points, closed outlines, both senses of rotation, lines of one place, vertical steps, water meshes, both data models.
What must
hold: `terp import` and `terp check` take it without a hand, the areas of all soils are those drawn, and so is the
weight. A failure names its seed: --number 1 --seed N makes the section again.
"""
import argparse
import json
import random
import re
import resource
import subprocess
import sys
import tempfile
import tomllib
import zipfile
from pathlib import Path

SECONDS = 30  # of processor time: no command may take longer


def area(points):
    """Area of a closed outline [m^2]; counterclockwise is positive. Taken about its first point for the round-off."""
    x0, z0 = points[0]
    moved = [(x - x0, z - z0) for x, z in points]
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(moved, moved[1:] + moved[:1])) / 2


def at(line, x):
    """Height of a line at x, level beyond its ends."""
    if x <= line[0][0]:
        return line[0][1]
    for (x0, z0), (x1, z1) in zip(line, line[1:]):
        if x <= x1:
            return z1 if x1 == x0 else z0 + (z1 - z0) * (x - x0) / (x1 - x0)
    return line[-1][1]


def lower_of(a, b):
    """The lower of two lines at each x, with a vertex where they cross."""
    xs = sorted({x for x, _ in a} | {x for x, _ in b})
    line = []
    for left, right in zip(xs, xs[1:] + [None]):
        line.append((left, min(at(a, left), at(b, left))))
        if right is None:
            break
        d0, d1 = at(a, left) - at(b, left), at(a, right) - at(b, right)
        if d0 * d1 < 0:
            x = left + (right - left) * d0 / (d0 - d1)
            line.append((x, at(a, x)))
    return line


def crosses(a, b, c, d):
    """True if the edges a to b and c to d cross or touch, common ends aside: D-Stability has no such outline."""
    if {a, b} & {c, d}:
        return False

    def side(p, q, r):
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])

    return side(a, b, c) * side(a, b, d) <= 0 and side(c, d, a) * side(c, d, b) <= 0


def area_between(upper, lower):
    """Area between two lines that do not cross [m^2]."""
    xs = sorted({x for x, _ in upper} | {x for x, _ in lower})
    gap = [at(upper, x) - at(lower, x) for x in xs]
    return sum((b - a) * (g + h) / 2 for a, b, g, h in zip(xs, xs[1:], gap, gap[1:]))


class Section:
    """What is drawn: `lines` from the base to the ground, soil k between lines k and k + 1; a lens; an excavation."""

    def __init__(self, chance):
        self.chance = chance
        self.left = float(chance.randint(-80, -20))
        self.right = self.left + chance.uniform(60.0, 180.0) // 1
        self.n_layers = chance.randint(1, 7)
        self.base = -float(chance.randint(8, 20))
        self.lines = [[(self.left, self.base), (self.right, self.base)]]
        self.ground = self.dike()
        for k in range(1, self.n_layers):
            self.lines.append(self.boundary(k))
        self.lines.append(self.ground)
        self.excavation = self.ditch() if chance.random() < 0.4 else None
        self.lens = self.lens_in_a_layer() if chance.random() < 0.5 else None
        self.slack = 0.0  # area that vertices beside an edge may add or take [m^2]

    def rounded(self, x, z):
        return round(x, 3), round(z, 3)

    def dike(self):
        """Ground from laser data: a dike with a crest, on land that is not level."""
        chance = self.chance
        crest, height = self.left + (self.right - self.left) * chance.uniform(0.35, 0.6), chance.uniform(2.0, 6.0)
        slope = chance.uniform(2.0, 4.0)
        shape = [(self.left, 0.0), (crest - 2.0 - slope * height, chance.uniform(-0.5, 0.5)), (crest - 2.0, height),
                 (crest + 2.0, height), (crest + 2.0 + slope * height, chance.uniform(-1.0, 0.3)), (self.right, -0.5)]
        shape = [p for p in shape if self.left <= p[0] <= self.right]
        spacing = (self.right - self.left) / chance.randint(100, 700)
        points, x = [], self.left
        while x < self.right - 0.5 * spacing:
            points.append(self.rounded(x, at(shape, x) + chance.gauss(0.0, 0.02)))
            x += spacing
        points.append(self.rounded(self.right, at(shape, self.right)))
        return sorted(dict(points).items())

    def boundary(self, k):
        """A line between the one below and the ground. It may lie on either of them for a while."""
        chance, below = self.chance, self.lines[-1]
        xs = sorted({self.left, self.right, *(round(chance.uniform(self.left, self.right), 3)
                                             for _ in range(chance.randint(0, 40)))})
        mean = self.base + (k + chance.uniform(-0.3, 0.3)) * (-2.0 - self.base) / self.n_layers
        pinch = chance.choice([None, None, 0.0, 1.0])
        drawn = [self.rounded(x, mean + chance.gauss(0.0, 0.4)) for x in xs]
        if pinch is not None:
            a, b = sorted((chance.uniform(self.left, self.right), chance.uniform(self.left, self.right)))
            limit = below if pinch == 0.0 else self.ground
            drawn = [(x, at(limit, x)) if a < x < b else (x, z) for x, z in drawn]
        lowered = lower_of(drawn, self.ground)
        raised = [(x, -z) for x, z in lower_of([(x, -z) for x, z in lowered], [(x, -z) for x, z in below])]
        return raised

    def ditch(self):
        chance = self.chance
        middle = chance.uniform(self.left + 5.0, self.right - 5.0)
        width, depth = chance.uniform(1.0, 3.0), chance.uniform(0.3, 1.5)
        foot = chance.uniform(0.0, 0.8) * width / 2
        a, b = middle - width / 2, middle + width / 2
        bottom = min(at(self.ground, a), at(self.ground, b)) - depth
        return [self.rounded(a, at(self.ground, a) + 0.1), self.rounded(middle - foot, bottom),
                self.rounded(middle + foot, bottom), self.rounded(b, at(self.ground, b) + 0.1)]

    def cut(self, line):
        """A line after the excavation."""
        if self.excavation is None:
            return line
        high = 1e3
        a, b = self.excavation[0], self.excavation[-1]
        wall = [(self.left - 1.0, high), (a[0] - 1e-9, high), *self.excavation, (b[0] + 1e-9, high),
                (self.right + 1.0, high)]
        lowered = lower_of(line, wall)
        return [p for p in lowered if self.left <= p[0] <= self.right]

    def lens_in_a_layer(self):
        """A small outline inside one layer, well away from its boundaries and from the excavation."""
        chance = self.chance
        for _ in range(30):
            k, x = chance.randrange(self.n_layers), chance.uniform(self.left + 4.0, self.right - 4.0)
            xs = [x - 2.0 + 0.05 * i for i in range(81)]
            low = max(at(self.lines[k], s) for s in xs) + 0.2
            high = min(at(self.cut(self.lines[k + 1]), s) for s in xs) - 0.2
            if high - low > 0.3:
                n = chance.randint(3, 12)
                upper = sorted(self.rounded(x - 2.0 + 4.0 * chance.random(), chance.uniform((low + high) / 2, high))
                               for _ in range(n))
                outline = [self.rounded(x - 2.0, low), *upper, self.rounded(x + 2.0, low)]
                outline = list(dict(outline).items())
                if area(outline) < -0.05:
                    return k, outline
        return None

    def areas(self):
        """Area of each soil [m^2]; the lens is the last one."""
        found = [area_between(self.cut(b), self.cut(a)) for a, b in zip(self.lines, self.lines[1:])]
        if self.lens is not None:
            k, outline = self.lens
            found[k] -= abs(area(outline))
            found.append(abs(area(outline)))
        return found

    def thin(self):
        """What joining corners within 1 mm may move [m^2]: where a layer ends in a wedge."""
        total = 0.0
        for a, b in zip(self.lines, self.lines[1:]):
            low, high = self.cut(a), self.cut(b)
            xs = sorted({x for x, _ in high} | {x for x, _ in low})
            for left, x, right in zip([xs[0], *xs], xs, [*xs[1:], xs[-1]]):
                if 0.0 < at(high, x) - at(low, x) < 2e-3:
                    total += 1e-3 * (right - left)
        return total

    def outlines(self):
        """(soil, outline) of each layer: one for every stretch in which the soil has a thickness; clockwise."""
        made = []
        for k, (lower, upper) in enumerate(zip(self.lines, self.lines[1:])):
            xs = sorted({x for x, _ in upper} | {x for x, _ in lower})
            thick = [at(upper, x) - at(lower, x) > 1e-9 for x in xs]
            start = None
            for i, x in enumerate(xs):
                here = thick[i] or (i + 1 < len(xs) and thick[i + 1])
                if start is None and here:
                    start = i
                if start is not None and (i + 1 == len(xs) or (not thick[i] and not thick[i + 1] and i > start)
                                          or (not thick[i] and i > start)):
                    made.append((k, self.outline(lower, upper, xs[start], x)))
                    start = i if i + 1 < len(xs) and not thick[i] and thick[i + 1] else None
        if self.lens is not None:
            made.append((self.n_layers, self.lens[1]))
        return made

    @staticmethod
    def outline(lower, upper, a, b):
        def part(line):
            inner = [p for p in line if a < p[0] < b]
            return [(a, at(line, a)), *inner, (b, at(line, b))]

        points = part(upper) + part(lower)[::-1]
        return [p for p, q in zip(points, points[1:] + points[:1]) if p != q]


def made_unpleasant(section, chance):
    """The outlines with what files have: edges of 1 mm, vertices beside an edge, repeats, any start and any sense."""
    shapes = []
    for soil, outline in section.outlines():
        points = [tuple(p) for p in outline]
        for _ in range(chance.choice([0, 0, 1, 4])):  # a vertex beside a neighbour's edge
            i = chance.randrange(len(points))
            (x0, z0), (x1, z1) = points[i], points[(i + 1) % len(points)]
            length = ((x1 - x0) ** 2 + (z1 - z0) ** 2) ** 0.5
            if length > 0.5 and abs(x1 - x0) > 0.4:
                off = chance.uniform(-0.004, 0.004)
                middle = ((x0 + x1) / 2, (z0 + z1) / 2 + off)
                edges = list(zip(points, points[1:] + points[:1]))
                if not any(crosses(end, middle, *edge) for end in edges[i] for edge in edges):
                    points.insert(i + 1, middle)
                    section.slack += length * abs(off)
        for _ in range(chance.choice([0, 0, 1, 3])):  # an edge of 1 mm
            i = chance.randrange(len(points))
            (x0, z0), (x1, z1) = points[i], points[(i + 1) % len(points)]
            length = ((x1 - x0) ** 2 + (z1 - z0) ** 2) ** 0.5
            if length > 0.1:
                points.insert(i + 1, (x0 + (x1 - x0) * 0.001 / length, z0 + (z1 - z0) * 0.001 / length))
        if chance.random() < 0.2:
            i = chance.randrange(len(points))
            points.insert(i, points[i])
        first = chance.randrange(len(points))
        points = points[first:] + points[:first]
        if chance.random() < 0.2:
            points.reverse()
        if chance.random() < 0.2:
            points.append(points[0])
        shapes.append((soil, points))
    chance.shuffle(shapes)
    return shapes


class File:
    """Members of a D-Stability file; ids count up."""

    def __init__(self, section, chance):
        self.section, self.chance = section, chance
        self.version = chance.choice(["1", "2"])
        self.last = 0
        self.members = {}

    def id(self):
        self.last += 1
        return str(self.last)

    def add(self, name, content):
        content["ContentVersion"] = self.version
        self.members[name] = content

    def points(self, line):
        return [{"X": x, "Z": z} for x, z in line]

    def number(self, name, value):
        blank = {"IsProbabilistic": False, "Mean": 1.0, "StandardDeviation": 0.0}
        return {name: value, name + "StochasticParameter": blank}

    def soil(self, k):
        """Sand and clay in turn; sand has an empty number where no model asks for it."""
        soft = k % 2 == 1
        drained = {**self.number("Cohesion", 3.0), **self.number("FrictionAngle", 30.0),
                   **self.number("Dilatancy", 0.0)}
        undrained = {**self.number("ShearStrengthRatio", 0.25 if soft else "NaN"),
                     **self.number("StrengthIncreaseExponent", 0.8)}
        soil = {"Id": self.id(), "Name": f"soil {k}", "Code": f"s{k}", "Notes": None, "IsProbabilistic": False,
                "VolumetricWeightAbovePhreaticLevel": 18.0 + 0.25 * k,
                "VolumetricWeightBelowPhreaticLevel": 18.0 + 0.25 * k}
        above, below = "ShearStrengthModelTypeAbovePhreaticLevel", "ShearStrengthModelTypeBelowPhreaticLevel"
        if self.version == "1":
            return {**soil, above: "CPhi", below: "Su" if soft else "CPhi", **drained, **undrained}
        return {**soil, above: "MohrCoulombAdvanced", below: "Su" if soft else "MohrCoulombAdvanced",
                "MohrCoulombAdvancedShearStrengthModel": drained, "SuShearStrengthModel": undrained}

    def phreatic_line(self):
        s, chance = self.section, self.chance
        ground = [z for _, z in s.ground]
        high, low = at(s.ground, s.left) + chance.uniform(-1.0, 1.0), at(s.ground, s.right) - chance.uniform(0.2, 1.0)
        middle = sum(x for x, z in s.ground if z > 0.9 * max(ground)) / sum(z > 0.9 * max(ground) for z in ground)
        kind = chance.choice(["line", "step", "one", "short", "leftwards"])
        line = [(s.left, high), (middle - 5.0, high), (middle + 6.0, low), (s.right, low)]
        if kind == "step":
            line = [(s.left, high), (middle, high), (middle, low), (s.right, low)]
        if kind == "one":
            line = [(middle, low)]
        if kind == "short":
            line = line[1:3]
        if kind == "leftwards":
            line.reverse()
        return [s.rounded(*p) for p in line]

    def water(self):
        chance, s = self.chance, self.section
        phreatic, deep = self.id(), self.id()
        lines = [{"Id": phreatic, "Label": "Phreatic", "Notes": None, "Points": self.points(self.phreatic_line())}]
        references = []
        if chance.random() < 0.6:
            level = at(s.ground, s.right) - chance.uniform(0.0, 1.0)
            lines.append({"Id": deep, "Label": "Aquifer", "Notes": None, "Points": self.points([(0.0, level)])})
            z = chance.uniform(s.base, -2.0)
            line = chance.choice([[(s.left, z), (s.right, z)], [(0.0, z)], [(s.right, z), (s.left, z)]])
            bottom = chance.choice([None, deep])
            references.append({"Id": self.id(), "Label": "Reference", "Notes": None, "Points": self.points(line),
                               "TopHeadLineId": deep, "BottomHeadLineId": bottom})
        return {"Id": self.id(), "UnitWeightWater": 9.81, "PhreaticLineId": phreatic, "HeadLines": lines,
                "ReferenceLines": references}

    def water_mesh(self):
        """Two triangles over the whole section, hydrostatic below a level under the ground."""
        s = self.section
        level = min(z for _, z in s.ground) - 0.5
        corners = [(s.left, s.base), (s.right, s.base), (s.right, 30.0), (s.left, 30.0)]
        nodes = [{"Point": {"X": x, "Z": z}, "TotalPorePressure": 9.81 * (level - z)} for x, z in corners]
        return {"Id": self.id(), "UnitWeightWater": 9.81,
                "Elements": [{"WaterMeshNodes": [nodes[i] for i in t]} for t in ((0, 1, 2), (0, 2, 3))],
                "WaterMeshProperties": {"FileName": "flow", "Date": None, "Time": None, "ScenarioName": None,
                                        "CalculationName": None}}

    def loads(self, layers):
        s, chance = self.section, self.chance
        loads = []
        for k in range(chance.choice([0, 0, 1, 2])):
            start = chance.uniform(s.left + 1.0, s.right - 6.0)
            degrees = [{"LayerId": layer, "Degree": 100.0} for layer in layers]
            loads.append({"Label": chance.choice(["traffic", "traffic", ""]), "Notes": None, "Start": round(start, 3),
                          "End": round(start + chance.choice([0.05, 2.5, 5.0]), 3), "Magnitude": 13.0, "Spread": 30.0,
                          "Consolidations": degrees})
        return {"Id": self.id(), "UniformLoads": loads, "LineLoads": [], "Trees": None, "LayerLoads": []}

    def states(self, outlines):
        """A state point in some of the layers, at a place of the file's own choice: the middle of its outline."""
        points = []
        for layer, (_, outline) in outlines:
            if self.chance.random() < 0.5:
                x, z = (sum(c) / len(outline) for c in zip(*outline))
                stress = {"StateType": "Pop", **self.number("Pop", 15.0), "Ocr": 1.0, "YieldStress": "NaN"}
                points.append({"Id": self.id(), "LayerId": layer, "Label": "", "Notes": None, "IsProbabilistic": False,
                               "Point": {"X": x, "Z": z}, "Stress": stress})
        return {"Id": self.id(), "StatePoints": points, "StateLines": []}

    def write(self, path):
        s, chance = self.section, self.chance
        shapes = made_unpleasant(s, chance)
        soils = [self.soil(k) for k in range(s.n_layers + (s.lens is not None))]
        layers = [self.id() for _ in shapes]
        stage = {"Id": self.id(), "Label": "high water", "Notes": None}
        parts = {
            "GeometryId": ("geometries/geometry", {"Id": self.id(), "Layers": [
                {"Id": layer, "Label": "", "Notes": None, "Points": self.points(outline)}
                for layer, (_, outline) in zip(layers, shapes)]}),
            "SoilLayersId": ("soillayers/soillayers", {"Id": self.id(), "SoilLayers": [
                {"LayerId": layer, "SoilId": soils[soil]["Id"]} for layer, (soil, _) in zip(layers, shapes)]}),
            "DecorationsId": ("decorations/decorations", {"Id": self.id(), "Excavations": [
                {"Label": "ditch", "Notes": None, "Points": self.points(s.excavation)}] if s.excavation else []}),
            "WaternetId": ("waternets/waternets", self.water()),
            "StateId": ("states/states", self.states(list(zip(layers, shapes)))),
            "LoadsId": ("loads/loads", self.loads(layers)),
        }
        if self.version == "2" and chance.random() < 0.3:
            stage["WaterDefinitionType"] = "WaterMesh"
            parts["WaterMeshId"] = ("watermeshes/watermeshes", self.water_mesh())
        for key, (name, content) in parts.items():
            stage[key] = content["Id"]
            self.add(name + ".json", content)
        self.add("soils.json", {"Soils": soils})
        self.add("projectinfo.json", {"ApplicationModified": "D-Stability"})
        if self.version == "1":
            self.add("stages/stage.json", stage)
        else:
            self.add("scenarios/scenario.json", {"Id": self.id(), "Label": "", "Notes": None, "Stages": [stage],
                                                 "Calculations": []})
        back, mark = chance.random() < 0.3, chance.random() < 0.3
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
            for name, content in self.members.items():
                text = json.dumps(content).encode("utf-8-sig" if mark else "utf-8")
                archive.writestr(name.replace("/", "\\") if back else name, text)
            archive.writestr("checksum", "0" * 64)
        return soils


def run(command):
    begun = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run(command, capture_output=True, text=True, timeout=10 * SECONDS, check=False)
    if done.returncode != 0:
        raise AssertionError(f"status {done.returncode} of {' '.join(map(str, command[1:]))}:\n{done.stderr}")
    if resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - begun > SECONDS:
        raise AssertionError(f"{command[1]} took more than {SECONDS} s")
    if "has no effect" in done.stderr:
        raise AssertionError(f"{command[1]} finds keys without effect in a case that Terp wrote:\n{done.stderr}")


def numbers_of_the_report(text, n_soils):
    """Area [m^2] of each soil by report.md, and the weight of all [N/m]."""
    area_of = [0.0] * n_soils
    for number, value in re.findall(r"^\| soil_(\d+)\w* \| ([\d.]+) \|", text, re.MULTILINE):
        area_of[int(number)] += float(value)
    return area_of, 1e3 * float(re.search(r"^\| all \| [\d.]+ \| ([\d.]+) \|", text, re.MULTILINE)[1])


def compare(section, soils, folder):
    """Areas and weight beside those drawn. A soil may have several materials: cut at the water, by its POP."""
    expected = section.areas()
    slack = section.slack + section.thin() + 1e-9 * sum(expected)
    in_report, weight = numbers_of_the_report((folder / "report.md").read_text(encoding="utf-8"), len(soils))
    case = tomllib.loads((folder / "case.toml").read_text(encoding="utf-8"))
    in_case = [0.0] * len(soils)
    for body in case["body"]:
        if body["name"].endswith("fill below the base"):  # of a corner that was drawn 1 mm higher
            thickness = area(body["polygon"]) / (section.right - section.left)
            if abs(thickness) > 0.002:
                raise AssertionError(f"{body['name']} is {abs(thickness):.3g} m thick")
            continue
        in_case[int(re.match(r"soil_(\d+)", body["material"])[1])] += abs(area(body["polygon"]))
    for k, (soil, drawn) in enumerate(zip(soils, expected)):
        # A later body takes its place from an earlier one: the layer around a lens may be drawn with it or without.
        with_lens = expected[-1] if section.lens is not None and k == section.lens[0] else 0.0
        off = min(abs(in_case[k] - drawn), abs(in_case[k] - drawn - with_lens))
        if max(off, abs(in_report[k] - drawn) - 1e-6) > slack:
            raise AssertionError(f"{soil['Name']}: {in_case[k]:.9g} m^2 in the case, {in_report[k]:.9g} in the report, "
                                 f"{drawn:.9g} drawn, slack {slack:.3g}")
    drawn = sum(1e3 * soil["VolumetricWeightAbovePhreaticLevel"] * a for soil, a in zip(soils, expected))
    if abs(weight - drawn) > 25e3 * (slack - 1e-9 * sum(expected)) + 1e-9 * drawn + 1e-3:
        raise AssertionError(f"weight {weight:.9g} N/m in the report, {drawn:.9g} drawn")


def trial(terp, seed, folder):
    chance = random.Random(seed)
    section = Section(chance)
    file = File(section, chance)
    path = folder / f"section_{seed}.stix"
    soils = file.write(path)
    target = folder / f"case_{seed}"
    run([terp, "import", path, "-o", target, "--force", "--between", f"{section.left},{section.right}", "--base",
         str(section.base), "--cell", "1"])
    compare(section, soils, target)
    run([terp, "check", target / "case.toml"])
    run([terp, "import", path, "-o", folder / f"part_{seed}", "--force"])
    return section


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("terp")
    parser.add_argument("--number", type=int, default=10)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", metavar="FOLDER")
    options = parser.parse_args()
    failed = []
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(options.keep or scratch)
        folder.mkdir(parents=True, exist_ok=True)
        for seed in range(options.seed, options.seed + options.number):
            try:
                trial(Path(options.terp).resolve(), seed, folder)
            except AssertionError as fault:
                failed.append(seed)
                print(f"seed {seed}: {fault}", file=sys.stderr)
    print(f"{options.number - len(failed)} of {options.number} sections are imported as drawn")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
