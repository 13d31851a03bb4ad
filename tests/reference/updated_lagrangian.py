"""Updated-Lagrangian explicit finite elements in NumPy: a case of Terp on a mesh that moves with the soil.

No material point changes its cell and nothing is averaged between points. So a difference from Terp is due to material
points and background mesh. Plane strain, 4-node quadrilaterals, B-bar, lumped mass, leapfrog, rollers, and Tresca
without softening. Written from the paper (Sec. 2.1, Eqs. (5), (6)), from Belytschko, Liu & Moran, Nonlinear Finite
Elements for Continua and Structures, chapters 4 to 6, and from Hughes & Winget, Int. J. Numer. Meth. Engng 15 (1980)
1862-1867; not from the C++. Not for: softening, contact, cells that fold over.

    /usr/bin/python3 tests/reference/updated_lagrangian.py --cells 0.2 0.1    model 1 of the paper, rows of CSV

Units are SI per metre of thickness, tension is positive. Nodal vectors have the shape [2, n_nodes], values at corners
and at Gauss points [4, n_cells], with Gauss point g beside corner g. The stress is kept as its deviator xx, yy, xy at
each Gauss point (zz = -xx - yy) and one mean stress per cell. For B-bar gives all Gauss points of a cell the same
volumetric strain, and Tresca flow has none.
"""
import argparse
import csv
import sys
import tomllib
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from one_step import CORNERS, GAUSS, bulk_modulus

MODEL_1 = Path(__file__).resolve().parents[2] / "cases/column_collapse/model_1.toml"
SHAPE = (1 + GAUSS[:, :1] * CORNERS[:, 0]) * (1 + GAUSS[:, 1:] * CORNERS[:, 1]) / 4  # N_i at Gauss point g, [g, i]
D_XI = CORNERS[:, 0] * (1 + GAUSS[:, 1:] * CORNERS[:, 1]) / 4                        # dN_i/dxi
D_ETA = CORNERS[:, 1] * (1 + GAUSS[:, :1] * CORNERS[:, 0]) / 4                       # dN_i/deta


@dataclass
class Options:
    """How a body is integrated in time.

    order "central" is of second order in time: the first velocity is that of half a step, strain is that over the mesh
    in the middle of the step, and the kinetic energy takes the velocity of its own time. order "terp" is that of Terp's
    step: a whole step at first, strain over the mesh at the start of the step, the last velocity.
    """
    courant: float = 0.9      # dt over the time in which a wave passes the smallest cell, Body.stable_time_step
    order: str = "central"    # or "terp"
    rate: str = "none"        # or "jaumann": the stress turns with the soil, decision 0017
    damping: float = 0.0      # local, reading R13
    averaging_time: float = 0.0  # of the force that is damped [s], decision 0043


