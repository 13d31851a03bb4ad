#include "run/element/element_tests.hpp"

#include "support/cases.hpp"
#include "support/problems.hpp"

#include <numbers>

namespace element_test {

/// Follows a test of the laboratory; what is left out of the options is as `terp element` has it.
ElementResult tested(const MaterialCase& material, const std::string& test, ElementTestOptions options)
{
  for (const ElementTestInfo& info : element_tests())
    if (info.name == test) options.test = &info;
  return follow_path(element_soil({}, material), path_of_test(options), std::nan(""));
}

MaterialCase soil(const std::string& model, std::vector<Real> parameters, Drainage drainage = Drainage::drained)
{
  MaterialCase material;
  material.name = "soil", material.model = model, material.density = 1800.0;
  material.parameters = find_material(model)->complete(parameters);
  material.drainage = drainage;
  return material;
}

Real last(const ElementResult& result, const char* name)
{
  EXPECT_EQ(result.fault, "");
  return result.at(name).back();
}

/// G, nu, c, phi, psi of mohr_coulomb.
MaterialCase sand(Real cohesion = 5e3, Real phi = 30.0, Real psi = 10.0)
{
  return soil("mohr_coulomb", {4e6, 0.3, cohesion, phi, psi});
}

constexpr std::array<Real, 4> pressed{-100e3, -100e3, -100e3, 0.0};

TEST(Element, TriaxialCompressionOfElasticSoilIsHookesLaw)
{
  const MaterialCase material = soil("linear_elastic", {4e6, 0.3});
  const ElementResult result = tested(material, "triaxial", {.stress = pressed, .strain = {0.01}, .increments = 7});
  EXPECT_NEAR(last(result, "stress_yy"), -100e3 - 2.6 * 4e6 * 0.01, 1e-6);
  EXPECT_NEAR(last(result, "strain_xx"), 0.3 * 0.01, 1e-13);
  EXPECT_NEAR(last(result, "strain_zz"), 0.3 * 0.01, 1e-13);
  EXPECT_NEAR(last(result, "deviator_strain"), 2.0 / 3.0 * 1.3 * 0.01, 1e-13);
  EXPECT_NEAR(last(result, "deviator"), 2.6 * 4e6 * 0.01, 1e-6);
  EXPECT_NEAR(last(result, "time"), 1000.0, 1e-9);
}

TEST(Element, LoadAndUnloadOfElasticSoilReturnToTheStart)
{
  const MaterialCase material = soil("linear_elastic", {4e6, 0.2});
  const ElementResult result =
      tested(material, "oedometer", {.stress = pressed, .load = {300e3, 100e3}, .increments = 4});
  EXPECT_NEAR(result.at("strain_yy")[4], -200e3 / (4e6 * 2.0 * 0.8 / 0.6), 1e-12);
  EXPECT_NEAR(last(result, "strain_yy"), 0.0, 1e-13);
  EXPECT_NEAR(last(result, "stress_xx"), -100e3, 1e-6);
}

TEST(Element, UndrainedWaterTakesSkemptonsShareOfThePressure)
{
  MaterialCase material = soil("linear_elastic", {4e6, 0.3}, Drainage::undrained_effective);
  material.water_stiffness = 30e6;
  const Real bulk = 4e6 * 2.0 * 1.3 / (3.0 * 0.4), b = 30e6 / (30e6 + bulk);
  const ElementResult pressed_soil =
      tested(material, "isotropic", {.stress = pressed, .undrained = true, .load = {160e3}, .increments = 3});
  EXPECT_NEAR(last(pressed_soil, "pore_pressure"), 60e3 * b, 1e-6);
  EXPECT_NEAR(last(pressed_soil, "mean_pressure"), 100e3 + 60e3 * (1.0 - b), 1e-6);
  const ElementResult sheared =
      tested(material, "triaxial", {.stress = pressed, .undrained = true, .load = {160e3}, .increments = 3});
  EXPECT_NEAR(last(sheared, "pore_pressure"), 20e3 * b, 1e-6);  // A = 1/3
}

TEST(Element, WaterThatCannotBeCompressedKeepsTheVolume)
{
  const ElementResult result =
      tested(soil("linear_elastic", {4e6, 0.3}), "triaxial", {.stress = pressed, .undrained = true, .strain = {0.01}});
  EXPECT_NEAR(last(result, "volume_strain"), 0.0, 1e-14);
  EXPECT_NEAR(last(result, "mean_pressure"), 100e3, 1e-7);
  EXPECT_NEAR(last(result, "deviator"), 3.0 * 4e6 * 0.01, 1e-6);
  EXPECT_NEAR(last(result, "pore_pressure"), 4e6 * 0.01, 1e-6);  // q/3
}

TEST(Element, SandInTriaxialCompressionHasItsStrengthAndDilates)
{
  const Real s = 0.5, c = 5e3, root = std::sqrt(0.75);
  const ElementResult result =
      tested(sand(), "triaxial", {.stress = pressed, .strain = {0.05, 0.1}, .increments = 100});
  const Real strength = (2.0 * c * root + 2.0 * 100e3 * s) / (1.0 - s);
  EXPECT_NEAR(last(result, "deviator"), strength, 1e-8 * strength);
  // On the edge, beyond yield: dev/da = 2 sin(psi)/(1 - sin(psi)) for each axial strain.
  const Real sin_psi = std::sin(std::numbers::pi / 18.0), rate = 2.0 * sin_psi / (1.0 - sin_psi);
  EXPECT_NEAR(last(result, "volume_strain") - result.at("volume_strain")[100], 0.05 * rate, 1e-8 * 0.05);
}

TEST(Element, SandInBiaxialCompressionHasThePassiveStress)
{
  const ElementResult result = tested(sand(0.0, 35.0, 5.0), "biaxial", {.stress = pressed, .strain = {0.1}});
  const Real s = std::sin(35.0 * std::numbers::pi / 180.0);
  EXPECT_NEAR(last(result, "stress_yy"), -100e3 * (1.0 + s) / (1.0 - s), 1e-8 * 370e3);
}

TEST(Element, TheOedometerIsTheLedgersPath)
{
  const Real shear = 4e6, c = 5e3, s = 0.5, cos_phi = std::sqrt(0.75), lame = 2.0 * shear * 0.2 / 0.6;
  MaterialCase material = soil("mohr_coulomb", {shear, 0.2, c, 30.0, 10.0});
  const ElementResult result = tested(material, "oedometer", {.strain = {0.05}, .increments = 50});
  const Real d = std::sin(std::numbers::pi / 18.0);
  const Real m1 = 2.0 * lame * d + 2.0 * shear * (1.0 + d), m2 = 2.0 * lame * d,
             m3 = 2.0 * lame * d - 2.0 * shear * (1.0 - d);
  const Real k = m1 - m3 + s * (m1 + m3) + m2 - m3 + s * (m2 + m3);
  for (std::size_t i = 0; i <= 50; ++i) {
    const Real strain = 0.001 * static_cast<Real>(i);
    const Real f = std::max(0.0, (2.0 * shear - 2.0 * (lame + shear) * s) * strain - 2.0 * c * cos_phi);
    EXPECT_NEAR(result.at("stress_yy")[i], -(lame + 2.0 * shear) * strain - 2.0 * m3 * f / k, 1e-8 * c);
  }
}

TEST(Element, UndrainedShearOfSandIsTheStrengthOfItsMeanStress)
{
  const ElementResult result =
      tested(sand(5e3, 30.0, 0.0), "biaxial", {.stress = pressed, .undrained = true, .strain = {0.1}});
  const Real strength = 2.0 * (5e3 * std::sqrt(0.75) + 100e3 * 0.5);  // sigma_zz lies between, p' of the plane stays
  EXPECT_NEAR(last(result, "stress_xx") - last(result, "stress_yy"), strength, 1e-8 * strength);
  EXPECT_NEAR(last(result, "stress_yy") - last(result, "pore_pressure"), -100e3 - strength, 1e-8 * strength);
}

TEST(Element, UndrainedSandThatContractsGivesItsPressureToTheWater)
{
  const Real shear = 4e6, plane = shear / 0.4, pressure = 100e3, c = 5e3, s = 0.5, cos_phi = std::sqrt(0.75);
  const Real d = std::sin(-6.0 * std::numbers::pi / 180.0);
  const ElementResult result = tested(
      sand(c, 30.0, -6.0), "biaxial", {.stress = pressed, .undrained = true, .strain = {0.03}, .increments = 60});
  for (std::size_t i = 0; i <= 60; ++i) {
    const Real strain = 0.0005 * static_cast<Real>(i);
    const Real slip =
        std::max(0.0, (2.0 * shear * strain - c * cos_phi - s * pressure) / (2.0 * shear + 2.0 * s * d * plane));
    const Real mean = pressure + 2.0 * plane * d * slip, radius = 2.0 * shear * (strain - slip);
    EXPECT_NEAR(-0.5 * (result.at("stress_xx")[i] + result.at("stress_yy")[i]), mean, 1e-8 * pressure) << i;
    EXPECT_NEAR(result.at("pore_pressure")[i], pressure - mean + radius, 1e-8 * pressure) << i;
  }
  EXPECT_LT(-0.5 * (result.at("stress_xx").back() + result.at("stress_yy").back()), 0.6 * pressure);
}

TEST(Element, SoftClayInShearFollowsItsStrength)
{
  const MaterialCase material = soil("tresca_softening", {2e6, 0.48, 8e3, 2e3, 50.0}, Drainage::undrained);
  const ElementResult result = tested(material, "shear", {.strain = {0.1}, .increments = 200});
  for (std::size_t i = 20; i <= 200; ++i) {
    const Real k = result.at("eps_eq_p")[i], tau = result.at("stress_xy")[i];
    EXPECT_NEAR(tau, 2e3 + 6e3 * std::exp(-50.0 * k), 1e-8 * 8e3);
    EXPECT_NEAR(tau, 2e6 * (0.1 * static_cast<Real>(i) / 200.0 - 2.0 * k), 1e-8 * 8e3);
  }
  EXPECT_TRUE(std::isnan(last(result, "pore_pressure")));  // its stress is the total one
}

/// phi, lambda, kappa, e0, nu, yield stress, largest p'.
MaterialCase clay_of_critical_state(Real yield_stress)
{
  return soil("modified_cam_clay", {25.0, 0.2, 0.04, 1.0, 0.2, yield_stress, 400e3});
}

TEST(Element, UndrainedCamClayKeepsItsVolumeAndEndsAtTheCriticalState)
{
  const ElementResult result =
      tested(clay_of_critical_state(130e3), "triaxial", {.stress = pressed, .undrained = true, .strain = {0.3}});
  const Real kappa = 0.04 / 2.0, lambda = 0.2 / 2.0;
  const auto& p = result.at("mean_pressure");
  const auto& hardening = result.at("hardening");
  for (std::size_t k = 0; k < p.size(); ++k)
    EXPECT_NEAR(kappa * std::log(p[k] / 100e3) + (lambda - kappa) * hardening[k], 0.0, 1e-8 * lambda);
  const Real m = std::sqrt(3.0) * std::sin(25.0 * std::numbers::pi / 180.0);
  EXPECT_NEAR(last(result, "deviator") / p.back(), m, 1e-6);
}

TEST(Element, ALoadBeyondTheStrengthEndsThePathInWords)
{
  const ElementResult result = tested(sand(), "triaxial", {.stress = pressed, .load = {600e3}, .increments = 100});
  EXPECT_THAT(result.fault, testing::HasSubstr("no strain leads from increment"));
  EXPECT_THAT(result.fault, testing::HasSubstr("stress_yy = "));
  const Real strength = 100e3 + (2.0 * 5e3 * std::sqrt(0.75) + 100e3) / 0.5;
  EXPECT_LT(-result.at("stress_yy").back(), strength);
  EXPECT_GT(-result.at("stress_yy").back(), strength - 5e3 - 1.0);
}

TEST(Element, WaterThatCannotBeCompressedIsRefusedWhereTheVolumeIsPrescribed)
{
  const auto problems =
      problems_of([] { tested(sand(), "oedometer", {.stress = pressed, .undrained = true, .strain = {0.1}}); });
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_THAT(problems[0], told("material.soil", testing::HasSubstr("takes no path of strains alone")));
}

TEST(Element, AStartOutsideTheYieldSurfaceIsRefused)
{
  const auto problems =
      problems_of([] { tested(clay_of_critical_state(20e3), "triaxial", {.stress = pressed, .strain = {0.1}}); });
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].key, "material.soil.yield_stress");
}

}  // namespace element_test
