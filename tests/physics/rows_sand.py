"""Rows of the table: soil without cohesion rests and slides where it must, factors of safety, layers that slide."""
import math

import numpy as np

from row import Measure, row
from rows_ground import GRAVITY, WALLS
from runs import TODAY

STABLE, SLIDING, BETWEEN = (1.1, 1.3), (0.9, 0.75), (0.95, 1.0, 1.05)
SLOPES = (1.5, 2.0, 2.5, 3.0, 4.0, 6.0)  # horizontal over vertical
HEIGHT, CREST, LAND = 5.0, 4.0, 5.0  # m
DIKE = {"slope": SLOPES, "cells": (5, 10), "associated": (False, True), "water": ("dry", "half")}


def sand(friction, dilatancy=0.0, density=1835.0, shear_modulus=5e6):
    return {"model": "mohr_coulomb", "density": density, "shear_modulus": shear_modulus, "poisson_ratio": 0.3,
            "cohesion": 0.0, "friction_angle": friction, "dilatancy_angle": dilatancy}


def face_friction(v, strength):
    """Angle of friction [deg] of so many times the strength at which the face is at its limit.

    tan beta where the soil dilates with its friction or the strength is below that, tan(asin(tan beta)) without
    dilatancy: there the stress on planes along the face is not the one that the strength allows.
    """
    limit = 1 / v.slope
    if strength > 1 and not v.associated:
        limit = math.tan(math.asin(limit))
    return math.degrees(math.atan(strength * limit))


def sand_dike(v, strength, cell):
    """One face of a dike, from its crest at the left to the land, on 2 to 3 m of the same sand."""
    foot = 2.0 + v.draw("base", (0.15, 0.4, 0.65, 0.9))
    toe = CREST + v.slope * HEIGHT
    width = math.ceil(toe + LAND)
    friction = face_friction(v, strength)
    outline = [[0, 0], [width, 0], [width, foot], [toe, foot], [CREST, foot + HEIGHT], [0, foot + HEIGHT]]
    case = {"mesh": v.mesh(width, math.ceil(foot + HEIGHT) + 1, cell, slant=0.2),
            "body": [{"material": "sand", "polygon": outline, "points_per_cell": v.points}],
            "material": {"sand": sand(friction, friction if v.associated else 0.0)}, "forces": GRAVITY,
            "boundary": WALLS}
    if v.water == "half":
        case["water"] = {"phreatic_line": [[0, foot + HEIGHT / 2], [width, foot + HEIGHT / 2]]}
    return case, friction


def from_rest(v, strength, cell, name, may_stop=False):
    """10 s without damping from the stress in which the dike rests, if there is one."""
    case, _ = sand_dike(v, strength, cell)
    return v.run(case | {"initial": {"stress": "equilibrium"}, "time": {"end": 10.0}}, name, may_stop=may_stop)


@row(number=36, cycle=DIKE | {"strength": STABLE})
def sand_rests(v):
    """A face with 1.1 times the strength that it needs comes to rest and stays for 10 s without damping."""
    run = from_rest(v, v.strength, HEIGHT / v.cells, "rest")
    return [Measure("moved in 10 s", run.last("moved_volume"), "m2", at_most=0.0),
            Measure("v at the end", run.last("v_999"), "m/s")]


@row(number=36, cycle=DIKE | {"strength": SLIDING})
def sand_slides(v):
    """A face with 0.9 times the strength slides: no equilibrium, and from k0 a skin of half a cell moves in 6 s."""
    cell = HEIGHT / v.cells
    case, friction = sand_dike(v, v.strength, cell)
    found = v.run(case | {"initial": {"stress": "equilibrium"}, "time": {"end": 0.01}}, "rest", may_stop=True)
    k0 = {"stress": "k0", "k0": 1 - math.sin(math.radians(friction))}
    # Soil that dilates without end outruns its time step: such a run may stop once it has moved.
    run = v.run(case | {"initial": k0, "time": {"end": 6.0}}, "k0", may_stop=True)
    skin = 0.5 * cell * HEIGHT * math.hypot(1, v.slope)
    return [Measure("equilibrium found", 0.0 if found.code == 3 else 1.0, at_most=0.0),
            Measure("moved from k0", run.last("moved_volume"), "m2", at_least=skin)]


@row(number=6, base={"shares": ("overlap",)}, cycle=DIKE | {"strength": BETWEEN, "cells": (5,)})
def sand_between(v):
    """Between the two bounds: the verdict is printed (1 rests), and is the same on half the cells."""
    runs = [from_rest(v, v.strength, HEIGHT / v.cells / k, f"cells_{k}", may_stop=True) for k in (1, 2)]
    rests = [float(run.code == 0 and run.last("moved_volume") == 0) for run in runs]
    return [Measure("rests", rests[0]), Measure("on half the cells", rests[1], at_least=rests[0], at_most=rests[0])]


