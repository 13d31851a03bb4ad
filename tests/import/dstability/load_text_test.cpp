#include "import/dstability/load_text.hpp"

#include "sections.hpp"

namespace load_text_test {

const SectionLayout layout{.low = {0.0, -10.0}, .high = {20.0, 0.0}};

StixStage loaded()
{
  StixStage stage = clay_on_sand();
  stage.loads = {{.label = "Traffic", .start = -4.0, .end = 4.0, .magnitude = 13e3, .spread = 30.0}};
  return stage;
}

TEST(LoadText, OfTheOnlyStageIsThereFromTheStart)
{
  const LoadTexts texts = load_texts(loaded(), nullptr, layout);
  ASSERT_EQ(texts.tables.size(), 1u);
  EXPECT_EQ(texts.tables[0].lines[0].value, "\"traffic\"");
  EXPECT_EQ(texts.tables[0].lines[1].value, "0.0") << "its part in the section";
  EXPECT_EQ(texts.tables[0].lines[3].value, "\"13 kPa\"");
  EXPECT_THAT(texts.sets, IsEmpty());
  EXPECT_THAT(in_english(texts.assumed),
      ElementsAre("Load traffic: its spread of 30 degrees is not set; the run computes how it "
                  "spreads."));
}

TEST(LoadText, ThatTheFirstStageDoesNotHaveIsPutOnInTheLast)
{
  const StixStage first = clay_on_sand(), same = loaded();
  EXPECT_THAT(load_texts(loaded(), &first, layout).sets, ElementsAre("\"load.traffic.pressure\" = 13000"));
  EXPECT_THAT(load_texts(loaded(), &same, layout).sets, IsEmpty());
}

TEST(LoadText, HasANameOfItsOwnWhateverTheFileCallsIt)
{
  StixStage stage = loaded();
  stage.loads.resize(4, stage.loads[0]);
  for (std::size_t k = 0; const char* label : {"q -1", "q 1", "砂", "γ"}) stage.loads[k++].label = label;
  std::vector<std::string> names;
  for (const CaseTableText& table : load_texts(stage, nullptr, layout).tables) names.push_back(table.lines[0].value);
  EXPECT_THAT(names, ElementsAre("\"q_minus_1\"", "\"q_1\"", "\"load\"", "\"load_2\""));
}

TEST(LoadText, BesideTheSectionIsLeftOut)
{
  StixStage stage = loaded();
  stage.loads[0].start = 30.0, stage.loads[0].end = 34.0;
  stage.layer_loads = {{"clay", {{"sand", 50.0}}}};
  const LoadTexts texts = load_texts(stage, nullptr, layout);
  EXPECT_THAT(texts.tables, IsEmpty());
  EXPECT_THAT(in_english(texts.left_out),
      ElementsAre("Load traffic: it has no width or no size in the section.",
          "Layers that count as loads without full consolidation: their excess pore pressure."));
}

}  // namespace load_text_test
