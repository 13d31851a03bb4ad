#include "mpm/step/stored_energy.hpp"
#include "run/measure/followers.hpp"
#include "run/report/ledger.hpp"
#include "run/report/summary.hpp"
#include "support/simulations.hpp"

namespace water_energy_test {

constexpr Real gamma_w = 10.0e3;

/// A block of rock on a floor, in water of 3 m up to its left face at x = 4 m.
Case block_by_river(const char* drainage)
{
  Case c;
  c.name = "block";
  c.scheme = "mpm_gp";
  c.mesh.size = {16.0, 6.0};
  c.mesh.cell = {0.5, 0.5};
  c.materials = {elastic(2e6, 0.3, 2000.0)};
  c.materials[0].drainage = drainage == std::string("drained") ? Drainage::drained : Drainage::undrained;
  c.time.end = 1.0;
  c.bodies.push_back(body("rock", {4.0, 0.0}, {12.0, 4.0}));
  c.forces.gravity = {0.0, -9.81};
  c.water.unit_weight = gamma_w;
  c.water.start.phreatic_line = {{0.0, 3.0}, {4.0, 3.0}, {4.0, -1.0}};
  return c;
}

Simulation measured(const Case& c) { return Simulation(c, 1, all_followers()); }

TableRow row_of(Simulation& s) { return keep_ledger(s.model, s.state, s.work); }

TEST(WaterEnergy, FreeWaterGivesHalfItsDepthSquaredTimesTheWayOfAWall)
{
  Simulation s = measured(block_by_river("undrained"));
  row_of(s);
  draw_points(s, [](Vec<2> x) { return Vec<2>{x[0] + 2.0, x[1]}; });
  TableRow row = row_of(s);
  EXPECT_NEAR(row["water_supply"], 0.5 * gamma_w * 3.0 * 3.0 * 2.0, 1e-6);
  EXPECT_EQ(row["water_volume"], 0.0);
  draw_points(s, [](Vec<2> x) { return Vec<2>{x[0] + 2.0, 0.5 * x[1]}; });  // points keep their size: no change
  EXPECT_NEAR(row_of(s)["water_supply"], row["water_supply"], 1e-6);
  draw_points(s, [](Vec<2> x) { return Vec<2>{x[0] - 1.0, x[1]}; });
  EXPECT_NEAR(row_of(s)["water_supply"], -0.5 * gamma_w * 3.0 * 3.0, 1e-6);
}

TEST(WaterEnergy, SoilThatOpensTakesWaterAtItsPressure)
{
  for (const char* drainage : {"drained", "undrained"}) {
    Case c = block_by_river(drainage);
    c.water.start.phreatic_line = {{0.0, 3.0}};
    c.bodies[0] = body("rock", {0.0, 0.0}, {16.0, 4.0});
    Simulation s = measured(c);
    row_of(s);
    for_each_point(s.state.points, [](const PointBlock<2>& block, Index lane) {
      if (block.row(Rows::x + 1)[lane] < 1.0) block.row(Rows::volume)[lane] *= 1.02;
    });
    const bool takes = drainage == std::string("drained");
    EXPECT_NEAR(row_of(s)["water_volume"], takes ? 0.02 * gamma_w * 2.5 * 16.0 : 0.0, 1e-6);
  }
}

TEST(WaterEnergy, IsUnknownWhereGravityIsTurnedAndNoneWithoutWater)
{
  Case c = block_by_river("undrained");
  c.forces.gravity = {1.0, -9.81};
  Simulation turned = measured(c);
  EXPECT_TRUE(std::isnan(row_of(turned)["water_supply"]));
  c.water = {};
  Simulation dry = measured(c);
  EXPECT_EQ(row_of(dry)["water_supply"], 0.0);
}

TEST(WaterEnergy, WorkThatNoWaterGivesIsSeen)
{
  Simulation s = measured(block_by_river("undrained"));
  row_of(s);
  draw_points(s, [](Vec<2> x) { return Vec<2>{x[0] + 2.0, x[1]}; });
  const Real given = 0.5 * gamma_w * 3.0 * 3.0 * 2.0;
  s.state.work.outer[outer_water] = 1.25 * given;
  s.state.work.from_outside = 2.0 * given;
  s.state.step = 20;
  row_of(s);
  EXPECT_NEAR(summarise(s.model, s.state).numbers.at("water_from_nowhere"), 0.125, 1e-9);
}

}  // namespace water_energy_test
