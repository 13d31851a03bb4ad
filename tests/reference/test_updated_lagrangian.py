"""Identities and closed forms that the finite element program must satisfy."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

from one_step import EYE, bulk_modulus, update_law
from updated_lagrangian import MODEL_1, Body, Options, body_of_case, grid, observe, rotated, run, tresca_return

CLAY = {"law": "tresca_softening", "model": "tresca_softening", "density": 1990.0, "shear_modulus": 2.0e6,
        "poisson_ratio": 0.45, "su_peak": 8.0e3, "su_residual": 8.0e3, "eta": 50.0}
STRONG = {**CLAY, "su_peak": 1e9, "su_residual": 1e9}
GRAVITY = (0.0, -9.81)


def patch(material=CLAY):
    """4 x 3 cells without boundary conditions or gravity, interior nodes moved by up to 25 % of a cell."""
    x, cells = grid((0.3, -0.2), (1.1, 0.25), 4, 3)
    inside = (x[0] > 0.31) & (x[0] < 1.09) & (x[1] > -0.19) & (x[1] < 0.24)
    x = x + np.random.default_rng(3).uniform(-0.25, 0.25, x.shape) * np.array([[0.2], [0.15]]) * inside
    return Body(x, cells, np.zeros(x.shape, bool), material, (0.0, 0.0)), inside


def deform_patch(body, gradient):
    body.deform(body.x, np.array(gradient) @ body.x, "none")
    body.x += np.array(gradient) @ body.x


class UpdatedLagrangian(unittest.TestCase):
    def assertClose(self, value, expected, relative, scale=None):
        scale = np.max(np.abs(expected)) if scale is None else scale
        self.assertLess(np.max(np.abs(np.asarray(value) - expected)), relative * scale)

    def test_the_return_is_that_of_the_twin_in_sorted_principal_space(self):
        rng, two_g, yielded = np.random.default_rng(4), 2 * CLAY["shear_modulus"], 0
        for _ in range(400):
            s = rng.uniform(-3e4, 3e4, 3)
            trial = np.array([[s[0], s[2], 0], [s[2], s[1], 0], [0, 0, -s[0] - s[1]]])
            expected, eps = update_law(CLAY, trial, 0.0, 0 * EYE)
            new, d_eps, work = tresca_return(s[:, None, None], CLAY["su_peak"], two_g)
            self.assertClose(new[:, 0, 0], expected[[0, 1, 0], [0, 1, 1]], 1e-11, CLAY["su_peak"])
            self.assertClose(d_eps, eps, 1e-11, 1e-2)
            self.assertClose(work, np.sum(expected * (trial - expected)) / two_g, 1e-11, CLAY["su_peak"] * 1e-2)
            yielded += eps > 0
        self.assertGreater(yielded, 200)

    def test_a_distorted_patch_carries_a_uniform_stress_without_force_inside(self):
        for gradient in ([[2e-3, 1e-3], [-3e-3, -1e-3]], [[4e-2, 5e-2], [-2e-2, -3e-2]]):  # elastic, plastic
            body, inside = patch()
            deform_patch(body, gradient)
            strain = (np.array(gradient) + np.transpose(gradient)) / 2
            p = bulk_modulus(CLAY) * np.trace(strain)
            self.assertClose(body.p, p, 1e-12)
            self.assertClose(body.s, body.s[:, :1, :1], 1e-12)
            full = np.zeros((3, 3))
            full[:2, :2] = strain
            expected, eps = update_law(CLAY, 0 * EYE, 0.0, full)
            self.assertClose(body.eps_eq_p, eps, 1e-11, 1e-2)
            self.assertClose(body.s[:, 0, 0] + [p, p, 0], expected[[0, 1, 0], [0, 1, 1]], 1e-11)
            force = body.internal_force()
            self.assertClose(force[:, inside], 0.0, 1e-12, np.abs(force).max())

    def test_a_patch_moved_at_its_sides_finds_the_affine_state_inside(self):
        body, inside = patch(STRONG)
        body.fixed = np.array([~inside, ~inside])
        gradient = np.array([[1e-7, 2e-7], [-3e-7, 2e-7]])  # small: squares of strains do not matter
        du = np.where(inside, 0.0, gradient @ body.x)
        body.deform(body.x, du, "none")
        expected = body.x_0 + gradient @ body.x_0
        body.x += du
        for _ in run(body, [1.0], Options(damping=0.8)):
            pass
        self.assertClose(body.x, expected, 1e-5, 1e-7)

    def test_the_force_does_the_work_that_the_cells_take(self):
        body, _ = patch(STRONG)
        rng, before = np.random.default_rng(6), 0.0
        for _ in range(3):  # displacements that are not affine
            du = rng.uniform(-1e-6, 1e-6, body.x.shape)
            force = body.internal_force()
            body.deform(body.x, du, "none")
            work = np.sum((force + body.internal_force()) / 2 * du)
            g = STRONG["shear_modulus"]
            xx, yy, xy = body.s
            after = np.sum(body.jacobian(body.x)[1] * (body.p**2 / (2 * bulk_modulus(STRONG))
                                                       + (xx**2 + yy**2 + xx * yy + xy**2) / (2 * g)))
            self.assertClose(after - before, work, 1e-11)
            before = after

    def test_free_fall_is_exact(self):
        for order, path in (("central", lambda t, dt: t * t / 2), ("terp", lambda t, dt: t * (t + dt) / 2)):
            body, _ = patch()
            body.gravity = np.array([[1.3], [-9.81]])
            dt, n_steps = 2e-4, 50
            options = Options(order=order)
            for k in range(n_steps):
                body.step(dt, dt / 2 if order == "central" and k == 0 else dt, options)
            self.assertClose(body.x - body.x_0, body.gravity * path(n_steps * dt, dt), 1e-11)
            self.assertClose(body.p, 0.0, 1e-7, 1.0)

    def test_stress_turns_with_the_soil_and_a_turn_strains_nothing(self):
        for rate in ("jaumann", "none"):
            body, _ = patch(STRONG)
            deform_patch(body, [[2e-3, 1e-3], [-3e-3, -1e-3]])
            s, p, angle = body.s.copy(), body.p.copy(), np.pi / 9
            turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
            for k in range(6):
                du = turn @ body.x - body.x
                body.deform(body.x + du / 2, du, rate)  # the mesh in the middle of the step
                body.x += du
            full = np.array([[s[0, 0, 0], s[2, 0, 0]], [s[2, 0, 0], s[1, 0, 0]]])
            six = np.linalg.matrix_power(turn, 6 if rate == "jaumann" else 0)
            self.assertClose(body.s[:, 0, 0], (six @ full @ six.T)[[0, 1, 0], [0, 1, 1]], 1e-11)
            self.assertClose(body.p, p, 1e-11)

    def test_a_small_turn_is_that_of_decision_0017(self):
        s, spin = np.array([3.0, -1.0, 2.0]), 1e-6
        self.assertClose(rotated(s, spin) - s, spin * np.array([-2 * s[2], 2 * s[2], s[0] - s[1]]), 1e-5)

    def test_a_column_that_gravity_loads_at_once_settles_twice_as_far(self):
        height, n = 3.0, 60
        x, cells = grid((0, 0), (0.05, height), 1, n)
        sides = np.array([np.full(x.shape[1], True), x[1] == 0])
        body = Body(x, cells, sides, STRONG, (0.0, -0.0981))  # a hundredth: small strains
        modulus = bulk_modulus(STRONG) + 4 / 3 * STRONG["shear_modulus"]
        period = 4 * height / np.sqrt(modulus / STRONG["density"])
        at_rest = STRONG["density"] * 0.0981 * height**2 / (2 * modulus)
        for row, share in zip(run(body, [period / 2, period], Options()), (2.0, 0.0)):
            self.assertClose(body.x_0[1, -1] - body.x[1, -1], share * at_rest, 0.005, at_rest)

    def test_energy_is_balanced(self):
        for order, most in (("central", 1e-4), ("terp", 3e-3)):  # of the work of gravity
            row = list(run(body_of_case(MODEL_1, 0.25), [0.25], Options(order=order)))[-1]
            self.assertGreater(row["plastic"], row["gravity"] / 3)
            self.assertLess(abs(row["balance"]), most * row["gravity"])

    def test_half_of_a_symmetric_block_is_half_of_it(self):
        x, cells = grid((-2.0, 0.0), (2.0, 2.0), 16, 8)
        whole = Body(x, cells, np.array([np.zeros(x.shape[1], bool), x[1] == 0]), CLAY, GRAVITY)
        x, cells = grid((0.0, 0.0), (2.0, 2.0), 8, 8)
        half = Body(x, cells, x == 0, CLAY, GRAVITY)
        rows = [list(run(body, [0.3], Options()))[-1] for body in (whole, half)]
        for key in ("kinetic", "elastic", "plastic", "gravity"):
            self.assertClose(rows[0][key], 2 * rows[1][key], 1e-9)
        self.assertClose(rows[0]["front_x"], rows[1]["front_x"], 1e-12)
        self.assertClose(whole.x[0].min(), -rows[1]["front_x"], 1e-9)

    def test_model_1_has_the_energy_of_the_reference(self):
        rows = run(body_of_case(MODEL_1, 0.2), [0.14, 0.22, 0.30], Options())
        for row, kinetic in zip(rows, (739.7, 1262.5, 1930.1)):  # J, cells of 0.2 m, the limit of small time steps
            self.assertClose(row["kinetic"], kinetic, 1e-3)

    def test_damping_takes_its_share(self):
        rows = [list(run(body_of_case(MODEL_1, 0.25), [0.2], Options(damping=a)))[-1] for a in (0.0, 0.1)]
        self.assertLess(rows[1]["damping"], 0.0)
        self.assertLess(rows[1]["kinetic"], rows[0]["kinetic"])
        self.assertLess(abs(rows[1]["balance"]), 1e-3 * rows[1]["gravity"])

    def test_the_velocity_between_nodes_has_less_energy_than_lumped_mass(self):
        x, cells = grid((0.0, 0.0), (0.8, 0.3), 2, 1)
        body = Body(x, cells, np.zeros(x.shape, bool), CLAY, (0.0, 0.0))
        body.v = np.array([x[0], 0 * x[0]])  # 1/s times x
        row = observe(body, 0.0, 0.0, Options())
        self.assertClose(row["kinetic_in_cells"], CLAY["density"] * 0.3 * 0.8**3 / 3 / 2, 1e-12)
        self.assertClose(row["kinetic"], CLAY["density"] * 0.3 * (0.4 * 0.4**2 + 0.2 * 0.8**2) / 2, 1e-12)

    def test_the_shape_of_a_square_and_of_a_triangle(self):
        modulus = bulk_modulus(CLAY) + 4 / 3 * CLAY["shear_modulus"]
        shapes = ((0, 0, 1, 1), 1.0, 1.0), ((0, 0, 0.5, 1), 0.75, 2 / 3), ((0, 0, 0, 1), 0.5, 0.0)
        for y, slenderness, convexity in shapes:
            x = np.array([[0, 1, 1, 0], y], float)
            body = Body(x, np.arange(4)[:, None], np.zeros(x.shape, bool), CLAY, (0.0, 0.0))
            found, longest, convex = body.shape()
            self.assertClose([found[0], longest[0], convex[0]], np.array([slenderness, np.sqrt(2), convexity]), 1e-12)
            self.assertClose(body.stable_time_step(), slenderness / np.sqrt(2 * modulus / CLAY["density"]), 1e-12)

    def test_what_it_cannot_do_is_refused(self):
        with self.assertRaisesRegex(ValueError, "model_2.toml: not one box in the corner of two rollers"):
            body_of_case(MODEL_1.with_name("model_2.toml"), 0.5)
        with tempfile.TemporaryDirectory() as folder:
            case = Path(folder) / "softer.toml"
            case.write_text(MODEL_1.read_text().replace("su_residual   = 8.0e3", "su_residual   = 2.0e3"))
            with self.assertRaisesRegex(ValueError, "softer.toml: not tresca_softening with su_residual = su_peak"):
                body_of_case(case, 0.5)

    def test_a_mesh_that_fails_ends_the_run(self):
        for push, message in ((60.0, "a cell folded over at 0.0"), (-60.0, "soil passed below the floor at 0.0")):
            body = body_of_case(MODEL_1, 1.0)
            body.v[1, 12] = push  # m/s; the node at (3, 1) m
            with self.assertRaisesRegex(RuntimeError, message):
                list(run(body, [1.0], Options()))


if __name__ == "__main__":
    unittest.main()
