// Where a slide enters the ground, on a dike from x = 0 to 20 with a crest of 4 m at a height of 4 m.
#include "report/entry_point.hpp"
#include "support/test.hpp"

namespace {

const std::vector<float> dike = {-5, 0, 0, 0, 8, 4, 12, 4, 20, 0, 30, 0};

std::string zone_of(Real x, Facing facing)
{
  SlideSummary slide;
  slide.slide.facing = facing;
  slide.slip.line = {{x, -1.0}, {25.0, -1.0}};
  if (facing == Facing::left) slide.slip.line = {{-3.0, -1.0}, {x, -1.0}};
  const auto entry = entry_point(slide, dike);
  return entry ? std::string(entry->zone) : "none";
}

TEST(EntryPoint, IsNamedByThePartOfTheSlopeThatSlides)
{
  EXPECT_EQ(zone_of(4.0, Facing::right), "beyond_crest");
  EXPECT_EQ(zone_of(9.0, Facing::right), "crest");
  EXPECT_EQ(zone_of(15.0, Facing::right), "upper_half");  // 2.5 m of 4 m
  EXPECT_EQ(zone_of(17.0, Facing::right), "lower_half");  // 1.5 m
  EXPECT_EQ(zone_of(5.0, Facing::left), "upper_half");
  EXPECT_EQ(zone_of(15.0, Facing::left), "beyond_crest");
  EXPECT_EQ(zone_of(40.0, Facing::left), "none");
}

TEST(EntryPoint, LiesOnTheFirstGround)
{
  SlideSummary slide;
  slide.slip.line = {{15.0, 0.5}, {25.0, -1.0}};
  EXPECT_FLOAT_EQ(static_cast<float>(entry_point(slide, dike)->y), 2.5f);
  slide.slip.line.clear();
  EXPECT_FALSE(entry_point(slide, dike).has_value());
}

}  // namespace
