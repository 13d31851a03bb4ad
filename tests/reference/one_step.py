"""NumPy twin of Terp's time step: the oracle of the C++ tests, written from the paper and the readings R1-R20 alone.

Pure explicit MUSL with FLIP, plane strain, 4-node quadrilaterals; schemes standard_mpm, mpm_mixed and mpm_gp.
Where a point counts is an array of shares [point, cell, sub-cell]: one 1 (Eq. 1), or overlap_shares.py.
Run it to check the twin against identities that hold exactly and to write one_step.json beside this file.
Not for: speed, or points that leave their cell (the step asserts that none does).

Units are SI, tension is positive. Inside, a stress or strain is a full 3 x 3 tensor; in the file it is xx yy zz xy.
"""
from collections import Counter
import sys
from pathlib import Path

import numpy as np

from overlap_shares import overlap_shares, taken_shares

CORNERS = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])  # of the cell and, scaled, of the Gauss rule
GAUSS = CORNERS / np.sqrt(3.0)  # weights w_g are all 1
CENTRE = np.zeros(2)
EYE = np.eye(3)
SMALL_MASS = 1e-9  # nodes lighter than this times rho V_e keep a = 0
LEAST_SHARE = 1e-30  # of a point for each corner of its cell, decision 0027
TIE = 1e-9         # |xi| below this counts as 0, reading R7
met = Counter()    # which branches the scenarios went through, to show that none is left out


# --- geometry of one cell; `corners` are its nodes' coordinates, shape [4, 2] ---

def shape_functions(xi):
    return (1 + CORNERS[:, 0] * xi[0]) * (1 + CORNERS[:, 1] * xi[1]) / 4


def jacobian(corners, xi):
    """dN_i/dxi_a, shape [4, 2], and dx_b/dxi_a, shape [2, 2]."""
    dn = np.stack([CORNERS[:, 0] * (1 + CORNERS[:, 1] * xi[1]), CORNERS[:, 1] * (1 + CORNERS[:, 0] * xi[0])], 1) / 4
    return dn, dn.T @ corners


def gradients(corners, xi):
    """dN_i/dx_b, shape [4, 2]."""
    dn, jac = jacobian(corners, xi)
    return dn @ np.linalg.inv(jac).T


def gauss_volumes(corners):
    """w_g detJ(xi_g), shape [4]; their sum is the cell's volume V_e."""
    return np.array([np.linalg.det(jacobian(corners, xi)[1]) for xi in GAUSS])


def local_coordinates(corners, x):
    xi = np.zeros(2)
    for _ in range(50):
        d_xi = np.linalg.solve(jacobian(corners, xi)[1].T, x - shape_functions(xi) @ corners)
        xi = xi + d_xi
        if np.abs(d_xi).max() < 1e-15:
            break
    assert np.abs(xi).max() < 1, "a point left its cell"
    return xi


def sub_cell(xi):
    right, upper = xi[0] > -TIE, xi[1] > -TIE
    return {(False, False): 0, (True, False): 1, (True, True): 2, (False, True): 3}[bool(right), bool(upper)]


def velocity_gradient(grad, v):
    """L_ab = dv_a/dx_b as a 3 x 3 tensor; v of the cell's nodes, shape [4, 2]."""
    full = np.zeros((3, 3))
    full[:2, :2] = v.T @ grad
    return full


def strain_and_spin(corners, xi, u, b_bar):
    """Increments from nodal displacements u = v dt; B-bar takes the centre's volumetric strain, reading R5."""
    l = velocity_gradient(gradients(corners, xi), u)
    d_eps, d_spin = (l + l.T) / 2, (l - l.T) / 2
    if b_bar:
        theta_0 = np.trace(velocity_gradient(gradients(corners, CENTRE), u))
        d_eps = d_eps + (theta_0 - np.trace(d_eps)) / 3 * EYE
    return d_eps, d_spin


# --- constitutive laws ---

def bulk_modulus(mat):
    nu = mat["poisson_ratio"]
    return 2 * mat["shear_modulus"] * (1 + nu) / (3 * (1 - 2 * nu))


