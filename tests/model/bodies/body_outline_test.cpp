#include "model/bodies/body_outline.hpp"
#include "support/test.hpp"

namespace body_outline_test {

Polygon box(Vec<2> low, Vec<2> high) { return {low, {high[0], low[1]}, high, {low[0], high[1]}}; }

BodyOutline body(const Polygon& polygon, const std::vector<Polygon>& holes = {}) { return {polygon, {5, 5}, holes}; }

TEST(BodyOutline, CoversItsPolygonButNotItsHoles)
{
  const BodyOutline wall =
      body(box({0.0, 0.0}, {6.0, 2.0}), {box({1.0, 0.5}, {2.0, 1.5}), box({3.0, 0.5}, {4.0, 1.5})});
  EXPECT_TRUE(covers(wall, {0.5, 1.0}));
  EXPECT_TRUE(covers(wall, {2.5, 1.0}));
  EXPECT_FALSE(covers(wall, {1.5, 1.0}));
  EXPECT_FALSE(covers(wall, {3.5, 1.0}));
  EXPECT_FALSE(covers(wall, {6.5, 1.0}));
  EXPECT_DOUBLE_EQ(area(wall), 10.0);
}

/// Where the vertical through x crosses the outline of a body that is no region.
std::vector<Real> crossings(const BodyOutline& outline, Real x)
{
  return crossings_of_vertical(outline_sides({}, outline), x);
}

TEST(BodyOutline, VerticalsCrossItInAscendingOrder)
{
  const Polygon ell{{0.0, 0.0}, {3.0, 0.0}, {3.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}};
  EXPECT_THAT(crossings(body(ell), 0.5), ElementsAre(DoubleEq(0.0), DoubleEq(2.0)));
  EXPECT_THAT(crossings(body(ell), 2.0), ElementsAre(DoubleEq(0.0), DoubleEq(1.0)));
  EXPECT_THAT(crossings(body(Polygon(ell.rbegin(), ell.rend())), 0.5), ElementsAre(DoubleEq(0.0), DoubleEq(2.0)));
  EXPECT_THAT(crossings(body(ell), 3.5), IsEmpty());
  EXPECT_THAT(crossings(body({{0.0, 0.0}, {4.0, 0.0}, {0.0, 2.0}}), 1.0), ElementsAre(DoubleEq(0.0), DoubleEq(1.5)));
}

TEST(BodyOutline, VerticalsCrossTheHolesToo)
{
  const BodyOutline wall = body(box({0.0, 0.0}, {6.0, 2.0}), {box({1.0, 0.5}, {2.0, 1.25})});
  EXPECT_THAT(crossings(wall, 1.5), ElementsAre(DoubleEq(0.0), DoubleEq(0.5), DoubleEq(1.25), DoubleEq(2.0)));
  EXPECT_THAT(crossings(wall, 2.5), ElementsAre(DoubleEq(0.0), DoubleEq(2.0)));
}

TEST(BodyOutline, OfCellsIsTheSidesThatNoOtherCellOfTheBodyShares)
{
  const Mesh<2> mesh = make_rectangle({0.0, 0.0}, {3.0, 3.0}, {3, 3});
  const BodyOutline ring{{}, {5, 5}, {}, {0, 1, 2, 3, 5, 6, 7, 8}};  // all but the middle
  const auto sides = outline_sides(mesh, ring);
  EXPECT_EQ(sides.size(), 12u + 4u);
  EXPECT_THAT(crossings_of_vertical(sides, 0.5), ElementsAre(0.0, 3.0));
  EXPECT_THAT(crossings_of_vertical(sides, 1.5), ElementsAre(0.0, 1.0, 2.0, 3.0));
  EXPECT_THAT(crossings_of_vertical(sides, 1.0), SizeIs(AnyOf(2, 4)));  // along a side: of one column or the other
}

TEST(CheckOutline, FindsNothingWrongWithASoundBody)
{
  EXPECT_THAT(
      check_outline(body(box({0.0, 0.0}, {6.0, 2.0}), {box({1.0, 0.5}, {2.0, 1.25}), box({2.0, 0.5}, {3.0, 1.25})})),
      IsEmpty());
  EXPECT_THAT(check_outline(body(Polygon{{0.0, 0.0}, {3.0, 0.0}, {3.0, 1.0}, {0.0, 0.0}})), IsEmpty());
  EXPECT_THAT(check_outline({{}, {5, 5}, {}, {3, 4}}), IsEmpty());
}

TEST(CheckOutline, LetsAPolygonTouchItself)
{
  const Polygon keyhole{{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {2.0, 4.0}, {2.0, 3.0}, {3.0, 1.0}, {1.0, 1.0}, {2.0, 3.0},
      {2.0, 4.0}, {0.0, 4.0}};
  EXPECT_THAT(check_outline(body(keyhole)), IsEmpty());
}

TEST(CheckOutline, SaysWhatMakesAnOutlineNoBody)
{
  using Found = testing::Matcher<const std::string&>;
  const Polygon ground = box({0.0, 0.0}, {6.0, 2.0});
  const Polygon notched{{0.0, 0.0}, {6.0, 0.0}, {6.0, 2.0}, {4.0, 2.0}, {3.0, 0.5}, {2.0, 2.0}, {0.0, 2.0}};
  const std::pair<BodyOutline, Found> rows[] = {
      {body({}), "the polygon has 0 different corners; it needs at least 3"},
      {body({{1.5, 2.0}, {3.0, 0.0}, {1.5, 2.0}}),
          "the polygon has 2 different corners from (1.5, 2) m; it needs at least 3"},
      {body({{1.0, 2.0}, {3.0, 3.0}, {5.0, 4.0}}),
          "the polygon has no area: all its corners lie on a line in the box from (1, 2) to (5, 4) m"},
      {body({{0.0, 0.0}, {2.0, 2.0}, {2.0, 0.0}, {0.0, 1.0}}),
          "the polygon crosses itself: its side from (0, 0) to (2, 2) m crosses its side from (2, 0) to (0, 1) m "
          "at (0.666667, 0.666667) m"},
      {body(ground, {box({7.0, 0.5}, {8.0, 1.0})}), "hole 1 lies outside its body: its corner (7, 0.5) m"},
      {body(notched, {box({1.0, 1.0}, {5.0, 1.5})}),
          HasSubstr("hole 1 lies outside its body: it crosses the polygon at (")},
      {body(ground, {box({1.0, 0.5}, {3.0, 1.5}), box({2.0, 1.0}, {4.0, 1.8})}),
          AllOf(HasSubstr("hole 1 and hole 2 cross at ("), HasSubstr(") m"))},
      {body(ground, {box({1.0, 0.5}, {3.0, 1.5}), box({2.0, 1.0}, {2.5, 1.2})}),
          "hole 1 and hole 2 lie in each other at (2, 1) m"},
      {body(ground, {box({1.0, 0.5}, {2.0, 1.0}), {{3.0, 1.0}, {4.0, 1.0}}}),
          "hole 2 has 2 different corners from (3, 1) m; it needs at least 3"},
      {body({{0.0, 0.0}, {std::numeric_limits<Real>::quiet_NaN(), 1.0}, {2.0, 0.0}}),
          "the polygon has a corner that is not a number: (nan, 1)"},
      {{box({0.0, 0.0}, {1.0, 1.0}), {5, 5}, {}, {3, 4}}, "a body of whole cells has no polygon and no holes"},
  };
  for (const auto& [outline, found] : rows) EXPECT_THAT(check_outline(outline), ElementsAre(found));
}

}  // namespace body_outline_test