@row(number=18, cycle={"fill": (0.05, 0.1, 0.2, 0.35, 0.5, 0.9), "water": ("dry", "deep"), "friction": (25.0, 35.0)})
def level_sand(v):
    """Level sand, dry or under 6 m of water, whose surface fills a part of a cell: at rest from the start."""
    top = 3.0 + 0.5 * v.fill
    case = {"mesh": v.mesh(10.0, 5.0, 0.5, slant=0.0), "forces": GRAVITY, "boundary": WALLS,
            "body": [{"material": "sand", "box": [[0, 0], [10, top]], "points_per_cell": v.points}],
            "material": {"sand": sand(v.friction, density=2000.0)}, "initial": {"stress": "equilibrium"},
            "time": {"end": 3.0}}
    if v.water == "deep":
        case["water"] = {"phreatic_line": [[0, 9], [10, 9]]}
    run = v.run(case, "rest")
    return [Measure("moved in 3 s", run.last("moved_volume"), "m2", at_most=0.0),
            Measure("v at the end", run.last("v_999"), "m/s")]


@row(number=18, cycle={"slope": (2.5, 3.0, 4.0), "cells": (5, 10), "strength": (0.9, 0.75, 1.3)})
def seepage_face(v):
    """A face with water seeping along it, psi = phi: slides at 0.9 of the strength of its closed form, rests at 1.3.

    F = (gamma cos^2 beta - gamma_w) / (gamma sin beta cos beta) tan phi, for vertical columns of water.
    """
    cell, weight, beta = HEIGHT / v.cells, 20e3, math.atan(1 / v.slope)
    needed = weight * math.sin(beta) * math.cos(beta) / (weight * math.cos(beta) ** 2 - 9810.0)
    friction = math.degrees(math.atan(v.strength * needed))
    foot = 2.0 + v.draw("base", (0.15, 0.4, 0.65, 0.9))
    toe = CREST + v.slope * HEIGHT
    width = math.ceil(toe + LAND)
    ground = [[0, foot + HEIGHT], [CREST, foot + HEIGHT], [toe, foot], [width, foot]]
    run = v.run({"mesh": v.mesh(width, math.ceil(foot + HEIGHT) + 1, cell, slant=0.2), "forces": GRAVITY,
                 "boundary": WALLS, "water": {"phreatic_line": ground}, "initial": {"stress": "equilibrium"},
                 "body": [{"material": "sand", "polygon": [[0, 0], [width, 0], *ground[::-1]],
                           "points_per_cell": v.points}],
                 "material": {"sand": sand(friction, friction, density=weight / 9.81)}, "time": {"end": 4.0}},
                "rest", may_stop=True)
    rests = float(run.code == 0 and run.last("moved_volume") == 0)
    must = float(v.strength > 1)
    return [Measure("rests", rests, at_least=must, at_most=must)]


# Bishop's circles through the dike of sand of `dike_factor`, phi 30: least factor of those at least so deep [m].
CIRCLES = ((0.0, 1.443), (0.3, 1.454), (1.0, 1.498), (2.0, 1.661))
FACE = {False: 1.323, True: 1.443}  # closed form of the face of 1:2.5, without and with dilatancy


def factor(v, case, tolerance=0.02, least=0.0, most=0.0):
    """Factor, half-width and depth [m]; infinite, zero, zero where nothing was found."""
    options = ["--tolerance", tolerance] + (["--from", least, "--to", most] if least else [])
    found = v.stability(case, *options)
    if not found or found["factor_of_safety"] is None:
        return math.inf, math.inf, 0.0
    mechanism = found["mechanism"] or {"depth": 0.0}
    return found["factor_of_safety"], found["uncertainty"], mechanism["depth"]


def dike_factor_on(v, cell):
    outline = [[0, 0], [62, 0], [62, 5], [46.5, 5], [34, 10], [30, 10], [15, 5], [0, 5]]
    value, width, depth = factor(v, {
        "mesh": v.mesh(62.0, 12.0, cell, slant=0.1), "time": {"end": 1.0}, "forces": GRAVITY, "boundary": WALLS,
        "body": [{"material": "sand", "polygon": outline, "points_per_cell": v.points}],
        "material": {"sand": sand(30.0, 30.0 if v.associated else 0.0, shear_modulus=1e7)}}, 0.03, 1.0, 2.0)
    circle = float(np.interp(depth, *zip(*CIRCLES)))
    return [Measure("factor", value, at_least=1.30, at_most=(1.05 if v.associated else 1.0) * circle),
            Measure("+-", width), Measure("depth", depth, "m"), Measure("circle of that depth", circle),
            Measure("face", FACE[v.associated])]