def strength(mat, eps):
    """S_u, Eq. (5) with the sign of reading R1."""
    return mat["su_residual"] + (mat["su_peak"] - mat["su_residual"]) * np.exp(-mat["eta"] * eps)


def bisect(excess, low, high):
    """Root of a function that is >= 0 at low and <= 0 at high, to the last bit."""
    while True:
        middle = (low + high) / 2
        if middle in (low, high):
            return middle
        low, high = (middle, high) if excess(middle) > 0 else (low, middle)


def update_law(mat, sigma, eps_eq_p, d_eps):
    """New stress and eps_eq_p: elastic trial, then the implicit Tresca return in sorted principal space."""
    g = mat["shear_modulus"]
    theta = np.trace(d_eps)
    trial = sigma + bulk_modulus(mat) * theta * EYE + 2 * g * (d_eps - theta / 3 * EYE)
    if mat["law"] == "linear_elastic":
        return trial, eps_eq_p
    s_t, directions = np.linalg.eigh(trial)
    s_t, directions = s_t[::-1], directions[:, ::-1]  # s1 >= s2 >= s3
    if s_t[0] - s_t[2] - 2 * strength(mat, eps_eq_p) <= 0:
        met["elastic"] += 1
        return trial, eps_eq_p
    s, d_eq = tresca_return(mat, s_t, eps_eq_p)
    return directions @ np.diag(s) @ directions.T, eps_eq_p + d_eq


def tresca_return(mat, s_t, eps):
    """Principal stresses on the yield surface and the increment of Eq. (6)."""
    g = mat["shear_modulus"]
    d = bisect(lambda d: s_t[0] - s_t[2] - 4 * g * d - 2 * strength(mat, eps + d), 0.0, (s_t[0] - s_t[2]) / (4 * g))
    s = s_t + 2 * g * d * np.array([-1.0, 0.0, 1.0])
    if s[0] >= s[1] >= s[2]:
        met["face"] += 1
        return s, d
    upper = s[0] < s[1]  # else s2 < s3
    met["edge s1 = s2" if upper else "edge s2 = s3"] += 1
    ratio = np.array([2.0, 2.0, -4.0]) / 3 if upper else np.array([4.0, -2.0, -2.0]) / 3
    on_edge = lambda d: s_t.mean() + ratio * strength(mat, eps + d)
    increment = lambda d: np.sqrt(np.sum(((s_t - on_edge(d)) / (2 * g)) ** 2) / 2)
    d = bisect(lambda d: increment(d) - d, 0.0, max(increment(0.0), increment(np.inf)))
    return on_edge(d), d


# --- the step ---

def point_shares(case, pts, xi, subs):
    """Part of each point that counts in each sub-cell, shape [n, n_cells, 4]; over these, its sum is 1."""
    if case["options"]["shares"] == "overlap":
        mesh = case["mesh"]
        volumes = np.array([gauss_volumes(mesh["nodes"][cell]).sum() for cell in mesh["cells"]])
        taken = taken_shares(pts["volume"], pts["cell"], volumes)
        return overlap_shares(mesh["cells"], pts["cell"], xi, pts["extent"], taken, met)
    shares = np.zeros((len(xi), len(case["mesh"]["cells"]), 4))
    shares[np.arange(len(xi)), pts["cell"], subs] = 1
    return shares


def gauss_values(case, corners, pts, omega):
    """Weights, sigma_hat, p_e and the cell's eps_eq_p, all of the start: Eqs. (1)-(3), readings R3, R6, R8, R9.

    omega: volume of each point in each sub-cell of this cell, shape [n, 4].
    """
    volumes = gauss_volumes(corners)
    filled = omega.sum() >= case["options"]["filled_fraction"] * volumes.sum()
    met["filled cell" if filled else "part-filled cell"] += 1
    mean = lambda field, part: np.tensordot(part, field, 1) / part.sum()
    weight, sigma, eps = np.zeros(4), np.zeros((4, 3, 3)), np.zeros(4)
    for g in range(4):
        part = omega[:, g]
        if not part.any():
            met["empty sub-cell, filled" if filled else "empty sub-cell, part-filled"] += 1
            if not filled:
                continue
            part = omega.sum(1)
        weight[g] = volumes[g] if filled else part.sum()
        sigma[g], eps[g] = mean(pts["sigma"], part), mean(pts["eps_eq_p"], part)      # Eq. (1)
    p_g = np.trace(sigma, axis1=1, axis2=2) / 3
    p_e = weight @ p_g / weight.sum()                                                 # Eq. (2)
    return weight, sigma - (p_g - p_e)[:, None, None] * EYE, p_e, weight @ eps / weight.sum()  # Eq. (3)


