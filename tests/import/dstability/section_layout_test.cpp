#include "import/dstability/section_layout.hpp"
#include "model/bodies/body_outline.hpp"
#include "support/problems.hpp"

namespace section_layout_test {

SectionLayout layout(const Polygon& outline, const LayoutWishes& wishes = {})
{
  return layout_of({{"soil", outline}}, {}, wishes);
}

Real area_of(const CleanRegion& region) { return area(BodyOutline{region.polygon, {1, 1}, region.holes}); }

/// The ground over a base at -10 m.
Polygon over_level_base(Polygon ground)
{
  ground.push_back({ground.back()[0], -10.0});
  ground.push_back({ground.front()[0], -10.0});
  std::ranges::reverse(ground);
  return ground;
}

TEST(SectionLayout, TakesTheDikeForTheCrestAndNotTheHillBehindIt)
{
  const Polygon hill = over_level_base({{0, 0}, {20, 0}, {30, 5}, {35, 5}, {45, 0}, {90, 0}, {100, 9}, {120, 9}});
  const SectionLayout found = layout(hill, {.land = LandEnd::right});
  EXPECT_NEAR(found.crest[0], 30.0, 1e-3);
  EXPECT_NEAR(found.crest[1], 5.0, 1e-3);
  EXPECT_NEAR(found.height, 5.0, 1e-3);  // over the lowest ground behind it: the land's end is above the crest
  EXPECT_NEAR(found.top, 9.0, 1e-3);
  EXPECT_EQ(found.cell, 0.5);
}

TEST(SectionLayout, TakesTheDikeForTheCrestAndNotTheForelandBesideADeepRiver)
{
  const Polygon river = over_level_base({{0, -8}, {10, -8}, {20, 3}, {40, 3}, {50, 8}, {55, 8}, {70, 1}, {100, 1}});
  EXPECT_NEAR(layout(river).crest[1], 8.0, 1e-3);
}

TEST(SectionLayout, TakesTheCrestBetweenTheTopsThatTheFileNames)
{
  const Polygon two = over_level_base({{0, 0}, {20, 0}, {30, 5}, {35, 5}, {45, 0}, {60, 7}, {70, 7}, {80, 0}, {90, 0}});
  EXPECT_NEAR(layout(two).crest[1], 7.0, 1e-3);
  const SectionLayout named = layout(two, {.crest = Vec<2>{31.0, 34.0}});
  EXPECT_NEAR(named.crest[1], 5.0, 1e-3);
  EXPECT_NEAR(named.crest[0], 31.0, 1e-3);
}

TEST(SectionLayout, TakesTheHighestPlaceWhereTheSectionBeginsOnTheCrest)
{
  const Polygon half =
      over_level_base({{0, 8}, {3, 8}, {20, 0}, {22, -1}, {24, 0}, {40, 0}, {42, -1}, {44, 0}, {60, 0}});
  EXPECT_NEAR(layout(half).crest[1], 8.0, 1e-3);
}

TEST(SectionLayout, ChoosesCellsThatALaptopSolvesInSomeMinutes)
{
  const Polygon low = over_level_base({{0, 0}, {20, 0}, {24, 2}, {28, 2}, {32, 0}, {60, 0}});
  const Polygon wide = over_level_base({{0, 0}, {1000, 0}, {1004, 2}, {1008, 2}, {1012, 0}, {2000, 0}});
  EXPECT_EQ(layout(low).cell, 0.4);  // 0.2 m would be ten times the work
  EXPECT_EQ(layout(wide).cell, 1.0);
}

TEST(SectionLayout, RefusesCellsThatAreTooManyBeforeItMakesThem)
{
  const Polygon box{{0, -10}, {100, -10}, {100, 0}, {0, 0}};
  EXPECT_THAT(problems_of([&] { layout(box, {.cell = 1e-3}); }),
      ElementsAre(told("", "cells of 0.001 m are too small for this section",
          HasSubstr("The soil would have 1e+09 of them, at most 4e+06. Give larger ones, from 0.016 m on"))));
  EXPECT_EQ(layout(box, {.cell = 0.05}).cell, 0.05);
}

TEST(SectionLayout, RefusesCellsThatAreLargeBesideHeightAndSoil)
{
  const SectionLayout low = layout(over_level_base({{0, 0}, {20, 0}, {24, 2}, {28, 2}, {32, 0}, {60, 0}}));
  EXPECT_THAT(problems_of([&] { check_cell(low, 50.0); }),
      ElementsAre(told("", "cells of 50 m are too large for this section", HasSubstr("Give at most 3 m with --cell"))));
  check_cell(low, 3.0);
  check_cell(low, 0.0);
}

TEST(BaseFill, FillsBelowTheBaseAndNoAirAboveTheGround)
{
  // A slab that rises from 0 to 5 m and is 3 m thick: a triangle of 20 m by 5 m is below it.
  const CleanRegion slab{0, {{0, 0}, {20, 5}, {20, 8}, {0, 3}}, {}};
  const auto fills = base_fill(layout(slab.polygon), {slab});
  ASSERT_EQ(fills.size(), 1u);
  EXPECT_NEAR(area_of(fills[0]), 50.0, 1e-9);
  EXPECT_EQ(fills[0].polygon.size(), 3u);
  EXPECT_FALSE(contains(fills[0].polygon, Vec<2>{1.0, 4.0}));  // above the ground at the low end
}

TEST(BaseFill, HasAPieceOnEachSideOfTheLowestPlaceWithTheSoilAboveIt)
{
  const CleanRegion left{0, {{0, 2}, {50, 0}, {50, 10}, {0, 10}}, {}},
      right{1, {{50, 0}, {90, 1}, {90, 10}, {50, 10}}, {}};
  SectionLayout whole = layout(left.polygon);
  whole.high[0] = 90.0;
  const auto fills = base_fill(whole, {left, right});
  ASSERT_EQ(fills.size(), 2u);
  EXPECT_EQ(fills[0].drawn, 0);
  EXPECT_EQ(fills[1].drawn, 1);
  EXPECT_NEAR(area_of(fills[0]), 50.0, 1e-9);
  EXPECT_NEAR(area_of(fills[1]), 20.0, 1e-9);
}

TEST(BaseFill, IsEmptyUnderALevelBase)
{
  const CleanRegion box{0, {{0, 0}, {50, 0}, {50, 10}, {0, 10}}, {}};
  EXPECT_TRUE(base_fill(layout(box.polygon), {box}).empty());
}

TEST(CutAlong, PartsARegionAtALine)
{
  const CleanRegion box{3, {{0, -5}, {40, -5}, {40, 5}, {0, 5}}, {}};
  Real left_there = 0.0;
  const auto parts = cut_along(box, {{0, 0}, {40, 2}}, 0.05, left_there);
  ASSERT_EQ(parts.size(), 2u);
  for (const CutRegion& part : parts) {
    EXPECT_EQ(part.region.drawn, 3);
    EXPECT_NEAR(area_of(part.region), part.above ? 160.0 : 240.0, 1e-9);
  }
  EXPECT_EQ(left_there, 0.0);
}

TEST(CutAlong, LeavesASliverWithTheOtherSideAlsoBesideAThickPiece)
{
  // 1 cm above the line up to a ditch at x = 30 m, a dike of 5 m behind it.
  const CleanRegion ground{0,
      {{0, -5}, {100, -5}, {100, 0}, {90, 0}, {80, 5}, {70, 5}, {60, 0}, {34, 0}, {33, -1}, {31, -1}, {30, 0}, {0, 0}},
      {}};
  Real left_there = 0.0;
  const auto parts = cut_along(ground, {{0, -0.01}, {100, -0.01}}, 0.05, left_there);
  ASSERT_EQ(parts.size(), 2u);  // the strip to the left of the ditch stays below
  EXPECT_NEAR(left_there, 0.3, 1e-3);
  Real sum = 0.0;
  for (const CutRegion& part : parts) sum += area_of(part.region);
  EXPECT_NEAR(sum, area_of(ground), 1e-9);
}

TEST(CutAlong, KeepsHoles)
{
  const CleanRegion ring{0, {{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{4, 1}, {4, 3}, {6, 3}, {6, 1}}}};
  Real left_there = 0.0;
  const auto parts = cut_along(ring, {{0, 5}}, 0.05, left_there);
  ASSERT_EQ(parts.size(), 2u);
  for (const CutRegion& part : parts) EXPECT_NEAR(area_of(part.region), part.above ? 50.0 : 46.0, 1e-9);
}

TEST(PutOnTop, PutsTheInnerRegionBehindTheOuterOne)
{
  const CleanRegion outer{0, {{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{4, 4}, {4, 6}, {6, 6}, {6, 4}}}},
      inner{1, {{4, 4}, {6, 4}, {6, 6}, {4, 6}}, {}};
  BodyOrder order{{{"", "inner", "", {}, {}}, {"", "outer", "", {}, {}}}, {inner, outer}};
  put_on_top(order);
  EXPECT_EQ(order.bodies[0].material, "outer");
  EXPECT_EQ(order.bodies[1].material, "inner");
  EXPECT_TRUE(order.bodies[0].holes.empty());  // the inner one fills it
}

}  // namespace section_layout_test
