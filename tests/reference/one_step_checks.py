"""Identities that the NumPy twin in one_step.py must satisfy to round-off, and controls that must break them.

Each line printed is a number relative to the size of the quantity. Not for: the C++, which has tests of its own.
"""
import numpy as np

from one_step import CENTRE, EYE, GAUSS, gauss_and_force, gauss_volumes, gradients, rotated, step
from one_step import strain_and_spin, strength, update_law, update_mixed
from one_step_scenarios import OVERLAP_SCENARIOS, TRESCA, make_case, make_overlap_case

ROUND_OFF = 1e-12
SUMMED = np.inf  # a filled_fraction that no cell reaches: Omega_GP is then the sum of the point volumes everywhere


def expect(what, value, holds=True):
    print(f"{'zero' if holds else 'not zero':9s}{value:9.1e}  {what}")
    assert (value < ROUND_OFF) == holds, what


def free_case(scheme, **options):
    """A distorted scenario without boundaries and damping."""
    case, pts = make_case(np.random.default_rng(5), scheme, scheme, True, False, "none", TRESCA)
    case["mesh"]["fixed"][:] = False
    case["options"].update(local_damping=0.0, **options)
    return case, pts


def overlap_cases(**options):
    """Scenarios with shares that overlap, without boundaries and damping."""
    for index, description in enumerate(OVERLAP_SCENARIOS):
        case, pts = make_overlap_case(np.random.default_rng([6, index]), *description)
        case["mesh"]["fixed"][:] = False
        case["options"].update(local_damping=0.0, **options)
        yield case, pts


def check_momentum():
    cases = [free_case(scheme) for scheme in ("standard_mpm", "mpm_mixed", "mpm_gp")] + list(overlap_cases())
    for case, pts in cases:
        total = lambda points: points["mass"] @ points["v"]
        impulse = pts["mass"].sum() * case["options"]["gravity"] * case["dt"]
        error = np.abs(total(step(case, pts)[0]) - total(pts) - impulse).max() / np.abs(impulse).max()
        expect(f"momentum gained less the impulse of gravity, {case['name']}", error)


def power_gap(case, pts):
    """Nodal internal power less sum Omega_p sigma_p : d_eps/dt; stress and volume of the start of the step."""
    seen = step(case, pts)[1]
    nodal = np.sum(seen["f_int"] * seen["v"]) * case["dt"]
    terms = pts["volume"] * np.einsum("pij,pij->p", pts["sigma"], seen["d_eps"])
    return abs(nodal - terms.sum()) / np.abs(terms).sum()


def check_energy():
    expect("nodal power less the points', standard_mpm", power_gap(*free_case("standard_mpm")))
    for scheme in ("mpm_mixed", "mpm_gp"):
        summed = {"filled_fraction": SUMMED}
        expect(f"nodal power less the points', summed weights, {scheme}", power_gap(*free_case(scheme, **summed)))
        expect(f"the same with B in the force, {scheme}",
               power_gap(*free_case(scheme, **summed, force_operator="b")), False)
        expect(f"the same with hybrid weights, {scheme}", power_gap(*free_case(scheme)), False)
    for case, pts in overlap_cases(**summed):  # the way back is the transpose of the way there
        expect(f"nodal power less the points', summed weights, {case['name']}", power_gap(case, pts))


def interior_force(sigma, fraction, **options):
    """Largest force of a uniform stress at an interior node, all cells exactly full, sub-cells uneven."""
    case, pts = free_case("mpm_gp", filled_fraction=fraction, **options)
    cells, corners = np.unique(pts["cell"]), case["mesh"]["nodes"][case["mesh"]["cells"]]
    for e in cells:
        members = pts["cell"] == e
        pts["volume"][members] *= gauss_volumes(corners[e]).sum() / pts["volume"][members].sum()
    pts["sigma"][:] = sigma
    force = step(case, pts)[1]["f_int"]
    return np.abs(force[[5, 6, 9]]).max() / np.abs(force).max()  # node 10 touches the empty cell


def check_uniform_stress():
    sheared = 1e4 * np.array([[-3.0, 0.7, 0], [0.7, -1.2, 0], [0, 0, -2.1]])
    expect("interior force of uniform stress, uneven sub-cells, filled cells", interior_force(sheared, 0.9))
    expect("the same with B in the force", interior_force(sheared, 0.9, force_operator="b"))
    expect("the same with summed weights", interior_force(sheared, SUMMED), False)
    expect("uniform pressure, summed weights", interior_force(-2e4 * EYE, SUMMED))
    expect("the same with B in the force", interior_force(-2e4 * EYE, SUMMED, force_operator="b"), False)


