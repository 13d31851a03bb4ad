#include "model/bodies/polygon.hpp"
#include "support/test.hpp"

namespace polygon_test {

// An L: 3 wide and 1 high, with a leg 1 wide up to 2.
const Polygon ell{{0.0, 0.0}, {3.0, 0.0}, {3.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}};

TEST(Polygon, HoldsWhatLiesInsideItAndNotWhatLiesInItsNotch)
{
  EXPECT_TRUE(contains(ell, {2.5, 0.5}));
  EXPECT_TRUE(contains(ell, {0.5, 1.5}));
  EXPECT_FALSE(contains(ell, {2.0, 1.5}));
  EXPECT_FALSE(contains(ell, {-0.1, 0.5}));
  EXPECT_FALSE(contains(ell, {0.5, 2.1}));
}

TEST(Polygon, HoldsTheSameEitherWayRound)
{
  const Polygon turned(ell.rbegin(), ell.rend());
  for (const Vec<2> x : {Vec<2>{2.5, 0.5}, Vec<2>{2.0, 1.5}, Vec<2>{0.5, 1.5}})
    EXPECT_EQ(contains(turned, x), contains(ell, x));
}

TEST(Polygon, SlantedSidesCutWhereTheyLie)
{
  const Polygon triangle{{0.0, 0.0}, {4.0, 0.0}, {0.0, 2.0}};
  EXPECT_TRUE(contains(triangle, {1.99, 1.0}));
  EXPECT_FALSE(contains(triangle, {2.01, 1.0}));
}

TEST(Polygon, APlaceOnASharedSideBelongsToExactlyOneNeighbour)
{
  const Polygon left{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}},
      right{{1.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, 1.0}};
  EXPECT_NE(contains(left, {1.0, 0.5}), contains(right, {1.0, 0.5}));
}

TEST(Polygon, AreaIsPositiveCounterClockwise)
{
  EXPECT_DOUBLE_EQ(signed_area(ell), 4.0);
  EXPECT_DOUBLE_EQ(signed_area(Polygon(ell.rbegin(), ell.rend())), -4.0);
}

TEST(Polygon, BoxesThatTouchOverlap)
{
  const BoundingBox a{{0.0, 0.0}, {2.0, 1.0}};
  EXPECT_TRUE(overlap(a, {{2.0, 1.0}, {3.0, 3.0}}));
  EXPECT_TRUE(overlap(a, {{0.5, -5.0}, {0.6, 5.0}}));
  EXPECT_FALSE(overlap(a, {{2.1, 0.0}, {3.0, 1.0}}));
  EXPECT_FALSE(overlap(a, {{0.0, 1.1}, {2.0, 3.0}}));
  EXPECT_FALSE(overlap(a, {{0.0, -3.0}, {2.0, -0.1}}));
}

TEST(Polygon, ALineCrossesABoxOnlyIfItReachesIt)
{
  const BoundingBox a{{0.0, 0.0}, {2.0, 1.0}};
  EXPECT_TRUE(crosses(a, {-1.0, -1.0}, {3.0, 2.0}));
  EXPECT_TRUE(crosses(a, {0.5, 0.5}, {0.6, 0.5}));   // within
  EXPECT_TRUE(crosses(a, {-1.0, 1.0}, {3.0, 1.0}));  // along a side
  EXPECT_TRUE(crosses(a, {1.0, 2.0}, {3.0, 0.0}));   // over a corner
  EXPECT_FALSE(crosses(a, {1.0, 2.1}, {3.0, 0.1}));  // just past it
  EXPECT_FALSE(crosses(a, {3.0, 0.5}, {5.0, 0.5}));
  EXPECT_FALSE(crosses(a, {1.0, -2.0}, {1.0, -0.1}));
}

TEST(Polygon, ClippedToABoxItKeepsItsAreaAndItsInsideThere)
{
  const BoundingBox at_the_leg{{0.5, 0.5}, {2.0, 1.5}};
  const Polygon kept = clip_to_box(ell, at_the_leg);
  EXPECT_DOUBLE_EQ(signed_area(kept), 1.5 * 0.5 + 0.5 * 0.5);
  for (const Vec<2> x : {Vec<2>{0.6, 1.4}, Vec<2>{1.9, 0.6}, Vec<2>{1.9, 1.4}, Vec<2>{1.1, 1.1}})
    EXPECT_EQ(contains(kept, x), contains(ell, x));
  EXPECT_TRUE(clip_to_box(ell, {{2.0, 1.5}, {3.0, 2.0}}).empty());
}

TEST(Polygon, ClippedIntoTwoItStillHasTheEvenOddRule)
{
  const Polygon cup{{0.0, 0.0}, {3.0, 0.0}, {3.0, 2.0}, {2.0, 2.0}, {2.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}};
  const Polygon kept = clip_to_box(cup, {{-1.0, 1.2}, {4.0, 5.0}});
  EXPECT_NEAR(signed_area(kept), 1.6, 1e-15);
  EXPECT_TRUE(contains(kept, {0.5, 1.5}));
  EXPECT_FALSE(contains(kept, {1.5, 1.5}));
  EXPECT_TRUE(contains(kept, {2.5, 1.5}));
}

}  // namespace polygon_test
