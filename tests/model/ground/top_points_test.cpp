#include "model/ground/top_points.hpp"
#include "support/blocks.hpp"

namespace top_points_test {

/// Points at given places, all of one cell that holds them.
PointBlocks<2> points_at(const Mesh<2>& mesh, const std::vector<Vec<2>>& places, Real size)
{
  PointBlocks<2> points(mesh.n_cells(), 0);
  for (const Vec<2>& x : places) {
    PointValues p;
    p.local = {x[0] / 5.0 - 1.0, x[1] / 5.0 - 1.0};  // of a cell of 10 m x 10 m
    p.volume = size * size;
    p.id = static_cast<Real>(points.n_points());
    add_point(mesh, 0, p, points);
  }
  points.update_occupied();
  return points;
}

/// A lattice below a surface; columns lean by `lean` per height.
std::vector<Vec<2>> lattice(Real dx, Real dy, Real lean, const std::function<Real(Real)>& surface)
{
  std::vector<Vec<2>> places;
  for (int i = -40; i < 80; ++i)
    for (int j = 0; j < 60; ++j)
      if (const Vec<2> x{1.0 + (i + 0.5) * dx + lean * j * dy, 1.0 + (j + 0.5) * dy};
          x[0] > 1.0 && x[0] < 7.0 && x[1] < surface(x[0]))
        places.push_back(x);
  return places;
}

/// Largest depth of a top point below the surface, over the distance of rows.
Real deepest(Real dx, Real dy, Real lean, const std::function<Real(Real)>& surface)
{
  const Mesh<2> mesh = make_rectangle({0.0, 0.0}, {10.0, 10.0}, {1, 1});
  const auto tops = find_top_points(points_at(mesh, lattice(dx, dy, lean, surface), std::sqrt(dx * dy)), 2.0, 6.0);
  Real most = 0.0, gap = 0.0;
  for (std::size_t k = 0; k < tops.size(); ++k) {
    most = std::max(most, (surface(tops[k].x[0]) - tops[k].x[1]) / dy);
    if (k > 0) gap = std::max(gap, tops[k].x[0] - tops[k - 1].x[0]);
  }
  EXPECT_LT(gap, 2.1 * dx);
  EXPECT_GT(tops.size(), 4.0 / dx * 0.6);
  return most;
}

TEST(TopPoints, AreTheUppermostRowOfALattice)
{
  const auto flat = [](Real) { return 4.0; };
  for (const auto& [dx, dy] : {std::pair(0.1, 0.1), std::pair(0.2, 0.1), std::pair(0.1, 0.2)})
    EXPECT_LT(deepest(dx, dy, 0.0, flat), 0.51) << dx;
}

TEST(TopPoints, DoNotLieDeepWhereColumnsLean)
{
  const auto flat = [](Real) { return 4.0; };
  for (const Real lean : {0.1, 0.35, 0.5, 1.0})
    for (const auto& [dx, dy] : {std::pair(0.1, 0.1), std::pair(0.2, 0.1)})
      EXPECT_LT(deepest(dx, dy, lean, flat), 1.6) << dx << ' ' << lean;
}

TEST(TopPoints, FollowASlope)
{
  for (const Real slope : {-1.0, -0.5, 1.0 / 3.0, 1.0})
    EXPECT_LT(deepest(0.1, 0.1, 0.0, [&](Real x) { return 4.0 + slope * (x - 4.0); }), 2.1) << slope;
}

TEST(TopPoints, OfAStepAreThoseOfBothLevels)
{
  EXPECT_LT(deepest(0.1, 0.1, 0.0, [](Real x) { return x < 4.0 ? 4.0 : 2.0; }), 0.51);
}

TEST(TopPoints, AreSortedAndWithinTheStretch)
{
  const Mesh<2> mesh = make_rectangle({0.0, 0.0}, {10.0, 10.0}, {1, 1});
  const auto points = points_at(mesh, {{5.0, 2.0}, {3.0, 2.0}, {4.0, 2.5}, {4.05, 2.2}, {8.0, 1.0}}, 0.5);
  const auto tops = find_top_points(points, 2.0, 6.0);
  ASSERT_EQ(tops.size(), 3u);
  EXPECT_EQ(tops[0].x[0], 3.0);
  EXPECT_EQ(tops[1].x[1], 2.5);
  EXPECT_EQ(tops[2].x[0], 5.0);
  EXPECT_TRUE(find_top_points(points, 9.0, 9.5).empty());
}

}  // namespace top_points_test
