#include <fmt/format.h>

#include "import/dstability/case_folder.hpp"
#include "import/dstability/read_stix.hpp"
#include "import/dstability/trigger.hpp"
#include "river_dike.hpp"
#include "model/water/water_pressure.hpp"
#include "support/paths.hpp"

namespace trigger_test {

StixProject dike() { return project_of({river_dike()}); }

constexpr RiverInStage river{.at_left = true, .ends = {-20.0, 40.0}, .level = 2.0, .inland = -1.0};

TEST(Trigger, TheRiverRisesToTheShoreAndHeadsInProportion)
{
  const StixStage stage = with_river_at(StixSection(dike(), 0, 0, StixBasis::deterministic), river, 3.2);
  const StixLine& phreatic = stage.water.head_lines[0].line;
  ASSERT_EQ(phreatic.size(), 4u);
  EXPECT_EQ(phreatic[0], (Vec<2>{-20.0, 3.2}));
  EXPECT_NEAR(phreatic[1][0], 2.4, 0.051);  // the slope is at 3.2 m there
  EXPECT_EQ(phreatic[1][1], 3.2);
  EXPECT_EQ(phreatic[2], (Vec<2>{16.0, -1.0}));
  const StixLine& aquifer = stage.water.head_lines[1].line;
  EXPECT_NEAR(aquifer[0][1], 1.0 + 1.2 * 2.0 / 3.0, 1e-12);  // 2 m over the land of -1 m, the river 3 m
  EXPECT_NEAR(aquifer[1][1], 0.5 + 1.2 * 1.5 / 3.0, 1e-12);
}

TEST(Trigger, ARiverAtTheRightRisesLikeItsMirrorImage)
{
  StixProject project = dike();
  StixStage& stage = project.scenarios[0].stages[0];
  const auto mirror = [](StixLine& line) {
    for (Vec<2>& x : line) x[0] = 20.0 - x[0];
    std::ranges::reverse(line);
  };
  for (StixLayer& layer : stage.layers) mirror(layer.outline);
  for (StixHeadLine& head : stage.water.head_lines) mirror(head.line);
  for (StixReferenceLine& line : stage.water.reference_lines) mirror(line.line);
  RiverInStage right = river;
  right.at_left = false;
  right.ends = {-20.0, 40.0};
  const StixStage raised = with_river_at(StixSection(project, 0, 0, StixBasis::deterministic), right, 3.2);
  const StixLine& phreatic = raised.water.head_lines[0].line;
  ASSERT_EQ(phreatic.size(), 4u);
  EXPECT_EQ(phreatic[3], (Vec<2>{40.0, 3.2}));
  EXPECT_NEAR(phreatic[2][0], 20.0 - 2.4, 0.051);
  EXPECT_EQ(phreatic[1], (Vec<2>{4.0, -1.0}));
}

TEST(Trigger, GroundThatWasDryStaysSo)
{
  StixProject project = dike();
  project.scenarios[0].stages[0].water.head_lines[0].line[2] = {14.0, 0.9};  // the slope is at 1 m there
  const StixStage stage = with_river_at(StixSection(project, 0, 0, StixBasis::deterministic), river, 3.5);
  EXPECT_NEAR(stage.water.head_lines[0].line[2][1], 1.0, 1e-9);
}

TEST(Trigger, GroundThatWasDryStaysSoBetweenPointsOfTheLine)
{
  StixProject project = dike();
  StixStage& stage = project.scenarios[0].stages[0];
  stage.layers[0].outline[4] = {14.0, 0.6};  // a dip of the inner slope above the line
  stage.layers[0].outline.insert(stage.layers[0].outline.begin() + 5, {16.0, 0.5});
  stage.water.head_lines[0].line = {{-20.0, 2.0}, {4.0, 2.0}, {15.0, 0.3}, {40.0, -1.0}};
  const StixLine line =
      with_river_at(StixSection(project, 0, 0, StixBasis::deterministic), river, 3.8).water.head_lines[0].line;
  for (const Real x : {14.0, 15.0, 16.0})
    EXPECT_LE(elevation_at(line, x), StixSection(project, 0, 0, StixBasis::deterministic).column(x).ground() + 1e-9)
        << x;
  EXPECT_GT(elevation_at(line, 20.0), elevation_at(stage.water.head_lines[0].line, 20.0));
}

TEST(Trigger, ARiverBelowTheLandThatRisesIsThatOfTheOtherWay)
{
  const StixProject project = dike();
  StixProject low = project;
  low.scenarios[0].stages[0] = with_river_at(StixSection(project, 0, 0, StixBasis::deterministic), river, -2.0);
  RiverInStage lowered = river;
  lowered.level = -2.0;
  const StixSection before(project, 0, 0, StixBasis::deterministic), after(low, 0, 0, StixBasis::deterministic);
  const StixLine direct = with_river_at(before, river, 3.0).water.head_lines[1].line;
  const StixLine there_and_back = with_river_at(after, lowered, 3.0).water.head_lines[1].line;
  for (std::size_t k = 0; k < direct.size(); ++k) EXPECT_NEAR(there_and_back[k][1], direct[k][1], 1e-12);
}

TEST(Trigger, WaterThatIsLevelDoesNotSayHowHeadsFollow)
{
  const StixProject project = dike();
  RiverInStage level = river;
  level.inland = 1.95;
  EXPECT_THAT(
      refusal<InputError>([&] { with_river_at(StixSection(project, 0, 0, StixBasis::deterministic), level, 3.0); }),
      HasSubstr(
          "daily: the river stands at 2.00 m, the phreatic line at the land's end at 1.95 m\n  From water that is "
          "level nobody can tell how the heads in the ground follow the river."));
}

TEST(Trigger, ARiverThatNoGroundHoldsIsRefused)
{
  EXPECT_EQ(
      refusal<InputError>([&] { with_river_at(StixSection(dike(), 0, 0, StixBasis::deterministic), river, 4.5); }),
      "daily: a river at 4.50 m would flood the whole section\n  Its highest ground is at 4.00 m. Give a lower level.");
}

TEST(Trigger, WaterOfAMeshIsRefused)
{
  StixProject project = dike();
  project.scenarios[0].stages[0].water.is_mesh = true;
  project.scenarios[0].stages[0].water.mesh = {
      {.corners = {{{-20.0, -10.0}, {40.0, -10.0}, {0.0, 4.0}}}, .pressure = {}}};
  EXPECT_THAT(
      refusal<InputError>([&] { with_river_at(StixSection(project, 0, 0, StixBasis::deterministic), river, 3.0); }),
      HasSubstr("its water is a mesh of pressures, in which no river can be moved"));
}

CaseFolder folder_with(const FolderTrigger& trigger, const StixProject& project = dike())
{
  return case_folder_of(project, {.kinds = kinds(), .trigger = trigger});
}

TEST(Trigger, OfWeakerSoilIsTheSmallestFactorThatFailedNotOneThatCrept)
{
  const FolderTrigger weaker = trigger_after({1.1, 1.12345, 1.12345});
  EXPECT_EQ(weaker.kind, TriggerKind::strength);
  EXPECT_DOUBLE_EQ(weaker.value, 1.1235);
  EXPECT_EQ(
      weaker.origin, "terp stability on these cells: it stands at a factor of 1.1, and fails at 1.1235 (stability/).");
  const FolderTrigger own = trigger_after({0.8, 0.9, 0.9});
  EXPECT_EQ(own.kind, TriggerKind::none);
  EXPECT_TRUE(own.needs_hold);
  for (const Real creeps : {0.9, 1.3}) {
    const FolderTrigger undecided = trigger_after({0.8, {}, creeps});
    EXPECT_EQ(undecided.kind, TriggerKind::none);
    EXPECT_FALSE(undecided.needs_hold);
    EXPECT_THAT(undecided.origin, HasSubstr(fmt::format("and is undecided up to {:g}, where it creeps", creeps)));
  }
  EXPECT_THAT(refusal<RunError>([] { trigger_after({1.0, {}, {}}); }), HasSubstr("--trigger strength=F"));
}

TEST(Trigger, OfWaterBringsTheRiverToTheCrestAndStrengthsFollowIt)
{
  const std::string text = folder_with({.kind = TriggerKind::water}).files.front().second;
  EXPECT_THAT(text, HasSubstr("water_level = 3.9"));  // 4 m less a fortieth of 4 m
  EXPECT_THAT(text, HasSubstr("# m: that of the trigger"));
  EXPECT_THAT(text, HasSubstr("\"material.clay_below.su_peak.shansep.water\" = \"raised_water\""));
  EXPECT_THAT(text, HasSubstr("water              = \"raised_water\""));
  EXPECT_THAT(folder_with({TriggerKind::water, 3.0}).files.front().second, HasSubstr("water_level = 3.0"));
}

TEST(Trigger, OfWaterNeedsARiverBelowTheCrest)
{
  const auto said = [](const FolderTrigger& trigger, const StixProject& project) {
    return refusal<InputError>([&] { folder_with(trigger, project); });
  };
  EXPECT_THAT(said({TriggerKind::water, 1.5}, dike()),
      HasSubstr("the river cannot be raised to 1.50 m\n  It stands at 2.00 m in this stage, the crest at 4.00 m."));
  EXPECT_THAT(said({TriggerKind::water, 4.5}, dike()), HasSubstr("the river cannot be raised to 4.50 m"));
  StixProject dry = dike();
  dry.scenarios[0].stages[0].water.head_lines[0].line = {{0.0, -2.0}};
  EXPECT_THAT(said({.kind = TriggerKind::water}, dry), HasSubstr("there is no river whose level could be changed"));
  StixProject polder = dike();  // the foreland is dry, and its water higher than that on the polder
  polder.scenarios[0].stages[0].water.head_lines[0].line = {{-20.0, -0.5}, {4.0, -0.5}, {16.0, -1.0}, {40.0, 0.2}};
  polder.scenarios[0].stages[0].layers[0].outline[0][1] = polder.scenarios[0].stages[0].layers[0].outline[1][1] = 1.0;
  polder.scenarios[0].stages[0].water.head_lines[0].line[0][1] = 0.6;
  EXPECT_THAT(said({.kind = TriggerKind::water}, polder),
      HasSubstr("the side of the river is in doubt: its level is not changed"));
  polder.scenarios[0].stages[0].embankment.top_water = 4.0;
  polder.scenarios[0].stages[0].embankment.top_land = 8.0;
  const std::string text = folder_with({.kind = TriggerKind::water}, polder).files.front().second;
  EXPECT_THAT(text, AllOf(ContainsRegex("river +=  *\"left\""), HasSubstr("water_level = 3.9")));
}

}  // namespace trigger_test
