#include "import/dstability/earlier_ground.hpp"

#include "sections.hpp"

namespace earlier_ground_test {

StixStage with_fill(const std::string& label, Real right)
{
  StixStage stage = clay_on_sand();
  stage.label = label;
  stage.layers.push_back(box_layer("fill", {5.0, 0.0}, {right, 2.0}, 0));
  return stage;
}

std::string said_of(std::vector<StixStage> stages)
{
  const std::size_t last = stages.size() - 1;
  const auto ground = earlier_ground(project_of(std::move(stages)), 0, last, {0.0, 20.0}, 0.5);
  return ground ? (ground->is_other ? "" : "same height: ") + ground->sentence.en : "nothing";
}

TEST(EarlierGround, SaysWhatWasAddedAndTakenAwaySince)
{
  EXPECT_THAT(said_of({clay_on_sand(), with_fill("berm", 10.0)}),
      StartsWith("Earlier stages of the file have other ground. Since `daily`: 10.0 m2 were added (x = 5.0 to 10.0 m). "
                 "The run has the ground of the analysed stage from its start: settlement, stress and slides of the "
                 "building are not in it."));
  EXPECT_THAT(said_of({with_fill("berm", 8.0), clay_on_sand()}),
      HasSubstr("Since `berm`: 6.0 m2 were taken away (x = 5.0 to 8.0 m)."));
  StixStage ditch = with_fill("ditch", 10.0);
  ditch.excavations = {{{14.0, 0.0}, {14.0, -1.0}, {18.0, -1.0}, {18.0, 0.0}}};
  EXPECT_THAT(said_of({clay_on_sand(), ditch}),
      HasSubstr("10.0 m2 were added (x = 5.0 to 10.0 m), 4.0 m2 were taken away (x = 14.0 to 18.0 m)."));
}

TEST(EarlierGround, NamesStagesOfTheSameGroundTogether)
{
  StixStage high = clay_on_sand();
  high.label = "high water";
  EXPECT_THAT(said_of({clay_on_sand(), high, with_fill("low berm", 8.0), with_fill("berm", 10.0)}),
      HasSubstr(
          "Since `daily`, `high water`: 10.0 m2 were added (x = 5.0 to 10.0 m). Since `low berm`: 4.0 m2 were added "
          "(x = 8.0 to 10.0 m)."));
}

TEST(EarlierGround, OfTheSameHeightSaysThatLayersOrLoadsChange)
{
  EXPECT_EQ(said_of({clay_on_sand(), clay_on_sand()}), "nothing");
  StixStage other = clay_on_sand();
  other.layers[0].soil = 0;
  EXPECT_THAT(said_of({clay_on_sand(), other}), StartsWith("same height: Layers or loads change between the stages"));
}

TEST(EarlierGround, IsSaidInDutchToo)
{
  const auto ground = earlier_ground(project_of({clay_on_sand(), with_fill("berm", 10.0)}), 0, 1, {0.0, 20.0}, 0.5);
  ASSERT_TRUE(ground.has_value());
  EXPECT_THAT(ground->sentence.nl, HasSubstr("Sinds `daily`: 10,0 m2 opgehoogd (x = 5,0 tot 10,0 m)."));
}

}  // namespace earlier_ground_test
