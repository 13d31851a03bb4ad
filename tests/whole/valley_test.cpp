// Soil in a valley between two banks: the sides of an oblique corner carry it and give no energy (decision 0038).
#include "support/verification.hpp"

namespace valley_test {

/// Banks of 30 degrees that meet at the origin, cells of 0.25 m along them.
Mesh<2> valley()
{
  Mesh<2> mesh = make_rectangle({-2.0, 0.0}, {4.0, 1.5}, {16, 6});
  for (Vec<2>& x : mesh.nodes) x[1] += 0.5774 * std::abs(x[0]);
  NamedSide west{"west", {}}, east{"east", {}};
  for (Index cell = 0; cell < 16; ++cell) (cell < 8 ? west : east).edges.push_back({cell, 0});
  mesh.sides.push_back(west);
  mesh.sides.push_back(east);
  return reconnected(mesh);
}

/// Elastic soil 1 m high on banks without friction, under its weight at once.
Simulation soil_between(SideKind west, SideKind east, const char* scheme)
{
  Case c = free_box(scheme, {-2.0, 0.0}, {2.0, 1.0}, elastic(2.0e6, 0.3, 2000.0));
  c.bodies[0].polygon = {{-2.0, 1.1548}, {0.0, 0.0}, {2.0, 1.1548}, {2.0, 2.1548}, {0.0, 1.0}, {-2.0, 2.1548}};
  c.mesh.origin = {-2.0, 0.0};
  c.mesh.size = {4.0, 3.0};
  c.forces.gravity = {0.0, -9.81};
  c.forces.local_damping = 0.3;
  c.sides = {side("west", west), side("east", east)};
  return simulate_on(valley(), c);
}

class Valley : public TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Schemes, Valley, testing::Values("standard_mpm", "mpm_mixed", "mpm_gp"),
    [](const auto& info) { return std::string(info.param); });

TEST_P(Valley, HoldsSoilAndDoesNoWorkOnIt)
{
  for (const auto& [west, east] : {std::pair{SideKind::contact_separating, SideKind::contact_separating},
           std::pair{SideKind::roller, SideKind::contact_separating},
           std::pair{SideKind::contact_separating, SideKind::roller}}) {
    auto s = soil_between(west, east, GetParam());
    s.step(static_cast<std::int64_t>(2.0 / s.model.dt));
    EXPECT_LT(s.state.work.boundary, 1e-6 * s.state.work.gravity);
    EXPECT_GT(s.state.work.gravity, 0.0);  // it settles
    Real mean = 0.0, largest = 0.0;
    const auto points = points_by_id(s.state);
    for (const auto& p : points)
      mean += p.v[0] / static_cast<Real>(points.size()), largest = std::max(largest, std::hypot(p.v[0], p.v[1]));
    EXPECT_LT(std::abs(mean), 1e-3);
    EXPECT_LT(largest, 0.05);  // m/s
  }
}

}  // namespace valley_test