def gauss_force(case, corners, weight, sigma):
    """Eq. (4) of one cell with B-bar transposed (reading R4), shape [4, 2]."""
    force, grad_0 = np.zeros((4, 2)), gradients(corners, CENTRE)
    for g in range(4):
        grad = gradients(corners, GAUSS[g])
        force += weight[g] * grad @ sigma[g, :2, :2]
        if case["options"]["force_operator"] == "b_bar":
            force += weight[g] * np.trace(sigma[g]) / 3 * (grad_0 - grad)
    return force


def correct_at_boundary(case, v, m):
    """Rollers, then bilateral contact with adhesion and friction on a horizontal base, reading R15.

    Changes v; returns the impulses along the base that were left unused.
    """
    v[case["mesh"]["fixed"]] = 0
    contact, unused = case["mesh"]["contact"], np.zeros(len(m))
    for i, a, mu, length in zip(contact["nodes"], contact["adhesion"], contact["friction"], contact["length"]):
        normal, tangential = -m[i] * v[i, 1], m[i] * v[i, 0]
        limit = a * length * case["dt"] + mu * max(0.0, normal)
        met["contact sticks" if abs(tangential) <= limit else "contact slides"] += tangential != 0
        met["contact pushes" if normal > 0 else "contact pulls"] += normal != 0
        v[i] = [np.sign(tangential) * max(0.0, abs(tangential) - limit) / m[i] if m[i] > 0 else 0.0, 0.0]
        unused[i] = max(0.0, limit - abs(tangential))
    return unused


def clamped(case, v):
    """Without fixed components and that across the contact. Changes v."""
    v[case["mesh"]["fixed"]] = 0
    v[case["mesh"]["contact"]["nodes"], 1] = 0
    return v


def free_force(case, r):
    """What sides and contact do not carry of nodal forces, reading R13."""
    free, contact = clamped(case, r.copy()), case["mesh"]["contact"]
    for i, a, mu, length in zip(contact["nodes"], contact["adhesion"], contact["friction"], contact["length"]):
        limit = a * length + mu * max(0.0, -r[i, 1])
        met["damping on contact"] += abs(free[i, 0]) > limit
        free[i, 0] = np.sign(free[i, 0]) * max(0.0, abs(free[i, 0]) - limit)
    return free


def accelerate_nodes(case, m, momentum, f_int, moving):
    """Nodal acceleration: gravity, local damping (reading R13), boundaries."""
    o, v, a = case["options"], np.zeros_like(momentum), np.zeros_like(momentum)
    v[moving] = momentum[moving] / m[moving, None]
    r = m[:, None] * o["gravity"] - f_int
    free_r, free_v = free_force(case, r), clamped(case, v.copy())
    down = o["gravity"] / np.linalg.norm(o["gravity"])
    # per component along and across gravity, of what the sides do not carry
    for e in (down, np.array([-down[1], down[0]])):
        r -= np.outer(o["local_damping"] * np.abs(free_r @ e) * np.sign(free_v @ e), e)
    a[moving] = r[moving] / m[moving, None]
    v_1 = v + a * case["dt"]
    unused = correct_at_boundary(case, v_1, m)
    return np.where(moving[:, None], (v_1 - v) / case["dt"], 0), unused


