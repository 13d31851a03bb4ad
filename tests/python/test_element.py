"""Element tests from Python: against an integration of its own, and what is said of what is asked wrongly."""

import math
import pathlib
import tempfile
import unittest
import warnings

import support  # noqa: F401

import numpy as np
import terp

try:
    from terp import _core  # noqa: F401
except ImportError:
    _core = None

SAND = dict(model="mohr_coulomb", density=1800.0, shear_modulus=4e6, poisson_ratio=0.3, cohesion=6e3,
            friction_angle=36.0, dilatancy_angle=12.0, cohesion_residual=1e3, friction_angle_residual=31.0,
            dilatancy_angle_residual=0.0, eta=30.0)


def softened(sand, name, k):
    residual = sand[f"{name}_residual"]
    return residual + (sand[name] - residual) * math.exp(-sand["eta"] * k)


def triaxial_by_hand(sand, pressure, strains):
    """Axial stress, lateral strain and plastic strain of implicit increments of the axial strain, compression positive.

    On the edge sigma_1 = sigma_2 = -pressure the axial stress follows from the strength at the end of the increment.
    The flow is ((1 + s)/2, (1 + s)/2, -(1 - s)) for s = sin(psi), whose deviator has the norm (3 - s)/sqrt(12)."""
    young = 2.0 * sand["shear_modulus"] * (1.0 + sand["poisson_ratio"])
    radians = math.pi / 180.0

    def strength(k):
        phi, c = radians * softened(sand, "friction_angle", k), softened(sand, "cohesion", k)
        return ((1.0 + math.sin(phi)) * pressure + 2.0 * c * math.cos(phi)) / (1.0 - math.sin(phi))

    def change(strain, plastic, k, at):  # of k, for the strength at `at`, less that
        s = math.sin(radians * softened(sand, "dilatancy_angle", at))
        axial = strain - plastic - (strength(at) - pressure) / young
        return axial * (3.0 - s) / (math.sqrt(12.0) * (1.0 - s)) - (at - k)

    k = plastic = lateral = 0.0
    rows = []
    for strain in strains:
        stress = pressure + young * (strain - plastic)
        if stress > strength(k):
            low, high = k, k + 2.0 * strain
            for _ in range(200):
                middle = 0.5 * (low + high)
                low, high = (middle, high) if change(strain, plastic, k, middle) > 0.0 else (low, middle)
            k, stress = low, strength(low)
            s = math.sin(radians * softened(sand, "dilatancy_angle", k))
            more = strain - (stress - pressure) / young - plastic
            plastic, lateral = plastic + more, lateral + more * (1.0 + s) / (2.0 * (1.0 - s))
        rows.append((stress, lateral + sand["poisson_ratio"] * (stress - pressure) / young, k))
    return np.array(rows).T


LOOSE = {**SAND, "cohesion": 1e3, "friction_angle": 32.0, "dilatancy_angle": -8.0, "friction_angle_residual": 30.0,
         "eta": 90.0}


def undrained_by_hand(sand, pressure, strains):
    """Effective mean stress s', radius t and plastic strain of a plane-strain test at constant volume.

    The flow (1 + s, 0, -(1 - s)) for s = sin(psi) takes 2 s lambda of volume, which the elastic soil gives back; its
    deviator has the norm sqrt(1 + s^2/3)."""
    shear, nu = sand["shear_modulus"], sand["poisson_ratio"]
    plane, radians = shear / (1.0 - 2.0 * nu), math.pi / 180.0  # lame + G

    def step(strain, state, at):  # lambda that the strength at `at` asks for, and what it makes of the state
        mean, slip, _ = state
        phi, c = radians * softened(sand, "friction_angle", at), softened(sand, "cohesion", at)
        s = math.sin(radians * softened(sand, "dilatancy_angle", at))
        excess = 2.0 * shear * (strain - slip) - c * math.cos(phi) - mean * math.sin(phi)
        more = max(0.0, excess / (2.0 * shear + 2.0 * plane * s * math.sin(phi)))
        return more * math.sqrt(1.0 + s * s / 3.0), (mean + 2.0 * plane * s * more, slip + more, at)

    state, rows = (pressure, 0.0, 0.0), []
    for strain in strains:
        low, high = state[2], state[2] + 2.0 * strain
        for _ in range(200):
            middle = 0.5 * (low + high)
            more, _ = step(strain, state, middle)
            low, high = (middle, high) if more > middle - state[2] else (low, middle)
        state = step(strain, state, low)[1]
        rows.append((state[0], 2.0 * shear * (strain - state[1]), state[2]))
    return np.array(rows).T


