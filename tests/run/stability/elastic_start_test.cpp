#include "run/stability/elastic_start.hpp"
#include "math/errors.hpp"
#include "model/water/nodal_water.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "run/loop/simulation.hpp"
#include "support/cases.hpp"

namespace elastic_start_test {

/// Clay 4 m wide and 2 m high between smooth walls.
Case filled_box()
{
  Case c = free_box("mpm_gp", {0.0, 0.0}, {4.0, 2.0});
  c.bodies[0].points_per_cell = {2, 2};
  c.mesh.size = {4.0, 2.5};
  c.forces.gravity = {0.0, -10.0};
  c.sides = {side("left", SideKind::roller), side("right", SideKind::roller), side("bottom", SideKind::roller)};
  return c;
}

ElasticStart settle(const Case& c, Real stiffening = 1.0)
{
  return settle_elastically(c, std::make_shared<const Mesh<2>>(build_mesh(c)), stiffening, 1, std::atomic<bool>{false});
}

TEST(ElasticStart, ScalesAreThoseOfTheHandCalculation)
{
  const ElasticStart start = settle(filled_box());
  const Real height = 2.0 - 0.125;  // between the lowest and the highest points
  const Real shear = 2e6, young = 2.0 * shear * 1.48;
  EXPECT_NEAR(start.height, height, 1e-12);
  EXPECT_NEAR(start.traversal, height / std::sqrt(shear / 1990.0), 1e-12);
  EXPECT_NEAR(start.displacement, 1990.0 * 10.0 * height * height / young, 1e-9);
  EXPECT_NEAR(start.free_motion, 10.0 * std::pow(2.0 * start.traversal, 2), 1e-9);
  EXPECT_GT(start.steps, 10);
  EXPECT_EQ(start.rest.step, 0);
  EXPECT_NEAR(settle(filled_box(), 1e3).displacement, start.displacement, 1e-9) << "of the soil as it is";
}

TEST(ElasticStart, StrengthDoesNotLimitItsStresses)
{
  Case weak = filled_box();
  weak.materials[0].parameters[2] = weak.materials[0].parameters[3] = 1.0;  // S_u = 1 Pa
  EXPECT_EQ(settle(weak).steps, settle(filled_box()).steps);
}

TEST(ElasticStart, ContactPlanesThatHoldDoNotSlip)
{
  Case weak = filled_box();  // its base would slide out to the right
  weak.mesh.size = {6.0, 2.5};
  weak.sides.back() = side("bottom", SideKind::contact_separating);
  weak.sides.back().friction = 1e-3;
  Case strong = weak;
  strong.sides.back().adhesion = 1e9;
  EXPECT_EQ(settle(weak).steps, settle(strong).steps);
}

// On the border of two sub-cells they would take the strain of one and of the other, at each vibration.
TEST(ElasticStart, NoPointLiesOnTheBorderOfTwoSubCells)
{
  Case c = filled_box();
  c.bodies[0].points_per_cell = {5, 5};
  const ElasticStart start = settle(c);
  const std::atomic<bool> stop{false};
  const auto local =
      std::ranges::find(start.rest.arrays, std::string("points/local"), [](const NamedArray& a) { return a.name; });
  ASSERT_NE(local, start.rest.arrays.end());
  Real least = 1.0;
  for (const Real at : std::get<std::vector<Real>>(local->values)) least = std::min(least, std::abs(at));
  EXPECT_GT(least, 1e-7);
}

TEST(ElasticStart, NeedsGravity)
{
  Case c = filled_box();
  c.forces.gravity = {0.0, 0.0};
  EXPECT_THROW(settle(c), InputError);
}

TEST(QuietCase, NothingMovesButByItsWeight)
{
  Case c = filled_box();
  c.footings.resize(1);
  c.bodies[0].velocity = {1.0, 0.0};
  c.sides.push_back(side("top", SideKind::velocity));
  c.sides.back().velocity = {0.0, -1.0};
  const Case quiet = quiet_case(c);
  EXPECT_TRUE(quiet.footings.empty());
  EXPECT_EQ(quiet.bodies[0].velocity, (Vec<2>{0.0, 0.0}));
  EXPECT_EQ(quiet.method.shares, Shares::point) << "no point comes to another sub-cell";
  EXPECT_EQ(quiet.sides.back().velocity, (Vec<2>{0.0, 0.0}));
  c.bodies[0].velocity_at = c.sides.back().velocity_at = [](Vec<2> x) { return x; };
  const Case still = quiet_case(c);
  EXPECT_FALSE(still.bodies[0].velocity_at || still.sides.back().velocity_at) << "formulas";
}

/// A box with a river of three stages, the last of which names no water.
Case staged_box()
{
  Case c = filled_box();
  c.water.start.phreatic_line = {{0.0, 0.5}};
  c.water.situations = {
      {.name = "other", .phreatic_line = {{0.0, 1.0}}}, {.name = "flood", .phreatic_line = {{0.0, 3.0}}}};
  const auto changed = std::make_shared<const Case>(c);
  for (const char* water : {"other", "flood", ""}) {
    StageCase stage;
    stage.name = "stage " + std::to_string(c.stages.size()), stage.water = water, stage.changed = changed;
    c.stages.push_back(stage);
  }
  return c;
}

TEST(QuietCase, HasTheWaterAtTheEndOfTheLastStage)
{
  Case c = staged_box();
  EXPECT_EQ(quiet_case(c).water.standing, 2u) << "the last stage keeps what the one before it brought";
  EXPECT_EQ(first_water(quiet_case(c).water).name, "flood");
  EXPECT_EQ(quiet_case(c).water.situations.size(), 2u) << "strengths may name any of them";
  c.stages.clear();
  EXPECT_EQ(quiet_case(c).water.standing, 0u) << "without stages: that of the start";
}

TEST(QuietCase, ItsWaterStandsFromTheStartOn)
{
  const Case quiet = quiet_case(staged_box());
  Simulation s(quiet);
  const auto at_base = std::ranges::find(s.model.mesh->nodes, Vec<2>{0.0, 0.0}) - s.model.mesh->nodes.begin();
  for (const Real time : {0.0, 1e9})
    EXPECT_NEAR(water_at(s.model, time).pressure[static_cast<std::size_t>(at_base)], 9810.0 * 3.0, 1e-6);
}

TEST(QuietCase, IsOfTheStrengthThatTheCaseAsksFor)
{
  Case c = filled_box();
  c.at_strength = 1.6;
  const Case quiet = quiet_case(c);
  EXPECT_DOUBLE_EQ(quiet.materials[0].parameters[2], 8000.0 / 1.6);
  EXPECT_EQ(quiet.at_strength, 1.0);
}

}  // namespace elastic_start_test
