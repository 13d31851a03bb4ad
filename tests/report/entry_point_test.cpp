// Where a slide enters the ground, on a dike from x = 0 to 20 with a crest of 4 m at a height of 4 m.
#include "report/entry_point.hpp"
#include "support/test.hpp"

namespace entry_point_test {

const std::vector<float> dike = {-5, 0, 0, 0, 8, 4, 12, 4, 20, 0, 30, 0};

std::optional<EntryPoint> entry_of(std::vector<Vec<2>> line, Facing facing = Facing::right)
{
  SlideSummary slide;
  slide.slide.facing = facing;
  slide.onset.line = std::move(line);
  slide.slip.time = 1.0;
  return entry_point(slide, dike);
}

/// Of a line whose upper end lies on the ground.
std::string zone_of(Vec<2> end, Facing facing)
{
  const auto entry =
      facing == Facing::right ? entry_of({end, {25.0, -1.0}}) : entry_of({{-3.0, -1.0}, end}, Facing::left);
  return entry ? std::string(entry->zone) : "none";
}

TEST(EntryPoint, IsNamedByThePartOfTheSlopeThatSlides)
{
  EXPECT_EQ(zone_of({4.0, 2.0}, Facing::right), "beyond_crest");
  EXPECT_EQ(zone_of({9.0, 4.0}, Facing::right), "crest");
  EXPECT_EQ(zone_of({15.0, 2.5}, Facing::right), "upper_half");
  EXPECT_EQ(zone_of({17.0, 1.5}, Facing::right), "lower_half");
  EXPECT_EQ(zone_of({5.0, 2.5}, Facing::left), "upper_half");
  EXPECT_EQ(zone_of({15.0, 2.5}, Facing::left), "beyond_crest");
  EXPECT_EQ(zone_of({40.0, 0.0}, Facing::left), "none");
}

TEST(EntryPoint, LiesWhereTheLineGoesOnToTheFirstGround)
{
  const auto flat = entry_of({{11.0, 3.2}, {14.0, 3.0}, {25.0, -1.0}});  // 0.8 m below the crest, nearly level
  ASSERT_TRUE(flat);
  EXPECT_NEAR(flat->x, 10.2, 1e-6);  // at 45 degrees
  EXPECT_NEAR(flat->y, 4.0, 1e-6);
  const auto steep = entry_of({{11.0, 3.2}, {12.0, 1.2}, {25.0, -1.0}});
  ASSERT_TRUE(steep);
  EXPECT_NEAR(steep->x, 10.6, 1e-6);  // 2 in 1
  const auto left = entry_of({{-3.0, -1.0}, {8.0, 1.2}, {9.0, 3.2}}, Facing::left);
  ASSERT_TRUE(left);
  EXPECT_NEAR(left->x, 9.4, 1e-6);
}

TEST(EntryPoint, IsNotKnownOfALineThatEndsDeepBelowTheGroundOrAboveIt)
{
  EXPECT_TRUE(entry_of({{10.0, 2.5}, {25.0, -1.0}}));
  EXPECT_FALSE(entry_of({{10.0, 2.3}, {25.0, -1.0}}));  // more than two fifths of 4 m
  EXPECT_TRUE(entry_of({{15.0, 2.6}, {25.0, -1.0}}));
  EXPECT_FALSE(entry_of({{15.0, 3.0}, {25.0, -1.0}}));
  EXPECT_FALSE(entry_of({}));
}

TEST(EntryPoint, IsThatOfTheOnsetNotOfTheFastestShear)
{
  SlideSummary slide;
  slide.slip = {.time = 2.0, .line = {{4.0, 2.0}, {25.0, -1.0}}};
  EXPECT_FALSE(entry_point(slide, dike));
  slide.onset = {.time = 1.0, .line = {{9.0, 4.0}, {25.0, -1.0}}};
  EXPECT_EQ(entry_point(slide, dike)->x, 9.0);
  slide.onset.time = 2.0;  // not seen before
  EXPECT_FALSE(entry_point(slide, dike));
}

}  // namespace entry_point_test