@unittest.skipUnless(_core, "the compiled part of the package was not built")
class ElementTests(unittest.TestCase):
    def test_a_softening_sand_is_that_of_an_own_integration(self):
        for sand, fall in ((SAND, 50e3), (LOOSE, 5e3)):
            with self.subTest(psi=sand["dilatancy_angle"]):
                self.drained(sand, fall)

    def drained(self, sand, fall):
        test = terp.element({"material": {"sand": sand}}, strain=0.1, pressure=80e3, increments=200)
        stress, lateral, k = triaxial_by_hand(sand, 80e3, np.linspace(0.0, 0.1, 201)[1:])
        np.testing.assert_allclose(-test["stress_yy"][1:], stress, rtol=1e-8)
        across = 0.5 * (test["strain_xx"] + test["strain_zz"])  # of each by itself the stress on the edge says nothing
        np.testing.assert_allclose(across[1:], lateral, rtol=0.0, atol=1e-10)
        np.testing.assert_allclose(test["eps_eq_p"][1:], k, rtol=0.0, atol=1e-10)
        self.assertGreater(max(stress), stress[-1] + fall)  # it softens
        self.assertEqual(test.fault, "")

    def test_undrained_loose_sand_is_that_of_an_own_integration(self):
        test = terp.element({"material": {"sand": LOOSE}}, test="biaxial", strain=0.4, pressure=80e3, undrained=True,
                            increments=400)
        mean, radius, k = undrained_by_hand(LOOSE, 80e3, np.linspace(0.0, 0.4, 401)[1:])
        xx, yy = test["stress_xx"][1:], test["stress_yy"][1:]
        np.testing.assert_allclose(-0.5 * (xx + yy), mean, rtol=1e-8)
        np.testing.assert_allclose(0.5 * (xx - yy), radius, rtol=1e-8)
        np.testing.assert_allclose(test["eps_eq_p"][1:], k, rtol=0.0, atol=1e-10)
        np.testing.assert_allclose(test["pore_pressure"][1:], 80e3 - mean + radius, rtol=1e-8)  # total xx is held
        self.assertLess(mean[-1], 0.8 * 80e3)  # it gives its pressure to the water ...
        self.assertLess(abs(mean[-1] - mean[-40]), 1e-3 * mean[-1])  # ... until the critical state

    def test_a_path_of_a_table_is_that_of_the_test(self):
        test = terp.element({"material": {"sand": SAND}}, strain=0.04, pressure=80e3, increments=80)
        table = {"strain_yy": [-0.01, -0.04], "stress_xx": [-80e3, -80e3], "stress_zz": [-80e3, -80e3]}
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "path.csv"
            file.write_text("strain_yy,stress_xx,stress_zz\n-0.01,-80e3,-80e3\n-0.04,-80e3,-80e3\n", encoding="utf-8")
            for path in (table, file):
                same = terp.element({"material": {"sand": SAND}}, path=path, pressure=80e3, increments=20)
                self.assertEqual(len(same["time"]), 41)
                np.testing.assert_allclose(same["stress_yy"][:21], test["stress_yy"][:21], rtol=1e-10)
                self.assertAlmostEqual(same["strain_yy"][-1], -0.04, delta=1e-14)

    def test_columns_are_arrays_with_units_and_a_picture(self):
        test = terp.element({"material": {"sand": SAND}}, test="oedometer", load=[200e3, 50e3], void_ratio=0.8,
                            increments=10)
        self.assertIn("void_ratio", test)
        self.assertEqual((test.units["deviator"], len(test["time"])), ("Pa", 21))
        np.testing.assert_allclose(test["void_ratio"], 1.8 * np.exp(test["volume_strain"]) - 1.0, rtol=1e-12)
        self.assertEqual(repr(test), f"<ElementTest of sand: 20 increments, {len(test)} columns>")
        axes = test.plot()
        self.assertEqual([len(axis.lines) for axis in axes], [1, 1, 1, 1])
        self.assertEqual(axes[0].get_ylabel(), "deviator stress q [kPa]")

    def test_what_is_asked_wrongly_is_refused_in_words(self):
        two = {"material": {"sand": SAND, "clay": SAND}}
        for options, words in (({}, "several materials: give one of sand, clay"),
                               ({"material": "clay"}, "either strain or load"),
                               ({"material": "clay", "test": "triaxal", "strain": 0.1}, "no test `triaxal`"),
                               ({"material": "peat", "strain": 0.1}, "no material `peat`"),
                               ({"material": "clay", "path": {"stress_xx": [1.0], "strain_xx": [0.0]}},
                                "path:2: strain and stress xx are both given")):
            with self.subTest(words), self.assertRaisesRegex(terp.CaseError, words):
                terp.element(two, **options)

    def test_a_load_beyond_the_strength_warns_and_keeps_what_it_has(self):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            test = terp.element({"material": {"sand": SAND}}, load=2e6)
        self.assertIn("does not follow the path to its end", str(told[0].message))
        self.assertGreater(len(test["time"]), 50)


if __name__ == "__main__":
    unittest.main()
