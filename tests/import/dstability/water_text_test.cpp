// Pressures by hand: gamma_w = 10 kN/m3.
#include "import/dstability/water_text.hpp"

#include "sections.hpp"

namespace water_text_test {

SectionLayout layout()
{
  return {.low = {0.0, -10.0}, .high = {20.0, 0.0}, .crest = {10.0, 0.0}, .top = 0.0, .height = 5.0, .cell = 0.5};
}

WaterText text_of(const StixStage& stage)
{
  return water_text({project_of({stage}), 0, 0, StixBasis::deterministic}, layout(), "water", false);
}

std::string value_of_key(const WaterText& text, const std::string& key) { return test::value_of_key(text.lines, key); }

StixStage with_phreatic(const StixLine& line)
{
  StixStage stage = clay_on_sand();
  stage.water.head_lines[0].line = line;
  return stage;
}

TEST(WaterText, IsThePhreaticLine)
{
  const WaterText text = text_of(clay_on_sand());
  EXPECT_EQ(value_of_key(text, "phreatic_line"), "[[0.0, -1.0], [20.0, -1.0]]");
  EXPECT_FALSE(text.on_grid);
  EXPECT_EQ(text.deviation, 0.0);
  EXPECT_EQ(text.phreatic.size(), 2u);
}

TEST(WaterText, SaysThatALineIsLevelBeyondItsEndsWhereItSlopesThere)
{
  EXPECT_EQ(value_of_key(text_of(with_phreatic({{2, -1}, {8, -2}})), "phreatic_line"),
      "[[0.0, -1.0], [2.0, -1.0], [8.0, -2.0], [20.0, -2.0]]");
  EXPECT_EQ(value_of_key(text_of(with_phreatic({{2, -1}, {8, -1}})), "phreatic_line"), "[[2.0, -1.0], [8.0, -1.0]]");
  EXPECT_EQ(value_of_key(text_of(with_phreatic({{5, -1}})), "phreatic_line"), "[[5.0, -1.0]]");
  EXPECT_EQ(
      value_of_key(text_of(with_phreatic({{-5, -1}, {30, -2}})), "phreatic_line"), "[[-5.0, -1.0], [30.0, -2.0]]");
}

TEST(WaterText, HasReferenceLinesWithAFirstOneWhereTheWaterBegins)
{
  StixStage stage = clay_on_sand();
  stage.water.head_lines.push_back({.id = "h", .label = "Aquifer", .line = {{0.0, 2.0}}});
  stage.water.reference_lines = {{.label = "r", .line = {{0.0, -6.0}}, .top_head = 1, .bottom_head = 1}};
  const WaterText text = text_of(stage);
  EXPECT_EQ(value_of_key(text, "head_lines"), "{ aquifer_2 = [[0.0, 2.0]] }");
  EXPECT_EQ(value_of_key(text, "reference_lines"),
      "[\n  { line = [[0.0, -1.0], [20.0, -1.0]], head = \"phreatic\" },\n"
      "  { line = [[0.0, -6.0]], head = \"aquifer_2\" }]");
  EXPECT_LT(text.deviation, 1.0);  // 80 kPa at -6 m, linear from 0 at -1 m
}

TEST(WaterText, IsAGridWhereALineRunsBack)
{
  const WaterText text = text_of(with_phreatic({{0, -1}, {12, -1}, {8, -3}, {20, -3}}));
  EXPECT_TRUE(text.on_grid);
  EXPECT_EQ(text.grid_file, "water.csv");
  EXPECT_THAT(text.grid, HasSubstr("\n2.0,-10.0,90000.0\n"));
  EXPECT_EQ(value_of_key(text, "pressure"), "{ csv = \"water.csv\" }");
}

TEST(WaterText, HasGridsThatKeepTheirPlacesFarFromTheOrigin)
{
  StixStage stage = with_phreatic({{155000.25, -1}, {155012, -1}, {155008, -3}, {155020.25, -3}});
  for (StixLayer& layer : stage.layers)
    for (Vec<2>& x : layer.outline) x[0] += 155000.25;
  SectionLayout far = layout();
  far.low[0] += 155000.25, far.high[0] += 155000.25, far.crest[0] += 155000.25;
  EXPECT_THAT(water_text({project_of({stage}), 0, 0, StixBasis::deterministic}, far, "water", false).grid,
      HasSubstr("\n155000.75,-9.75,87500.0\n"));
}

TEST(WaterText, OfADryStageIsEmptyAndBelowTheSectionBesideOthers)
{
  StixStage dry = clay_on_sand();
  dry.water.phreatic.reset();
  EXPECT_TRUE(text_of(dry).lines.empty());
  EXPECT_EQ(value_of_key(water_below(layout()), "phreatic_line"), "[[0.0, -11.0], [20.0, -11.0]]");
  EXPECT_TRUE(water_below(layout()).phreatic.empty());
}

}  // namespace water_text_test