class Body:
    """Mesh, motion and stress of one body of soil. Starts at rest and free of stress."""

    def __init__(self, x, cells, fixed, material, gravity):
        """x [2, n_nodes]; cells [4, n_cells], counter-clockwise; fixed [2, n_nodes]: components without motion."""
        self.cells, self.fixed, self.material = cells, fixed, material
        self.gravity, self.floor = np.array(gravity)[:, None], x[1][fixed[1]].min() if fixed[1].any() else -np.inf
        self.x_0, self.x, self.v = x.copy(), x.copy(), np.zeros_like(x)
        volume = self.jacobian(x)[1]
        self.mass_g = material["density"] * volume      # of the Gauss points
        self.mass = self.to_nodes(SHAPE.T @ self.mass_g)  # lumped: sums of the rows of the consistent mass
        self.s, self.p = np.zeros((3, *volume.shape)), np.zeros(volume.shape[1])  # deviator, mean stress [Pa]
        self.mean_force = np.zeros_like(x)
        self.eps_eq_p, self.plastic, self.damped = np.zeros_like(volume), 0.0, 0.0  # Eq. (6); works [J]

    def to_nodes(self, at_corners):
        return np.bincount(self.cells.ravel(), at_corners.ravel(), self.x.shape[1])

    def jacobian(self, x):
        """x_xi, x_eta, y_xi, y_eta of nodal x [2, n_nodes] and their determinant, at the Gauss points."""
        first, second = x[0][self.cells], x[1][self.cells]
        parts = D_XI @ first, D_ETA @ first, D_XI @ second, D_ETA @ second
        return parts, parts[0] * parts[3] - parts[1] * parts[2]

    def internal_force(self):
        """sum_g detJ_g sigma_g grad N_i, Eq. (4), [N]. With one mean stress per cell it is also that of B-bar."""
        (x_xi, x_eta, y_xi, y_eta), _ = self.jacobian(self.x)
        xx, yy, xy = self.s[0] + self.p, self.s[1] + self.p, self.s[2]
        return np.array([self.to_nodes(D_XI.T @ (a * y_eta - b * x_eta) + D_ETA.T @ (b * x_xi - a * y_xi))
                         for a, b in ((xx, xy), (xy, yy))])

    def acceleration(self, options, dt=0.0):
        """a_i, and the force of local damping, R13, of the mean force, which follows over dt [s]. Both are zero where a
        roller carries the force."""
        r = np.where(self.fixed, 0.0, self.mass * self.gravity - self.internal_force())
        if options.averaging_time > 0:
            self.mean_force += (r - self.mean_force) * min(dt / options.averaging_time, 1.0)
        damped = -options.damping * np.abs(self.mean_force if options.averaging_time > 0 else r) * np.sign(self.v)
        return (r + damped) / self.mass, damped

    def deform(self, x, du, rate):
        """Stress after the displacements du [m] over the mesh x."""
        (x_xi, x_eta, y_xi, y_eta), det = self.jacobian(x)
        (u_xi, u_eta, w_xi, w_eta), _ = self.jacobian(du)
        xx, yy = (u_xi * y_eta - u_eta * y_xi) / det, (w_eta * x_xi - w_xi * x_eta) / det
        u_y, w_x = (u_eta * x_xi - u_xi * x_eta) / det, (w_xi * y_eta - w_eta * y_xi) / det
        trace = xx + yy
        if rate == "jaumann":  # tan(angle / 2) = spin / 2, Hughes & Winget (1980)
            self.s = rotated(self.s, 2 * np.arctan((w_x - u_y) / 4))
        two_g = 2 * self.material["shear_modulus"]
        trial = self.s + two_g * np.array([xx - trace / 3, yy - trace / 3, (u_y + w_x) / 2])
        self.p = self.p + bulk_modulus(self.material) * np.sum(det * trace, 0) / det.sum(0)  # B-bar: mean of the cell
        self.s, d_eps, work = tresca_return(trial, self.material["su_peak"], two_g)
        self.eps_eq_p += d_eps
        self.plastic += np.sum(det * work)

    def step(self, dt, kick, options):
        """Velocity from the acceleration over `kick` [s], then stress and position over dt [s]."""
        a, damped = self.acceleration(options, dt)
        self.v += kick * a
        du = dt * self.v
        self.deform(self.x + du / 2 if options.order == "central" else self.x, du, options.rate)
        self.damped += np.sum(damped * du)
        self.x += du

    def shape(self):
        """Slenderness, twice the area over the longest side or diagonal squared; that length [m]; convexity, the least
        detJ of a corner over its mean. A square has 1 and 1; a triangle, where a cell begins to fold over, 0 convexity.
        """
        corners = self.x[:, self.cells]
        ahead, back = (np.roll(corners, k, 1) - corners for k in (-1, 1))
        first, second = corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]
        longest = np.sqrt(np.maximum(np.maximum(np.sum(first**2, 0), np.sum(second**2, 0)),
                                     np.sum(ahead**2, 0).max(0)))
        twice_area = cross(first, second)
        return twice_area / longest**2, longest, 2 * cross(ahead, back).min(0) / twice_area

    def stable_time_step(self):
        """Area over the longest side or diagonal, over the speed of the P-wave [s]; smallest of all cells."""
        slenderness, longest, _ = self.shape()
        modulus = bulk_modulus(self.material) + 4 / 3 * self.material["shear_modulus"]
        return np.min(slenderness * longest) / 2 / np.sqrt(modulus / self.material["density"])


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def rotated(s, angle):
    """Deviator xx, yy, xy turned by the angle [rad], counter-clockwise."""
    mean, half, c, d = (s[0] + s[1]) / 2, (s[0] - s[1]) / 2, np.cos(2 * angle), np.sin(2 * angle)
    turned = half * c - s[2] * d
    return np.array([mean + turned, mean - turned, s[2] * c + half * d])


def tresca_return(s, su, two_g):
    """Deviator xx, yy, xy in the yield surface, increment of Eq. (6), plastic work per volume [Pa].

    With r the radius of Mohr's circle in the plane and m its centre, the principal values are m + r, m - r and -2 m.
    Their largest difference is 2 r, or r + 3 |m| where zz is the largest or the smallest. On a plane of the surface the
    middle value stays; beyond its end the return goes to the edge, where two values are equal.
    """
    mean, half = (s[0] + s[1]) / 2, (s[0] - s[1]) / 2
    r, m = np.hypot(half, s[2]), np.abs(mean)
    zz_is_middle = 3 * m <= r
    r_1 = np.where(zz_is_middle, su, np.clip(0.75 * (r - m) + su / 2, 0, su))  # 0.75: r - m stays, r + 3 m is 2 su
    m_1 = np.where(zz_is_middle, np.minimum(m, su / 3), (2 * su - r_1) / 3)
    yields = np.maximum(2 * r, r + 3 * m) > 2 * su
    r_1, m_1 = np.where(yields, r_1, r), np.where(yields, m_1, m)
    ratio, centre = r_1 / np.where(r > 0, r, 1), np.sign(mean) * m_1
    new = np.array([centre + ratio * half, centre - ratio * half, ratio * s[2]])
    work = 2 * (r_1 * (r - r_1) + 3 * m_1 * (m - m_1)) / two_g
    return new, np.sqrt((r - r_1) ** 2 + 3 * (m - m_1) ** 2) / two_g, work


ROW = ["t", "kinetic", "kinetic_in_cells", "elastic", "plastic", "gravity", "damping", "balance", "front_x",
       "max_eps_eq_p", "slenderness", "convexity"]


