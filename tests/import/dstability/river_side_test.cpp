#include "import/dstability/case_folder.hpp"
#include "import/dstability/river_side.hpp"
#include "import/dstability/sections.hpp"

namespace river_side_test {

/// A dike with its crest of 4 m from x = 4 to 8 m; ground of 1 m at the left end, of 0 m at the right one.
StixProject dike(const StixLine& phreatic, std::array<Real, 2> tops = {not_given, not_given})
{
  StixStage stage = clay_on_sand();
  stage.layers[0].outline = {
      {-20.0, 1.0}, {-2.0, 1.0}, {4.0, 4.0}, {8.0, 4.0}, {16.0, 0.0}, {40.0, 0.0}, {40.0, -6.0}, {-20.0, -6.0}};
  stage.layers[1] = box_layer("sand", {-20.0, -10.0}, {40.0, -6.0}, 0);
  stage.water.head_lines[0].line = phreatic;
  stage.embankment.top_water = tops[0], stage.embankment.top_land = tops[1];
  return project_of({stage});
}

StixRiver river_of(const StixProject& project)
{
  return find_river(StixSection(project, 0, 0, StixBasis::deterministic), {-20.0, 40.0});
}

std::string text_of(const StixProject& project, std::size_t file = 0)
{
  const CaseFolder folder = case_folder_of(project, {.kinds = kinds()});
  return file == 0 ? folder.files.front().second : folder.files.back().second;
}

const StixLine dry_foreland{{-20.0, 0.6}, {4.0, 0.6}, {16.0, 0.0}, {20.0, 0.1}, {40.0, 0.1}};
const StixLine level{{-20.0, 2.0}, {40.0, 2.0}};

TEST(RiverSide, IsTheWaterSideThatTheFileNamesThoughWaterStandsInThePolder)
{
  const StixRiver river = river_of(dike(dry_foreland, {4.0, 8.0}));
  EXPECT_EQ(river.side, "left");
  EXPECT_EQ(river.doubt.en, "");
  const std::string report = text_of(dike(dry_foreland, {4.0, 8.0}), 1);
  EXPECT_THAT(
      report, HasSubstr("No water stands on the ground at the river's end (left) of the section: the case has no"));
  EXPECT_EQ(river_of(dike(level, {8.0, 4.0})).side, "right");  // named: no tie
  EXPECT_EQ(river_of(dike(level, {8.0, 4.0})).doubt.en, "");
}

TEST(RiverSide, IsInDoubtWhereTheFileAndTheWaterContradict)
{
  const StixRiver river = river_of(dike({{-20.0, 2.0}, {4.0, 2.0}, {16.0, 0.0}, {40.0, -1.0}}, {8.0, 4.0}));
  EXPECT_EQ(river.side, "right");
  EXPECT_EQ(river.doubt.en,
      "The file has its embankment's water side at the right end, but water stands on the ground at the left end, and "
      "higher: 2.00 m, not -1.00 m. The river is taken to be at the right end.");
}

TEST(RiverSide, IsInDoubtWhereThePointsOfTheEmbankmentContradictOrLieOutside)
{
  StixProject project = dike(level, {4.0, 8.0});
  StixEmbankment& at = project.scenarios[0].stages[0].embankment;
  at.toe_water = -2.0, at.toe_land = 16.0;
  EXPECT_EQ(river_of(project).doubt.en, "");
  std::swap(at.toe_water, at.toe_land);
  EXPECT_EQ(river_of(project).side, "left");
  EXPECT_EQ(river_of(project).doubt.en,
      "The file has the top of its embankment's water side at the left end, but its toe at the right end. The river is "
      "taken to be at the left end.");
  at.toe_water = at.toe_land = not_given, at.top_land = 140.0;
  EXPECT_EQ(river_of(project).doubt.en,
      "The file has a point of its embankment at x = 140.00 m, outside of the section (-20.00 to 40.00 m). The river "
      "is taken to be at the left end.");
}

TEST(RiverSide, WithoutASideInTheFileIsThatOfTheHigherPhreaticLine)
{
  EXPECT_EQ(river_of(dike({{-20.0, 2.0}, {4.0, 2.0}, {16.0, 0.0}, {40.0, -1.0}})).side, "left");
  const StixRiver doubtful = river_of(dike(dry_foreland));
  EXPECT_EQ(doubtful.side, "left");
  EXPECT_THAT(
      doubtful.doubt.en, testing::StartsWith("The phreatic line is higher at the left end (0.60 m, below the ground)"));
  EXPECT_THAT(text_of(dike(dry_foreland)), testing::Not(HasSubstr("\n[flood]\n")));
  EXPECT_EQ(river_of(dike({{-20.0, 0.5}, {40.0, 0.5}})).side, "right");  // level water, ground that is not
  EXPECT_EQ(river_of(dike({{-20.0, -2.0}, {40.0, -3.0}})).side, "");     // no river
}

TEST(RiverSide, IsNotInHighLandThoughItsWaterIsHigher)
{
  StixProject slope = dike({{-20.0, 3.0}, {8.0, 3.0}, {16.0, 1.0}, {40.0, 1.0}});
  StixLine& outline = slope.scenarios[0].stages[0].layers[0].outline;
  outline[0][1] = outline[1][1] = 3.9;  // as high as the crest
  const StixRiver river = river_of(slope);
  EXPECT_EQ(river.side, "right");
  EXPECT_EQ(river.doubt.en, "");
  EXPECT_THAT(text_of(slope), HasSubstr("water_level = 1.0"));
  outline[0][1] = outline[1][1] = 3.2;
  EXPECT_NE(river_of(slope).doubt.en, "");
}

TEST(RiverSide, OfTwoEqualWatersIsNotKnown)
{
  const StixRiver river = river_of(dike(level));
  EXPECT_EQ(river.side, "");
  EXPECT_THAT(
      river.doubt.en, testing::StartsWith("Water stands equally high on the ground at both ends of the section (2.00"));
  EXPECT_THAT(text_of(dike(level)), AllOf(HasSubstr("water_level = 2.0"), testing::Not(ContainsRegex("\nriver +="))));
}

TEST(RiverSide, ARiverAboveTheCrestKeepsItsLevel)
{
  const StixProject project = dike({{-20.0, 4.6}, {4.0, 4.6}, {16.0, 0.0}, {40.0, -1.0}});
  EXPECT_THAT(text_of(project), HasSubstr("water_level = 4.6"));
  EXPECT_THAT(text_of(project, 1),
      HasSubstr("The river of this stage (4.60 m) stands above the crest (4.00 m): it floods without any slide."));
}

}  // namespace river_side_test
