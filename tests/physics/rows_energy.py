"""Rows of the table: no energy from nothing."""
import math

import numpy as np

from row import Measure, row
from rows_ground import GRAVITY
from runs import TODAY

ROLLERS = dict.fromkeys(("left", "right", "bottom"), "roller")
MADE = 0.003  # most energy from nothing, as a part of the largest work of gravity


def elastic(young, ratio, density=1800.0):
    return {"model": "linear_elastic", "density": density, "shear_modulus": young / 2 / (1 + ratio),
            "poisson_ratio": ratio}


def above(corners, point, angle, upper):
    """The part of a convex polygon above (or below) a line through `point` that rises by `angle` [rad]."""
    height = [(-math.sin(angle) * (x - point[0]) + math.cos(angle) * (y - point[1])) * (1 if upper else -1)
              for x, y in corners]
    part = []
    for k, (a, h) in enumerate(zip(corners, height)):
        b, g = corners[(k + 1) % len(corners)], height[(k + 1) % len(corners)]
        if h >= 0:
            part.append(list(a))
        if h * g < 0:
            part.append([a[i] + (b[i] - a[i]) * h / (h - g) for i in (0, 1)])
    return part


@row(cycle={"contrast": (10, 100, 30, 1000, 10, 100), "stiff": ("above", "below")})
def elastic_slip(v):
    """Two elastic soils with a border that dips across cells swing for 10 s: no slip, no plastic work."""
    dip = v.draw("dip", (0, 6, 15, 27, 40, 60))
    box, middle = [[0, 0], [4, 0], [4, 2], [0, 2]], (2.0, 1.0 + v.random.uniform(-0.2, 0.2))
    bodies = [{"material": name, "polygon": above(box, middle, math.radians(dip), name == "upper"),
               "points_per_cell": v.points} for name in ("lower", "upper")]
    soils = {"lower": elastic(3e6, 0.3), "upper": elastic(3e6, 0.3)}
    soils["upper" if v.stiff == "above" else "lower"] = elastic(3e6 * v.contrast, 0.3)
    run = v.run({"time": {"end": 10.0}, "mesh": v.mesh(4.0, 2.4, 0.2), "body": bodies, "material": soils,
                 "forces": GRAVITY, "boundary": ROLLERS})
    made, lost = run.most_made(1.0)
    return [Measure("slip and plastic work", max(run.largest("plastic"), run.largest("slip_work")), "J", at_most=0.0),
            Measure("made", made, at_most=0.005), Measure("lost", lost, at_least=-0.005)]


def flow(v, points, ratio, mesh, material=None):
    """A clay dike without strength for its height flows for 6 s (front to the left and to the right)."""
    soil = material or {"model": "tresca_softening", "density": 1850.0, "shear_modulus": 3e6, "poisson_ratio": ratio,
                        "su_peak": 5e3, "sensitivity": 3.0, "eta": 15.0, "softening": {"length": 1.0}}
    outline = [[0, 0], [52, 0], [52, 4], [36, 4], [26, 8], [23, 8], [12, 4], [0, 4]]
    return {"time": {"end": 6.0}, "mesh": mesh,
            "body": [{"material": "clay", "points_per_cell": points, "polygon": outline}], "material": {"clay": soil},
            "initial": {"stress": "k0", "k0": 0.9}, "forces": GRAVITY, "method": {"relaxation_time": 0.05},
            "boundary": {"left": "roller", "right": "roller", "bottom": "fixed"}, "output": {"ledger": {"every": 0.05}}}


def dike_mesh(v):
    return v.mesh(52.0, 9.0, 0.5, slant=0.1)


def energy(v, run):
    """Energy made and lost of a flow: less may be lost with more points."""
    made, lost = run.most_made()
    return [Measure("made", made, at_most=MADE),
            Measure("lost", lost, at_least={2: -0.05, 3: -0.03, 4: -0.01}[v.points])]


@row(cycle={"ratio": (0.45, 0.49)})
def flowing_clay(v):
    """Clay that flows never has more energy than gravity gave."""
    run = v.run(flow(v, v.points, v.ratio, dike_mesh(v)))
    return energy(v, run) + [Measure("gravity", run.last("gravity_work") / 1e3, "kJ"),
                             Measure("v", run.largest("v_max"), "m/s", at_most=8.0)]


@row(number=12)
def flowing_clay_undrained(v):
    """The same with undrained soil of effective stress, cohesion 5 kPa and no friction."""
    soil = {"model": "mohr_coulomb", "density": 1850.0, "shear_modulus": 3e6, "poisson_ratio": 0.3, "cohesion": 5e3,
            "friction_angle": 0.0, "drainage": "undrained_effective"}
    run = v.run(flow(v, v.points, 0.3, dike_mesh(v), soil) | {"water": {"phreatic_line": [[0, 0], [52, 0]]}})
    return energy(v, run) + [Measure("v", run.largest("v_max"), "m/s", at_most=8.0)]


