"""Rows of the table: what must stay where it is, and what falls."""
from row import Measure, row

GRAVITY = {"gravity": [0.0, -9.81]}
WALLS = {"left": "roller", "right": "roller", "bottom": "fixed"}


def clay(strength, density=1800.0):
    return {"model": "tresca_softening", "density": density, "shear_modulus": 2e5, "poisson_ratio": 0.48,
            "su_peak": strength, "su_residual": strength}


def ground_mesh(v, width, depth, top, along, border=()):
    """Mesh of level ground, and the bottom of the soil in it [corners]. A polygon has a bed of 1:5.

    along: the surface at `top` lies along cells. border: heights of borders along cells.
    """
    if v.kind != "polygon":
        level = (top, *border) if along else border
        return v.mesh(width, depth, 1.0, amount=v.moves_of_nodes(), level=level), [[0, 0], [width, 0]]
    bed = [[0, 0], [width / 2, 0], [width, 2]]
    high = top if along else depth
    return {"polygon": bed + [[width, high], [0, high]], "edges": {"bottom": [0, 1], "right": [2], "top": [3],
            "left": [4]}, "cell": 1.0, "variant": v.draw("mesh", range(8)), "follow_bodies": along or bool(border)}, bed


def level_ground(v, strength, along):
    """Level ground of one clay that begins with its overburden, undamped."""
    top = 7.0 if along else 7.0 + v.random.uniform(0.2, 0.8)
    mesh, bed = ground_mesh(v, 20.0, 9.0, top, along)
    body = {"material": "clay", "polygon": bed + [[20, top], [0, top]], "points_per_cell": v.points}
    return {"time": {"end": 10.0}, "mesh": mesh, "body": [body], "material": {"clay": clay(strength)},
            "initial": {"stress": "k0", "k0": 1.0}, "forces": GRAVITY, "boundary": WALLS}


@row(cross={"surface": ("across", "along")}, cycle={"su": (500, 200)})
def level_clay(v):
    """Level clay stays level. 2 x 2 points are judged at 500 Pa."""
    strength = v.factors["su"] = 500 if v.points == 2 else v.su
    run = v.run(level_ground(v, strength, v.surface == "along"))
    return [Measure("K in 4.5 s", run.largest("kinetic", 4.5), "J", at_most=5.0 if v.points == 2 else 1.0),
            Measure("moved in 10 s", run.last("moved_volume"), "m2", at_most=0.0)]


@row(number=6, cycle={"surface": ("across", "along")})
def level_clay_50_pa(v):
    """As far as it comes: printed, not judged."""
    run = v.run(level_ground(v, 50.0, v.surface == "along"))
    return [Measure("K in 4.5 s", run.largest("kinetic", 4.5), "J")]


@row(number=12, cycle={"surface": ("across", "along")})
def level_clay_factor(v):
    """No failure exists on level ground: 500 Pa stand at a ninth of the strength."""
    found = v.stability(level_ground(v, 500.0, v.surface == "along"), "--from", 9, "--to", 10, "--tolerance", 0.5)
    return [Measure("factor", found and (found["stable_at"] or 0.0) or 0.0, at_least=9.0)]


@row(cross={"border": ("inside", "along")})
def two_clays(v):
    """Two clays, the lower one heavier, the border inside cells or along them."""
    along = v.border == "along"
    middle = 4.0 if along else 4.0 + v.random.uniform(0.2, 0.8)
    mesh, bed = ground_mesh(v, 20.0, 9.0, 7.5, False, (middle,) if along else ())
    bodies = [{"material": "lower", "polygon": bed + [[20, middle], [0, middle]], "points_per_cell": v.points},
              {"material": "upper", "box": [[0, middle], [20, 7.5]], "points_per_cell": v.points}]
    run = v.run({"time": {"end": 10.0}, "mesh": mesh, "body": bodies, "initial": {"stress": "k0", "k0": 1.0},
                 "material": {"lower": clay(500.0, 2000.0), "upper": clay(500.0, 1400.0)}, "forces": GRAVITY,
                 "boundary": WALLS})
    most = (5.0 if v.points == 2 else 1.0) if along else 10.0
    return [Measure("K in 4.5 s", run.largest("kinetic", 4.5), "J", at_most=most),
            Measure("moved in 10 s", run.last("moved_volume"), "m2", at_most=0.0)]


@row(cross={"surface": ("across", "along")})
def still_water(v):
    """Water in a basin with a bank of 2:3 stays still for 20 s."""
    depth = 1.5 if v.surface == "along" else 1.5 + v.random.uniform(-0.2, 0.2)
    sides = dict.fromkeys(("left", "bottom", "right"), "roller")
    if v.kind == "polygon":
        mesh = {"polygon": [[0, 0], [4, 0], [7, 2], [0, 2]], "cell": 0.25, "variant": v.draw("mesh", range(8)),
                "edges": {"bottom": [0], "right": [1], "top": [2], "left": [3]}, "follow_bodies": v.surface == "along"}
    else:
        mesh = v.mesh(4.0, 2.0, 0.25, amount=v.moves_of_nodes(), level=(1.5,),
                      place=lambda x, y: (x * (1 + 0.375 * y), y))
    water = {"model": "newtonian_fluid", "density": 1000.0, "bulk_modulus": 2e6, "viscosity": 0.001}
    body = {"material": "water", "polygon": [[0, 0], [4, 0], [4 + 1.5 * depth, depth], [0, depth]],
            "points_per_cell": v.points}
    run = v.run({"time": {"end": 20.0}, "mesh": mesh, "body": [body], "material": {"water": water},
                 "initial": {"stress": "k0"}, "forces": GRAVITY, "boundary": sides})
    return [Measure("v in 2 s", run.largest("v_max", 2.0), "m/s"),
            Measure("v in 20 s", run.largest("v_max"), "m/s", at_most=0.02)]


@row(cycle={"strength": ("elastic", "clay")})
def free_fall(v):
    """A block that falls has no stress: no elastic energy, no plastic work, all of its momentum."""
    x, y = 4.0 + v.random.uniform(0, 2), 4.0 + v.random.uniform(0, 0.4)
    block = {"model": "linear_elastic", "density": 1800.0, "shear_modulus": 2e5, "poisson_ratio": 0.48}
    run = v.run({"time": {"end": 0.7}, "mesh": v.mesh(20.0, 9.0, 0.5, amount=v.moves_of_nodes()),
                 "body": [{"material": "block", "box": [[x, y], [x + 4.1, y + 4.1]], "points_per_cell": v.points}],
                 "material": {"block": block if v.strength == "elastic" else clay(500.0)}, "forces": GRAVITY})
    momentum = run.last("mass") * 9.81 * run.last("time")
    return [Measure("elastic energy", run.largest("elastic"), "J", at_most=1e-5),
            Measure("plastic work", run.largest("plastic"), "J", at_most=0.0),
            Measure("error of momentum", abs(run.last("momentum_y") / momentum + 1), at_most=1e-11)]
