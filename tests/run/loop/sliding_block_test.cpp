// Soil at rest on a contact base. A block that slides: cases/verification/sliding_block, tests/whole/incline_test.
#include "support/simulations.hpp"

namespace sliding_block_test {

class SlidingBlock : public TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Schemes, SlidingBlock, testing::Values("standard_mpm", "mpm_mixed", "mpm_gp"),
    [](const auto& info) { return std::string(info.param); });

/// A column of one cell's width between rollers, its weight carried from the start.
Case standing_soil(const char* scheme)
{
  Case c = free_box(scheme, {0.0, 0.0}, {0.1, 2.0}, elastic(1e6, 0.3, 2000.0));
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

}  // namespace sliding_block_test