@row(number=12)
def clay_on_its_bed(v):
    """A column of weak clay that comes down on a bed of the same clay, where its points crowd."""
    soil = {"model": "tresca_softening", "density": 1800.0, "shear_modulus": 1e6, "poisson_ratio": 0.49,
            "su_peak": 3e3, "su_residual": 3e3}
    outline = [[0, 0], [24, 0], [24, 0.5], [13, 0.5], [13, 4.5], [11, 4.5], [11, 0.5], [0, 0.5]]
    run = v.run({"time": {"end": 3.0}, "mesh": v.mesh(24.0, 6.0, 0.25, slant=0.1), "forces": GRAVITY,
                 "body": [{"material": "clay", "points_per_cell": v.points, "polygon": outline}],
                 "material": {"clay": soil}, "initial": {"stress": "k0", "k0": 0.8},
                 "boundary": {"left": "roller", "right": "roller", "bottom": "fixed"},
                 "output": {"ledger": {"every": 0.02}}}, may_stop=True)
    return energy(v, run)


@row(number=6, base={"points": (2,)}, cycle={"ratio": (0.45, 0.49)})
def flowing_clay_front(v):
    """2 x 2 points flow as far as 4 x 4, and gravity does the same work."""
    mesh = dike_mesh(v)
    few, many = (v.run(flow(v, n, v.ratio, mesh), f"points_{n}") for n in (2, 4))
    ratios = {key: few.last(key) / many.last(key) for key in ("gravity_work",)}
    ratios["front"] = (few.last("front_x") - 36) / (many.last("front_x") - 36)
    ratios["front to the left"] = (12 - few.last("front_left_x")) / (12 - many.last("front_left_x"))
    return [Measure(f"{key}, 2 x 2 over 4 x 4", value, at_least=0.9, at_most=1.1) for key, value in ratios.items()]


@row()
def random_boxes(v):
    """An elastic box with points at random places swings for 10 s."""
    step = 0.5 / v.points
    lines = ["x,y,volume,material"]
    for j in range(round(2 / step)):
        for i in range(round(4 / step)):
            place = [(k + 0.5 + v.random.uniform(-1.2, 1.2)) * step for k in (i, j)]
            x, y = (min(max(c, 1e-3), most - 1e-3) for c, most in zip(place, (4, 2)))
            lines.append(f"{x:.9f},{y:.9f},{step * step:.9f},clay")
    v.path("points.csv").write_text("\n".join(lines) + "\n")
    run = v.run({"time": {"end": 10.0}, "mesh": v.mesh(4.0, 3.0, 0.5, amount=0.2), "body": [{"points": "points.csv"}],
                 "material": {"clay": {"model": "linear_elastic", "density": 1850.0, "shear_modulus": 3e6,
                                       "poisson_ratio": 0.49}}, "forces": GRAVITY, "boundary": ROLLERS})
    made, lost = run.most_made(1.0)
    return [Measure("made", made, at_most=MADE), Measure("lost", lost)]


SLIVERS = (1e-6, 1e-5, 1e-4, 1e-3, 3e-3, 0.01, 0.03, 0.1, 0.2)


@row(cross={"shape": ("box", "sliding box", "steps")}, cycle={"over": SLIVERS})
def corner_slivers(v):
    """Corners that lie a little in the next cell shake no more than corners on the nodes."""
    cell, height, strength = (1.0, 4.0, 40e3) if v.shape == "steps" else (0.5, 2.0, 12e3)
    left = 1.0 if v.shape == "sliding box" else 0.0
    mesh = v.mesh(9.0, height + 2 * cell, cell, kept=[(left + 4, 2), (6, 2), (3, 4)])
    soil = {"model": "tresca_softening", "density": 1850.0, "shear_modulus": 2e6, "poisson_ratio": 0.48,
            "su_peak": strength, "su_residual": strength}

    def fastest(over, name):
        outline = [[left, 0], [left + 4 + over, 0], [left + 4 + over, 2 + over], [left, 2 + over]]
        if v.shape == "steps":
            outline = [[0, 0], [6 + over, 0], [6 + over, 2 + over], [3 + over, 2 + over], [3 + over, 4 + over],
                       [0, 4 + over]]
        run = v.run({"time": {"end": 1.0}, "mesh": mesh, "material": {"clay": soil},
                     "body": [{"material": "clay", "points_per_cell": v.points, "polygon": outline}],
                     "forces": {"gravity": [0.3 if left else 0.0, -9.81]},
                     "boundary": {"left": "roller", "bottom": "roller"}}, name)
        return run.largest("v_max")

    whole, cut = fastest(0.0, "whole"), fastest(v.over * cell, "cut")
    more = 1.4 if v.shape == "steps" else 1.2
    return [Measure("v", cut, "m/s", at_most=min(1.0, more * whole)), Measure("whole cells", whole, "m/s")]


