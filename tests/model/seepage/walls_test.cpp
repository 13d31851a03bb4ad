#include "model/seepage/computed_water.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "support/cases.hpp"

namespace walls_test {

/// A layer of 20 m below lakes of 31 and 21 m, parted by a sheet pile of a depth.
Case sheet_pile(Real depth, Real cell)
{
  Case c;
  c.name = "sheet pile";
  c.scheme = "mpm_gp";
  c.mesh.size = {160.0, 22.5};
  c.mesh.cell = {cell, cell};
  c.materials = {elastic(2e6, 0.3, 2000.0)};
  c.materials[0].permeability = {1e-5, 1e-5};
  c.bodies = {body("rock", {0.0, 0.0}, {160.0, 20.0})};
  c.time.end = 1.0;
  c.forces.gravity = {0.0, -9.81};
  c.water.kind = WaterKind::seepage;
  c.water.walls = {{"pile", {{80.0, 22.5}, {80.0, 20.0 - depth}}}};
  c.water.start.seepage.ponds = {{"river", 0.0, 80.0, 31.0}, {"pit", 80.0, 160.0, 21.0}};
  return c;
}

SharedMesh mesh_of(const Case& c) { return std::make_shared<const Mesh<2>>(build_mesh(c)); }

ComputedWater water_of(const Case& c, const SeepageSection& section)
{
  return compute_water(*section.walled.mesh, section, c.water.start.seepage, {.band = 0.5}, "water");
}

TEST(Walls, LetThroughBelowTheirTipWhatTheExactSolutionSays)
{
  // q/(k h) = K'/(2 K) of the modulus sin(pi s/2 T): 0.5 at s/T = 0.5, 0.34032 at 0.75.
  for (const auto& [depth, exact, bound] : {std::array{10.0, 5.0e-5, 0.03}, {15.0, 3.4032e-5, 0.03}})
    for (const Real cell : {1.25, 0.625}) {
      const Case c = sheet_pile(depth, cell);
      const SeepageSection section = seepage_section(c, mesh_of(c));
      const ComputedWater water = water_of(c, section);
      EXPECT_NEAR(-water.flow.outflow[1], exact, bound * exact * cell / 1.25) << depth << ' ' << cell;
      EXPECT_NEAR(water.flow.outflow[2], exact, bound * exact * cell / 1.25) << depth << ' ' << cell;
      EXPECT_NEAR(*head_at(*section.walled.mesh, water.flow.heads, {80.0, 0.5 * (20.0 - depth)}), 26.0, 0.01);
      const Real before = *head_at(*section.walled.mesh, water.flow.heads, {79.999, 18.0}),
                 behind = *head_at(*section.walled.mesh, water.flow.heads, {80.001, 18.0});
      EXPECT_GT(before - behind, 7.0);
    }
}

TEST(Walls, HaveTheMeanHeadOfBothSidesAtTheirNodesInASituation)
{
  const Case c = sheet_pile(10.0, 1.25);
  const SeepageSection section = seepage_section(c, mesh_of(c));
  const ComputedWater water = water_of(c, section);
  WaterSituation situation;
  set_computed(situation, section, water);
  for (const Real y : {10.0, 11.25, 17.5, 20.0}) EXPECT_NEAR(situation.formula({80.0, y}, 0.0), 26.0, 1e-6) << y;
  EXPECT_GT(situation.formula({79.0, 17.5}, 0.0), 29.0);
  EXPECT_LT(situation.formula({81.0, 17.5}, 0.0), 23.0);
}

TEST(Walls, ThatEndAtTheGroundOrAnywhereAboveItDoNotLeakThroughTheEmptyCellsThere)
{
  Case c = sheet_pile(10.0, 1.25);
  const Real outflow = water_of(c, seepage_section(c, mesh_of(c))).flow.outflow[2];
  for (const Real top : {20.0, 21.0}) {
    c.water.walls[0].line[0][1] = top;
    EXPECT_DOUBLE_EQ(water_of(c, seepage_section(c, mesh_of(c))).flow.outflow[2], outflow) << top;
  }
}

TEST(Walls, EndARiver)
{
  Case c = sheet_pile(10.0, 1.25);
  c.water.walls[0].line[0][1] = 31.0;
  const Real by_ponds = water_of(c, seepage_section(c, mesh_of(c))).flow.outflow[2];
  c.water.start.seepage.river = RiverCase{SectionSide::left, 31.0};
  c.water.start.seepage.ponds.erase(c.water.start.seepage.ponds.begin());
  EXPECT_DOUBLE_EQ(water_of(c, seepage_section(c, mesh_of(c))).flow.outflow[2], by_ponds);
  c.water.walls[0].line[0][1] = 30.9;  // the river flows over it, into the pit
  EXPECT_THROW(water_of(c, seepage_section(c, mesh_of(c))), InputError);
}

TEST(Walls, ThatCloseALayerLetNothingThrough)
{
  Case c = sheet_pile(20.0, 1.25);
  c.materials[0].permeability = {1e-4, 1e-4};
  c.water.walls[0].line[0][1] = 31.0;
  const SeepageSection section = seepage_section(c, mesh_of(c));
  const ComputedWater water = water_of(c, section);
  EXPECT_NEAR(water.flow.outflow[1], 0.0, 1e-14);
  EXPECT_NEAR(*head_at(*section.walled.mesh, water.flow.heads, {79.0, 5.0}), 31.0, 1e-9);
  EXPECT_NEAR(*head_at(*section.walled.mesh, water.flow.heads, {81.0, 5.0}), 21.0, 1e-9);
}

TEST(Walls, MayBendAndMeet)
{
  Case c = sheet_pile(10.0, 1.25);
  c.water.walls.push_back({"floor", {{60.0, 10.0}, {80.0, 10.0}, {100.0, 10.0}}});
  const SeepageSection section = seepage_section(c, mesh_of(c));
  const Real longer = -water_of(c, section).flow.outflow[1];
  // The way under the floor alone is 40 m long and 10 m high.
  EXPECT_LT(longer, 1e-5 * 10.0 * 10.0 / 40.0);
  EXPECT_GT(longer, 0.5 * 1e-5 * 10.0 * 10.0 / 40.0);
}

TEST(Walls, MustRunAlongSidesOfCells)
{
  const auto problem_of = [](std::vector<Vec<2>> line) {
    Case c = sheet_pile(10.0, 1.25);
    c.water.walls[0].line = std::move(line);
    try {
      seepage_section(c, mesh_of(c));
    } catch (const InputError& error) {
      return error.problems()[0].key + ": " + error.problems()[0].detail;
    }
    return std::string();
  };
  EXPECT_THAT(problem_of({{80.0, 22.5}, {80.0, 9.5}}), HasSubstr("water.walls[0]: It leaves them at (80, 9."));
  EXPECT_THAT(problem_of({{80.3, 22.5}, {80.3, 10.0}}), HasSubstr("the nearest node lies at (80, 20) m"));
  EXPECT_THAT(problem_of({{80.0, 22.5}, {81.25, 10.0}}), HasSubstr("It leaves them"));
  EXPECT_THAT(problem_of({{180.0, 22.5}, {180.0, 10.0}}), HasSubstr("It leaves them"));
  EXPECT_EQ(problem_of({{80.0, 30.0}, {80.0, 10.0}}), "");  // beyond the mesh there is no soil
}

}  // namespace walls_test
