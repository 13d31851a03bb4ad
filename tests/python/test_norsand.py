"""The example cases/user_law/norsand.c against an integration of its own, and against what is known of its ends."""

import math
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import support

import numpy as np
import terp
import tomllib

try:
    from terp import _core  # noqa: F401
except ImportError:
    _core = None

ROOT = support.HERE.parents[1]
EXAMPLE = ROOT / "cases" / "user_law"
COMPILER = shutil.which("cc")


class Sand:
    """NorSand in p and q of triaxial compression, as docs/user_laws.md has its equations; pressures in Pa."""

    def __init__(self, c, void_ratio, pressure):
        self.c, self.e0 = c, void_ratio
        self.k = 2.0 * (1.0 + c["poisson_ratio"]) / (3.0 * (1.0 - 2.0 * c["poisson_ratio"])) * c["stiffness"]
        self.p_i = c["overconsolidation"] * self.image(0.0) * pressure

    def image(self, eta):
        """p_i/p on the yield surface."""
        m, n = self.c["M"], self.c["N"]
        return ((1.0 - n * eta / m) / (1.0 - n)) ** (-(1.0 - n) / n) if n > 0.0 else math.exp(eta / m - 1.0)

    def psi(self, p, volume):
        e = (1.0 + self.e0) * math.exp(-volume) - 1.0
        return e - self.c["Gamma"] + self.c["lambda"] * math.log(p / self.c["p_ref"])

    def plastic(self, p, q, volume):
        """Numbers a, b with which the plastic strain grows by a d_e_q + b d_v, and the dilatancy."""
        c, eta = self.c, q / p
        m, n, ratio = c["M"], c["N"], self.image(q / p)
        dilatancy = (m - eta) / (1.0 - n)
        psi_i = self.psi(ratio * p, volume)
        most = (1.0 + c["chi"] * psi_i * n / m) ** ((n - 1.0) / n) if n > 0.0 else math.exp(-c["chi"] * psi_i / m)
        resistance = 3.0 * c["stiffness"] + dilatancy ** 2 * self.k + (dilatancy + eta) * c["h"] * (most / ratio - 1.0)
        return 3.0 * c["stiffness"] / resistance, dilatancy * self.k / resistance, dilatancy

    def rates(self, y, d_v):
        """Of p, q, v and g for the axial strain 1 and the volume strain d_v."""
        p, q, volume, _ = y
        a, b, dilatancy = self.plastic(p, q, volume)
        d_e_q = 1.0 - d_v / 3.0
        grows = a * d_e_q + b * d_v
        return np.array([self.k * p * (d_v - dilatancy * grows), 3.0 * self.c["stiffness"] * p * (d_e_q - grows), d_v,
                         grows])

    def increment(self, y, strain, d_v, parts):
        """Straight in the strains, by Runge and Kutta's method of the fourth order."""
        h = strain / parts
        for _ in range(parts):
            one = self.rates(y, d_v)
            two = self.rates(y + 0.5 * h * one, d_v)
            three = self.rates(y + 0.5 * h * two, d_v)
            four = self.rates(y + h * three, d_v)
            y = y + h / 6.0 * (one + 2.0 * two + 2.0 * three + four)
        return y

    def test(self, pressure, strains, drained, parts=40):
        """p, q, v and g at the axial strains. Drained: with the volume strain that keeps the stress across."""
        y, last, rows, d_v = np.array([pressure, 0.0, 0.0, 0.0]), 0.0, [], 0.0
        for strain in strains:
            miss = lambda d_v: (lambda z: z[1] - 3.0 * (z[0] - pressure))(  # noqa: E731
                self.increment(y, strain - last, d_v, parts))  # noqa: B023
            if drained:
                one, two = d_v, d_v + 0.01
                f_one, f_two = miss(one), miss(two)
                while abs(f_two) > 1e-6 and two != one:
                    one, two, f_one = two, two - f_two * (two - one) / (f_two - f_one), f_two
                    f_two = miss(two)
                d_v = two
            y, last = self.increment(y, strain - last, d_v, parts), strain
            rows.append(y)
        return np.array(rows).T


