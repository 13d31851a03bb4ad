#include "import/dstability/stage_text.hpp"
#include "support/test.hpp"

namespace stage_text_test {

std::string lines_of(const CaseTableText& table)
{
  std::string text = table.header;
  for (const CaseLine& line : table.lines) text += "; " + line.key + " = " + line.value;
  return text;
}

TEST(StageText, OfOneStageThereAreNoneUnlessItIsHeld)
{
  EXPECT_TRUE(stage_tables({.analysed = "Stage 1"}).empty());
  const auto held = stage_tables({.analysed = "Stage 1", .is_held = true});
  ASSERT_EQ(held.size(), 2u);
  EXPECT_EQ(lines_of(held[0]),
      "[[stage]]; name = \"rise\"; duration = 12.0; set = { \"forces.damping.local\" = 0.5, at_strength = 0.5 }");
  EXPECT_EQ(lines_of(held[1]),
      "[[stage]]; name = \"release\"; ramp = 12.0; until = \"at_rest\"; at_most = 42.0; set = { "
      "\"forces.damping.local\" = 0.05, at_strength = 1.0 }; reset_displacement = true");
}

TEST(StageText, OfSoilThatIsHeldLetsTheRiverRiseBeforeTheRelease)
{
  const StagePlan plan{.first = "Daily",
      .analysed = "High",
      .water = "high",
      .sets = {"\"load.q.pressure\" = 5000"},
      .is_held = true,
      .has_flood = true};
  const auto tables = stage_tables(plan);
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_EQ(lines_of(tables[0]),
      "[[stage]]; name = \"rise\"; water = \"high\"; ramp = 8.0; duration = 12.0; set = { \"forces.damping.local\" = "
      "0.5, at_strength = 0.5, \"load.q.pressure\" = 5000 }");
  EXPECT_THAT(lines_of(tables[1]), HasSubstr("; ramp = 12.0; until = \"verdict\"; at_most = 42.0; set"));
  StagePlan triggered = plan;
  triggered.trigger = {.name = "weaker_soil", .sets = {"at_strength = 1.2"}};
  EXPECT_THAT(lines_of(stage_tables(triggered)[1]), HasSubstr("until = \"at_rest\"")) << "the verdict ends the last";
}

TEST(StageText, GoesFromTheFirstStageToTheAnalysedOne)
{
  const auto tables =
      stage_tables({.first = "Daily", .analysed = "Daily", .water = "high", .sets = {"\"load.q.pressure\" = 5000"}});
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_EQ(lines_of(tables[0]),
      "[[stage]]; name = \"daily\"; until = \"at_rest\"; at_most = 20.0; set = { \"forces.damping.local\" = 0.5 }");
  EXPECT_EQ(lines_of(tables[1]),
      "[[stage]]; name = \"daily_2\"; water = \"high\"; ramp = 10.0; until = \"at_rest\"; at_most = 30.0; set = { "
      "\"forces.damping.local\" = 0.05, \"load.q.pressure\" = 5000 }; reset_displacement = true");
}

TEST(StageText, NoTwoStagesHaveOneNameWhateverTheFileCallsThem)
{
  const TriggerStage weaker{.name = "weaker_soil", .sets = {"at_strength = 1.2"}};
  const auto one = stage_tables({.analysed = "Held", .is_held = true, .trigger = {.name = "release"}});
  const auto two = stage_tables({.first = "Weaker soil", .analysed = "Weaker soil 2", .trigger = weaker});
  const auto three = stage_tables({.first = "Weaker soil", .analysed = "Weaker soil", .trigger = weaker});
  const auto names_in = [](const std::vector<CaseTableText>& tables) {
    std::vector<std::string> names;
    for (const CaseTableText& table : tables) names.push_back(table.lines[0].value);
    return names;
  };
  const auto signs = stage_tables({.first = "River at 2.00 m", .analysed = "River at -2.00 m"});
  const auto odd = stage_tables({.first = "砂", .analysed = "γ"});
  EXPECT_THAT(names_in(signs), testing::ElementsAre("\"river_at_2_00_m\"", "\"river_at_minus_2_00_m\""));
  EXPECT_THAT(names_in(odd), testing::ElementsAre("\"stage\"", "\"stage_2\""));
  EXPECT_THAT(names_in(one), testing::ElementsAre("\"rise\"", "\"release\"", "\"release_2\""));
  EXPECT_THAT(names_in(two), testing::ElementsAre("\"weaker_soil\"", "\"weaker_soil_2\"", "\"weaker_soil_3\""));
  EXPECT_THAT(names_in(three), testing::ElementsAre("\"weaker_soil\"", "\"weaker_soil_2\"", "\"weaker_soil_3\""));
}

TEST(StageText, ATriggerIsTheLastStage)
{
  const auto tables =
      stage_tables({.analysed = "Stage 1", .trigger = {.name = "weaker_soil", .sets = {"at_strength = 1.2"}}});
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_EQ(lines_of(tables[0]), "[[stage]]; name = \"stage_1\"; until = \"at_rest\"; at_most = 30.0");
  EXPECT_EQ(lines_of(tables[1]),
      "[[stage]]; name = \"weaker_soil\"; trigger = true; until = \"at_rest\"; at_most = 30.0; set = { at_strength = "
      "1.2 }; reset_displacement = true");
  const auto water =
      stage_tables({.analysed = "Stage 1", .trigger = {.name = "raised_river", .water = "raised_water"}});
  EXPECT_THAT(lines_of(water[1]), HasSubstr("trigger = true; water = \"raised_water\"; ramp = 10.0; until"));
}

}  // namespace stage_text_test
