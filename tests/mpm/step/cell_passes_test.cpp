#include "mpm/step/cell_passes.hpp"
#include "support/blocks.hpp"

namespace cell_passes_test {

/// A mesh of 2 x 1 cells of 2 m x 1 m; points are put into cell 0.
struct TwoCells {
  Mesh<2> mesh = make_rectangle({0.0, 0.0}, {4.0, 1.0}, {2, 1});
  PointBlocks<2> points{2, 0};

  std::vector<Index> lanes_that_leave(Vec<2> du)
  {
    CornerVectors<Quad4> all;
    for (int d = 0; d < 2; ++d) all[d].fill(du[d]);
    std::vector<PointPlace> points_leaving;
    advance_points(mesh.geometry(0), mesh.centres[0], all, only_block(points, 0), 0, points_leaving);
    std::vector<Index> lanes;
    for (const auto& l : points_leaving) lanes.push_back(l.lane);
    return lanes;
  }
};

TEST(CellPasses, CornerValuesAreThoseOfTheCellsNodesTimesTheFactor)
{
  TwoCells cells;
  std::vector<NodeValues> node(6);
  for (int i = 0; i < 6; ++i) node[i].v = {1.0 + i, 10.0 + i};
  const CornerVectors<Quad4> values = corner_values(cells.mesh, node, 1, &NodeValues::v, 0.5);
  EXPECT_THAT(values[0], ElementsAre(1.0, 1.5, 3.0, 2.5));  // nodes 1, 2, 5, 4
  EXPECT_THAT(values[1], ElementsAre(5.5, 6.0, 7.5, 7.0));
}

TEST(CellPasses, PointsMoveWithTheShapeFunctions)
{
  TwoCells cells;
  add_point(cells.mesh, 0, {.local = {0.5, -0.5}}, cells.points);
  CornerVectors<Quad4> du{};
  du[0] = {0.0, 0.16, 0.0, 0.0};  // corner 1: N = 0.75 * 0.75
  du[1] = {0.0, 0.0, 0.0, 0.16};  // corner 3: N = 0.25 * 0.25
  std::vector<PointPlace> points_leaving;
  advance_points(cells.mesh.geometry(0), cells.mesh.centres[0], du, only_block(cells.points, 0), 0, points_leaving);
  const PointBlock<2>& block = only_block(cells.points, 0);
  EXPECT_NEAR(block.row(Rows::x)[0], 1.5 + 0.09, 1e-15);
  EXPECT_NEAR(block.row(Rows::x + 1)[0], 0.25 + 0.01, 1e-15);
  EXPECT_NEAR(block.row(Rows::xi)[0], 0.59, 1e-15);
  EXPECT_NEAR(block.row(Rows::xi + 1)[0], -0.48, 1e-15);
  EXPECT_TRUE(points_leaving.empty());
}

TEST(CellPasses, ACellIsHalfOpen)
{
  TwoCells cells;
  for (const Real xi : {-1.0, -0.75, 0.75, 0.875}) add_point(cells.mesh, 0, {.local = {xi, 0.0}}, cells.points);
  EXPECT_THAT(cells.lanes_that_leave({0.0, 0.0}), IsEmpty());         // xi = -1 belongs to the cell
  EXPECT_THAT(cells.lanes_that_leave({0.125, 0.0}), ElementsAre(3));  // xi = 1 does not
  EXPECT_THAT(cells.lanes_that_leave({-0.25, 0.0}), ElementsAre(0));
}

/// One cell, almost a triangle: its corner 2 is nearly straight.
Mesh<2> nearly_a_triangle()
{
  Mesh<2> mesh;
  mesh.nodes = {{0.0, 0.0}, {1.0, 0.0}, {0.502, 0.502}, {0.0, 1.0}};
  mesh.cells = {{0, 1, 2, 3}};
  connect(mesh);
  return mesh;
}

/// One point moved by du in such a cell; true if it is reported to have left.
bool leaves_triangle(Vec<2> local, Vec<2> du, Vec<2>& after, Vec<2>& x)
{
  const Mesh<2> mesh = nearly_a_triangle();
  PointBlocks<2> points{1, 0};
  add_point(mesh, 0, {.local = local}, points);
  CornerVectors<Quad4> all;
  for (int d = 0; d < 2; ++d) all[d].fill(du[d]);
  std::vector<PointPlace> points_leaving;
  const PointBlock<2>& block = only_block(points, 0);
  advance_points(mesh.geometry(0), mesh.centres[0], all, block, 0, points_leaving);
  after = {block.row(Rows::xi)[0], block.row(Rows::xi + 1)[0]};
  x = {block.row(Rows::x)[0], block.row(Rows::x + 1)[0]};
  return !points_leaving.empty();
}

TEST(CellPasses, BesideAnAlmostStraightCornerLocalCoordinatesFollowThePlace)
{
  for (const Vec<2> local : {Vec<2>{0.9, 0.9}, Vec<2>{0.97, 0.8}, Vec<2>{0.6, 0.95}})
    for (const Vec<2> du : {Vec<2>{-0.02, -0.02}, Vec<2>{-0.2, 0.1}, Vec<2>{0.1, -0.2}, Vec<2>{-1e-4, -2e-4}}) {
      Vec<2> after, x;
      ASSERT_FALSE(leaves_triangle(local, du, after, x));
      const Vec<2> back = place_in_cell(nearly_a_triangle(), 0, after);
      for (int d = 0; d < 2; ++d) EXPECT_NEAR(back[d], x[d], 1e-14);
    }
}

TEST(CellPasses, APlaceThatTheMapDoesNotReachHasLeft)
{
  for (const Vec<2> du :
      {Vec<2>{0.02, 0.02}, Vec<2>{0.1, 0.1}, Vec<2>{1.0, 1.0}, Vec<2>{0.3, -0.1}, Vec<2>{3.0, 0.0}}) {
    Vec<2> after, x;
    EXPECT_TRUE(leaves_triangle({0.97, 0.97}, du, after, x)) << du[0] << ' ' << du[1];
  }
}

TEST(CellPasses, PaddingNeverLeaves)
{
  TwoCells cells;
  for (int k = 0; k < 9; ++k) add_point(cells.mesh, 0, {.local = {0.0, 0.0}}, cells.points);
  EXPECT_THAT(cells.lanes_that_leave({5.0, 0.0}), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8));
}

}  // namespace cell_passes_test
