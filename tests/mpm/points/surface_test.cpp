#include "mpm/points/surface.hpp"
#include "support/blocks.hpp"
#include "support/random.hpp"

namespace surface_test {

const Mesh<2> mesh = make_rectangle({0.0, 0.0}, {4.0, 2.0}, {4, 2});

/// Points at these places in the mesh, of cells of 1 m.
PointBlocks<2> points_at(const std::vector<Vec<2>>& places)
{
  PointBlocks<2> points(mesh.n_cells(), 0);
  for (const Vec<2>& x : places) {
    const Location at = locate(mesh, x, 0);
    add_point(mesh, at.cell, {.local = at.local}, points);
  }
  points.update_occupied();
  return points;
}

TEST(Surface, IsTheHighestPointOfEachColumn)
{
  const auto heights =
      surface_heights(mesh, points_at({{0.2, 0.5}, {0.9, 1.25}, {2.5, 0.75}}), {.left = 0.0, .width = 1.0, .n = 4});
  EXPECT_THAT(heights, ElementsAre(1.25, -INFINITY, 0.75, -INFINITY));
}

TEST(Surface, LooksOnlyAtItsColumns)
{
  const auto heights =
      surface_heights(mesh, points_at({{0.25, 0.5}, {1.25, 0.5}, {3.5, 1.5}}), {.left = 1.0, .width = 0.5, .n = 2});
  EXPECT_THAT(heights, ElementsAre(0.5, -INFINITY));
}

TEST(Surface, APlaceOnAnEdgeBelongsToTheColumnOnItsRight)
{
  EXPECT_THAT(
      surface_heights(mesh, points_at({{1.0, 0.5}}), {.left = 0.0, .width = 1.0, .n = 2}), ElementsAre(-INFINITY, 0.5));
}

TEST(Surface, FrontAndLowestAreTheExtremesOfAllPoints)
{
  const auto points = points_at({{0.25, 0.5}, {3.25, 1.75}, {1.5, 0.125}});
  EXPECT_EQ(extent_in_x(mesh, points)[1], 3.25);
  EXPECT_EQ(lowest(points), 0.125);
}

TEST(Surface, IsThatOfAllPointsInWhateverOrderTheirCellsCome)
{
  Random random(5);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Vec<2>> places;
    for (int k = 0; k < 60; ++k) places.push_back({random.between(0.0, 4.0), random.between(0.0, 2.0)});
    const Columns columns{.left = 0.3, .width = 0.37, .n = 8};
    std::vector<Real> expected(8, -INFINITY);
    Real right = 0.0;
    const PointBlocks<2> points = points_at(places);
    for_each_point(points, [&](const PointBlock<2>& block, Index lane) {
      const Real x = block.row(0)[lane], column = (x - columns.left) / columns.width;
      right = std::max(right, x);
      if (column >= 0.0 && column < 8.0)
        expected[static_cast<std::size_t>(column)] =
            std::max(expected[static_cast<std::size_t>(column)], block.row(1)[lane]);
    });
    EXPECT_EQ(surface_heights(mesh, points, columns), expected);
    EXPECT_EQ(extent_in_x(mesh, points)[1], right);
  }
}

}  // namespace surface_test
