#!/usr/bin/env python3
"""A reach of dikes on an aquifer whose head lifts the land behind them in a flood, written as D-Stability files.

    aquifer_dikes.py FOLDER [--number 12] [--seed 1] [--terp TERP]

Each has a dike body of drained soil, a cover layer of clay or peat, and sand below. In the flood the water in the sand
carries all of the cover over 10 to 40 m behind the toe, or, in every fourth section, no part of it. The first section
is always the same: a cover of 3 m, no effective stress over 30 m. With --terp each is imported and checked: it must
have a film where the land lifts, and none elsewhere.
"""
import argparse
import json
import random
import subprocess
import tomllib
import zipfile
from pathlib import Path

WATER = 9.81  # kN/m3


class Dike:
    def __init__(self, k, chance):
        plain = k == 0
        draw = (lambda low, high: (low + high) / 2) if plain else chance.uniform
        self.name = f"dike_{k + 1:02d}"
        self.height = 5.0 if plain else round(chance.uniform(3.5, 6.5), 1)
        self.slope = 3.0 if plain else round(chance.uniform(2.5, 3.5), 1)
        self.cover = 3.0 if plain else round(chance.uniform(2.0, 5.0), 1)
        self.is_peat = not plain and chance.random() < 0.3
        self.lifted = 30.0 if plain else (0.0 if k % 4 == 3 else round(chance.uniform(10.0, 40.0)))
        self.berm = 0.0 if plain or chance.random() < 0.6 else round(chance.uniform(4.0, 10.0))
        self.load = not plain and chance.random() < 0.4
        self.weight = 12.0 if self.is_peat else round(draw(15.0, 17.0), 1)
        self.river = round(self.height - 0.5, 2)
        self.crest = 4.0
        self.toe = self.crest + self.slope * self.height + (self.berm + self.slope if self.berm else 0.0)
        self.ends = -50.0, round(self.toe + max(self.lifted, 20.0) + 40.0)

    def ground(self):
        h, outer = self.height, -self.slope * self.height
        points = [(self.ends[0], 0.0), (outer, 0.0), (0.0, h), (self.crest, h)]
        if self.berm:
            low = 1.0
            foot = self.crest + self.slope * (h - low)
            points += [(foot, low), (foot + self.berm, low), (foot + self.berm + self.slope * low, 0.0)]
            self.toe = points[-1][0]
        else:
            points += [(self.toe, 0.0)]
        return points + [(self.ends[1], 0.0)]

    def head_of_uplift(self):
        """Head at which the water carries the cover [m]; that of the phreatic line where nothing is lifted."""
        return -self.cover + self.cover * self.weight / WATER if self.lifted else -0.3

    def lines(self, river, share):
        """Phreatic line and head of the sand. share: of the way from the level of the land to that of the flood."""
        head = (share if self.lifted else 1.0) * self.head_of_uplift()
        end = self.toe + self.lifted
        phreatic = [(self.ends[0], river), (-self.slope * (self.height - max(river, 0.0)), river),
                    (self.crest, max(0.5 * river, 0.0)), (self.toe, -0.2), (self.ends[1], -0.3)]
        near = max(head, river * 0.7) if self.lifted else 0.5 * (river - 0.2)
        aquifer = [(self.ends[0], river), (-self.slope * self.height, river), (self.crest, near), (self.toe, head),
                   (end, head), (self.ends[1], 0.0 if self.lifted else -0.3)]
        return phreatic, aquifer


