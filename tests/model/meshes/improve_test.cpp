#include "model/meshes/improve.hpp"
#include "support/meshes.hpp"

namespace improve_test {

Real worst(const Mesh<2>& mesh, const std::vector<Vec<2>>& nodes)
{
  Real least = 1e300;
  for (const auto& cell : mesh.cells) least = std::min(least, smallest_altitude(cell, nodes));
  return least;
}

/// Corners fixed, sides slide, the rest is free.
std::vector<Freedom> freedom_of_rectangle(Index nx, Index ny)
{
  std::vector<Freedom> freedom;
  for (Index j = 0; j <= ny; ++j)
    for (Index i = 0; i <= nx; ++i) {
      const bool x_side = i == 0 || i == nx, y_side = j == 0 || j == ny;
      freedom.push_back(x_side && y_side ? Freedom{0, {}}
                        : x_side         ? Freedom{1, {0.0, 1.0}}
                        : y_side         ? Freedom{1, {1.0, 0.0}}
                                         : Freedom{2, {}});
    }
  return freedom;
}

TEST(SmallestAltitude, IsTheLeastHeightOverASide)
{
  const std::vector<Vec<2>> nodes{{0, 0}, {4, 0}, {5, 3}, {0, 2}};
  EXPECT_NEAR(
      smallest_altitude({0, 1, 2, 3}, nodes), 10.0 / std::sqrt(26.0), 1e-15);  // of the origin over the upper side
  EXPECT_LT(smallest_altitude({0, 3, 2, 1}, nodes), 0.0);
}

TEST(EnlargeAltitudes, RepairsADistortedRectangle)
{
  const auto mesh = distorted_rectangle(12, 8, 0.1, 0.45, 5);
  auto nodes = mesh.nodes;
  enlarge_altitudes(mesh.cells, freedom_of_rectangle(12, 8), std::vector<Real>(mesh.cells.size(), 0.1), nodes);
  EXPECT_LT(worst(mesh, mesh.nodes), 0.05);
  EXPECT_GT(worst(mesh, nodes), 0.09);
}

TEST(EnlargeAltitudes, UntanglesInvertedCells)
{
  const auto mesh = distorted_rectangle(6, 6, 0.1, 0.0, 6);
  auto nodes = mesh.nodes;
  nodes[3 * 7 + 3] = {0.45, 0.48};  // beyond the far corner of its cell
  ASSERT_LT(worst(mesh, nodes), 0.0);
  enlarge_altitudes(mesh.cells, freedom_of_rectangle(6, 6), std::vector<Real>(mesh.cells.size(), 0.1), nodes);
  EXPECT_GT(worst(mesh, nodes), 0.08);
}

TEST(EnlargeAltitudes, LeavesSquaresAlone)
{
  const auto mesh = make_rectangle({0.0, 0.0}, {1.2, 0.8}, {12, 8});
  auto nodes = mesh.nodes;
  enlarge_altitudes(mesh.cells, freedom_of_rectangle(12, 8), std::vector<Real>(mesh.cells.size(), 0.1), nodes);
  EXPECT_EQ(nodes, mesh.nodes);
}

TEST(EnlargeAltitudes, MovesNodesOnlyAsFarAsTheyAreFree)
{
  const auto mesh = distorted_rectangle(5, 4, 0.1, 0.4, 7);
  auto freedom = freedom_of_rectangle(5, 4);
  freedom[1 * 6 + 2] = {0, {}};
  freedom[2 * 6 + 3] = {1, {0.6, 0.8}};
  auto nodes = mesh.nodes;
  enlarge_altitudes(mesh.cells, freedom, std::vector<Real>(mesh.cells.size(), 0.1), nodes);
  EXPECT_EQ(nodes[1 * 6 + 2], mesh.nodes[1 * 6 + 2]);
  const Vec<2> a = mesh.nodes[2 * 6 + 3], b = nodes[2 * 6 + 3];
  EXPECT_NE(a, b);
  EXPECT_NEAR((b[0] - a[0]) * 0.8 - (b[1] - a[1]) * 0.6, 0.0, 1e-15);
  for (const Index corner : {0, 5, 24, 29}) EXPECT_EQ(nodes[corner], mesh.nodes[corner]);
  for (Index i = 0; i <= 5; ++i) EXPECT_EQ(nodes[i][1], 0.0);
}

}  // namespace improve_test