def nodal_velocity(case, m, momentum, unused):
    """Velocity after the second map, however light the node.

    Fixed components and the normal one of a contact are set to zero; along it acts the strength that was left unused.
    """
    v = np.zeros_like(momentum)
    v[m > 0] = momentum[m > 0] / m[m > 0, None]
    for i in case["mesh"]["contact"]["nodes"]:
        if m[i] > 0:
            v[i, 0] = np.sign(v[i, 0]) * max(0.0, abs(v[i, 0]) - unused[i] / m[i])
    return clamped(case, v)


def rotated(case, sigma, w):
    """Reading R17."""
    return sigma + w @ sigma - sigma @ w if case["options"]["objective_rate"] == "jaumann" else sigma


def block_mean(pts, field, chosen):
    return np.tensordot(pts["volume"][chosen], field[chosen], 1) / pts["volume"][chosen].sum()


def update_points(case, pts, d_eps, spin, sigma):
    """The law at each point, from a stress `sigma`. Changes pts."""
    for p in range(len(sigma)):
        pts["sigma"][p], pts["eps_eq_p"][p] = update_law(
            case["material"], rotated(case, sigma[p], spin[p]), pts["eps_eq_p"][p], d_eps[p])


def pressure_of_cells(case, pts, gauss, shares):
    """Stress of the points with the pressure p_e around them, reading R10. Overlap: each block keeps its mean."""
    around = shares.sum(2) @ gauss["p_e"]
    change = around - np.trace(pts["sigma"], axis1=1, axis2=2) / 3
    if case["options"]["shares"] == "overlap":
        for members in blocks(pts):
            change[members] -= block_mean(pts, change, members)
    return pts["sigma"] + change[:, None, None] * EYE


def update_mixed(case, pts, gauss, shares, subs, strain, spin):
    """The law at the Gauss points, whose results go to the points. Changes pts."""
    sigma, eps = gauss["sigma"].copy(), np.repeat(gauss["eps"][:, None], 4, 1)
    for e, g in zip(*np.nonzero(shares.any(0))):
        sigma[e, g], eps[e, g] = update_law(
            case["material"], rotated(case, sigma[e, g], spin[e, g]), eps[e, g], strain[e, g])
    to_points = lambda field: np.tensordot(shares, field, 2)
    if case["options"]["shares"] == "point":
        pts["sigma"], pts["eps_eq_p"] = to_points(sigma), to_points(eps)
        return
    turned = zip(pts["sigma"] - to_points(gauss["sigma"]), to_points(spin))
    apart = np.array([rotated(case, *each) for each in turned])  # from its Gauss points, at the start
    pts["sigma"] = to_points(sigma)
    pts["eps_eq_p"] += to_points(eps - gauss["eps"][:, None])
    for members in blocks(pts):
        pts["sigma"][members] += np.trace(block_mean(pts, apart, members)) / 3 * EYE
        for g in np.unique(subs[members]):
            here = members[subs[members] == g]
            mean = block_mean(pts, apart, here)
            pts["sigma"][here] += mean - np.trace(mean) / 3 * EYE


def blocks(pts):
    return [np.flatnonzero(pts["cell"] == e) for e in np.unique(pts["cell"])]


def gauss_strain_and_spin(mesh, cells, v, dt):
    """Increments at all Gauss points of the cells that hold points, shapes [n_cells, 4, 3, 3]."""
    strain, spin = np.zeros((2, len(mesh["cells"]), 4, 3, 3))
    for e in cells:
        nodes = mesh["cells"][e]
        for g in range(4):
            strain[e, g], spin[e, g] = strain_and_spin(mesh["nodes"][nodes], GAUSS[g], v[nodes] * dt, True)
    return strain, spin


def gauss_and_force(case, pts, shares):
    """Values of the Gauss points of all cells, and the internal force of the nodes."""
    mesh, n = case["mesh"], len(case["mesh"]["cells"])
    gauss = {"sigma": np.zeros((n, 4, 3, 3)), "p_e": np.zeros(n), "eps": np.zeros(n)}
    f_int = np.zeros((len(mesh["nodes"]), 2))
    for e in np.unique(pts["cell"]):
        corners, omega = mesh["nodes"][mesh["cells"][e]], shares[:, e] * pts["volume"][:, None]
        weight, gauss["sigma"][e], gauss["p_e"][e], gauss["eps"][e] = gauss_values(case, corners, pts, omega)
        f_int[mesh["cells"][e]] += gauss_force(case, corners, weight, gauss["sigma"][e])
    return gauss, f_int