class File:
    def __init__(self, dike):
        self.dike, self.last, self.members = dike, 0, {}

    def id(self):
        self.last += 1
        return str(self.last)

    def add(self, name, content):
        self.members[name] = {**content, "ContentVersion": "2"}
        return content["Id"]

    @staticmethod
    def points(line):
        return [{"X": x, "Z": z} for x, z in line]

    @staticmethod
    def number(name, value):
        return {name: value, name + "StochasticParameter":
                {"IsProbabilistic": False, "Mean": 1.0, "StandardDeviation": 0.0}}

    def soil(self, name, weight, cohesion, friction, ratio=None):
        drained = {**self.number("Cohesion", cohesion), **self.number("FrictionAngle", friction),
                   **self.number("Dilatancy", 0.0)}
        undrained = {**self.number("ShearStrengthRatio", ratio or "NaN"),
                     **self.number("StrengthIncreaseExponent", 0.85)}
        model = "Su" if ratio else "MohrCoulombAdvanced"
        return {"Id": self.id(), "Name": name, "Code": name, "Notes": None, "IsProbabilistic": False,
                "VolumetricWeightAbovePhreaticLevel": weight[0], "VolumetricWeightBelowPhreaticLevel": weight[1],
                "ShearStrengthModelTypeAbovePhreaticLevel": model, "ShearStrengthModelTypeBelowPhreaticLevel": model,
                "MohrCoulombAdvancedShearStrengthModel": drained, "SuShearStrengthModel": undrained}

    def stage(self, label, layers, soils, water):
        d = self.dike
        outlines = [o for o, _ in layers]
        ids = [self.id() for _ in layers]
        phreatic, aquifer = water
        lines = [self.id(), self.id()]
        pop = {"StateType": "Pop", **self.number("Pop", 15.0), "Ocr": 1.0, "YieldStress": "NaN"}
        load = {"Label": "traffic", "Notes": None, "Start": 0.5, "End": 3.0, "Magnitude": 13.0, "Spread": 30.0,
                "Consolidations": [{"LayerId": i, "Degree": 0.0 if k == 1 else 100.0} for k, i in enumerate(ids)]}
        n = f"_{len(self.members)}.json"
        return {"Id": self.id(), "Label": label, "Notes": None,
                "GeometryId": self.add("geometries/geometry" + n, {"Id": self.id(), "Layers": [
                    {"Id": i, "Label": f"L{k}", "Notes": None, "Points": self.points(o)}
                    for k, (i, o) in enumerate(zip(ids, outlines))]}),
                "SoilLayersId": self.add("soillayers/soillayers" + n, {"Id": self.id(), "SoilLayers": [
                    {"LayerId": i, "SoilId": soils[s]["Id"]} for i, (_, s) in zip(ids, layers)]}),
                "DecorationsId": self.add("decorations/decorations" + n, {"Id": self.id(), "Excavations": []}),
                "WaternetId": self.add("waternets/waternets" + n, {
                    "Id": self.id(), "UnitWeightWater": WATER, "PhreaticLineId": lines[0],
                    "HeadLines": [{"Id": i, "Label": t, "Notes": None, "Points": self.points(p)}
                                  for i, t, p in zip(lines, ("Phreatic", "Aquifer"), (phreatic, aquifer))],
                    "ReferenceLines": [{"Id": self.id(), "Label": "Top of the sand", "Notes": None,
                                        "Points": self.points([(x, -d.cover) for x in d.ends]),
                                        "TopHeadLineId": lines[1], "BottomHeadLineId": lines[1]}]}),
                "StateId": self.add("states/states" + n, {"Id": self.id(), "StateLines": [], "StatePoints": [
                    {"Id": self.id(), "LayerId": ids[1], "Label": "", "Notes": None, "IsProbabilistic": False,
                     "Point": {"X": d.toe + 5.0, "Z": -0.5 * d.cover}, "Stress": pop}]}),
                "LoadsId": self.add("loads/loads" + n, {
                    "Id": self.id(), "UniformLoads": [load] if d.load and label == "flood" else [], "LineLoads": [],
                    "Trees": None, "LayerLoads": []})}

    def write(self, path):
        d = self.dike
        ground = d.ground()
        (left, right), cover, base = d.ends, -d.cover, -d.cover - 10.0
        body = [p for p in ground if p[1] > 0.0]
        foot = [(-d.slope * d.height, 0.0), *body, (d.toe, 0.0)]
        layers = [(foot, 0),
                  ([(left, 0.0), foot[0], (d.toe, 0.0), (right, 0.0), (right, cover), (left, cover)], 1),
                  ([(left, cover), (right, cover), (right, base), (left, base)], 2)]
        soils = [self.soil("dike", (19.0, 20.0), 0.0, 33.0),
                 self.soil("peat" if d.is_peat else "clay", (d.weight, d.weight), 0.0, 0.0,
                           0.30 if d.is_peat else 0.24),
                 self.soil("sand", (18.0, 20.0), 0.0, 32.0)]
        stages = [self.stage("daily", layers, soils, d.lines(0.3, 0.2)),
                  self.stage("flood", layers, soils, d.lines(d.river, 1.0))]
        self.members["soils.json"] = {"Soils": soils, "ContentVersion": "2"}
        self.members["projectinfo.json"] = {"ApplicationModified": "D-Stability", "ContentVersion": "2"}
        self.add("scenarios/scenario.json", {"Id": self.id(), "Label": "", "Notes": None, "Stages": stages,
                                             "Calculations": []})
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
            for name, content in self.members.items():
                archive.writestr(name, json.dumps(content))


def try_import(terp, dike, path):
    """What is wrong with the films of an imported section; nothing: they are where the land lifts."""
    folder = path.with_suffix("")
    for command in ([terp, "import", path, "--cell", "1", "-o", folder, "--force"],
                    [terp, "check", folder / "case.toml"]):
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            return done.stderr
    case = tomllib.loads((folder / "case.toml").read_text())
    films = [body["polygon"] for body in case["body"] if body["material"].startswith("film_")]
    tops = {round(max(z for _, z in film), 3) for film in films}
    reach = max((x for film in films for x, _ in film), default=0.0)
    if not dike.lifted:
        return f"{len(films)} films, and no land lifts" if films else ""
    if tops != {round(-dike.cover, 3)}:
        return f"films at {tops}, the sand begins at {-dike.cover}"
    return "" if reach >= dike.toe + dike.lifted else f"films end at x = {reach}, before the land that lifts"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--number", type=int, default=12)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--terp", help="program that imports and checks them")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    chance = random.Random(options.seed)
    for k in range(options.number):
        dike = Dike(k, chance)
        dike.ground()  # which sets the toe
        path = options.folder / f"{dike.name}.stix"
        File(dike).write(path)
        if options.terp and (fault := try_import(options.terp, dike, path)):
            raise SystemExit(f"{path}: {fault}")


if __name__ == "__main__":
    main()
