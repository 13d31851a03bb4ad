#include "soil/laws/probe.hpp"

namespace mohr_coulomb_test {

constexpr Real degree = std::numbers::pi / 180.0;
constexpr Real infinity = std::numeric_limits<Real>::infinity();

struct Soil {
  Real G = 4e6, nu = 0.3, c = 5e3, phi = 30.0, psi = 10.0, cutoff = infinity;  // Pa, deg
  Real c_residual = 5e3, phi_residual = 30.0, psi_residual = 10.0, eta = 0.0;

  std::vector<Real> values() const { return {G, nu, c, phi, psi, cutoff, c_residual, phi_residual, psi_residual, eta}; }
  Probe probe() const { return {*find_material("mohr_coulomb"), values()}; }
  Real sin_phi() const { return std::sin(phi * degree); }
  Real sin_psi() const { return std::sin(psi * degree); }
  Real decay(Real e) const { return std::exp(-eta * e); }
  Real cohesion_at(Real e) const { return c_residual + (c - c_residual) * decay(e); }
  Real phi_at(Real e) const { return (phi_residual + (phi - phi_residual) * decay(e)) * degree; }
  Real passive(Real e) const { return (1.0 + std::sin(phi_at(e))) / (1.0 - std::sin(phi_at(e))); }  // tan^2(45 + phi/2)
  Real tension_at(Real e) const { return std::min(cutoff, cohesion_at(e) / std::tan(phi_at(e))); }
};

Soil softening_soil()
{
  return {.phi = 35.0, .psi = 12.0, .c_residual = 1e3, .phi_residual = 28.0, .psi_residual = 0.0, .eta = 40.0};
}

Stress isotropic(Real p) { return {{p, p, p, 0.0}}; }

/// How far the stress lies outside the surface of its own strain [Pa]; negative inside.
Real excess_of(const Soil& soil, const Probe& point)
{
  const auto s = sorted_principal(point.sigma);
  const Real e = point.state[0], sine = std::sin(soil.phi_at(e));
  const Real by_shear = s[0] - s[2] + (s[0] + s[2]) * sine - 2.0 * soil.cohesion_at(e) * std::cos(soil.phi_at(e));
  return std::max(by_shear, s[0] - soil.tension_at(e));
}

/// Strains a point with `given`, and with as much of `free` beside it as brings component k of the stress to `target`.
Stress strain_towards(Probe& point, const Stress& given, const Stress& free, int k, Real target)
{
  const Stress sigma = point.sigma;
  const auto state = point.state;
  Real low = -0.01, high = 0.01;
  Stress d_eps{};
  for (int n = 0; n < 100; ++n) {
    const Real amount = 0.5 * (low + high);
    for (int c = 0; c < 4; ++c) d_eps[c] = given[c] + amount * free[c];
    point.sigma = sigma;
    point.state = state;
    point.strain(d_eps);
    (point.sigma[k] < target ? low : high) = amount;
  }
  return d_eps;
}

/// yy is strained by `rate` per step, xx keeps its pressure, and so does zz in the triaxial cell.
struct LaboratoryPath {
  const char* name;
  Real p, rate;
  bool triaxial;
};

TEST(MohrCoulomb, PathsOfTheLaboratoryFailAtThePassiveOrActiveStressAndDilate)
{
  const Soil soil;
  const Real passive = soil.passive(0.0), sin_psi = soil.sin_psi();
  for (const auto& [name, p, rate, triaxial] :
      {LaboratoryPath{"triaxial compression, on the edge sigma_1 = sigma_2", -50e3, -5e-4, true},
          {"triaxial extension, on the edge sigma_2 = sigma_3", -80e3, 5e-4, true},
          {"plane strain compression, between the edges", -50e3, -5e-4, false},
          {"plane strain extension", -80e3, 5e-4, false}}) {
    Probe point = soil.probe();
    point.sigma = isotropic(p);
    Stress d_eps{};
    for (int k = 0; k < 200; ++k)
      d_eps = strain_towards(point, {{0.0, rate, 0.0, 0.0}}, {{1.0, 0.0, triaxial ? 1.0 : 0.0, 0.0}}, 0, p);
    const bool compressed = rate < 0.0;
    const Real limit =
        compressed ? p * passive - 2.0 * 5e3 * std::sqrt(passive) : p / passive + 2.0 * 5e3 / std::sqrt(passive);
    EXPECT_NEAR(point.sigma[1], limit, 1e-6) << name;
    if (triaxial) {
      EXPECT_NEAR(point.sigma[2], p, 1e-6) << name;
    } else if (compressed) {
      EXPECT_LT(point.sigma[2], p - 1e3) << name;
      EXPECT_GT(point.sigma[2], point.sigma[1] + 1e3) << name;
    }
    if (triaxial || compressed) {
      EXPECT_NEAR(trace(d_eps) / 5e-4, 2.0 * sin_psi / (compressed ? 1.0 - sin_psi : 1.0 + sin_psi), 1e-9) << name;
    }
  }
}

TEST(MohrCoulomb, Eq5_IsTheCurveThatSimpleShearFollows)  // c and phi soften together, psi = 0
{
  Soil soil = softening_soil();
  soil.psi = 0.0;
  Probe point = soil.probe();
  point.sigma = isotropic(-60e3);
  Real eps_xy = 0.0;
  for (int k = 0; k < 120; ++k) {
    point.strain({{0.0, 0.0, 0.0, 1e-3}});
    eps_xy += 1e-3;
    const Real e = point.state[0],
               strength = soil.cohesion_at(e) * std::cos(soil.phi_at(e)) + 60e3 * std::sin(soil.phi_at(e));
    if (e > 0.0) {
      ASSERT_NEAR(point.sigma[3], strength, 1e-7) << "eps_eq_p = " << e;
    }
    ASSERT_NEAR(e, std::max(0.0, eps_xy - point.sigma[3] / (2.0 * soil.G)), 1e-13);
  }
  EXPECT_NEAR(point.derived(0), 1e3, 50.0);
  EXPECT_NEAR(point.derived(1), 28.0, 0.1);
}

TEST(MohrCoulomb, ShowsTheStrengthThatIsLeft)
{
  Probe point = softening_soil().probe();
  point.state[0] = 0.02;
  EXPECT_NEAR(point.derived(0), 1e3 + 4e3 * std::exp(-0.8), 1e-9);
  EXPECT_NEAR(point.derived(1), 28.0 + 7.0 * std::exp(-0.8), 1e-12);
  EXPECT_NEAR(point.derived(2), 12.0 * std::exp(-0.8), 1e-12);
}

TEST(MohrCoulomb, ExpansionEndsAtTheApexAndWithACutOffBelowIt)
{
  for (const Real cutoff : {infinity, 2e3, 0.0}) {
    const Soil soil{.cutoff = cutoff};
    Probe point = soil.probe();
    for (int k = 0; k < 50; ++k) point.strain({{1e-3, 2e-3, 1e-3, 1e-3}});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(point.sigma[c], soil.tension_at(0.0), 1e-9);
    EXPECT_NEAR(point.sigma[3], 0.0, 1e-9);
  }
}

TEST(MohrCoulomb, ThatHasComeApartGivesNoPressureBeforeItHasClosed)
{
  Probe point = Soil{.c = 0.0, .c_residual = 0.0}.probe();
  const Real K = point.law().bulk_modulus();
  point.sigma = isotropic(-3e3);
  point.strain({{2e-3, 1e-3, 1e-3, 5e-4}});
  for (int c = 0; c < 4; ++c) EXPECT_EQ(point.sigma[c], 0.0);
  EXPECT_NEAR(point.state[1], 4e-3 - 3e3 / K, 1e-15);
  point.strain({{1e-3, -3e-3, 0.0, 2e-3}});
  for (int c = 0; c < 4; ++c) EXPECT_EQ(point.sigma[c], 0.0) << "apart: no shear stress either";
  point.strain(isotropic(-2e-3 / 3.0));
  EXPECT_EQ(point.state[1], 0.0);
  EXPECT_NEAR(trace(point.sigma) / 3.0, -3e3, 1e-6) << "the volume of the start has the pressure of the start";
}

TEST(MohrCoulomb, WithCohesionComesApartAtTheApexAndClosesWithoutTension)
{
  Probe point = Soil{.cutoff = 2e3}.probe();
  for (int k = 0; k < 20; ++k) point.strain({{1e-3, 1e-3, 1e-3, 0.0}});
  EXPECT_NEAR(trace(point.sigma) / 3.0, 2e3, 1e-9) << "perfectly plastic while it opens";
  EXPECT_NEAR(point.plastic_work, 2e3 * 3e-3, 1e-12);
  EXPECT_NEAR(point.state[1], 0.06 - 2e3 / point.law().bulk_modulus(), 1e-15);
  for (int k = 0; k < 19; ++k) {
    point.strain({{-1e-3, -1e-3, -1e-3, 0.0}});
    EXPECT_EQ(trace(point.sigma), 0.0) << "closing gives no work back";
    EXPECT_EQ(point.plastic_work, 0.0);
  }
  point.strain({{-1e-3, -1e-3, -2e-3, 0.0}});
  EXPECT_NEAR(trace(point.sigma) / 3.0, -point.law().bulk_modulus() * 1e-3, 1e-6);
}

TEST(MohrCoulomb, WithoutFrictionItIsTresca)  // to the round-off of both, softening and a limit of tension included
{
  constexpr Real left_out = std::numeric_limits<Real>::quiet_NaN();
  for (const Real cutoff : {infinity, 3e3, 0.0}) {
    const Soil soil{.G = 2e6,
        .nu = 0.48,
        .c = 8e3,
        .phi = 0.0,
        .psi = 0.0,
        .cutoff = cutoff,
        .c_residual = 2e3,
        .phi_residual = 0.0,
        .psi_residual = 0.0,
        .eta = 50.0};
    Random random(91);
    Real largest_opening = 0.0;
    for (int walk = 0; walk < 50; ++walk) {
      const std::vector<Real> clay{2e6, 0.48, 8e3, 2e3, 50.0, left_out, left_out, left_out, left_out, cutoff};
      Probe mohr = soil.probe(), tresca(*find_material("tresca_softening", {}, cutoff < infinity), clay);
      for (int step = 0; step < 40; ++step) {
        const Stress d_eps = random_tensor(0.004, random);
        mohr.strain(d_eps);
        tresca.strain(d_eps);
        for (int c = 0; c < 4; ++c)
          ASSERT_NEAR(mohr.sigma[c], tresca.sigma[c], 1e-6) << cutoff << ", walk " << walk << ", step " << step;
        ASSERT_NEAR(mohr.state[0], tresca.state[0], 1e-12);
        ASSERT_NEAR(mohr.plastic_work, tresca.plastic_work, 1e-8);
        if (tresca.state.size() < 2) continue;
        ASSERT_NEAR(mohr.state[1], tresca.state[1], 1e-12);
        largest_opening = std::max(largest_opening, tresca.state[1]);
      }
    }
    EXPECT_EQ(largest_opening > 1e-3, cutoff < infinity) << "it was torn";
  }
}

/// Soils of all kinds: with and without cohesion, dilatancy, cut-off and softening.
std::vector<Soil> various_soils()
{
  Soil steep = softening_soil();
  steep.eta = 0.98 * 1.5 * steep.G / (4e3 * std::cos(28.0 * degree));
  Soil cut = softening_soil();
  cut.cutoff = 500.0;
  return {Soil{}, softening_soil(), steep, cut, {.c = 0.0, .psi = 0.0, .c_residual = 0.0, .psi_residual = 0.0},
      {.c = 0.0, .phi = 40.0, .psi = 12.0, .c_residual = 0.0, .phi_residual = 32.0, .psi_residual = 0.0, .eta = 100.0},
      {.nu = 0.0, .psi = 30.0, .psi_residual = 30.0}, {.nu = 0.49, .psi = 0.0, .cutoff = 0.0, .psi_residual = 0.0},
      {.nu = 0.25, .psi = -15.0, .c_residual = 2e3, .psi_residual = 0.0, .eta = 40.0},  // it contracts
      {.c = 0.0, .psi = -8.0, .c_residual = 0.0, .psi_residual = -8.0}};
}

TEST(MohrCoulomb, EndsEveryStepOnOrInsideTheSurfaceOfItsOwnStrainAndDissipates)
{
  Random random(92);
  Real worst = 0.0;
  for (const Soil& soil : various_soils())
    for (int walk = 0; walk < 40; ++walk) {
      Probe point = soil.probe();
      point.sigma = isotropic(-random.between(0.0, 200e3));
      const Real size = std::pow(10.0, random.between(-5.0, -1.7));
      for (int step = 0; step < 100; ++step) {
        Stress d_eps;
        for (int c = 0; c < 4; ++c)
          d_eps[c] = random.between(-size, size) - (c < 3 ? random.between(0.0, 0.1 * size) : 0.0);
        const Real before = point.state[0];
        point.strain(d_eps);
        worst = std::max(worst, excess_of(soil, point) / (1.0 + std::abs(sorted_principal(point.sigma)[2])));
        ASSERT_GE(point.plastic_work, 0.0);
        ASSERT_GE(point.state[0], before);
      }
    }
  EXPECT_LT(worst, 1e-11);
}

TEST(MohrCoulomb,
    CountsThePlasticShearOfTheStepItReturnedWith)  // Eq. (6), whatever the softening does to the strength meanwhile
{
  Random random(93);
  for (const Soil& soil : various_soils())
    for (int k = 0; k < 500; ++k) {
      Probe point = soil.probe();
      Stress trial;
      const Real p = random.between(-150e3, 10e3);
      for (int c = 0; c < 4; ++c) trial[c] = (c < 3 ? p : 0.0) + random.between(-60e3, 60e3);
      point.sigma = trial;
      point.state[0] = k % 2 == 0 ? 0.0 : random.between(0.0, 0.05);
      const Real before = point.state[0];
      point.strain(Stress{});
      Real square = 0.0;
      const Real mean = (trace(trial) - trace(point.sigma)) / 3.0;
      for (int c = 0; c < 4; ++c)
        square +=
            (c < 3 ? 1.0 : 2.0) * std::pow((trial[c] - point.sigma[c] - (c < 3 ? mean : 0.0)) / (2.0 * soil.G), 2);
      ASSERT_NEAR(point.state[0] - before, std::sqrt(0.5 * square), 1e-12) << "eta " << soil.eta;
    }
}

TEST(MohrCoulomb, PlasticWorkIsStressTimesPlasticStrain)
{
  Random random(94);
  const Soil soil = softening_soil();
  for (int k = 0; k < 500; ++k) {
    Probe point = soil.probe();
    Stress trial, d_eps_p;
    for (int c = 0; c < 4; ++c) trial[c] = (c < 3 ? -40e3 : 0.0) + random.between(-40e3, 40e3);
    point.sigma = trial;
    point.strain(Stress{});
    const Real mean = (trace(trial) - trace(point.sigma)) / 3.0;
    for (int c = 0; c < 4; ++c)
      d_eps_p[c] = (trial[c] - point.sigma[c] - (c < 3 ? mean : 0.0)) / (2.0 * soil.G) +
                   (c < 3 ? mean / (3.0 * point.law().bulk_modulus()) : 0.0);
    EXPECT_NEAR(point.plastic_work, double_dot(point.sigma, d_eps_p), 1e-9);
  }
}

TEST(MohrCoulomb,
    IsReturnedFromTheMeanOfTwoStatesThatMixedForms)  // the mean stress may lie outside the surface of the mean strain
{
  Random random(95);
  const Soil soil = softening_soil();
  int outside = 0;
  for (int k = 0; k < 300; ++k) {
    std::vector<Probe> two;
    for (int n = 0; n < 2; ++n) {
      two.push_back(soil.probe());
      two[n].sigma = isotropic(-random.between(1e3, 100e3));
      two[n].state[0] = random.between(0.0, 0.1);
      for (int step = 0; step < 5; ++step) two[n].strain({{-0.001, 0.001, 0.0, random.between(0.0, 0.004)}});
    }
    Probe mean = soil.probe();
    for (int c = 0; c < 4; ++c) mean.sigma[c] = 0.5 * (two[0].sigma[c] + two[1].sigma[c]);
    mean.state[0] = 0.5 * (two[0].state[0] + two[1].state[0]);
    outside += excess_of(soil, mean) > 1.0 ? 1 : 0;
    mean.strain(Stress{});
    EXPECT_LT(excess_of(soil, mean), 1e-6);
  }
  EXPECT_GT(outside, 50);
}

std::vector<ParameterProblem> problems_of(const Soil& soil)
{
  return find_material("mohr_coulomb")->check(soil.values());
}

TEST(MohrCoulombCheck, AdmitsSoilsOfAllKinds)
{
  for (const Soil& soil : various_soils()) EXPECT_TRUE(problems_of(soil).empty());
}

TEST(MohrCoulombCheck, RefusesWhatNoSoilIs)
{
  EXPECT_THAT(problems_of({.psi = 31.0, .psi_residual = 0.0}),
      ElementsAre(problem("dilatancy_angle", "the dilatancy angle exceeds the friction angle",
          "dilatancy_angle = 31 deg, at most friction_angle = 30 deg: soil that dilates more gains energy by "
          "shearing.")));
  EXPECT_THAT(problems_of({.psi = 20.0, .phi_residual = 15.0, .psi_residual = 20.0}),
      ElementsAre(problem("dilatancy_angle_residual", "the dilatancy angle exceeds the friction angle",
          "dilatancy_angle_residual = 20 deg, at most friction_angle_residual = 15 deg: soil that dilates more gains "
          "energy by shearing.")));
  EXPECT_THAT(problems_of({.c_residual = 6e3}),
      ElementsAre(problem("cohesion_residual", "the residual cohesion exceeds the peak",
          "cohesion_residual = 6000 Pa, at most cohesion = 5000 Pa.")));
  EXPECT_THAT(problems_of({.phi_residual = 31.0}),
      ElementsAre(problem("friction_angle_residual", "the residual friction angle exceeds the peak",
          "friction_angle_residual = 31 deg, at most friction_angle = 30 deg.")));
  EXPECT_THAT(problems_of({.psi_residual = 11.0}),
      ElementsAre(problem("dilatancy_angle_residual", "the residual dilatancy angle exceeds the peak",
          "dilatancy_angle_residual = 11 deg, allowed are those from 0 to dilatancy_angle = 10 deg.")));
  EXPECT_THAT(problems_of({.psi = -5.0, .psi_residual = 1.0}),
      ElementsAre(problem("dilatancy_angle_residual", "the residual dilatancy angle exceeds the peak",
          "dilatancy_angle_residual = 1 deg, allowed are those from 0 to dilatancy_angle = -5 deg.")));
  EXPECT_THAT(problems_of({.nu = 0.45, .psi = -15.0, .psi_residual = 0.0}),
      ElementsAre(problem("dilatancy_angle", "the soil contracts too much for its stiffness",
          "With dilatancy_angle = -15 deg a small strain would take all strength at once. Use an angle nearer to 0, or "
          "a smaller\npoisson_ratio: that of drained soil, 0.2 to 0.35.")));
  EXPECT_THAT(
      problems_of({.c = 0.0, .phi = 0.0, .psi = 0.0, .c_residual = 0.0, .phi_residual = 0.0, .psi_residual = 0.0}),
      ElementsAre(problem("cohesion", "the soil has no strength",
          "cohesion and friction_angle are both 0. Give one of them, or choose model = \"newtonian_fluid\".")));
  EXPECT_THAT(problems_of({.G = 1e6,
                  .phi = 0.0,
                  .psi = 0.0,
                  .c_residual = 1e3,
                  .phi_residual = 0.0,
                  .psi_residual = 0.0,
                  .eta = 500.0}),
      ElementsAre(problem("eta", "softening is too steep",
          "eta (cohesion - cohesion_residual) cos(phi) = 2e+06 Pa, at most 1.5 G = 1.5e+06 Pa\n"
          "(beyond sqrt(3) G the return mapping has no unique answer). Use eta <= 375, or a stiffer soil.")));
}

}  // namespace mohr_coulomb_test
