// A stiff elastic block, and soil at rest, on a contact base. Blocks on inclined meshes:
// tests/whole/incline_test.
#include "support/simulations.hpp"

namespace sliding_block_test {

constexpr Real length = 4.0, height = 0.5, density = 2000.0;  // [m], [m], [kg/m^3]
constexpr Real mass = density * length * height;              // [kg per m]

/// The block on a base with this contact, at rest, its weight carried from the start.
Case block(const char* scheme, SideKind base, Vec<2> gravity)
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
  c.sides = {side("bottom", base)};
  return c;
}

class SlidingBlock : public TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Schemes, SlidingBlock, testing::Values("standard_mpm", "mpm_mixed", "mpm_gp"),
    [](const auto& info) { return std::string(info.param); });

/// A column of one cell's width between rollers, its weight carried from the start.
Case standing_soil(const char* scheme)
{
  Case c = free_box(scheme, {0.0, 0.0}, {0.1, 2.0}, elastic(1e6, 0.3, density));
  c.mesh.size = {0.1, 3.0};
  c.mesh.cell = {0.1, 0.1};
  c.forces.gravity = {0.0, -9.81};
  c.initial.stress = InitialStress::k0;
  c.sides = {
      side("left", SideKind::roller), side("right", SideKind::roller), side("bottom", SideKind::contact_separating)};
  return c;
}

TEST_P(SlidingBlock, SoilAtRestOnASeparatingBaseGainsNoEnergy)
{
  Simulation s(standing_soil(GetParam()));
  s.step(static_cast<std::int64_t>(6.0 / s.model.dt));
  EXPECT_LT(s.state.work.boundary, 1e-9);                  // a floor that stays does no work
  EXPECT_LT(kinetic_energy(points_by_id(s.state)), 0.01);  // of 24 J elastic
}

/// Under pure FLIP a sliding block rings, and a bilateral base rubs under pushes only: 10 % PIC keeps it quiet.
TEST_P(SlidingBlock, WithFrictionAcceleratesAsCoulombSays)
{
  for (const auto& [kind, degrees] : {std::pair{SideKind::contact_bilateral, 40.0},
           {SideKind::contact_separating, 40.0}, {SideKind::contact_bilateral, 15.0}}) {  // tan 15 degrees = 0.27: rest
    const Real t = degrees * std::numbers::pi / 180.0,
               expected = std::max(9.81 * (std::sin(t) - 0.4 * std::cos(t)), 0.0);
    Case c = block(GetParam(), kind, {9.81 * std::sin(t), -9.81 * std::cos(t)});
    c.sides[0].friction = 0.4;
    c.method.flip = 0.9;
    Simulation s(c);
    s.step(s.model.n_steps);
    EXPECT_NEAR(momentum(s.state)[0] / (mass * s.state.time), expected, std::max(0.01 * expected, 0.002)) << degrees;
  }
}

}  // namespace sliding_block_test