def check_overlap():
    """Shares of a point sum to 1. At rest the mean stress of blocks, uniform stress and the state stay."""
    for case, pts in overlap_cases():
        error = step(case, pts)[1]["shares"].sum((1, 2)) - 1
        expect(f"shares of a point less 1, {case['name']}", np.abs(error).max())
    for case, pts in overlap_cases(gravity=np.array([0.0, -1e-30])):
        held = {**pts, "v": 0 * pts["v"], "sigma": 1e-3 * pts["sigma"]}  # far from yield
        case["mesh"]["fixed"][:] = True
        end = step(case, held)[0]
        expect(f"volume-weighted mean stress of blocks at rest, {case['name']}", rest_error(held, end))
        apart = np.abs(end["sigma"] - held["sigma"]).max() / np.abs(held["sigma"]).max()
        expect(f"the same, point by point, {case['name']}", apart, False)
        expect(f"state at rest, {case['name']}", np.abs(end["eps_eq_p"] - held["eps_eq_p"]).max())
        held["sigma"][:] = np.array([[-3.0, 0.7, 0], [0.7, -1.2, 0], [0, 0, -2.1]])
        change = np.abs(step(case, held)[0]["sigma"] - held["sigma"]).max() / 3
        expect(f"uniform stress at rest, {case['name']}", change)


def check_turned_stress():
    """Stress of MPM-Mixed turns with soil that does not strain: the mean of each block by the spin."""
    w = 0.03 * np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
    for case, pts in overlap_cases(objective_rate="jaumann"):
        if case["scheme"] != "mpm_mixed":
            continue
        pts["sigma"] *= 1e-3  # far from yield
        shares, end, n = step(case, pts)[1]["shares"], {k: a.copy() for k, a in pts.items()}, len(case["mesh"]["cells"])
        update_mixed(case, end, gauss_and_force(case, pts, shares)[0], shares, step(case, pts)[1]["sub_cell"],
                     np.zeros((n, 4, 3, 3)), np.broadcast_to(w, (n, 4, 3, 3)))
        turned = {**pts, "sigma": np.array([rotated(case, sigma, w) for sigma in pts["sigma"]])}
        expect(f"mean stress of blocks that turn, {case['name']}", rest_error(turned, end))


def rest_error(start, end):
    """Largest change of a block's mean stress over the largest stress."""
    change = [start["volume"][b] @ (end["sigma"] - start["sigma"])[b].reshape(-1, 9) / start["volume"][b].sum()
              for b in (start["cell"] == e for e in np.unique(start["cell"]))]
    return np.abs(change).max() / np.abs(start["sigma"]).max()


def check_affine_strain():
    case, _ = free_case("mpm_gp")
    rate, worst = np.array([[3e-3, -7e-3], [2e-3, 5e-3]]), 0.0
    for corners in case["mesh"]["nodes"][case["mesh"]["cells"]]:
        u = corners @ rate.T
        worst = max(worst, np.abs(affine_error(corners, u, rate)).max())
        mean = np.tensordot(gauss_volumes(corners), np.array([gradients(corners, xi) for xi in GAUSS]), 1)
        worst = max(worst, np.abs(mean / gauss_volumes(corners).sum() - gradients(corners, CENTRE)).max() / 10)  # 1/h
    expect("strain and spin of an affine motion; B(0) less the mean of B", worst)


def affine_error(corners, u, rate):
    """Strain plus spin less the gradient itself: B-bar changes nothing, as the trace is theta_0 everywhere."""
    sums = np.array([np.sum(strain_and_spin(corners, xi, u, True), 0)[:2, :2] for xi in GAUSS])
    return (sums - rate) / np.abs(rate).max()


def check_tresca():
    """After random returns: on the yield surface, no plastic volume, Eq. (6), trial directions, normality."""
    rng, g, worst = np.random.default_rng(8), TRESCA["shear_modulus"], 0.0
    for _ in range(300):
        sigma, eps = stress(rng), rng.uniform(0, 0.05)
        new, eps_new = update_law(TRESCA, sigma, eps, np.zeros((3, 3)))
        if eps_new == eps:
            continue
        s, su = np.linalg.eigvalsh(new), strength(TRESCA, eps_new)
        plastic = (sigma - new) / (2 * g)
        d_p = np.linalg.eigvalsh(plastic)  # normality: the work s : d_p is the most that the surface allows
        errors = [s[2] - s[0] - 2 * su, g * np.trace(plastic), g * (np.sqrt(np.sum(plastic**2) / 2) - (eps_new - eps)),
                  np.abs(new @ sigma - sigma @ new).max() / su, g * (np.sum(new * plastic) / su - np.abs(d_p).sum())]
        worst = max(worst, np.abs(errors).max() / su)
    expect("Tresca: yield, plastic volume, Eq. (6), coaxiality, normality", worst)


def stress(rng):
    a = rng.uniform(-4e4, 4e4, (3, 3))
    a[2, :2] = a[:2, 2] = 0
    return (a + a.T) / 2


def check_identities():
    check_affine_strain()
    check_tresca()
    check_uniform_stress()
    check_momentum()
    check_energy()
    check_overlap()
    check_turned_stress()