def observe(body, t, dt, options):
    """One row at the time t [s], after a step of dt: energies and works [J per m], front [m], worst shape of a cell.

    kinetic: of the lumped mass. kinetic_in_cells: of the velocity between the nodes. balance: what the energies have
    more than the works.
    """
    v = body.v + dt / 2 * body.acceleration(options)[0] if options.order == "central" else body.v
    kinetic = np.sum(body.mass * v**2) / 2
    in_cells = sum(np.sum(body.mass_g * (SHAPE @ each[body.cells]) ** 2) for each in v) / 2
    xx, yy, xy = body.s
    shear = (xx**2 + yy**2 + xx * yy + xy**2) / (2 * body.material["shear_modulus"])  # s:s / 4G
    elastic = np.sum(body.jacobian(body.x)[1] * (body.p**2 / (2 * bulk_modulus(body.material)) + shear))
    gravity = np.sum(body.mass * body.gravity * (body.x - body.x_0))
    slenderness, _, convexity = body.shape()
    balance = kinetic + elastic + body.plastic - gravity - body.damped
    return dict(zip(ROW, (t, kinetic, in_cells, elastic, body.plastic, gravity, body.damped, balance, body.x[0].max(),
                          body.eps_eq_p.max(), slenderness.min(), convexity.min())))


def run(body, times, options):
    """Yields a row for each of the times [s], with equal steps before each time.

    Raises RuntimeError where a cell folds over, or soil passes below the floor, which only nodes of the base feel.
    """
    t, dt_before = 0.0, 0.0
    for end in times:
        while t < end:
            n_left = int(np.ceil((end - t) / (options.courant * body.stable_time_step()) - 1e-9))  # 1e-9: round-off
            dt = (end - t) / n_left
            body.step(dt, (dt_before + dt) / 2 if options.order == "central" else dt, options)
            t, dt_before = end if n_left == 1 else t + dt, dt
            if not body.jacobian(body.x)[1].min() > 0:
                raise RuntimeError(f"a cell folded over at {t:.4f} s")
            if body.x[1].min() < body.floor - 1e-9:  # m: round-off
                raise RuntimeError(f"soil passed below the floor at {t:.4f} s")
        yield observe(body, t, dt_before, options)


def grid(low, high, n_x, n_y):
    """Nodes [2, n] and cells [4, n] of a box, row by row."""
    x, y = np.meshgrid(np.linspace(low[0], high[0], n_x + 1), np.linspace(low[1], high[1], n_y + 1))
    lower_left = (np.arange(n_y)[:, None] * (n_x + 1) + np.arange(n_x)).ravel()
    return np.array([x.ravel(), y.ravel()]), lower_left + np.array([0, 1, n_x + 2, n_x + 1])[:, None]


def body_of_case(file, cell):
    """The box of a case file, on cells of about the size `cell` [m], with rollers on its left side and its base."""
    case = tomllib.loads(Path(file).read_text())
    material = case["material"][case["body"][0]["material"]]
    low, high = np.array(case["body"][0]["box"])
    if len(case["body"]) > 1 or [*low] != [0, 0] or any(case["boundary"][k] != "roller" for k in ("left", "bottom")):
        raise ValueError(f"{file}: not one box in the corner of two rollers, left and bottom")
    if material["model"] != "tresca_softening" or material["su_peak"] != material["su_residual"]:
        raise ValueError(f"{file}: not tresca_softening with su_residual = su_peak")
    x, cells = grid(low, high, *np.rint((high - low) / cell).astype(int))
    return Body(x, cells, x == 0, material, case["forces"]["gravity"])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--case", default=MODEL_1, help="case file (default: model 1 of the paper)")
    parser.add_argument("--cells", type=float, nargs="+", default=[0.2, 0.1], help="sizes of cells [m]")
    parser.add_argument("--times", type=float, nargs="+", default=[0.14, 0.22, 0.30], help="times of the rows [s]")
    parser.add_argument("--courant", type=float, nargs="+", default=[Options.courant], help="time step over the stable")
    parser.add_argument("--order", choices=["central", "terp"], default=Options.order, help="order of the step")
    parser.add_argument("--rate", choices=["none", "jaumann"], default=Options.rate, help="objective rate")
    parser.add_argument("--damping", type=float, default=Options.damping, help="local damping, not that of the case")
    parser.add_argument("--averaging-time", type=float, default=Options.averaging_time, help="of the damped force [s]")
    given = parser.parse_args()
    table = csv.DictWriter(sys.stdout, ["cell", "courant", *ROW], lineterminator="\n")
    table.writeheader()
    for cell in given.cells:
        for courant in given.courant:
            options = Options(courant, given.order, given.rate, given.damping, given.averaging_time)
            for row in run(body_of_case(given.case, cell), given.times, options):
                values = {"cell": cell, "courant": courant} | row
                table.writerow({key: f"{value:.6g}" for key, value in values.items()})
                sys.stdout.flush()


if __name__ == "__main__":
    try:
        main()
    except (RuntimeError, ValueError) as error:
        sys.exit(f"error: {error}")
