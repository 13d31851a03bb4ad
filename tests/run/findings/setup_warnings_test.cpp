#include "run/findings/setup_warnings.hpp"
#include "model/parts/setup.hpp"
#include "support/cases.hpp"
#include "support/paths.hpp"
#include "support/problems.hpp"

namespace setup_warnings_test {

std::vector<Problem> warnings_of(Case c)
{
  c.forces.gravity = {0.0, -9.81};  // without it nothing would move, which is a warning of its own
  Model model = build_model(c, 1);
  return find_warnings(model, build_state(model));
}

TEST(SetupWarnings, ABodyUnderLaterOnesIsTold)
{
  Case c = free_box("mpm_gp", {1.0, 0.5}, {2.0, 1.0});
  c.materials.push_back(elastic(2e6, 0.3, 2500.0));
  c.bodies.push_back(body("rock", {1.5, 0.5}, {2.0, 1.0}));
  EXPECT_TRUE(warnings_of(c).empty());
  c.bodies[1].polygon = {{0.75, 0.5}, {2.5, 0.5}, {2.5, 1.0}, {0.75, 1.0}};
  EXPECT_THAT(warnings_of(c), ElementsAre(told("body[0]", "body 0 of `clay` has no material points")));
}

TEST(SetupWarnings, AFaceOfFewCellsThatIsDugAwayIsTold)
{
  const auto told_of = [](Real height, bool has_soil_beside) {
    Case c = free_box("mpm_gp", {1.0, 0.5}, {2.0, 0.5 + height});  // cells of 0.25 m
    c.bodies[0].removed = 2;
    if (has_soil_beside) c.bodies.push_back(body("clay", {2.0, 0.5}, {3.0, 0.5 + height}));
    return warnings_of(c);
  };
  EXPECT_THAT(told_of(1.0, true), ElementsAre(told("body[0]",
                                      "body 0 is dug away over 4 cells of height, which hold up a face that soil does "
                                      "not: what becomes of the face "
                                      "itself needs cells of at most 0.2 m (docs/stages.md#bodies-that-come-and-go)",
                                      "")));
  EXPECT_TRUE(told_of(1.25, true).empty()) << "five cells";
  EXPECT_TRUE(told_of(1.0, false).empty()) << "no soil beside it: no face";
}

TEST(SetupWarnings, FramesThatDoNotSayWhereThereIsSoilAreTold)
{
  Case c = free_box("mpm_gp", {1.0, 0.5}, {2.0, 1.0});
  c.output.field_names = {"stress"};
  EXPECT_TRUE(warnings_of(c).empty()) << "no soil comes or goes";
  const auto is_told = ElementsAre(told("output.fields.names", "the frames do not say of which points there is soil"));
  Case dug = c, open = c;
  dug.bodies[0].removed = 2;
  EXPECT_THAT(warnings_of(dug), is_told);
  open.sides.push_back(side("right", SideKind::open));
  EXPECT_THAT(warnings_of(open), is_told);
  for (const char* name : {"material", "cell", "volume"}) {
    dug.output.field_names = {"stress", name};
    EXPECT_TRUE(warnings_of(dug).empty()) << name;
  }
}

TEST(SetupWarnings, PointsOfAFileWithHardlyAnyVolumeAreTold)
{
  const ScratchFolder folder;
  Case c = free_box("mpm_gp", {1.0, 0.5}, {2.0, 1.0});  // cells of 0.25 m
  c.folder = folder.path();
  c.bodies.emplace_back().points_file = "points.csv";
  std::ofstream(folder.path() + "/points.csv") << "x,y,volume,material\n3.1,1.1,0.008,clay\n3.2,1.1,0.008,clay\n";
  EXPECT_TRUE(warnings_of(c).empty());
  std::ofstream(folder.path() + "/points.csv") << "x,y,volume,material\n3.1,1.1,0.008,clay\n3.2,1.1,0.007,clay\n";
  const auto warnings = warnings_of(c);
  EXPECT_THAT(
      warnings, ElementsAre(told("body[1].points", _, StartsWith("Their volumes fill 24 % of the fullest cell;"))));
}

TEST(SetupWarnings, WaterThatTouchesNoSoilIsTold)
{
  Case c = free_box("mpm_gp", {1.0, 0.5}, {2.0, 1.0});
  c.water.start.phreatic_line = {{0.0, 0.75}};
  EXPECT_TRUE(warnings_of(c).empty());
  c.water.start.phreatic_line = {{0.0, 0.5}};
  EXPECT_THAT(warnings_of(c), ElementsAre(told("water", "the water touches no soil")));
}

TEST(SetupWarnings, WhereThePorePressureIsCutIsTold)
{
  Case c = free_box("mpm_gp", {1.0, 0.5}, {2.0, 1.0});  // clay, 1990 kg/m^3: 9.76 kPa at its base
  c.water.start.phreatic_line = {{0.0, 1.0}};
  c.water.start.head_lines = {{"aquifer", {{0.0, 3.0}}}};
  c.water.start.reference_lines = {{{{0.0, 0.6}}, "aquifer", "aquifer"}};
  EXPECT_THAT(warnings_of(c),
      ElementsAre(told("water", "the pore pressure was cut at 5 of 15 nodes",
          StartsWith(
              "It was up to 14.8 kPa more than the weight of the soil and the water above, most at (1, 0.5) m"))));
}

TEST(SetupWarnings, ASideThatMovesMoreThanACellIsTold)
{
  Case c = column("mpm_gp");  // cells of 0.5 m
  c.time.end = 2.0;
  c.sides = {side("left", SideKind::velocity)};
  c.sides[0].velocity = {0.24, 0.0};
  EXPECT_TRUE(warnings_of(c).empty());
  c.sides[0].velocity = {0.3, 0.0};
  EXPECT_THAT(warnings_of(c),
      ElementsAre(told("boundary.\"left\".velocity", "the side stays in place: it pushes soil over one cell at most",
          StartsWith("Its velocity times time.end is 0.6 m, the smallest cell is 0.5 m high."))));
}

TEST(SetupWarnings, AMeanOfTheForceOverLessThanAStepIsTold)
{
  Case c = free_box("mpm_gp", {1.0, 0.5}, {2.0, 1.0});
  c.forces.gravity = {0.0, -9.81};
  c.forces.local_damping = 0.1;
  c.forces.averaging_time = 1e-9;
  Model model = build_model(c, 1);
  EXPECT_THAT(find_warnings(model, build_state(model)),
      Contains(told("forces.damping.averaging_time", "the averaging time is not longer than a time step",
          StartsWith("Got 1e-09 s; the step is "))));
  c.forces.averaging_time = 10.0 * model.dt;
  model = build_model(c, 1);
  EXPECT_THAT(find_warnings(model, build_state(model)), IsEmpty());
}

TEST(SetupWarnings, SharesOfBodiesAddUp)
{
  Case c = free_box("mpm_gp", {1.0, 0.5}, {2.0, 1.0});
  c.materials.push_back(elastic(2e6, 0.3, 2500.0));
  c.bodies.push_back(body("rock", {1.5, 0.5}, {2.0, 1.0}));
  Model model = build_model(c, 1);
  build_state(model);
  ASSERT_EQ(model.bodies.size(), 2u);
  EXPECT_EQ(model.bodies[0].n_points, 4 * 25);
  EXPECT_NEAR(model.bodies[0].area, 0.25, 1e-12);
  EXPECT_EQ(model.bodies[1].material, "rock");
  EXPECT_NEAR(model.bodies[1].mass, 0.25 * 2500.0, 1e-9);
}

}  // namespace setup_warnings_test
