#include "import/dstability/section_part.hpp"
#include "support/problems.hpp"

namespace section_part_test {

/// A dike of 4 m with slopes of 1:2 and a crest from x = 100 to 104 m, on 3 m of clay and 20 m of sand, 300 m wide.
std::vector<DrawnRegion> dike()
{
  return {{"sand", {{0, -23}, {300, -23}, {300, -3}, {0, -3}}}, {"clay", {{0, -3}, {300, -3}, {300, 0}, {0, 0}}},
      {"dike", {{92, 0}, {112, 0}, {104, 4}, {100, 4}}}};
}

const std::vector<bool> clay_is_undrained{false, true, false};

TEST(SectionPart, HasRoomBeyondTheToesAndBelowTheUndrainedSoil)
{
  const SectionPart part = part_that_matters(dike(), {}, {102, 4}, clay_is_undrained);
  EXPECT_EQ(part.between[0], 92.0 - 18.0);  // 3 x 4 m and 2 x 3 m before the toe
  EXPECT_EQ(part.between[1], 112.0 + 18.0);
  EXPECT_EQ(part.base, -6.0);  // half of 4 m below the height of the dike under the ground, which is deeper than clay
  EXPECT_EQ(part_that_matters(dike(), {}, {102, 4}, {false, false, false}).between[0], 92.0 - 12.0);
  const SectionPart deep = part_that_matters(dike(), {}, {102, 4}, {true, true, false});
  EXPECT_EQ(deep.base, -23.0) << "nothing of the undrained soil is left out";
  EXPECT_EQ(deep.between[0], 92.0 - 58.0);
}

TEST(SectionPart, TakesADitchForPartOfTheDike)
{
  const std::vector<DrawnExcavation> ditch{{"ditch", {{120, 0}, {121, -2}, {123, -2}, {124, 0}}}};
  const SectionPart part = part_that_matters(dike(), ditch, {102, 4}, clay_is_undrained);
  EXPECT_GT(part.between[1], 120.0 + 3.0 * 6.0) << "three times the height of the crest over the ditch";
  EXPECT_LT(part.between[1], 124.0 + 3.0 * 6.0 + 2.0 * 3.0 + 1.0);
}

TEST(SectionPart, IsAllOfLevelGroundAndOfAShortSection)
{
  const std::vector<DrawnRegion> level{{"clay", {{0, 0}, {50, 0}, {50, 10}, {0, 10}}}};
  const SectionPart part = part_that_matters(level, {}, {102, 4}, {true});
  EXPECT_EQ(describe(part, level), "");
  EXPECT_EQ(part_of(level, part)[0].polygon.size(), 4u);
  std::vector<DrawnRegion> narrow = part_of(dike(), {.between = {85.0, 120.0}, .base = -5.0});
  EXPECT_EQ(describe(part_that_matters(narrow, {}, {102, 4}, clay_is_undrained), narrow), "");
}

TEST(SectionPart, SaysWhatItLeavesOutAndHowToTakeAll)
{
  EXPECT_EQ(describe(part_that_matters(dike(), {}, {102, 4}, clay_is_undrained), dike()),
      "Only the part from x = 74 to 130 m and above z = -6 m was taken over. Beyond the toes at x = 92.0 and 112.0 m "
      "it has three times the height of the dike (4.00 m) and twice the thickness of the undrained soil there; below "
      "the undrained soil half the height. --between 0,300 --base -23 takes all of it.");
  EXPECT_THAT(problems_of([] {
    part_of(dike(), {.between = {900.0, 990.0}});
  }),
      ElementsAre(told("", "there is no soil in this part of the section",
          HasSubstr("Got --between 900,990 --base -1e+09; the soil lies from x = 0 to 300 m, z = -23 to 4 m."))));
}

TEST(SectionPart, OfARegionBelowTheBaseIsEmpty)
{
  const std::vector<DrawnRegion> part = part_of(dike(), {.between = {0.0, 300.0}, .base = -3.0});
  EXPECT_TRUE(part[0].polygon.empty());
  EXPECT_EQ(std::abs(signed_area(part[1].polygon)), 900.0);
}

}  // namespace section_part_test
