// A stiff elastic block on a contact base, against the motion of a rigid one.
#include "simulation/equilibrium.hpp"
#include "support/simulations.hpp"
#include <atomic>

namespace sliding_block_test {

constexpr Real length = 4.0, height = 0.5, density = 2000.0;  // [m], [m], [kg/m^3]
constexpr Real mass = density * length * height;              // [kg per m]

/// The block on a base with this contact, at rest, its weight carried from the start.
Case block(const char* scheme, const SideCondition& base, Vec<2> gravity)
{
  Case c;
  c.scheme = scheme;
  c.time.end = 0.2;
  c.mesh.size = {8.0, 1.0};
  c.mesh.cell = {0.05, 0.25};  // short: a base node at each end holds half an edge more than the block covers
  c.materials = {elastic(2e7, 0.3, density)};
  c.bodies = {body("rock", {1.0, 0.0}, {1.0 + length, height})};
  c.bodies[0].points_per_cell = {3, 3};
  c.forces.gravity = gravity;
  c.initial.stress = InitialStress::k0;
  c.initial.k0 = 0.0;
  c.sides = {base};
  return c;
}

SideCondition base(SideKind kind, Real adhesion, Real friction)
{
  SideCondition s = side("bottom", kind);
  s.adhesion = adhesion;
  s.friction = friction;
  return s;
}

/// Mean acceleration along the base [m/s^2].
Real mean_acceleration(const Case& c)
{
  Simulation s(c);
  s.step(s.model.n_steps);
  return momentum(s.state)[0] / (mass * s.state.time);
}

Vec<2> tilted(Real degrees)
{
  const Real t = degrees * std::numbers::pi / 180.0;
  return {9.81 * std::sin(t), -9.81 * std::cos(t)};
}

class SlidingBlock : public TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Schemes, SlidingBlock, testing::Values("standard_mpm", "mpm_mixed", "mpm_gp"),
    [](const auto& info) { return std::string(info.param); });

TEST_P(SlidingBlock, WithAdhesionAcceleratesByGravityLessAdhesionOverMass)
{
  const Real adhesion = 1000.0, expected = 5.0 - adhesion * length / mass;
  const Real a = mean_acceleration(block(GetParam(), base(SideKind::contact_bilateral, adhesion, 0.0), {5.0, -9.81}));
  EXPECT_NEAR(a, expected, 0.01 * expected);
}

TEST_P(SlidingBlock, SticksWhenAdhesionExceedsThePush)
{
  Simulation s(block(GetParam(), base(SideKind::contact_bilateral, 8000.0, 0.0), {5.0, -9.81}));  // 32 kN against 20 kN
  const auto before = points_by_id(s.state);
  s.step(s.model.n_steps);
  const auto after = points_by_id(s.state);
  for (std::size_t p = 0; p < before.size(); ++p)
    EXPECT_LT(std::abs(after[p].x[0] - before[p].x[0]), 0.002);  // free: 0.1 m
}

/// A column of one cell's width between rollers, its weight carried from the start.
Case standing_soil(const char* scheme)
{
  Case c = free_box(scheme, {0.0, 0.0}, {0.1, 2.0}, elastic(1e6, 0.3, density));
  c.mesh.size = {0.1, 3.0};
  c.mesh.cell = {0.1, 0.1};
  c.forces.gravity = {0.0, -9.81};
  c.initial.stress = InitialStress::k0;
  c.sides = {
      side("left", SideKind::roller), side("right", SideKind::roller), base(SideKind::contact_separating, 0.0, 0.0)};
  return c;
}

using SeparatingContact = SlidingBlock;
INSTANTIATE_TEST_SUITE_P(Schemes, SeparatingContact, testing::Values("standard_mpm", "mpm_mixed", "mpm_gp"),
    [](const auto& info) { return std::string(info.param); });

TEST_P(SeparatingContact, SoilAtRestGainsNoEnergy)
{
  Simulation s(standing_soil(GetParam()));
  s.step(static_cast<std::int64_t>(6.0 / s.model.dt));
  EXPECT_LT(s.state.work.boundary, 1e-9);                  // a floor that stays does no work
  EXPECT_LT(kinetic_energy(points_by_id(s.state)), 0.01);  // of 24 J elastic
}

TEST_P(SlidingBlock, SoilAtRestOnAnAdhesiveSlopeGainsNoEnergy)
{
  Case c = block(GetParam(), base(SideKind::contact_bilateral, 20000.0, 0.0), {5.0, -9.81});
  c.initial.stress = InitialStress::equilibrium;
  Simulation s(c);
  ASSERT_TRUE(find_equilibrium(s.model, s.state, std::atomic<bool>{false}).reached);
  s.step(static_cast<std::int64_t>(4.0 / s.model.dt));
  EXPECT_LT(std::abs(s.state.work.boundary), 1e-6);
  EXPECT_LT(kinetic_energy(points_by_id(s.state)), 0.01);
}

/// Under pure FLIP a sliding block rings, and a bilateral base rubs under pushes only: 10 % PIC keeps it quiet.
Case rubbing_block(const char* scheme, SideKind kind, Real friction, Real degrees)
{
  Case c = block(scheme, base(kind, 0.0, friction), tilted(degrees));
  c.method.flip = 0.9;
  return c;
}

TEST_P(SlidingBlock, WithFrictionAcceleratesAsCoulombSays)
{
  const Real t = 40.0 * std::numbers::pi / 180.0, expected = 9.81 * (std::sin(t) - 0.4 * std::cos(t));
  for (const SideKind kind : {SideKind::contact_bilateral, SideKind::contact_separating})
    EXPECT_NEAR(mean_acceleration(rubbing_block(GetParam(), kind, 0.4, 40.0)), expected, 0.01 * expected);
}

TEST_P(SlidingBlock, SticksWhenFrictionExceedsTheSlope)  // tan 15 degrees = 0.27
{
  EXPECT_NEAR(mean_acceleration(rubbing_block(GetParam(), SideKind::contact_bilateral, 0.4, 15.0)), 0.0, 0.002);
}

}  // namespace sliding_block_test
