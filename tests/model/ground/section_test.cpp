#include "model/ground/section.hpp"
#include "support/test.hpp"

namespace section_test {

constexpr Real none = -INFINITY;

/// Columns of 1 m from x = 10 m on; the lowest point lies at 0.
Section section_of(const std::vector<Real>& heights)
{
  return {{.left = 10.0, .width = 1.0, .n = static_cast<Index>(heights.size())}, heights, 0.0};
}

TEST(Section, AColumnAtAWallHasOneSlopeWithAFreeToe)
{
  for (const auto& [facing, heights] : {std::pair{Facing::right, std::vector{4.0, 4.0, 4.0, none, none, none}},
           std::pair{Facing::left, std::vector{none, none, none, 4.0, 4.0, 4.0}}}) {
    const auto slopes = find_slopes(section_of(heights));
    ASSERT_EQ(slopes.size(), 1);
    EXPECT_EQ(slopes[0].facing, facing);
    EXPECT_TRUE(slopes[0].free_toe);
    EXPECT_EQ(slopes[0].crest, 13.0);
    EXPECT_EQ(slopes[0].toe, 13.0);
    EXPECT_EQ(slopes[0].height, 4.0);
  }
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

/// A plateau of 60 m from height `high` down to 5 m, a slope of 1:2 to the ground at 0, as columns of 1 m. steps:
/// heights are whole multiples of that, as rows of points make them.
Section sloping_plateau(Real high, Real steps = 0.0)
{
  std::vector<Real> heights;
  for (int k = 0; k < 100; ++k) {
    const Real x = k + 0.5, y = x < 60.0 ? high - (high - 5.0) * x / 60.0 : std::max(0.0, 5.0 - (x - 60.0) / 2.0);
    heights.push_back(steps > 0.0 ? steps * std::floor(y / steps) + 0.5 * steps : y);
  }
  return section_of(heights);
}

TEST(Section, APlateauThatFallsGentlyBelongsToTheCrest)
{
  for (const Real high : {5.0, 5.5, 6.5, 8.0, 10.0})
    for (const Real steps : {0.0, 0.125, 0.25}) {
      const auto slopes = find_slopes(sloping_plateau(high, steps));
      ASSERT_EQ(slopes.size(), 1) << high;
      EXPECT_NEAR(slopes[0].crest, 70.0, 1.01) << high << ' ' << steps;  // 10 m + 60 m
      EXPECT_NEAR(slopes[0].height, 5.0, 0.5) << high;
      EXPECT_NEAR(slopes[0].toe, 80.0, 1.01) << high;
      EXPECT_EQ(slopes[0].first, 0) << high;
    }
}

TEST(Section, ALevelPlateauHasTheHeightOfItsCrestAsItsMeasure)
{
  const Slope slope = find_slopes(sloping_plateau(5.0))[0];
  EXPECT_EQ(slope.height, 5.0);
  EXPECT_EQ(slope.relief, 5.0);
}

TEST(Section, ABermIsNoPlateauNorIsAnEvenSlope)
{
  std::vector<Real> berm, even, long_berm;
  for (int k = 0; k < 60; ++k) {
    const Real x = k + 0.5;
    const auto fall = [&](Real width) {  // crest of 4 m, 1:3 to a berm at 2 m, 1:3 to the ground
      const Real down = x - 10.0 < 6.0 ? (x - 10.0) / 3.0 : std::max(2.0, 2.0 + (x - 16.0 - width) / 3.0);
      return 4.0 - std::clamp(down, 0.0, 4.0);
    };
    berm.push_back(fall(5.0)), long_berm.push_back(fall(30.0)), even.push_back(std::max(0.0, 6.0 - 0.1 * x));
  }
  EXPECT_NEAR(find_slopes(section_of(berm))[0].crest, 20.5, 1.0);
  EXPECT_NEAR(find_slopes(section_of(long_berm))[0].crest, 20.5, 1.0);
  EXPECT_NEAR(find_slopes(section_of(even))[0].crest, 13.0, 1.0);
}

TEST(Section, TheMirrorImageOfASlopingPlateauIsMirrored)
{
  const Section right = sloping_plateau(8.0, 0.125);
  std::vector<Real> turned(right.heights.rbegin(), right.heights.rend());
  const Slope a = find_slopes(right)[0], b = find_slopes(section_of(turned))[0];
  EXPECT_EQ(b.facing, Facing::left);
  EXPECT_EQ(b.crest, 120.0 - a.crest);
  EXPECT_EQ(b.toe, 120.0 - a.toe);
  EXPECT_EQ(b.height, a.height);
}

}  // namespace section_test
