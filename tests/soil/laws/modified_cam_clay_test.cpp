// Modified Cam-Clay against its closed forms. Twins are written from the equations, in rates.
#include "soil/laws/probe.hpp"

namespace modified_cam_clay_test {

constexpr Real phi = 30.0 * std::numbers::pi / 180.0, kappa = 0.05, lambda = 0.25, e0 = 1.5, nu = 0.25;
constexpr Real kappa_star = kappa / (1.0 + e0), lambda_star = lambda / (1.0 + e0);
constexpr Real yield_stress = 80e3, largest = 2e6, smallest = 1e3;
const Real sin_phi = std::sin(phi), M = std::sqrt(3.0) * sin_phi;
const Real p_c0 = yield_stress * ((3.0 - 2.0 * sin_phi) / 3.0 + 1.0 / (3.0 - 2.0 * sin_phi));

const MaterialType& type() { return *find_material("modified_cam_clay"); }
Probe soil() { return Probe(type(), {30.0, lambda, kappa, e0, nu, yield_stress, largest, smallest}); }

/// A point at p' = p without shear.
Probe at_pressure(Real p)
{
  Probe point = soil();
  for (int k = 0; k < 3; ++k) point.sigma[k] = -p;
  return point;
}

Real pressure(const Probe& point) { return -(point.sigma[0] + point.sigma[1] + point.sigma[2]) / 3.0; }
Real radius(const Probe& point)
{
  const Real p = pressure(point);
  Real sum = 2.0 * point.sigma[3] * point.sigma[3];
  for (int k = 0; k < 3; ++k) sum += (point.sigma[k] + p) * (point.sigma[k] + p);
  return std::sqrt(0.5 * sum);
}
Real p_c(Probe& point) { return point.derived(0); }

Stress isotropic(Real compression) { return {{-compression / 3.0, -compression / 3.0, -compression / 3.0, 0.0}}; }

/// Compresses along yy by `axial` in one step, with the strain across that leaves the stress across as it is.
void drained_triaxial_step(Probe& point, Real axial)
{
  const Probe before = point;
  const Real target = point.sigma[0];
  Real low = -axial, high = 2.0 * axial;
  for (int k = 0; k < 50; ++k) {
    const Real across = 0.5 * (low + high);
    point = before;
    point.strain({{across, -axial, across, 0.0}});
    (point.sigma[0] > target ? high : low) = across;
  }
}

TEST(ModifiedCamClay, StartsWithAYieldSurfaceThroughTheStressOfItsYieldStress)
{
  Probe point = soil();
  const Real K0 = 1.0 - sin_phi, p = yield_stress * (1.0 + 2.0 * K0) / 3.0,
             J = yield_stress * (1.0 - K0) / std::sqrt(3.0);
  EXPECT_NEAR(p_c(point), p + J * J / (sin_phi * sin_phi * p), 1e-9 * p_c0);
  EXPECT_NEAR(p_c(point), p_c0, 1e-9 * p_c0);
}

TEST(ModifiedCamClay, FollowsItsLinesOfIsotropicCompressionInStepsOfAnySize)
{
  for (const int n : {1, 7, 300}) {
    Probe point = at_pressure(20e3);
    const Real to_yield = kappa_star * std::log(p_c0 / 20e3), beyond = 0.1, back = 0.03;
    strain_in_parts(point, isotropic(to_yield + beyond), n);
    const Real p = p_c0 * std::exp(beyond / lambda_star);
    EXPECT_NEAR(pressure(point), p, 1e-11 * p) << n;
    EXPECT_NEAR(p_c(point), p, 1e-11 * p) << n;
    EXPECT_LT(radius(point), 1e-9 * p);
    strain_in_parts(point, isotropic(-back), n);
    EXPECT_NEAR(pressure(point), p * std::exp(-back / kappa_star), 1e-11 * p) << n;
    EXPECT_NEAR(p_c(point), p, 1e-11 * p) << n;
  }
}

TEST(ModifiedCamClay, HasTheUndrainedStrengthOfItsOverconsolidation)
{
  for (const Real ocr : {1.0, 1.5, 2.0, 4.0, 10.0}) {
    const Real p0 = p_c0 / ocr, p_f = p0 * std::pow(0.5 * ocr, 1.0 - kappa / lambda);
    Probe plane = at_pressure(p0), triaxial = at_pressure(p0);
    strain_in_parts(plane, {{0.5, -0.5, 0.0, 0.0}}, 4000);
    strain_in_parts(triaxial, {{0.25, -0.5, 0.25, 0.0}}, 4000);
    EXPECT_NEAR(0.5 * (plane.sigma[0] - plane.sigma[1]), sin_phi * p_f, 1e-6 * p_f) << ocr;
    EXPECT_NEAR(pressure(plane), p_f, 1e-6 * p_f) << ocr;
    EXPECT_NEAR(plane.sigma[2], -p_f, 1e-6 * p_f) << "the mean, without strain along z";
    EXPECT_NEAR(triaxial.sigma[0] - triaxial.sigma[1], M * p_f, 1e-6 * p_f) << ocr;
  }
}

TEST(ModifiedCamClay, KeepsItsVolumeAlongTheUndrainedPathInStepsOfAnySize)
{
  for (const int n : {1, 5, 50, 5000}) {
    Probe point = at_pressure(0.8 * p_c0);
    strain_in_parts(point, {{0.02, -0.02, 0.0, 0.01}}, n);
    const Real changed = kappa_star * std::log(pressure(point) / (0.8 * p_c0)) +
                         (lambda_star - kappa_star) * std::log(p_c(point) / p_c0);
    EXPECT_NEAR(changed, 0.0, 1e-14) << n;
    const Real p = pressure(point), J = radius(point);
    EXPECT_NEAR(J * J, sin_phi * sin_phi * p * (p_c(point) - p), 1e-10 * J * J);
  }
}

TEST(ModifiedCamClay, ReachesTheCriticalStateInDrainedTriaxialCompressionFromBothSides)
{
  for (const Real p0 : {p_c0, 0.15 * p_c0}) {
    Probe point = at_pressure(p0);
    Real highest = 0.0;
    for (int k = 0; k < 2000; ++k) {
      drained_triaxial_step(point, 1e-3);
      highest = std::max(highest, point.sigma[0] - point.sigma[1]);
    }
    const Real p = p0 / (1.0 - M / 3.0), q = point.sigma[0] - point.sigma[1];  // q = 3 (p - p0) along the path
    EXPECT_NEAR(point.sigma[0], -p0, 1e-6 * p0);
    EXPECT_NEAR(pressure(point), p, 2e-3 * p);
    EXPECT_NEAR(q, M * pressure(point), 2e-3 * q);
    EXPECT_NEAR(p_c(point), 2.0 * p, 5e-3 * p);
    if (p0 < p_c0) {
      EXPECT_GT(highest, 1.2 * q) << "the dry side has a peak";
    } else {
      EXPECT_LT(highest, 1.0001 * q) << "the wet side has none";
    }
  }
}

/// The stress ratio q/p' that one-dimensional compression tends to: its strains, e_q = 2/3 e_v, in closed form.
Real excess_of_ratio(Real ratio)
{
  const Real G_over_K = 1.5 * (1.0 - 2.0 * nu) / (1.0 + nu);
  return kappa_star * ratio / (3.0 * G_over_K) + (lambda_star - kappa_star) * 2.0 * ratio / (M * M - ratio * ratio) -
         lambda_star * 2.0 / 3.0;
}

TEST(ModifiedCamClay, TendsToItsOwnRatioInOneDimensionalCompression)
{
  Probe point = at_pressure(30e3);
  strain_in_parts(point, {{0.0, -0.3, 0.0, 0.0}}, 20000);
  const Real p = pressure(point);
  EXPECT_NEAR(excess_of_ratio((point.sigma[0] - point.sigma[1]) / p), 0.0, 1e-4 * lambda_star);
  Probe more = point;
  strain_in_parts(more, {{0.0, -0.02, 0.0, 0.0}}, 1000);
  EXPECT_NEAR(std::log(pressure(more) / p), 0.02 / lambda_star, 1e-4);
}

/// One step of Euler's method on the rates, of soil that yields: the twin of a path.
struct Twin {
  Stress sigma;
  Real p_c;
  void step(const Stress& d)
  {
    Real p = -(sigma[0] + sigma[1] + sigma[2]) / 3.0;
    const Real K = std::clamp(p, smallest, largest) / kappa_star, G = 1.5 * K * (1.0 - 2.0 * nu) / (1.0 + nu);
    const Real volume = d[0] + d[1] + d[2];
    Stress n, elastic;
    Real shear = 0.0;  // s:de
    for (int k = 0; k < 4; ++k) {
      const Real one = k < 3 ? 1.0 : 0.0, s = sigma[k] + one * p;
      n[k] = s / (sin_phi * sin_phi) - one * (2.0 * p - p_c) / 3.0;
      elastic[k] = K * volume * one + 2.0 * G * (d[k] - one * volume / 3.0);
      shear += (k < 3 ? 1.0 : 2.0) * s * elastic[k];
    }
    const Real D = 2.0 * p - p_c, s2 = sin_phi * sin_phi;
    Real JJ = sigma[3] * sigma[3];
    for (int k = 0; k < 3; ++k) JJ += 0.5 * (sigma[k] + p) * (sigma[k] + p);
    const Real f = JJ / s2 - p * (p_c - p);
    const Real loading = shear / s2 - D * K * volume;
    const Real hardening = 2.0 * G * 2.0 * JJ / (s2 * s2) + K * D * D + p * p_c * D / (lambda_star - kappa_star);
    const Real gamma = f >= -1e-9 * p_c * p_c ? std::max(0.0, (loading + f) / hardening) : 0.0;
    for (int k = 0; k < 4; ++k) {
      const Real one = k < 3 ? 1.0 : 0.0;
      sigma[k] += elastic[k] - gamma * (2.0 * G * (sigma[k] + one * p) / s2 - K * D * one);
    }
    p_c *= 1.0 + gamma * D / (lambda_star - kappa_star);
  }
};

TEST(ModifiedCamClay, AgreesWithTheRatesAndConvergesWithTheStep)
{
  const Stress d{{0.02, -0.05, 0.0, 0.03}};
  Twin twin{{{-0.6 * p_c0, -0.7 * p_c0, -0.65 * p_c0, 0.0}}, p_c0};
  constexpr int fine = 400000;
  Stress part = d;
  for (int k = 0; k < 4; ++k) part[k] /= fine;
  for (int k = 0; k < fine; ++k) twin.step(part);
  std::vector<Real> errors;
  for (const int n : {50, 100, 200, 400}) {
    Probe point = soil();
    point.sigma = {{-0.6 * p_c0, -0.7 * p_c0, -0.65 * p_c0, 0.0}};
    strain_in_parts(point, d, n);
    Real error = 0.0;
    for (int k = 0; k < 4; ++k) error = std::max(error, std::abs(point.sigma[k] - twin.sigma[k]) / p_c0);
    errors.push_back(error);
  }
  EXPECT_LT(errors[0], 0.01);
  for (std::size_t k = 1; k < errors.size(); ++k) EXPECT_NEAR(errors[k - 1] / errors[k], 2.0, 0.3) << k;
}

TEST(ModifiedCamClay, LeadsBackToTheSameStressBelowYield)
{
  Probe point = at_pressure(25e3);
  const Stress forth{{0.002, -0.006, 0.0, 0.001}};
  Stress back = forth;
  for (int k = 0; k < 4; ++k) back[k] = -forth[k];
  for (int k = 0; k < 100; ++k) point.strain(forth), point.strain(back);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(point.sigma[k], -25e3, 1e-8);
  EXPECT_EQ(point.state[0], 0.0);
}

TEST(ModifiedCamClay, CarriesNoTensionAndKeepsALeastStiffnessAndPreconsolidation)
{
  Probe point = at_pressure(5e3);
  strain_in_parts(point, {{0.3, 0.2, 0.0, 0.1}}, 500);
  EXPECT_GE(pressure(point), 0.0);
  EXPECT_LT(pressure(point), 0.5 * smallest);
  EXPECT_NEAR(p_c(point), smallest, 1e-9 * smallest) << "it falls no further";
  Probe pulled = at_pressure(5e3);
  pulled.strain(isotropic(-0.2));
  EXPECT_NEAR(pressure(pulled), 0.0, 1e-9);
  Probe slack = soil();  // no stress at all
  slack.strain(isotropic(1e-4));
  EXPECT_NEAR(pressure(slack), 1e-4 * smallest / kappa_star, 1e-9);
}

TEST(ModifiedCamClay, GrowsNoStifferThanTheStressForWhichTheTimeStepHolds)
{
  Probe point = at_pressure(largest);
  point.state[1] = std::log(10.0 * largest / p_c0);
  point.strain(isotropic(1e-3));
  EXPECT_NEAR(pressure(point), largest * (1.0 + 1e-3 / kappa_star), 1e-6);
  EXPECT_DOUBLE_EQ(point.law().bulk_modulus(), largest / kappa_star);
  EXPECT_NEAR(point.law().shear_modulus(), 1.5 * (1.0 - 2.0 * nu) / (1.0 + nu) * largest / kappa_star, 1e-3);
}

TEST(ModifiedCamClay, StoresTheWorkOfElasticCompression)
{
  Probe point = soil();
  constexpr int n = 20000;
  Real work = 0.0;
  for (int k = 0; k < n; ++k) {  // through the least stress, and through the largest
    const Real before = pressure(point);
    point.state[1] = 10.0;
    point.strain(isotropic(0.18 / n));
    work += 0.5 * (before + pressure(point)) * 0.18 / n;
  }
  EXPECT_GT(pressure(point), largest);
  EXPECT_NEAR(point.law().stored_energy({}, point.sigma), work, 1e-6 * work);
}

TEST(ModifiedCamClay, DissipatesInEveryStepWhateverTheStress)
{
  Random random(7);
  for (int seed = 0; seed < 200; ++seed) {
    Probe point = at_pressure(random.between(0.0, p_c0));
    for (int k = 0; k < 50; ++k) {
      const Real size = std::pow(10.0, random.between(-7.0, -1.0)), before = point.state[0];
      point.strain(random_tensor(size, random));
      ASSERT_GE(point.plastic_work, 0.0);
      ASSERT_GE(point.state[0], before);
      const Real p = pressure(point), J = radius(point);
      ASSERT_LE(J * J, sin_phi * sin_phi * p * (p_c(point) - p) + 3e-12 * (J * J + p_c(point) * (p + J)));
    }
  }
}

/// What speaks against a stress with which a point begins.
std::vector<ParameterProblem> told_of(Probe& of, Real yy, Real across)
{
  return of.law().check_start({.state = {.data = of.state.data()}, .parameters = {}}, {{across, yy, across, 0.0}});
}

TEST(ModifiedCamClay, SaysWhichStartingStressItDoesNotAdmit)
{
  Probe point = soil();
  Probe loaded = point;
  loaded.state[1] = std::log(2.0);  // p_c is twice that of the start
  const auto told = [&](Real yy, Real across) { return told_of(point, yy, across); };
  EXPECT_TRUE(told(-yield_stress, -(1.0 - sin_phi) * yield_stress).empty()) << "normally consolidated";
  EXPECT_TRUE(told(0.0, 0.0).empty());
  EXPECT_THAT(told(-1.2 * yield_stress, -0.6 * yield_stress),
      ElementsAre(problem("yield_stress", "the starting stress lies outside the yield surface",
          "p' = 6.4e+04 Pa, J = 2.771e+04 Pa need p_c = 1.12e+05 Pa; yield_stress gives 9.333e+04 Pa. Give 1.2 times "
          "the yield_stress\nor more, by ocr or pop, or a k0 nearer to 1 - sin(phi) = 0.5.")));
  EXPECT_THAT(told(-3e6, -3e6),
      ElementsAre(problem("largest_mean_stress", "the soil starts with more than its largest mean stress",
          "p' = 3e+06 Pa, largest_mean_stress = 2e+06 Pa. Give the largest that will occur.")));
  EXPECT_TRUE(told_of(loaded, -1.9 * yield_stress, -0.95 * yield_stress).empty());
  EXPECT_THAT(told_of(loaded, -2.4 * yield_stress, -1.2 * yield_stress),
      ElementsAre(problem("yield_stress", "the starting stress lies outside the yield surface",
          "p' = 1.28e+05 Pa, J = 5.543e+04 Pa need p_c = 2.24e+05 Pa; the soil was loaded to 1.867e+05 Pa. Give 1.2 "
          "times the yield_stress\nor more, by ocr or pop, or a k0 nearer to 1 - sin(phi) = 0.5.")));
}

TEST(ModifiedCamClay, DoesNotStartInTension)
{
  Probe point = soil();
  const auto told = [&](Real yy, Real across) { return told_of(point, yy, across); };
  EXPECT_THAT(told(9e3, 3e3),
      ElementsAre(problem("model", "the soil starts without pressure",
          "p' = -5000 Pa, J = 3464 Pa, and this law carries no tension. Look at k0 and at the water there, or give "
          "the\nbody another law.")));
  EXPECT_EQ(told(5e3, 5e3).size(), 1u);
  EXPECT_EQ(told(-4e3, 2e3).size(), 1u) << "no pressure, but shear";
  EXPECT_TRUE(told(1.0, 1.0).empty()) << "round-off";
}

TEST(ModifiedCamClay, TakesTheYieldSurfaceThroughAStressThatASearchFound)
{
  Probe point = soil();
  const Stress sigma{{-50e3, -150e3, -60e3, 20e3}};
  point.law().start({.state = {.data = point.state.data()}, .parameters = {}}, sigma);
  point.sigma = sigma;
  const Real p = pressure(point), J = radius(point);
  EXPECT_NEAR(p_c(point), p + J * J / (sin_phi * sin_phi * p), 1e-9 * p);
  const Real grown = p_c(point);
  point.law().start({.state = {.data = point.state.data()}, .parameters = {}}, {{-1e3, -1e3, -1e3, 0.0}});
  EXPECT_EQ(p_c(point), grown) << "it does not shrink";
}

TEST(ModifiedCamClay, RefusesParametersThatDoNotFit)
{
  const auto problems = [](std::vector<Real> values) { return type().check(values); };
  EXPECT_THAT(problems({30.0, 0.2, 0.19, 1.0, 0.2, 50e3, 1e6, 1e3}),
      ElementsAre(problem("kappa", "kappa is too large beside lambda",
          "kappa/lambda = 0.95, at most 0.9: unloading must be stiffer than normal compression.")));
  EXPECT_THAT(problems({30.0, 0.2, 0.02, 1.0, 0.2, 50e3, 1e3, 1e3}),
      ElementsAre(problem("smallest_mean_stress", "the smallest mean stress is not below the largest",
          "smallest_mean_stress = 1000 Pa, largest_mean_stress = 1000 Pa.")));
  EXPECT_THAT(problems({30.0, 0.2, 0.02, 1.0, 0.2, 3e3, 1e5, 5e3}),
      ElementsAre(problem("yield_stress", "the yield stress is below what the law can hold",
          "It gives p_c = 3500 Pa; the least is smallest_mean_stress = 5000 Pa. Give a larger yield_stress, or a "
          "smaller\nsmallest_mean_stress.")));
}

}  // namespace modified_cam_clay_test
