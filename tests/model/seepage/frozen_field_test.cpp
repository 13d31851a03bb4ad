// Water in soil that slid. Numbers of the slump: an independent computation of the same field on outlines, cells of
// 0.25 m: 236 kN/m on the slip base, head 3.79 m at the foot of the scarp.
#include "model/seepage/computed_water.hpp"
#include "model/seepage/frozen_field.hpp"
#include "math/interpolate.hpp"
#include "model/bodies/seed.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "mpm/mesh/locate.hpp"
#include "support/cases.hpp"

namespace frozen_field_test {

std::vector<WetPoint> points_of(const Mesh<2>& mesh, const Polygon& outline)
{
  std::vector<WetPoint> points;
  for (const Seed& seed : seed_points(mesh, std::vector<BodyOutline>{{outline, {4, 4}}}))
    points.push_back({seed.x, seed.cell, seed.volume, {1e-4, 1e-4}});
  return points;
}

TEST(FrozenField, StillWaterAroundAHeapStaysStill)
{
  const Mesh<2> mesh = make_rectangle({0.0, 0.0}, {20.0, 6.0}, {40, 12});
  const auto points = points_of(mesh, {{0.0, 0.0}, {20.0, 0.0}, {20.0, 1.0}, {12.0, 3.7}, {8.0, 3.7}, {0.0, 1.0}});
  const AboveSoil above{
      [](Real x) { return std::min(1.0 + std::min(x, 20.0 - x) * 2.7 / 8.0, 3.7); }, [](Real) { return 5.0; }};
  const std::vector<Real> heads = frozen_heads(mesh, points, above, {});
  int n = 0;
  for (const Real head : heads)
    if (!std::isnan(head)) {
      ++n;
      EXPECT_NEAR(head, 5.0, 1e-9);
    }
  EXPECT_GT(n, 200);
}

TEST(FrozenField, WetDebrisInTheAirOfADryColumnHasNoPressureAtItsTable)
{
  // Wet up to 2 m below dry soil up to 4 m: hydrostatic below its table, whatever lies above.
  const Mesh<2> mesh = make_rectangle({0.0, 0.0}, {10.0, 6.0}, {20, 12});
  const auto points = points_of(mesh, {{0.0, 0.0}, {10.0, 0.0}, {10.0, 2.0}, {0.0, 2.0}});
  const AboveSoil above{[](Real) { return 4.0; }, [](Real) { return -1e9; }};
  const std::vector<Real> heads = frozen_heads(mesh, points, above, {});
  for (std::size_t i = 0; i < heads.size(); ++i)
    if (mesh.nodes[i][1] < 1.9) {
      EXPECT_NEAR(heads[i], 2.0, 1e-5);
    }
}

TEST(FrozenField, ASlumpHasThePressureOfTheFlowThroughItsWetSoil)
{
  Case c;
  c.scheme = "mpm_gp";
  c.mesh.size = {70.0, 8.0}, c.mesh.cell = {0.5, 0.5};
  c.materials = {elastic(2e6, 0.3, 2000.0)};
  c.materials[0].permeability = {1e-4, 1e-4};
  c.bodies = {body("rock", {0.0, 0.0}, {70.0, 2.0})};
  c.bodies[0].polygon = {
      {0.0, 0.0}, {70.0, 0.0}, {70.0, 2.0}, {47.0, 2.0}, {32.0, 7.0}, {28.0, 7.0}, {13.0, 2.0}, {0.0, 2.0}};
  c.time.end = 1.0;
  c.water.kind = WaterKind::seepage;
  c.water.start.seepage.river = RiverCase{SectionSide::left, 6.0};
  const auto mesh = std::make_shared<const Mesh<2>>(build_mesh(c));
  const SeepageSection section = seepage_section(c, mesh);
  const ComputedWater water = compute_water(*mesh, section, c.water.start.seepage, {.band = 0.25}, "water");
  const std::vector<Vec<2>> before{{13.0, 2.0}, {28.0, 7.0}, {32.0, 7.0}, {47.0, 2.0}, {70.0, 2.0}},
      after{{13.0, 2.0}, {28.0, 7.0}, {32.0, 7.0}, {33.0, 4.2}, {36.0, 4.0}, {44.0, 3.9}, {56.0, 2.0}, {70.0, 2.0}};
  std::vector<WetPoint> points;
  for (const Seed& seed : seed_points(*mesh, std::vector<BodyOutline>{{c.bodies[0].polygon, {4, 4}}})) {
    if (seed.x[1] > interpolate(water.table, seed.x[0])) continue;
    WetPoint point{seed.x, seed.cell, seed.volume, {1e-4, 1e-4}};
    if (seed.x[0] > 33.0 && seed.x[0] < 47.0 && seed.x[1] > 2.0) {
      point.x[0] = 33.0 + (seed.x[0] - 33.0) * 23.0 / 14.0;
      const Real squeeze =
          (interpolate(after, point.x[0]) - 2.0) / std::max(interpolate(before, seed.x[0]) - 2.0, 1e-9);
      point.x[1] = 2.0 + (seed.x[1] - 2.0) * squeeze;
      point.volume *= 23.0 / 14.0 * squeeze;
      point.cell = locate(*mesh, point.x).cell;
    }
    points.push_back(point);
  }
  const AboveSoil above{
      [&](Real x) { return x < 13.0 ? 2.0 : interpolate(after, x); }, [](Real x) { return x < 25.0 ? 6.0 : -1e9; }};
  const std::vector<Real> heads = frozen_heads(*mesh, points, above, {});
  Real force = 0.0;
  for (int k = 0; k < 230; ++k) {
    const Real x = 33.05 + 0.1 * k;
    force += 0.1 * 9.81 * std::max(*head_at(*mesh, heads, {x, 2.0}) - 2.0, 0.0);
  }
  EXPECT_NEAR(force, 236.0, 0.03 * 236.0);
  EXPECT_NEAR(*head_at(*mesh, heads, {33.05, 2.0}), 3.79, 0.1);
}

}  // namespace frozen_field_test