@unittest.skipUnless(_core and COMPILER, "no compiled part of the package, or no compiler")
class NorSand(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        here = pathlib.Path(cls.folder.name)
        subprocess.run([COMPILER, "-O2", "-fPIC", "-shared", "-I", ROOT / "src/soil/libraries", EXAMPLE / "norsand.c",
                        "-o", here / "norsand.so", "-lm"], check=True)
        shutil.copy(EXAMPLE / "norsand.toml", here)
        cls.path = here / "norsand.toml"

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def solved(self, strain, pressure=100e3, undrained=False, increments=200, test="triaxial", **changes):
        text = self.path.read_text(encoding="utf-8").replace('"norsand.so"', f'"{self.path.parent}/norsand.so"')
        case = {"material": tomllib.loads(text)["material"]}
        for key, value in changes.items():
            case["material"]["sand"]["state" if key == "void_ratio" else "parameters"][key] = value
        return terp.element(case, test=test, strain=strain, pressure=pressure, undrained=undrained,
                            increments=increments), case["material"]["sand"]

    def test_it_is_that_of_an_own_integration(self):
        for undrained, void_ratio, n in ((True, 0.85, 0.3), (False, 0.85, 0.3), (False, 0.7, 0.3), (True, 0.74, 0.3),
                                         (False, 0.72, 0.0)):
            with self.subTest(undrained=undrained, void_ratio=void_ratio, N=n):
                test, sand = self.solved(0.1, undrained=undrained, increments=50, void_ratio=void_ratio, N=n)
                self.assertEqual(test.fault, "")
                own = Sand(sand["parameters"], void_ratio, 100e3)
                p, q, volume, g = own.test(100e3, np.linspace(0.0, 0.1, 51)[1:], not undrained)
                for name, value, size in (("mean_pressure", p, 1e5), ("deviator", q, 1e5),
                                          ("volume_strain", -volume, 1.0), ("eps_eq_p", math.sqrt(0.75) * g, 1.0)):
                    np.testing.assert_allclose(test[name][1:], value, rtol=0.0, atol=1e-8 * size, err_msg=name)

    def test_stress_and_image_pressure_meet_on_the_yield_surface(self):
        test, sand = self.solved(0.2, void_ratio=0.7)
        c = sand["parameters"]
        p, q, p_i = test["mean_pressure"][1:], test["deviator"][1:], test["image_pressure"][1:]
        n = c["N"]
        np.testing.assert_allclose(q / p, c["M"] / n * (1.0 + (n - 1.0) * (p / p_i) ** (n / (1.0 - n))), rtol=1e-10)

    def test_dense_sand_neither_contracts_nor_dilates_at_its_image_state(self):
        test, sand = self.solved(0.1, void_ratio=0.7, increments=1000)
        p, q, v = test["mean_pressure"], test["deviator"], -test["volume_strain"]
        k = Sand(sand["parameters"], 0.7, 100e3).k
        plastic = v - np.log(p / p[0]) / k  # elastic part: d_v = d_p/(k p)
        image = int(np.argmax(q / p > sand["parameters"]["M"]))
        self.assertEqual(int(np.argmax(plastic)), image - 1 if plastic[image - 1] > plastic[image] else image)
        np.testing.assert_allclose(p[image], test["image_pressure"][image], rtol=2e-3)

    def test_least_dilatancy_is_chi_times_the_state_parameter(self):
        test, sand = self.solved(0.1, void_ratio=0.7, increments=1000)
        c = sand["parameters"]
        own = Sand(c, 0.7, 100e3)
        p, q, v = test["mean_pressure"], test["deviator"], -test["volume_strain"]
        at = int(np.argmax(test["image_pressure"]))  # there p_i = p_max
        psi_i = own.psi(test["image_pressure"][at], v[at])
        dilatancy = (c["M"] - q[at] / p[at]) / (1.0 - c["N"])
        np.testing.assert_allclose(dilatancy, c["chi"] * psi_i, rtol=1e-3)

    def test_shearing_ends_at_the_critical_state(self):
        for undrained, void_ratio in ((True, 0.85), (True, 0.78), (False, 0.85)):
            with self.subTest(undrained=undrained, void_ratio=void_ratio):
                test, sand = self.solved(2.0, undrained=undrained, increments=400, void_ratio=void_ratio)
                c = sand["parameters"]
                critical = c["Gamma"] - c["lambda"] * math.log(test["mean_pressure"][-1] / c["p_ref"])
                self.assertAlmostEqual(test["deviator"][-1] / test["mean_pressure"][-1], c["M"], delta=1e-6)
                e = (1.0 + void_ratio) * math.exp(test["volume_strain"][-1]) - 1.0
                self.assertAlmostEqual(e, critical, delta=1e-6)
                if undrained:  # the pressure of the critical state at the void ratio of the start
                    expected = c["p_ref"] * math.exp((c["Gamma"] - void_ratio) / c["lambda"])
                    self.assertAlmostEqual(test["mean_pressure"][-1] / expected, 1.0, delta=1e-4)

    def test_unloading_is_elastic_and_results_do_not_depend_on_the_increments(self):
        many, _ = self.solved([0.02, 0.019, 0.05], undrained=True, increments=400)  # its path of strains is straight
        few, sand = self.solved([0.02, 0.019, 0.05], undrained=True, increments=20)
        np.testing.assert_allclose(few["deviator"], many["deviator"][::20], rtol=0.0, atol=1e-8 * 1e5)
        p, q = many["mean_pressure"][401:801], many["deviator"][401:801]
        np.testing.assert_array_equal(many["eps_eq_p"][401:801], many["eps_eq_p"][401])
        slope = np.diff(q) / np.diff(many["deviator_strain"][401:801])
        mean = sand["parameters"]["stiffness"] * 3.0 * 0.5 * (p[1:] + p[:-1])
        np.testing.assert_allclose(slope, mean, rtol=1e-4)  # d_q = 3 G d_e_q

    def test_a_run_of_the_case_is_the_element(self):
        run = terp.Simulation(terp.Case(self.path))
        run.run()
        strain = run.field("strain")[0]
        test = terp.element(self.path, path={"strain_xy": [strain[3]]}, increments=run.n_steps)
        stress = [test[f"stress_{name}"][-1] for name in ("xx", "yy", "zz", "xy")]
        np.testing.assert_allclose(run.field("stress")[0], stress, rtol=1e-8)
        self.assertEqual([test["stress_xx"][0], test["stress_yy"][0]], [-50e3, -100e3])


if __name__ == "__main__":
    unittest.main()