FINITE_ELEMENTS = {0.1: 1990.0, 0.05: 2012.0}  # J: kinetic energy at 0.3 s; the limit of small cells is 2021 J


@row(number=12, base={"kind": ("rectangle", "quads")}, cycle={"cell": (0.1, 0.1, 0.05)})
def model_1(v):
    """The paper's column without damping: kinetic energy at 0.3 s. Shares of points are printed."""
    soil = {"model": "tresca_softening", "density": 1990.0, "shear_modulus": 2e6, "poisson_ratio": 0.48,
            "su_peak": 8e3, "su_residual": 8e3}
    run = v.run({"time": {"end": 0.3}, "mesh": v.mesh(10.0, 3.0, v.cell, amount=0.2), "material": {"clay": soil},
                 "body": [{"material": "clay", "box": [[0, 0], [8, 2]], "points_per_cell": v.points}],
                 "forces": GRAVITY, "boundary": ROLLERS})
    expected, judged = FINITE_ELEMENTS[v.cell], v.shares == "overlap"
    bounds = {"at_least": 0.993 * expected, "at_most": 1.007 * expected} if judged else {}
    return [Measure("K", run.last("kinetic"), "J", **bounds), Measure("made", run.most_made()[0])]


@row(number=6, cycle={"ratio": (0.0, 0.3)})
def cantilever(v):
    """An elastic beam that swings for ten periods: the balanced pressure gives it no energy."""
    case = {"time": {"end": 6.45}, "mesh": v.mesh(4.5, 3.0, 0.125, slant=0.1), "forces": GRAVITY,
            "body": [{"material": "beam", "box": [[0, 2], [4, 2.5]], "points_per_cell": v.points}],
            "material": {"beam": elastic(1e8, v.ratio, 1000.0)}, "boundary": {"left": "fixed"}}
    run, today = v.run(case), v.run(case | {"method": TODAY}, "today")
    gravity = run.largest("gravity_work")
    return [Measure("K over that of today", run.largest("kinetic") / today.largest("kinetic"), at_most=1.05),
            Measure("balance work", run.largest("balance_work") / gravity, at_most=0.05),
            Measure("sag over that of today", float(np.mean(run.column("gravity_work")[-100:])
                                                    / np.mean(today.column("gravity_work")[-100:])))]


TODAY_FORCE = {10: 1.032, 22.5: 1.034, 30: 1.035, 45: 1.047}  # mpm_gp, 4 x 4 points, after 0.32 m of slip


@row(number=24, cycle={"angle": (10, 30, 45, 22.5, -30), "stiff": (1, 10)})
def weak_layers(v):
    """Force on a weak layer of 2 m between strong blocks, in cells of 1 m that lie askew, over that of the layer."""
    length, strength = 20.0, 8e3
    cosine, sine = math.cos(math.radians(v.angle)), math.sin(math.radians(v.angle))
    mesh = v.mesh(30.0, 30.0, 1.0, slant=0.1, amount=0.2, place=lambda x, y: (
        length / 2 + cosine * (x - 15) - sine * (y - 15), 1.0 + sine * (x - 15) + cosine * (y - 15)))

    def soil(stiffness, strength):
        return {"model": "tresca_softening", "density": 1990.0, "shear_modulus": stiffness, "poisson_ratio": 0.45,
                "su_peak": strength, "su_residual": strength}

    bodies = [{"material": "strong", "points_per_cell": v.points, "box": [[0, -3], [length, 5]]},
              {"material": "weak", "points_per_cell": v.points, "box": [[0, 0], [length, 2]]}]
    footings = [{"name": "lower", "box": [[-50, -50], [100, -1.5]], "velocity": [-0.04, 0.0], "ramp": 0.5},
                {"name": "upper", "box": [[-50, 3.5], [100, 50]], "velocity": [0.04, 0.0], "ramp": 0.5}]
    run = v.run({"time": {"end": 4.3}, "mesh": mesh, "body": bodies, "footing": footings,
                 "material": {"strong": soil(2e6 * v.stiff, 10 * strength), "weak": soil(2e6, strength)},
                 "forces": {"damping": {"local": 0.2}}, "output": {"ledger": {"every": 0.025}}})
    # The footings part at 0.08 m/s after a ramp of 0.5 s: mean force while the slip doubles to s.
    force = []
    for slip in (0.16, 0.32):
        begins, ends = 0.25 + 0.25 * slip / 0.04, 0.25 + 0.5 * slip / 0.04
        work = run.at("boundary_work", ends) - run.at("boundary_work", begins)
        force.append(work / (0.08 * (ends - begins) * length * strength))
    most = (1.25 if v.scheme == "gp" else 1.30) if v.stiff > 1 else TODAY_FORCE[abs(v.angle)] + 0.02
    return [Measure("force after 0.32 m", force[1], at_most=most), Measure("0.16 m", force[0])]