@row(number=8, cycle={"associated": (False, True), "cell": (1.0, 1.0, 1.0, 0.5)})
def dike_factor(v):
    """Factor of safety of a sand dike: that of the mechanism's depth, not less than the face allows."""
    return dike_factor_on(v, v.cell)


@row(number=1, base={"shares": ("overlap",), "points": (2,), "kind": ("rectangle",)}, cycle={"associated": (False,)})
def dike_factor_fine(v):
    """The same on cells of 0.25 m."""
    return dike_factor_on(v, 0.25)


PLANE = math.radians(25.0)
LAYER = {"k0": (0.4, 0.6, 1.0), "cut": ("slip", "mean")}


def on_plane(x, above=0.0):
    return [x, 0.067385 + x * math.tan(PLANE) + above]


def plane_speeds(v, cell):
    """Mean speed [m/s] after 0.8 s of a sand layer of 1 m on rock, both cut by the cells; now and as it was."""
    thick = 1 / math.cos(PLANE)
    friction = math.degrees(math.atan(0.8 * math.tan(PLANE)))
    bodies = [{"material": "rock", "polygon": [[0, 0], [30, 0], on_plane(30), on_plane(0)]},
              {"material": "sand", "polygon": [on_plane(6), on_plane(22), on_plane(22, thick), on_plane(6, thick)]}]
    case = {"time": {"end": 0.8}, "mesh": v.mesh(30.0, 16.0, cell, slant=0.05), "forces": GRAVITY,
            "body": [body | {"points_per_cell": v.points} for body in bodies],
            "material": {"rock": {"model": "linear_elastic", "density": 2000.0, "shear_modulus": 2e8,
                                  "poisson_ratio": 0.3}, "sand": sand(friction, density=1800.0)},
            "initial": {"stress": "k0", "k0": v.k0},
            "boundary": dict.fromkeys(("left", "right", "bottom"), "fixed")}

    def speed(method, name):
        run = v.run(case | {"method": {"cut_cells": v.cut} | method}, name, fields=("velocity",))
        _, mean = run.motion(lambda p: 10 < p["x"] < 18 and p["y"] > on_plane(p["x"])[1])
        return -float(mean @ (math.cos(PLANE), math.sin(PLANE)))

    return speed({}, "run"), speed(TODAY, "today")


@row(number=8, cycle=LAYER | {"cell": (0.5, 0.5, 0.25)})
def sand_layer(v):
    """It slides no more than 5 % slower than before; exact 0.66 m/s."""
    now, today = plane_speeds(v, v.cell)
    return [Measure("speed", now, "m/s", at_least=0.95 * today), Measure("before", today, "m/s")]


@row(number=1, base={"points": (2,), "shares": ("overlap",), "kind": ("rectangle",)}, cycle=LAYER)
def sand_layer_fine(v):
    """On eight cells within 10 % of the exact speed."""
    now, today = plane_speeds(v, 0.125)
    return [Measure("speed", now, "m/s", at_least=max(0.594, 0.95 * today)), Measure("before", today, "m/s")]


SLAB = {  # size of the mesh, bed, clay, gravity: clay of 0.5 m on a firm bed, 20 degrees
    "along": ((20, 2.25), [[0, 0], [20, 0], [20, 1], [0, 1]], [[3.5, 1], [14.5, 1], [14, 1.5], [4, 1.5]],
              [3.35522, -9.21838]),
    "half": ((20, 2.5), [[0, 0], [20, 0], [20, 1.125], [0, 1.125]],
             [[3.5, 1.125], [14.5, 1.125], [14, 1.625], [4, 1.625]], [3.35522, -9.21838]),
    "askew": ((19, 8.5), [[0, 0], [19, 0], [19, 0.988744], [0, 7.90418]],
              [[3.63094, 6.58262], [13.9676, 2.8204], [13.6687, 3.46126], [4.2718, 6.88146]], [0, -9.81])}


