// Tresca with softening: returns to the face and to both edges against an independent bisection, and Eqs. (5) and (6).
#include "soil/laws/tresca_soil.hpp"

namespace tresca_softening_test {

/// Where zz stands among the principal stresses of a trial.
enum class Zz { major, middle, minor };

/// A stress with these principal values, largest first, turned by `angle` in the plane.
Stress stress_of(std::array<Real, 3> s, Zz zz, Real angle = 0.4)
{
  const Stress straight = zz == Zz::major    ? Stress{{s[1], s[2], s[0], 0.0}}
                          : zz == Zz::middle ? Stress{{s[0], s[2], s[1], 0.0}}
                                             : Stress{{s[0], s[1], s[2], 0.0}};
  return rotated(straight, -angle);
}

Probe returned_from(const Soil& soil, const Stress& trial, Real eps_eq_p)
{
  Probe point = soil.probe();
  point.sigma = trial;
  point.state[0] = eps_eq_p;
  point.strain(Stress{});
  return point;
}

/// Root of a falling function between low and high, to the last bit.
template <class F>
Real bisect(F&& f, Real low, Real high)
{
  for (int k = 0; k < 200; ++k) {
    const Real middle = 0.5 * (low + high);
    (f(middle) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

struct Answer {
  std::array<Real, 3> s;  // largest first
  Real d_e;
  int where;  // 0 face, 1 edge where the two larger are equal, 2 edge where the two smaller are equal
};

/// The exact return by bisection, written from method.md section 3.
Answer exact_return(const Soil& soil, const std::array<Real, 3>& t, Real e)
{
  const Real far = (t[0] - t[2]) / soil.G;
  const Real d = bisect([&](Real x) { return t[0] - t[2] - 4.0 * soil.G * x - 2.0 * soil.su_after(e, x); }, 0.0, far);
  const Answer face{{t[0] - 2.0 * soil.G * d, t[1], t[2] + 2.0 * soil.G * d}, d, 0};
  if (face.s[0] >= face.s[1] && face.s[1] >= face.s[2]) return face;
  const Real p = (t[0] + t[1] + t[2]) / 3.0;
  const bool larger = face.s[0] < face.s[1];
  const auto corner = [&](Real x) {
    const Real su = soil.su_after(e, x);
    return larger ? std::array{p + 2.0 / 3.0 * su, p + 2.0 / 3.0 * su, p - 4.0 / 3.0 * su}
                  : std::array{p + 4.0 / 3.0 * su, p - 2.0 / 3.0 * su, p - 2.0 / 3.0 * su};
  };
  const auto missing = [&](Real x) {
    Real square = 0.0, outward = 0.0;
    for (int k = 0; k < 3; ++k) {
      const Real beyond = (t[k] - corner(x)[k]) / (2.0 * soil.G);
      square += beyond * beyond;
      outward += beyond * (corner(x)[k] - p);
    }
    return std::copysign(std::sqrt(0.5 * square), outward) - x;
  };
  const Real x = bisect(missing, 0.0, far);
  return {corner(x), x, larger ? 1 : 2};
}

void expect_exact_return(const Soil& soil, const std::array<Real, 3>& t, Real e, int where)
{
  const Answer exact = exact_return(soil, t, e);
  ASSERT_EQ(exact.where, where) << "the trial does not lie where this test means it to";
  for (const Zz zz : {Zz::major, Zz::middle, Zz::minor}) {
    const Probe point = returned_from(soil, stress_of(t, zz), e);
    const auto s = sorted_principal(point.sigma);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(s[k], exact.s[k], 1e-11 * soil.su_peak) << "stress " << k << ", zz at " << int(zz);
    EXPECT_NEAR(point.state[0], e + exact.d_e, 1e-14);
  }
}

TEST(TrescaSoftening, Eq5_DropsBy95PercentAtSixPercentStrain)  // decision 0001
{
  const Soil soil;
  auto point = soil.probe();
  point.state[0] = 0.06;
  const Real su = point.derived(0);
  EXPECT_NEAR((soil.su_peak - su) / (soil.su_peak - soil.su_residual), 0.95, 0.001);
  EXPECT_NEAR(su, 2e3 + 6e3 * std::exp(-3.0), 1e-9);
  EXPECT_EQ(point.law().softened_strain(), 0.06);
  point.state[0] = 1.0;
  EXPECT_NEAR(point.derived(0), 2e3, 1e-9);
}

TEST(TrescaSoftening, IsNeverSoftenedWhereNothingSoftens)
{
  const MaterialType& type = *find_material("tresca_softening");
  const auto softened_strain = [&](const Soil& soil) { return type.make(soil.parameters())->softened_strain(); };
  EXPECT_EQ(softened_strain({.eta = 0.0}), INFINITY);
  EXPECT_EQ(softened_strain({.su_residual = 8e3}), INFINITY);
  EXPECT_EQ(softened_strain({.eta_remoulding = 2.0}), 0.06) << "nothing is left to remould";
  EXPECT_EQ(softened_strain({.su_remoulded = 100.0}), 0.06);
  EXPECT_EQ(softened_strain({.su_remoulded = 100.0, .eta_remoulding = 2.0}), 1.5) << "the slower of both falls";
  EXPECT_EQ(softened_strain({.su_residual = 8e3, .su_remoulded = 100.0, .eta_remoulding = 2.0}), 1.5);
}

/// The bound that spares elastic points the whole answer lies below the strength at any strain.
TEST(TrescaSoftening, YieldsAsSoonAsTheStressIsBeyondTheStrength)
{
  const Soil once, twice{.su_remoulded = 400.0, .eta_remoulding = 2.0}, never{.su_residual = 8e3};
  for (const Soil& soil : {once, twice, never})
    for (const Real e : {0.0, 1e-3, 0.01, 0.03, 0.1, 0.2, 1.0, 5.0})
      for (const Zz zz : {Zz::major, Zz::middle, Zz::minor})
        for (const Real middle : {-0.9, 0.0, 0.9}) {
          const auto strain_after = [&](Real part) {
            const Real su = part * soil.su_after(e, 0.0), p = -5e4;
            const Stress trial = stress_of({p + su, p + middle * su, p - su}, zz);
            Probe point = soil.probe();
            point.sigma = trial;
            point.state[0] = e;
            point.strain_in_all_lanes(Stress{});
            const Probe beside_others = returned_from(soil, trial, e);
            EXPECT_EQ(point.sigma.c, beside_others.sigma.c);
            EXPECT_EQ(point.state, beside_others.state);
            return point.state[0];
          };
          EXPECT_GT(strain_after(1.0 + 1e-6), e) << e << ", zz at " << int(zz);
          EXPECT_EQ(strain_after(1.0 - 1e-6), e) << e << ", zz at " << int(zz);
        }
}

TEST(TrescaSoftening, FallsASecondTimeToTheRemouldedStrength)
{
  const Soil quick{.su_remoulded = 100.0, .eta_remoulding = 1.5};
  auto point = quick.probe();
  EXPECT_EQ(point.derived(0), 8e3);
  point.state[0] = 0.4;  // the first fall is done, the second has e^-0.6 left
  EXPECT_NEAR(point.derived(0), 100.0 + 1900.0 * std::exp(-0.6), 1e-4);
  point.state[0] = 0.0;
  for (int k = 0; k < 3000; ++k) {
    point.strain({{0.0, 0.0, 0.0, 1e-3}});
    ASSERT_NEAR(point.sigma[3], std::min(quick.su(point.state[0]), 4e3 * (k + 1)), 1e-8);
  }
  EXPECT_NEAR(point.sigma[3], 100.0 + 1900.0 * std::exp(-1.5 * point.state[0]), 1e-8);
  EXPECT_NEAR(point.state[0], 3.0, 1e-2);
}

TEST(TrescaSoftening, Eq6_OnAFaceTheNormIsThePlasticMultiplier)  // decision 0002: half the plastic engineering shear
{
  auto point = Soil{}.probe();
  Real gamma = 0.0;
  for (int k = 0; k < 50; ++k) {
    point.strain({{0.0, 0.0, 0.0, 1e-3}});
    gamma += 2e-3;
  }
  const Real plastic_gamma = gamma - point.sigma[3] / 2e6;
  EXPECT_NEAR(point.state[0], 0.5 * plastic_gamma, 1e-14);
}

TEST(TrescaSoftening, Eq6_OnAnEdgeTheNormIsTheRootOfHalfTheSquares)
{
  const Soil soil{.eta = 0.0};
  const std::array<Real, 3> trial{30e3, 29e3, -20e3};
  const auto point = returned_from(soil, stress_of(trial, Zz::middle), 0.0);
  const auto s = sorted_principal(point.sigma);
  Real square = 0.0;
  for (int k = 0; k < 3; ++k) square += std::pow((trial[k] - s[k]) / (2.0 * soil.G), 2);
  EXPECT_NEAR(point.state[0], std::sqrt(0.5 * square), 1e-15);
}

TEST(TrescaSoftening, Eq6_AddsIncrementsToAPathLength)  // there and back counts twice
{
  auto point = Soil{.eta = 0.0}.probe();
  point.strain({{0.0, 0.0, 0.0, 0.01}});
  const Real there = point.state[0];
  point.strain({{0.0, 0.0, 0.0, -0.01}});
  EXPECT_NEAR(there, 0.01 - 8e3 / 4e6, 1e-15);
  EXPECT_NEAR(point.state[0] - there, 0.01 - 2.0 * 8e3 / 4e6, 1e-15);
}

TEST(TrescaSoftening, WithoutSofteningReturnsToTheFaceAndTheEdgesOfTheClosedForm)
{
  const Real su = 8e3;
  const std::pair<std::array<Real, 3>, std::array<Real, 3>> returns[] = {
      {{20e3, 3e3, -10e3}, {5e3 + su, 3e3, 5e3 - su}},
      {{20e3, 19e3, -12e3}, {9e3 + 2.0 / 3.0 * su, 9e3 + 2.0 / 3.0 * su, 9e3 - 4.0 / 3.0 * su}},      // p = 9 kPa
      {{20e3, -11e3, -12e3}, {-1e3 + 4.0 / 3.0 * su, -1e3 - 2.0 / 3.0 * su, -1e3 - 2.0 / 3.0 * su}},  // p = -1 kPa
  };
  for (const Zz zz : {Zz::major, Zz::middle, Zz::minor})
    for (const auto& [trial, expected] : returns)
      EXPECT_THAT(sorted_principal(returned_from({.eta = 0.0}, stress_of(trial, zz), 0.0).sigma),
          Pointwise(DoubleNear(1e-8), expected));
}

TEST(TrescaSoftening, ReturnsToTheFaceAndTheEdgesOfTheBisection)
{
  const Soil steep{.su_residual = 500.0, .eta = 350.0};
  for (const Real e : {0.0, 0.004, 0.06}) {
    expect_exact_return({}, {25e3, 4.8e3, -15e3}, e, 0);
    expect_exact_return(steep, {-40e3, -55e3, -70e3}, e, 0);
    expect_exact_return({}, {25e3, 24e3, -15e3}, e, 1);
    expect_exact_return({}, {25e3, 25e3, -15e3}, e, 1);
    expect_exact_return(steep, {-40e3, -41e3, -80e3}, e, 1);
    expect_exact_return({}, {25e3, -14e3, -15e3}, e, 2);
    expect_exact_return({}, {25e3, -15e3, -15e3}, e, 2);
    expect_exact_return(steep, {-40e3, -78e3, -80e3}, e, 2);
  }
}

/// Soils up to the steepest softening that check() admits: one fall, two falls, and strength that the rate raises.
std::vector<Soil> hard_soils()
{
  std::vector<Soil> soils;
  for (const Real su_residual : {10.0, 2e3, 7e3})
    for (const Real part : {0.0, 0.3, 0.7, 0.95, 1.0}) {
      Soil soil{.su_residual = su_residual};
      soil.eta = part * 1.5 * soil.G / (soil.su_peak - su_residual);
      soils.push_back(soil);
    }
  for (const Real su_remoulded : {1.0, 1900.0})
    for (const Real second : {0.01, 0.3, 0.99}) {
      Soil soil{.su_remoulded = su_remoulded};
      soil.eta = (1.0 - second) * 1.499 * soil.G / (soil.su_peak - soil.su_residual);
      soil.eta_remoulding = second * 1.499 * soil.G / (soil.su_residual - su_remoulded);
      soils.push_back(soil);
    }
  for (const Real mu : {0.05, 0.2})
    for (const Real rate_ref : {1e-9, 1e-5, 1e-1})
      for (const Real part : {0.0, 0.5, 1.0}) {
        Soil soil{.su_remoulded = 300.0, .rate_mu = mu, .rate_ref = rate_ref};
        soil.eta = part * 1.39 * soil.G / (soil.su_peak - soil.su_residual) / (1.0 + 9.0 * mu);
        soil.eta_remoulding = 0.1 * soil.G / (soil.su_residual - soil.su_remoulded) / (1.0 + 9.0 * mu);
        soils.push_back(soil);
      }
  return soils;
}

/// f(soil, eps_eq_p, strength, trial) of hard soils, radii from 1 + 1e-9 to 11 times the strength, any middle stress.
template <class F>
void for_each_hard_trial(F&& f)
{
  for (const Soil& soil : hard_soils())
    for (const Real e : {0.0, 1e-4, 1e-3, 0.01, 0.1})
      for (int k = 0; k <= 80; ++k) {
        const Real radius = soil.su(e) * (1.0 + std::pow(10.0, -9.0 + k / 8.0));
        for (int m = 0; m <= 12; ++m) {
          const Real part_way =
              m <= 6 ? std::pow(m / 6.0, 3) : 2.0 - std::pow((12 - m) / 6.0, 3);  // dense near both edges
          f(soil, e, soil.su(e), std::array{radius, radius * (1.0 - part_way), -radius});
        }
      }
}

TEST(TrescaSoftening, AdmitsTheHardSoilsOfTheseTests)
{
  for (const Soil& soil : hard_soils())
    EXPECT_TRUE(find_material("tresca_softening")->check(soil.parameters()).empty());
}

TEST(TrescaSoftening, SolvesItsImplicitEquationsForEverySofteningThatIsAdmitted)
{
  Real worst_face = 0.0, worst_edge = 0.0;
  for_each_hard_trial([&](const Soil& soil, Real e, Real strength, const std::array<Real, 3>& t) {
    const Probe point = returned_from(soil, stress_of(t, Zz::middle, 0.0), e);
    const auto s = sorted_principal(point.sigma);
    const Real d_e = point.state[0] - e;
    const bool on_edge = s[0] - s[1] < 1e-9 * strength || s[1] - s[2] < 1e-9 * strength;
    // Face: s1 - s3 = s1t - s3t - 4 G d_e. Edge: d_e is the norm of the plastic strain. Both: s1 - s3 = 2 S_u(e + d_e).
    Real square = 0.0;
    for (int k = 0; k < 3; ++k) square += 0.5 * (t[k] - s[k]) * (t[k] - s[k]);
    const Real flow =
        on_edge ? std::sqrt(square) - 2.0 * soil.G * d_e : 0.5 * (t[0] - t[2] - s[0] + s[2]) - 2.0 * soil.G * d_e;
    const Real yield = 0.5 * (s[0] - s[2]) - soil.su_after(e, d_e);
    const Real residual = std::max(std::abs(flow), std::abs(yield));
    // Of the numbers that this check subtracts: of little strain beside much, d_e and its rate have few digits.
    const Real of_rate = d_e > 0.0 ? soil.rate_mu * strength * point.state[0] / d_e : 0.0;
    const Real round_off = 8e-16 * (t[0] + soil.G * point.state[0] + of_rate);
    Real& worst = on_edge ? worst_edge : worst_face;
    worst = std::max(worst, std::max(0.0, residual - round_off) / strength);
  });
  EXPECT_LT(worst_face, 5e-14);  // measured 3e-14 with five steps, 4e-7 with four
  EXPECT_LT(worst_edge, 1e-14);  // measured round-off with four or more steps, 5e-9 with three
}

TEST(TrescaSoftening, FindsTheUniqueAnswerForEverySofteningThatIsAdmitted)
{
  Real worst = 0.0;
  for_each_hard_trial([&](const Soil& soil, Real e, Real strength, const std::array<Real, 3>& t) {
    const auto s = sorted_principal(returned_from(soil, stress_of(t, Zz::middle, 0.0), e).sigma);
    const Answer exact = exact_return(soil, t, e);
    for (int k = 0; k < 3; ++k) worst = std::max(worst, std::abs(s[k] - exact.s[k]) / std::max(strength, 1e-2 * t[0]));
  });
  EXPECT_LT(worst, 1e-11);
}

TEST(TrescaSoftening, IsContinuousFromTheFaceOntoBothEdges)
{
  const Soil soil{.eta = 400.0};
  const std::array<Real, 3> t{20e3, 0.0, -20e3};
  const Real shift = 2.0 * soil.G * exact_return(soil, t, 0.001).d_e;
  for (const Real border : {t[0] - shift, t[2] + shift}) {
    const auto below = returned_from(soil, stress_of({t[0], border - 1e-5, t[2]}, Zz::middle), 0.001);
    const auto above = returned_from(soil, stress_of({t[0], border + 1e-5, t[2]}, Zz::middle), 0.001);
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(above.sigma[c], below.sigma[c], 1e-4);
    EXPECT_NEAR(above.state[0], below.state[0], 1e-10);
    EXPECT_NEAR(above.plastic_work, below.plastic_work, 1e-6);
  }
}

TEST(TrescaSoftening, IsContinuousWhereZzChangesItsRank)
{
  const Soil soil;
  for (const Real zz : {12e3, -18e3}) {  // the in-plane pair is 12 and -18 kPa
    const auto below = returned_from(soil, rotated({{12e3, -18e3, zz - 1e-5, 0.0}}, 0.3), 0.0);
    const auto above = returned_from(soil, rotated({{12e3, -18e3, zz + 1e-5, 0.0}}, 0.3), 0.0);
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(above.sigma[c], below.sigma[c], 1e-4);
  }
}

TEST(TrescaSoftening, TheEdgeReturnLiesBetweenTheTwoFacesThatMeetThere)  // both plastic multipliers are not negative
{
  for_each_hard_trial([&](const Soil& soil, Real e, Real strength, const std::array<Real, 3>& t) {
    const auto s = sorted_principal(returned_from(soil, stress_of(t, Zz::middle, 0.0), e).sigma);
    ASSERT_GE(t[0] - s[0], -1e-12 * t[0]);
    ASSERT_LE(t[2] - s[2], 1e-12 * t[0]);
    const Real middle = t[1] - s[1];
    ASSERT_TRUE(s[0] - s[1] >= 1e-9 * strength || middle >= -1e-10 * t[0]);
    ASSERT_TRUE(s[1] - s[2] >= 1e-9 * strength || middle <= 1e-10 * t[0]);
  });
}

TEST(TrescaSoftening, KeepsTheDirectionsOfTheTrialStress)
{
  for (const Real angle : {0.0, 0.3, 1.2, -0.8}) {
    const auto point = returned_from({}, stress_of({25e3, 2e3, -15e3}, Zz::middle, angle), 0.0);
    EXPECT_NEAR(rotated(point.sigma, angle)[3], 0.0, 1e-10);
    EXPECT_GT(rotated(point.sigma, angle)[0], rotated(point.sigma, angle)[1]);
  }
}

TEST(TrescaSoftening, PlasticWorkIsStressTimesPlasticStrainAndPositiveAndThePressureStays)
{
  Random random(72);
  int n_plastic = 0;
  for (int k = 0; k < 2000; ++k) {
    const Stress trial = random_tensor(30e3, random);
    Stress d_eps_p;
    const auto point = returned_from({}, trial, random.between(0.0, 0.1));
    for (int c = 0; c < 4; ++c) d_eps_p[c] = (trial[c] - point.sigma[c]) / (2.0 * Soil{}.G);
    EXPECT_NEAR(point.plastic_work, double_dot(point.sigma, d_eps_p), 1e-10);
    EXPECT_NEAR(trace(point.sigma), trace(trial), 1e-9);
    n_plastic += point.plastic_work > 0.0 ? 1 : 0;
    const auto t = sorted_principal(trial), s = sorted_principal(point.sigma);
    EXPECT_EQ(point.plastic_work > 0.0, t[0] - t[2] > s[0] - s[2] + 1e-6);
  }
  EXPECT_GT(n_plastic, 1500);
}

TEST(TrescaSoftening, IsElasticBelowItsStrength)
{
  const Stress trial = stress_of({7e3, 0.0, -8.9e3}, Zz::middle);
  const auto point = returned_from({}, trial, 0.0);
  EXPECT_EQ(point.sigma.c, trial.c);
  EXPECT_EQ(point.state[0], 0.0);
  EXPECT_EQ(point.plastic_work, 0.0);
  EXPECT_GT(returned_from({}, trial, 0.01).state[0], 0.01) << "the softened soil yields under the same stress";
}

TEST(TrescaSoftening, CarriesAnyPressureAndAnyTension)
{
  for (const Real p : {-1e6, 3e5}) {
    const Stress trial{{p, p, p, 7e3}};
    EXPECT_EQ(returned_from({}, trial, 0.0).sigma.c, trial.c);
  }
}

std::vector<ParameterProblem> problems_of(const Soil& s)
{
  return find_material("tresca_softening")->check(s.parameters());
}

TEST(TrescaSofteningCheck, RefusesSofteningThatIsTooSteepAndAResidualStrengthAboveThePeak)
{
  EXPECT_THAT(problems_of({.eta = 800.0}),
      ElementsAre(problem("eta", "softening is too steep",
          "eta (su_peak - su_residual) = 4.8e+06 Pa, at most 1.5 G = 3e+06 Pa\n"
          "(beyond sqrt(3) G the return mapping has no unique answer). Use eta <= 500, or a stiffer soil.")));
  EXPECT_THAT(problems_of({.su_residual = 9e3}),
      ElementsAre(problem("su_residual", "the residual strength exceeds the peak strength",
          "su_residual = 9000 Pa, at most su_peak = 8000 Pa.")));
}

TEST(TrescaSofteningCheck, CountsBothFallsAndTheRateIntoTheSteepness)
{
  EXPECT_THAT(problems_of({.eta = 490.0, .su_remoulded = 500.0, .eta_remoulding = 100.0}),
      ElementsAre(problem("eta", "softening is too steep",
          "eta (su_peak - su_residual) + eta_remoulding (su_residual - su_remoulded) = 3.09e+06 Pa, at most 1.5 G = "
          "3e+06 Pa\n"
          "(beyond sqrt(3) G the return mapping has no unique answer). Use eta <= 475, or a stiffer soil.")));
  EXPECT_THAT(problems_of({.eta = 300.0, .rate_mu = 0.1, .rate_ref = 1e-6}),
      ElementsAre(problem("eta", "softening is too steep",
          "(1 + 9 rate_mu) (eta (su_peak - su_residual)) = 3.42e+06 Pa, at most 1.5 G = 3e+06 Pa\n"
          "(beyond sqrt(3) G the return mapping has no unique answer). Use eta <= 263, or a stiffer soil.")));
  EXPECT_THAT(problems_of({.eta = 1.0, .su_remoulded = 500.0, .eta_remoulding = 2500.0}),
      ElementsAre(problem("eta_remoulding", "softening is too steep",
          "eta (su_peak - su_residual) + eta_remoulding (su_residual - su_remoulded) = 3.76e+06 Pa, at most 1.5 G = "
          "3e+06 Pa\n"
          "(beyond sqrt(3) G the return mapping has no unique answer). Use eta_remoulding <= 2e+03, or a stiffer "
          "soil.")));
}

TEST(TrescaSofteningCheck, RefusesARemouldedStrengthAboveTheResidualAndARateWithoutReference)
{
  EXPECT_THAT(problems_of({.su_remoulded = 2500.0}),
      ElementsAre(problem("su_remoulded", "the remoulded strength exceeds the residual strength",
          "su_remoulded = 2500 Pa, at most su_residual = 2000 Pa.")));
  EXPECT_THAT(problems_of({.rate_mu = 0.1}),
      ElementsAre(problem("rate_mu", "`rate_mu` needs `rate_ref`",
          "rate_mu = 0.1 is the gain of strength per tenfold rate; it needs the rate above which it counts.\n"
          "Give rate_ref, half the engineering shear strain rate of the test that gave su_peak.\n"
          "A triaxial test at 1 %/h: 2.4e-6 1/s (docs/softening_laws.md).")));
}

TEST(TrescaSofteningCheck, AdmitsTheLimitItselfAndSoilThatDoesNotSoften)
{
  EXPECT_TRUE(problems_of({.eta = 500.0}).empty());
  EXPECT_EQ(problems_of({.eta = 500.001}).size(), 1u);
  EXPECT_TRUE(problems_of({.su_residual = 8e3}).empty());
  EXPECT_TRUE(problems_of({.eta = 0.0}).empty());
}

}  // namespace tresca_softening_test