def step(case, pts):
    """Points after one step, and what the checks look at. pts: arrays of n points, not changed."""
    mesh, dt, standard = case["mesh"], case["dt"], case["scheme"] == "standard_mpm"
    pts, n_nodes, points = {k: a.copy() for k, a in pts.items()}, len(mesh["nodes"]), range(len(pts["mass"]))
    nodes = mesh["cells"][pts["cell"]]  # of each point, shape [n, 4]
    corners = mesh["nodes"][nodes]
    xi = np.array([local_coordinates(corners[p], pts["x"][p]) for p in points])
    n = np.array([shape_functions(xi[p]) for p in points])
    subs = np.array([sub_cell(xi[p]) for p in points])
    to_corners = np.maximum(n, LEAST_SHARE)
    to_nodes = lambda f: sum_to_nodes(n_nodes, nodes, to_corners[:, :, None] * f[:, None, :])

    m = to_nodes(pts["mass"][:, None])[:, 0]                                       # 1. points to cells and nodes
    smallest = min(gauss_volumes(x_e).sum() for x_e in mesh["nodes"][mesh["cells"]])  # V_e
    moving = m >= SMALL_MASS * case["material"]["density"] * smallest
    if standard:
        shares = None
        f_int = sum_to_nodes(n_nodes, nodes, np.array(
            [pts["volume"][p] * gradients(corners[p], xi[p]) @ pts["sigma"][p, :2, :2] for p in points]))
    else:
        shares = point_shares(case, pts, xi, subs)
        gauss, f_int = gauss_and_force(case, pts, shares)

    a, unused = accelerate_nodes(case, m, to_nodes(pts["mass"][:, None] * pts["v"]), f_int, moving)  # 2. nodes
    pts["v"] += dt * np.einsum("pi,pia->pa", n, a[nodes])                          # 3. cells to points
    v = nodal_velocity(case, m, to_nodes(pts["mass"][:, None] * pts["v"]), unused)  # 4. nodes
    if standard:                                                                   # 5. strain, stress, volume, places
        d_eps, spin = map(np.array, zip(*[strain_and_spin(corners[p], xi[p], v[nodes[p]] * dt, False) for p in points]))
        update_points(case, pts, d_eps, spin, pts["sigma"].copy())
    else:
        strain_g, spin_g = gauss_strain_and_spin(mesh, np.unique(pts["cell"]), v, dt)
        d_eps, spin = np.tensordot(shares, strain_g, 2), np.tensordot(shares, spin_g, 2)
        if case["scheme"] == "mpm_mixed":
            update_mixed(case, pts, gauss, shares, subs, strain_g, spin_g)
        else:
            update_points(case, pts, d_eps, spin, pressure_of_cells(case, pts, gauss, shares))
    pts["strain"] += d_eps
    pts["volume"] *= 1 + np.trace(d_eps, axis1=1, axis2=2)
    pts["x"] += dt * np.einsum("pi,pia->pa", n, v[nodes])
    return pts, {"f_int": f_int, "v": v, "d_eps": d_eps, "m": m, "sub_cell": subs, "shares": shares}


def sum_to_nodes(n_nodes, nodes, contributions):
    total = np.zeros((n_nodes, contributions.shape[2]))
    np.add.at(total, nodes, contributions)
    return total


if __name__ == "__main__":
    from one_step_checks import check_identities
    from one_step_scenarios import differs, scenarios_text

    check_identities()
    file, text = Path(__file__).with_suffix(".json"), scenarios_text()
    if "--check" not in sys.argv:
        file.write_text(text)
    elif differs(text, file):
        sys.exit(f"{file.name} is not what the twin gives: run {Path(__file__).name} and review the change")