@row(number=12, cycle={"border": tuple(SLAB)})
def clay_layer(v):
    """A clay cover two cells thick that must slide by 0.67 m in 1 s: no slower than before by more than 5 %."""
    size, bed, cover, gravity = SLAB[v.border]
    soils = {"bed": {"model": "linear_elastic", "density": 1990.0, "shear_modulus": 2e6, "poisson_ratio": 0.3},
             "clay": {"model": "tresca_softening", "density": 1990.0, "shear_modulus": 1e6, "poisson_ratio": 0.45,
                      "su_peak": 2e3, "su_residual": 2e3}}
    case = {"time": {"end": 1.0}, "mesh": v.mesh(*size, 0.25, slant=0.05, level=(1.0,)), "forces": {"gravity": gravity},
            "body": [{"material": name, "polygon": outline, "points_per_cell": v.points}
                     for name, outline in (("bed", bed), ("clay", cover))], "material": soils,
            "boundary": {"bottom": "fixed"} | (dict(left="roller", right="roller") if v.border == "askew" else {})}
    down = np.subtract(cover[1], cover[0]) / math.dist(cover[1], cover[0])

    def slid(method, name):
        run = v.run(case | {"method": method}, name, fields=("velocity",))
        moved, _ = run.motion(lambda p: np.cross(down, np.subtract((p["x"], p["y"]), cover[0])) > 0)
        return float(moved @ down)

    now, today = slid({}, "run"), slid(TODAY, "today")
    return [Measure("slid", now, "m", at_least=0.95 * today), Measure("before", today, "m")]


def bank(friction, associated, density="19.5 kN/m3", cohesion=0.0):
    return {"model": "mohr_coulomb", "density": density, "shear_modulus": "38462 kPa", "poisson_ratio": 0.3,
            "cohesion": cohesion, "friction_angle": friction, "dilatancy_angle": friction if associated else 0}


def subsoil(density, strength):
    return {"model": "tresca_softening", "density": density, "shear_modulus": "38462 kPa", "poisson_ratio": 0.45,
            "su_peak": strength, "sensitivity": 1.0}


def three_soils(associated):
    """P5, ACADS 1(c)."""
    outlines = {"soil1": [[0, 20], [90, 20], [90, 35], [50, 35], [30, 25], [0, 25]],
                "soil2": [[0, 20], [90, 20], [90, 31], [54, 31], [50, 29], [30, 25], [0, 25]],
                "soil3": [[0, 20], [90, 20], [90, 24], [52, 24], [40, 27], [30, 25], [0, 25]]}
    strength = {"soil1": (0.0, 38.0), "soil2": (5.3e3, 23.0), "soil3": (7.2e3, 20.0)}
    return outlines, {name: bank(phi, associated, cohesion=c) for name, (c, phi) in strength.items()}, \
        {"origin": [0, 20], "size": [90, 16], "cell": 1.0}


def bank_on_clay(associated):
    """P11, Duncan and Wright 15.9, S_u constant."""
    return {"clay": [[0, 0], [42.672, 0], [42.672, 6.096], [0, 6.096]],
            "bank": [[12.192, 6.096], [42.672, 6.096], [42.672, 12.192], [27.432, 12.192]]}, \
        {"clay": subsoil("15.71 kN/m3", 14364.0), "bank": bank(35.0, associated, "19.64 kN/m3")}, \
        {"size": [42.672, 12.8016], "cell": 0.6096}


def high_bank(associated):
    """P12, Duncan and Wright 7.12."""
    return {"clay": [[0, 0], [213.36, 0], [213.36, 15.24], [0, 15.24]],
            "bank": [[30.48, 15.24], [182.88, 15.24], [121.92, 45.72], [91.44, 45.72]]}, \
        {"clay": subsoil("21.99 kN/m3", 119.7e3), "bank": bank(40.0, associated, "21.99 kN/m3")}, \
        {"size": [213.36, 48.768], "cell": 3.048}


# Least and greatest factor, least depth [m] of published slopes, on cells of so many times those of their folders.
PUBLISHED = {"P5": (three_soils, 1.36, 1.41, 5.0, 1.0), "P11": (bank_on_clay, 0.75, 0.81, 8.0, 1.0),
             "P12": (high_bank, 1.17, 1.25, 30.0, 1.0), "P12 on half the cells": (high_bank, 1.17, 1.23, 30.0, 0.5)}


@row(number=8, base={"kind": ("rectangle",), "points": (2, 2, 3)}, cycle={
    "slope": tuple(PUBLISHED), "associated": (False, False, True)})
def published_slopes(v):
    """Slopes with one soil without cohesion: the factor and the depth of the slide, not of a skin."""
    soils, least, most, depth, share = PUBLISHED[v.slope]
    outlines, materials, mesh = soils(v.associated)
    bodies = [{"material": name, "polygon": outline, "points_per_cell": v.points}
              for name, outline in outlines.items()]
    value, width, deep = factor(v, {"mesh": mesh | {"cell": mesh["cell"] * share}, "time": {"end": 1.0},
                                    "body": bodies, "material": materials, "forces": GRAVITY, "boundary": WALLS})
    return [Measure("factor", value, at_least=least, at_most=most), Measure("+-", width, at_most=0.0205),
            Measure("depth", deep, "m", at_least=depth)]
