#include "mpm/mesh/box_grid.hpp"
#include "support/random.hpp"

namespace box_grid_test {

bool holds(const BoundingBox& box, Vec<2> x)
{
  return x[0] >= box.low[0] && x[0] <= box.high[0] && x[1] >= box.low[1] && x[1] <= box.high[1];
}

std::vector<BoundingBox> random_boxes(Index n, Real largest, std::uint64_t seed)
{
  Random random(seed);
  std::vector<BoundingBox> boxes;
  for (Index k = 0; k < n; ++k) {
    const Vec<2> low{random.between(-3.0, 5.0), random.between(0.0, 1.0)};
    boxes.push_back({low, {low[0] + random.between(0.0, largest), low[1] + random.between(0.0, largest)}});
  }
  return boxes;
}

TEST(BoxGrid, NamesEveryBoxThatHoldsAPlaceInAscendingOrder)
{
  for (const Real largest : {0.0, 0.1, 3.0}) {
    const auto boxes = random_boxes(500, largest, 1);
    const BoxGrid grid = make_box_grid(boxes);
    Random random(2);
    for (int trial = 0; trial < 2000; ++trial) {
      const Vec<2> x = trial < 500 ? boxes[trial].high : Vec<2>{random.between(-4.0, 9.0), random.between(-1.0, 5.0)};
      const auto near = boxes_near(grid, x);
      ASSERT_TRUE(std::is_sorted(near.begin(), near.end()));
      for (Index k = 0; k < 500; ++k)
        ASSERT_TRUE(!holds(boxes[k], x) || std::binary_search(near.begin(), near.end(), k)) << k;
    }
  }
}

TEST(BoxGrid, AsksFewBoxesWhereTheyAreSmall)
{
  const auto boxes = random_boxes(10000, 0.03, 3);
  const BoxGrid grid = make_box_grid(boxes);
  for (const auto& box : boxes) EXPECT_LT(boxes_near(grid, box.low).size(), 30u);
}

TEST(BoxGrid, StaysSmallWhereEveryBoxIsLarge)
{
  const std::vector<BoundingBox> boxes(5000, BoundingBox{{0.0, 0.0}, {1.0, 1.0}});
  const BoxGrid grid = make_box_grid(boxes);
  EXPECT_LE(grid.boxes.size(), 16u * boxes.size());
  EXPECT_EQ(boxes_near(grid, {0.3, 0.9}).size(), boxes.size());
}

TEST(BoxGrid, IsEmptyWithoutBoxesAndForPlacesOutside)
{
  EXPECT_TRUE(boxes_near(make_box_grid({}), {0.0, 0.0}).empty());
  const BoxGrid grid = make_box_grid(random_boxes(10, 0.1, 4));
  const Real nan = std::numeric_limits<Real>::quiet_NaN(), infinity = std::numeric_limits<Real>::infinity();
  for (const Vec<2> x : {Vec<2>{-3.5, 0.5}, Vec<2>{0.0, 2.0}, Vec<2>{nan, 0.5}, Vec<2>{0.0, infinity}})
    EXPECT_TRUE(boxes_near(grid, x).empty());
}

TEST(BoxGrid, TakesBoxesOnALineAndAllAtOnePlace)
{
  const std::vector<BoundingBox> line{{{0.0, 2.0}, {1.0, 2.0}}, {{1.0, 2.0}, {2.0, 2.0}}};
  EXPECT_THAT(boxes_near(make_box_grid(line), {1.0, 2.0}), ElementsAre(0, 1));
  const std::vector<BoundingBox> place(3, BoundingBox{{1.0, 2.0}, {1.0, 2.0}});
  EXPECT_THAT(boxes_near(make_box_grid(place), {1.0, 2.0}), ElementsAre(0, 1, 2));
}

TEST(BoundingBox, SurroundsPlacesAndWidensByPartOfItsDiagonal)
{
  const BoundingBox box = box_around(std::array<Vec<2>, 3>{{{1.0, 5.0}, {4.0, 2.0}, {2.0, 6.0}}});
  EXPECT_THAT(box.low, ElementsAre(1.0, 2.0));
  EXPECT_THAT(box.high, ElementsAre(4.0, 6.0));
  const BoundingBox wide = widened(box, 0.1);
  EXPECT_THAT(wide.low, ElementsAre(DoubleEq(0.5), DoubleEq(1.5)));
  EXPECT_THAT(wide.high, ElementsAre(DoubleEq(4.5), DoubleEq(6.5)));
}

TEST(Line, IsAsFarAsItsNextPlaceOrItsNextEnd)
{
  EXPECT_DOUBLE_EQ(distance_to_line({1.0, 1.0}, {5.0, 4.0}, {6.0, 1.0}),
      3.0);  // beside it: the height of a triangle of sides 5, 3.16 on 5 m
  EXPECT_DOUBLE_EQ(distance_to_line({1.0, 1.0}, {5.0, 4.0}, {8.0, 8.0}), 5.0);  // beyond its end
  EXPECT_DOUBLE_EQ(distance_to_line({2.0, 1.0}, {2.0, 1.0}, {5.0, 5.0}), 5.0);  // a line of length zero
}

}  // namespace box_grid_test
