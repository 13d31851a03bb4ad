// The return itself is solved for many trials in tresca_softening_test.cpp.
#include "soil/laws/rate_factor.hpp"
#include "soil/laws/tresca_soil.hpp"

namespace rate_factor_test {

/// The equation of a plane, S = 1 + slope d: how often it was asked, and its answer.
struct Plane {
  Real radius, su, stiffness, e;  // stiffness: 2 G
  mutable int asked = 0;
  Excess<Real> operator()(Real d, Real factor) const
  {
    ++asked;
    return {radius - factor * su - stiffness * d, -stiffness, -su};
  }
};

TEST(RateFactor, IsSolvedInFewStepsFromCreepToImpact)
{
  int most = 0;
  for (const Real mu : {0.01, 0.1, 0.5})
    for (const Real rate_ref : {1e-9, 1e-6, 1e-2})
      for (const Real dt : {1e-6, 1e-3, 10.0})
        for (int k = 0; k < 120; ++k) {
          const Real over = std::pow(10.0, -9.0 + k / 12.0);  // of the trial stress over the strength
          const Plane plane{8e3 * (1.0 + over), 8e3, 4e6, 0.0};
          Real d = 8e3 * over / 4e6;
          const Real factor = RateFactor<Real>{mu, rate_ref}.solve(plane, dt, d);
          most = std::max(most, plane.asked);
          ASSERT_DOUBLE_EQ(factor, 1.0 + mu * std::log10(std::max(1.0, d / dt / rate_ref)));
          ASSERT_NEAR(plane(d, factor).value, 0.0, 1e-11 * plane.radius) << mu << ' ' << rate_ref << ' ' << over;
        }
  EXPECT_LE(most, 9);
}

/// Simple shear: gamma/2 = rate t, for a time.
Probe sheared(const Soil& soil, Real rate, Real time)
{
  Probe point = soil.probe();
  for (int k = 0; k < std::lround(time / soil.dt); ++k) point.strain({{0.0, 0.0, 0.0, rate * soil.dt}});
  return point;
}

TEST(RateFactor, GainsTheFactorOfTheRateInSteadyShear)  // then all strain is plastic
{
  const Soil soil{.eta = 0.0, .rate_mu = 0.1, .rate_ref = 1e-4};
  EXPECT_NEAR(sheared(soil, 1e-5, 2000.0 * soil.dt).sigma[3], 4e6 * 2e-5 * soil.dt * 1000.0, 1e-9) << "elastic";
  for (const Real dt : {0.01, 1.0, 10.0}) {
    Soil slow = soil;
    slow.dt = dt;
    EXPECT_NEAR(sheared(slow, 0.5e-4, 2000.0).sigma[3], 8e3, 1e-9) << "below the reference rate";
  }
  for (const Real dt : {1e-4, 1e-3}) {
    Soil fast = soil;
    fast.dt = dt;
    EXPECT_NEAR(sheared(fast, 0.1, 1.0).sigma[3], 8e3 * 1.3, 1e-6) << "three decades";
    EXPECT_NEAR(sheared(fast, 1.0, 1.0).sigma[3], 8e3 * 1.4, 1e-6) << "four decades";
  }
  EXPECT_NEAR(sheared(soil, -0.1, 1.0).sigma[3], -8e3 * 1.3, 1e-6);
}

/// d(tau)/dt = 2 G (rate - de/dt), tau = S(e)(1 + mu log10(de/dt / rate_ref)), by classical Runge-Kutta in small steps.
std::array<Real, 2> shear_history(const Soil& soil, Real rate, Real time)
{
  using Pair = std::array<Real, 2>;  // tau, e
  const auto slope = [&](const Pair& at) -> Pair {
    const Real over = (at[0] / soil.su(at[1]) - 1.0) / soil.rate_mu;
    const Real plastic = over > 0.0 ? soil.rate_ref * std::pow(10.0, over) : 0.0;
    return {2.0 * soil.G * (rate - plastic), plastic};
  };
  const auto add = [](const Pair& a, const Pair& b, Real f) -> Pair { return {a[0] + f * b[0], a[1] + f * b[1]}; };
  Pair at{0.0, 0.0};
  const int n = 400000;
  const Real h = time / n;
  for (int k = 0; k < n; ++k) {
    const Pair a = slope(at), b = slope(add(at, a, 0.5 * h)), c = slope(add(at, b, 0.5 * h)), d = slope(add(at, c, h));
    for (int i = 0; i < 2; ++i) at[i] += h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
  }
  return at;
}

TEST(RateFactor, FollowsTheRateWhateverTheTimeStep)  // softening and remoulding at once
{
  for (const Real rate : {0.02, 0.4}) {
    Soil soil{.su_remoulded = 500.0, .eta_remoulding = 5.0, .rate_mu = 0.1, .rate_ref = 1e-4};
    const Real time = 0.05 / rate;
    const auto [tau, e] = shear_history(soil, rate, time);
    for (const int steps : {100, 1000, 10000}) {
      soil.dt = time / steps;
      const Probe point = sheared(soil, rate, time);
      EXPECT_NEAR(point.sigma[3], tau, 4.0 / steps * tau) << rate << ", " << steps << " steps";
      EXPECT_NEAR(point.state[0], e, 0.02 / steps * e);
    }
  }
}

TEST(RateFactor, RelaxesWithTheLogarithmOfTime)  // held strain: d(tau)/dt = -2 G rate_ref 10^((tau/S - 1)/mu)
{
  Soil soil{.eta = 0.0, .rate_mu = 0.1, .rate_ref = 1e-4, .dt = 1e-4};
  Probe point = sheared(soil, 1.0, 0.1);
  const Real c = std::log(10.0) / 0.1, y_0 = c * (point.sigma[3] / 8e3 - 1.0), speed = 4e6 * 1e-4 * c / 8e3;
  Real time = 0.0;
  for (int k = 0; k < 400; ++k) {
    point.dt = 1e-6 * std::pow(1.06, k);
    time += point.dt;
    point.strain(Stress{});
    const Real y = std::max(0.0, -std::log(std::exp(-y_0) + speed * time));
    EXPECT_NEAR(point.sigma[3], 8e3 * (1.0 + y / c), 0.004 * 8e3) << "after " << time << " s";
  }
  EXPECT_NEAR(point.sigma[3], 8e3, 1e-8);
}

}  // namespace rate_factor_test
