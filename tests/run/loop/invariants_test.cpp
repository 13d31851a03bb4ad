// Momentum of blocks that collide: ledger, `ledgers`.
#include "support/twin.hpp"

namespace invariants_test {

class EveryScheme : public TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Schemes, EveryScheme, testing::Values("standard_mpm", "mpm_mixed", "mpm_gp"),
    [](const auto& info) { return std::string(info.param); });

/// The twin's scattered points on its distorted mesh, without boundaries and damping.
Simulation free_simulation(const std::string& scheme)
{
  Scenario s = load_free_scenario(scheme + "_distorted");
  return Simulation(std::move(s.model), std::move(s.state));
}

TEST_P(EveryScheme, GainsTheImpulseOfGravityInAStep)
{
  Simulation s = free_simulation(GetParam());
  const Vec<2> before = momentum(s.state);
  Real mass = 0.0;
  for (const Point& p : points_by_id(s.state)) mass += p.mass;
  make_steps(s);
  const Vec<2> after = momentum(s.state);
  for (int d = 0; d < 2; ++d) {
    EXPECT_NEAR(after[d] - before[d], mass * s.model.gravity[d] * s.model.dt, 1e-12 * momentum_scale(s.state));
  }
}

TEST_P(EveryScheme, KeepsTheMassOfEveryPointToTheBit)
{
  Case c = column(GetParam());
  c.bodies[0].velocity = {1.0, 0.0};
  Simulation s(c);
  const auto before = points_by_id(s.state);
  make_steps(s, 300);
  const auto after = points_by_id(s.state);
  ASSERT_EQ(after.size(), before.size());
  int moved = 0;
  for (std::size_t p = 0; p < after.size(); ++p) {
    EXPECT_EQ(after[p].id, static_cast<std::int64_t>(p));
    EXPECT_EQ(after[p].mass, before[p].mass);
    moved += after[p].cell != before[p].cell;
  }
  EXPECT_GT(moved, 20);
}

TEST_P(EveryScheme, FallsFreelyWithOneMinusAlphaTimesGravity)
{
  Case c = free_box(GetParam(), {1.0, 1.0}, {2.0, 1.75});
  c.forces.gravity = {0.0, -9.81};
  c.forces.local_damping = 0.1;
  Simulation s(c);
  make_steps(s, 51);
  // No damping at v = 0, so the first step sees the whole of g (method of local damping).
  const Real expected = -9.81 * s.model.dt * (1.0 + 50.0 * 0.9);
  for (const Point& p : points_by_id(s.state)) {
    EXPECT_NEAR(p.v[0], 0.0, 1e-5 * std::abs(expected));  // three sweeps for the slope of the pressure leave 1e-6
    EXPECT_NEAR(p.v[1], expected, 1e-5 * std::abs(expected));
  }
}

/// Work of the internal forces in one step, less minus the sum over the points of Omega_p sigma_p : d_eps; relative.
Real power_gap(Simulation s)
{
  const auto before = points_by_id(s.state);
  make_steps(s);
  const auto after = points_by_id(s.state);
  Real sum = 0.0, scale = 0.0;
  for (std::size_t p = 0; p < before.size(); ++p) {
    Real power = 0.0;
    for (int k = 0; k < 4; ++k)
      power += (k == 3 ? 2.0 : 1.0) * before[p].sigma[k] * (after[p].strain[k] - before[p].strain[k]);
    sum += before[p].volume * power;
    scale += std::abs(before[p].volume * power);
  }
  return std::abs(s.state.work.internal + sum) / scale;
}

Simulation with_method(const std::string& scheme, Weights weights, bool b_bar)
{
  Scenario s = load_free_scenario(scheme + "_distorted");
  s.model.method.weights = weights;
  s.model.method.b_bar = b_bar;
  return Simulation(std::move(s.model), std::move(s.state));
}

TEST(Energy, NodalInternalPowerIsThatOfThePointsWithSummedWeightsAndBBarTransposed)
{
  EXPECT_LT(power_gap(free_simulation("standard_mpm")), 1e-12);
  for (const char* scheme : {"mpm_mixed", "mpm_gp"}) {
    EXPECT_LT(power_gap(with_method(scheme, Weights::summed, true)), 1e-12) << scheme;
    EXPECT_GT(power_gap(with_method(scheme, Weights::summed, false)), 1e-4) << "Eq. (3) smooths a pressure";
    EXPECT_GT(power_gap(with_method(scheme, Weights::hybrid, true)), 1e-4) << scheme;
  }
}

Real total_work(const WorkTotals& w) { return w.given() + w.internal; }

/// Change of the points' kinetic energy plus 1/2 sum m |dv|^2 in one step, less all works; relative to the terms.
Real kinetic_gap(Simulation& s)
{
  const auto before = points_by_id(s.state);
  const WorkTotals earlier = s.state.work;
  make_steps(s);
  const auto after = points_by_id(s.state);
  Real jumps = 0.0;
  for (std::size_t p = 0; p < before.size(); ++p)
    for (int d = 0; d < 2; ++d) jumps += 0.5 * before[p].mass * std::pow(after[p].v[d] - before[p].v[d], 2);
  const Real gained = kinetic_energy(after) - kinetic_energy(before) + jumps;
  const WorkTotals& w = s.state.work;
  const Real scale = std::abs(w.internal - earlier.internal) + std::abs(w.gravity - earlier.gravity) + std::abs(gained);
  return std::abs(gained - (total_work(w) - total_work(earlier))) / scale;
}

TEST_P(EveryScheme, TheWorksOfAStepAddUpToTheKineticEnergyOfTheFreePoints)
{
  Scenario free = load_free_scenario(std::string(GetParam()) + "_distorted");
  free.model.damping = {.local = 0.1, .viscous = 3.0};
  Simulation s(std::move(free.model), std::move(free.state));
  for (int step = 0; step < 3; ++step) EXPECT_LT(kinetic_gap(s), 1e-12);
  EXPECT_NE(s.state.work.damping, 0.0);
}

TEST_P(EveryScheme, TheWorksOfAStepAddUpWhereSidesTakeVelocityFromTheNodes)
{
  Simulation s(column(GetParam()));
  make_steps(s, 200);
  for (int step = 0; step < 3; ++step) EXPECT_LT(kinetic_gap(s), 1e-12);
  EXPECT_GT(std::abs(s.state.work.clamps), 1e-6 * s.state.work.gravity);
}

TEST_P(EveryScheme, GravityWorkIsTheChangeOfPotential)
{
  Simulation s(column(GetParam()));
  const auto potential = [&] {
    Real sum = 0.0;
    for (const Point& p : points_by_id(s.state))
      sum -= p.mass * (s.model.gravity[0] * p.x[0] + s.model.gravity[1] * p.x[1]);
    return sum;
  };
  const Real start = potential();
  make_steps(s, 300);
  EXPECT_EQ(s.state.clamped, 0);
  EXPECT_NEAR(start - potential(), s.state.work.gravity, 1e-12 * start);
  EXPECT_GT(s.state.work.gravity, 1e-4 * start);
}

}  // namespace invariants_test
