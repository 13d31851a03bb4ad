// Free flight through a distorted mesh for ten metres: trajectory, momentum and mass are exact, and no stress arises.
#include "support/meshes.hpp"
#include "support/verification.hpp"

namespace flight_test {

constexpr Real h = 0.25;  // [m]

class Flight : public TestWithParam<std::string> {};

Simulation flying_block(const std::string& scheme, Vec<2> velocity, Real gravity)
{
  Case c = free_box(scheme, {0.3, 2.1}, {1.4, 2.9}, elastic(2.0e5, 0.3, 1500.0));
  c.bodies[0].velocity = velocity;
  c.forces.gravity = {0.0, gravity};
  return simulate_on(distorted_rectangle(48, 14, h, 0.3, 11), c);
}

/// Sum of m (x - centre) x (v - mean): spin about the centre of mass [kg m^2/s per m].
Real spin(const State& state)
{
  const Vec<2> centre = centre_of_mass(state), mean = mean_velocity(state);
  Real sum = 0.0;
  for (const Point& p : points_by_id(state))
    sum += p.mass * ((p.x[0] - centre[0]) * (p.v[1] - mean[1]) - (p.x[1] - centre[1]) * (p.v[0] - mean[0]));
  return sum;
}

TEST_P(Flight, KeepsTrajectoryMomentumAndMassForTenMetres)
{
  const Vec<2> v{4.0, 0.05};
  Simulation s = flying_block(GetParam(), v, 0.0);
  const auto start = points_by_id(s.state);
  const auto n = static_cast<std::int64_t>(10.0 / v[0] / s.model.dt);
  s.step(n);
  const Real time = s.state.time;
  EXPECT_GT(time * v[0], 9.9);
  Real stress = 0.0, off = 0.0;
  for (const Point& p : points_by_id(s.state)) {
    const Point& before = start[static_cast<std::size_t>(p.id)];
    for (int d = 0; d < 2; ++d) off = std::max(off, std::abs(p.x[d] - before.x[d] - v[d] * time));
    for (const Real component : p.sigma) stress = std::max(stress, std::abs(component));
    EXPECT_EQ(p.mass, before.mass);
    EXPECT_NEAR(p.volume, before.volume, 1e-9 * before.volume);
  }
  EXPECT_LT(off, 1e-9) << "of ten metres, after " << n << " steps";
  EXPECT_LT(stress, 1e-4) << "Pa, against a stiffness of 2e5 Pa: round-off of " << n << " steps";
  EXPECT_LT(std::abs(spin(s.state)), 1e-8 * momentum_scale(s.state));
  EXPECT_EQ(s.state.clamped, 0);
}

TEST_P(Flight, FallsAsAStone)
{
  const Vec<2> v{3.0, 0.0};
  Simulation s = flying_block(GetParam(), v, -1.0);
  const auto start = centre_of_mass(s.state);
  s.step(static_cast<std::int64_t>(1.5 / s.model.dt));
  const Real t = s.state.time, dt = s.model.dt;
  const Vec<2> end = centre_of_mass(s.state);
  EXPECT_NEAR(end[0] - start[0], v[0] * t, 1e-9);
  EXPECT_NEAR(end[1] - start[1], -0.5 * t * (t + dt),
      1e-9);  // symplectic Euler: the sum of v dt with v at the end of each step
  EXPECT_NEAR(mean_velocity(s.state)[1], -t, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(
    Schemes, Flight, testing::Values("standard_mpm", "mpm_mixed", "mpm_gp"), [](const auto& p) { return p.param; });

}  // namespace flight_test
