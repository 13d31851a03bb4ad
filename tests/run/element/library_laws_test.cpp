// Laws of libraries on paths of an element, and those of Plaxis in a run.

#include "run/element/element_tests.hpp"
#include "support/law_cases.hpp"

#include <numbers>

namespace library_laws_test {

LibraryCase udsm(const std::string& file, std::initializer_list<Real> parameters, Index model = 1)
{
  LibraryCase library = library_case(file, LawInterface::udsm, parameters);
  library.model_number = model;
  library.stress_unit = 1e3;
  return library;
}

/// shear, Poisson's ratio, k, fall, least k.
MaterialCase clay_of_plaxis() { return of_library(udsm("udsm_clay.so", {3000.0, 0.3, 8.0, 40.0, 2.0})); }

ElementResult tested(const MaterialCase& material, const std::string& test, ElementTestOptions options)
{
  for (const ElementTestInfo& info : element_tests())
    if (info.name == test) options.test = &info;
  return follow_path(element_soil({}, material), path_of_test(options), std::nan(""));
}

constexpr std::array<Real, 4> pressed{-100e3, -100e3, -100e3, 0.0};

TEST(Udsm, OfFortranSoftensInShearAsItsEquationsSay)
{
  if (!is_built("udsm_clay.so")) GTEST_SKIP() << "no gfortran";
  const ElementResult result =
      tested(clay_of_plaxis(), "shear", {.stress = pressed, .strain = {0.4}, .increments = 400});
  ASSERT_EQ(result.fault, "");
  for (std::size_t i = 0; i <= 400; ++i) {
    const Real gamma = 0.001 * static_cast<Real>(i);  // tau = G (gamma - 2 k_p) = k - fall k_p, then the least
    const Real falling = 3e6 * (gamma - 2.0 * (3e6 * gamma - 8e3) / (6e6 - 40e3));
    const Real tau = std::min(3e6 * gamma, std::max(2e3, falling));
    EXPECT_NEAR(result.at("stress_xy")[i], tau, 1e-8 * 8e3) << i;
    EXPECT_NEAR(result.at("state_2")[i], 0.5 * (gamma - tau / 3e6), 1e-12) << i;
  }
  EXPECT_NEAR(result.at("state_1").back(), 2.0, 1e-12) << "in kPa";
  EXPECT_EQ(result.at("state_3").back(), 400.0) << "calls of the increments, none of the search";
}

TEST(Udsm, OfFortranHasItsStrengthInUndrainedTriaxialCompression)
{
  if (!is_built("udsm_clay.so")) GTEST_SKIP() << "no gfortran";
  const ElementResult result = tested(of_library(udsm("udsm_clay.so", {3000.0, 0.3, 8.0, 0.0, 2.0})), "triaxial",
      {.stress = pressed, .undrained = true, .strain = {0.02}, .increments = 50});
  const Real q = std::numbers::sqrt3 * 8e3;
  EXPECT_NEAR(result.at("deviator").back(), q, 1e-8 * q);
  EXPECT_NEAR(result.at("pore_pressure").back(), q / 3.0, 1e-8 * q);
  EXPECT_NEAR(result.at("mean_pressure").back(), 100e3, 1e-6);
}

TEST(Udsm, OfCppStiffensWithItsPressure)
{
  const MaterialCase material = of_library(udsm("udsm_two.so", {3000.0, 5000.0, 100.0}, 2));
  const ElementResult result = tested(material, "isotropic", {.stress = pressed, .strain = {0.03}, .increments = 30});
  ASSERT_EQ(result.fault, "");
  const Real expected = 100e3 * std::pow(1.0 + 50.0 * 0.003, 30);  // explicit: p (1 + K0/p_ref d_v) each increment
  EXPECT_NEAR(result.at("mean_pressure").back(), expected, 1e-8 * expected);
  EXPECT_NEAR(result.at("state_1").back(), expected / 1e3, 1e-8 * expected / 1e3);
  EXPECT_NEAR(result.at("state_1").front(), 0.0, 0.0) << "task 1 has not been called";
  const ElementResult pulled =
      tested(material, "isotropic", {.stress = {1e3, 1e3, 1e3, 0.0}, .strain = {-0.01}, .increments = 2});
  EXPECT_THAT(pulled.fault, HasSubstr("the law asks to end the calculation (iAbort = 7)"));
}

TEST(Udsm, MovesAsElasticSoilOfTerp)
{
  MaterialCase own = elastic(shear, poisson, 1900.0);
  own.name = "soft clay";
  const MaterialCase mine = of_library(udsm("udsm_two.so", {shear / 1e3, poisson}, 1));
  for (const char* scheme : {"mpm_gp", "mpm_mixed"}) {
    Simulation a(moving_box(scheme, mine), 2), b(moving_box(scheme, own), 2);
    a.step(100), b.step(100);
    expect_same_stresses(a, b);
  }
}

TEST(Udsm, SaysHowManyStateVariablesItHas)
{
  const auto said = [](LibraryCase library) { return problems_of([&] { of_library(std::move(library)); }); };
  LibraryCase two = udsm("udsm_two.so", {3000.0, 5000.0, 100.0}, 2);
  two.state = {{"p_max", 0.0}, {"more", 0.0}};
  EXPECT_THAT(said(two), ElementsAre(told("state", "the law has 1 state variables, the case gives 2")));
  EXPECT_THAT(said(udsm("udsm_two.so", {}, 3)), ElementsAre(told("model_number", "the library has no model 3")));
  two.state = {{"p_max", 0.0}};
  EXPECT_EQ(of_library(two).from_library->state[0].name, "p_max");
}

TEST(Umat, OnThePathOfAnElementIsTheLawThatTerpHas)
{
  if (!is_built("tresca.so")) GTEST_SKIP() << "no gfortran";
  const MaterialCase umat =
      of_library(library_case("tresca.so", LawInterface::umat, {2e6, 0.48, 8e3, 2e3, 50.0}, {{"eps_eq_p", 0.0}}));
  MaterialCase own = clay();
  own.drainage = Drainage::undrained;
  for (const char* test : {"shear", "triaxial"}) {
    const ElementTestOptions options{.stress = pressed, .strain = {0.1, 0.08}, .increments = 100};
    const ElementResult a = tested(umat, test, options), b = tested(own, test, options);
    ASSERT_EQ(a.fault + b.fault, "");
    for (std::size_t i = 0; i <= 200; ++i) EXPECT_NEAR(a.at("deviator")[i], b.at("deviator")[i], 1e-8 * 16e3) << test;
  }
}

TEST(Esm, OnThePathOfAnElementHasItsStrength)
{
  if (!is_built("esm_hardening.so")) GTEST_SKIP() << "no gfortran";
  LibraryCase library =
      library_case("esm_hardening.so", LawInterface::esm, {3000.0, 0.3, 8.0}, {{"k", 0.0}, {"calls", 0.0}});
  library.stress_unit = 1e3;
  const ElementResult result = tested(of_library(library), "triaxial", {.stress = pressed, .strain = {0.02}});
  ASSERT_EQ(result.fault, "");
  EXPECT_NEAR(result.at("deviator").back(), std::numbers::sqrt3 * 8e3, 1e-8 * 14e3);
  EXPECT_EQ(result.at("calls").back(), 1000.0);
}

}  // namespace library_laws_test
