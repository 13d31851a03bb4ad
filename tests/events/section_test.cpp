// The slopes of sections drawn by hand.
#include "events/section.hpp"
#include "support/test.hpp"

namespace {

constexpr Real none = -INFINITY;

/// Columns of 1 m from x = 10 m on; the lowest point lies at 0.
Section section_of(const std::vector<Real>& heights)
{
  return {{.left = 10.0, .width = 1.0, .n = static_cast<Index>(heights.size())}, heights, 0.0};
}

TEST(Section, AColumnAtAWallHasOneSlopeWithAFreeToe)
{
  const auto slopes = find_slopes(section_of({4.0, 4.0, 4.0, none, none, none}));
  ASSERT_EQ(slopes.size(), 1);
  EXPECT_EQ(slopes[0].facing, Facing::right);
  EXPECT_TRUE(slopes[0].free_toe);
  EXPECT_EQ(slopes[0].crest, 13.0);
  EXPECT_EQ(slopes[0].toe, 13.0);
  EXPECT_EQ(slopes[0].height, 4.0);
}

TEST(Section, ItsMirrorImageHasTheMirrorImage)
{
  const auto slopes = find_slopes(section_of({none, none, none, 4.0, 4.0, 4.0}));
  ASSERT_EQ(slopes.size(), 1);
  EXPECT_EQ(slopes[0].facing, Facing::left);
  EXPECT_TRUE(slopes[0].free_toe);
  EXPECT_EQ(slopes[0].crest, 13.0);
  EXPECT_EQ(slopes[0].toe, 13.0);
  EXPECT_EQ(slopes[0].height, 4.0);
}

TEST(Section, GroundThatReachesTheSideOfTheMeshIsNoFreeToeAndTheSlopeEndsWhereItBegins)
{
  const auto slopes = find_slopes(section_of({5.0, 5.0, 4.0, 3.0, 2.0, 1.0, 1.0, 1.0}));
  ASSERT_EQ(slopes.size(), 1);
  EXPECT_FALSE(slopes[0].free_toe);
  EXPECT_EQ(slopes[0].height, 4.0);  // over the ground, not over the lowest point
  EXPECT_EQ(slopes[0].crest, 12.0);
  EXPECT_EQ(slopes[0].toe, 15.0);
}

TEST(Section, ADikeHasTwoSlopesAndADitchIsNoToe)
{
  const auto slopes = find_slopes(section_of({1.0, 1.0, 2.0, 5.0, 5.0, 3.0, 2.0, 1.0, 0.2, 1.0}));
  ASSERT_EQ(slopes.size(), 2);
  EXPECT_EQ(slopes[0].facing, Facing::right);
  EXPECT_EQ(slopes[0].crest, 15.0);
  EXPECT_EQ(slopes[0].toe, 17.0);
  EXPECT_EQ(slopes[1].facing, Facing::left);
  EXPECT_EQ(slopes[1].crest, 13.0);
  EXPECT_EQ(slopes[1].toe, 12.0);
  EXPECT_EQ(slopes[1].height, 4.0);
}

TEST(Section, FlatGroundHasNoSlope)
{
  EXPECT_TRUE(find_slopes(section_of({2.0, 2.0, 2.0, 2.0})).empty());
  EXPECT_TRUE(find_slopes(section_of({2.0, 2.0, 2.0, none})).empty());  // the mesh ends in the last column
  EXPECT_TRUE(find_slopes(section_of({none, none, none})).empty());
  EXPECT_TRUE(find_slopes(section_of({})).empty());
}

TEST(Section, LevelGroundWhosePointsDifferByLessThanAColumnHasNoSlope)
{
  EXPECT_TRUE(find_slopes(section_of({5.0, 5.0, 5.0, 4.9, 4.1, 4.1, 4.1})).empty());  // columns of 1 m
  EXPECT_TRUE(find_slopes(section_of({5.0, 5.0, 5.0, 5.0, 5.0 - 1e-10, 5.0 - 1e-10})).empty());
  EXPECT_EQ(moved_distance(section_of({5.0, 5.0, 5.0, 5.0, 5.0 - 1e-10, 5.0 - 1e-10})), 0.25);
  EXPECT_EQ(find_slopes(section_of({5.0, 5.0, 5.0, 4.9, 4.0, 4.0, 4.0})).size(), 1);
}

TEST(MovedDistance, IsATwentiethOfTheReliefAndOfTheHeightWithoutAny)
{
  EXPECT_NEAR(moved_distance(section_of({4.0, 4.0, none, none})), 0.2, 1e-12);
  EXPECT_NEAR(moved_distance(section_of({5.0, 5.0, 2.0, 1.0, 1.0})), 0.2, 1e-12);
  EXPECT_NEAR(moved_distance(section_of({2.0, 2.0, 2.0})), 0.1, 1e-12);
}

TEST(Columns, CoverTheRegionAndNoMore)
{
  EXPECT_EQ(columns_between(0.0, 16.0, 0.1).n, 160);  // not 161 for a bit of round-off
  EXPECT_EQ(columns_between(-1.0, 1.05, 0.5).n, 5);
}

}  // namespace
