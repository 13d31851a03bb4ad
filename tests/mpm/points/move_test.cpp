#include "mpm/points/move.hpp"
#include "support/blocks.hpp"
#include "support/meshes.hpp"

namespace move_test {

OpenSides closed(const Mesh<2>& mesh) { return OpenSides(mesh.cells.size(), 0); }

/// One point in cell 5 of a 4 x 3 mesh (h = 0.25), then displaced without telling anybody.
struct OnePoint {
  Mesh<2> mesh;
  PointBlocks<2> points;
  Moved outcome;
  std::vector<Real> values;

  OnePoint(Mesh<2> m, Vec<2> x) : OnePoint(m, x, closed(m)) {}
  OnePoint(Mesh<2> m, Vec<2> x, const OpenSides& open)
      : mesh(std::move(m)), points(mesh.n_cells(), 1), values(points.n_rows())
  {
    add_point(mesh, 5,
        {.volume = 0.01, .mass = 20.0, .v = {1.0, -2.0}, .sigma = {4.0, 5.0, 6.0, 7.0}, .state = {0.03}, .id = 9},
        points, 2, 3);
    points.update_occupied();
    auto& block = only_block(points, 5);
    block.row(Rows::x)[0] = x[0];
    block.row(Rows::x + 1)[0] = x[1];
    outcome = move_to_new_cell(mesh, open, points, {points.first_block(5), 0}, values);
    points.update_occupied();
  }
  Index cell() const { return points.occupied().at(0); }
  Real row(int r) const { return points.block(points.first_block(cell())).row(r)[0]; }
};

Mesh<2> regular() { return make_rectangle({0.0, 0.0}, {1.0, 0.75}, {4, 3}); }

TEST(MoveToNewCell, TakesAPointOverASideWithAllItCarries)
{
  const OnePoint moved(regular(), {0.55, 0.3});
  EXPECT_EQ(moved.outcome, Moved::inside);
  EXPECT_THAT(moved.points.occupied(), ElementsAre(6));
  EXPECT_NEAR(moved.row(Rows::xi), -0.6, 1e-15);
  EXPECT_NEAR(moved.row(Rows::xi + 1), -0.6, 1e-15);
  EXPECT_EQ(moved.row(Rows::x), 0.55);
  EXPECT_EQ(moved.row(Rows::v + 1), -2.0);
  EXPECT_EQ(moved.row(Rows::mass), 20.0);
  EXPECT_EQ(moved.row(Rows::volume), 0.01);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(moved.row(Rows::sigma + k), 4.0 + k);
  EXPECT_EQ(moved.row(Rows::state), 0.03);
  EXPECT_EQ(moved.row(Rows::id), 9.0);
  EXPECT_TRUE(moved.points.block(moved.points.first_block(6)) == (BlockKey{6, 2, 3}));
}

TEST(MoveToNewCell, PutsAPointThatLeftTheMeshBackOnTheWallAndCountsIt)
{
  const OnePoint moved(regular(), {1.2, 0.3});
  EXPECT_EQ(moved.outcome, Moved::put_back);
  EXPECT_EQ(moved.cell(), 7);
  EXPECT_EQ(moved.row(Rows::x), 1.0);
  EXPECT_NEAR(moved.row(Rows::x + 1), 0.3, 1e-15);
  EXPECT_EQ(moved.row(Rows::xi), 1.0);
  EXPECT_EQ(moved.points.n_points(), 1);
  EXPECT_EQ(moved.row(Rows::mass), 20.0);
}

TEST(MoveToNewCell, PutsAPointThatLeftOverACornerBackOnIt)
{
  const OnePoint moved(regular(), {-0.1, 0.9});
  EXPECT_EQ(moved.outcome, Moved::put_back);
  EXPECT_EQ(moved.cell(), 8);
  EXPECT_EQ(moved.row(Rows::x), 0.0);
  EXPECT_EQ(moved.row(Rows::x + 1), 0.75);
}

TEST(MoveToNewCell, LeavesAPointThatRestsOnTheWallAlone)
{
  const OnePoint moved(regular(), {1.0, 0.3});
  EXPECT_EQ(moved.outcome, Moved::inside);
  EXPECT_EQ(moved.cell(), 7);
  EXPECT_EQ(moved.row(Rows::x), 1.0);
}

OpenSides open_on_the_right()
{
  auto open = closed(regular());
  for (const Index cell : {3, 7, 11}) open[cell] = 1u << 1;
  return open;
}

TEST(MoveToNewCell, LetsAPointLeaveOverAnOpenSideAndHandsItOver)
{
  const OnePoint moved(regular(), {1.2, 0.3}, open_on_the_right());
  EXPECT_EQ(moved.outcome, Moved::left);
  EXPECT_EQ(moved.points.n_points(), 0);
  EXPECT_TRUE(moved.points.occupied().empty());
  EXPECT_EQ(moved.values[Rows::x], 1.2);
  EXPECT_EQ(moved.values[Rows::mass], 20.0);
  EXPECT_EQ(moved.values[Rows::v + 1], -2.0);
  EXPECT_EQ(moved.values[Rows::id], 9.0);
}

TEST(MoveToNewCell, HoldsAPointAtTheWallsBesideAnOpenSide)
{
  for (const Vec<2> x : {Vec<2>{-0.1, 0.3}, Vec<2>{0.9, 0.8}, Vec<2>{0.9, -0.1}}) {
    const OnePoint moved(regular(), x, open_on_the_right());
    EXPECT_EQ(moved.outcome, Moved::put_back);
    EXPECT_EQ(moved.points.n_points(), 1);
    EXPECT_EQ(moved.values[Rows::id], 9.0) << "the id is named in every case";
  }
}

TEST(MoveToNewCell, KnowsEachSideOfACell)
{
  const Vec<2> beyond[] = {{0.4, -0.1}, {1.1, 0.4}, {0.4, 0.8}, {-0.1, 0.4}};
  for (int crossed = 0; crossed < 4; ++crossed)
    for (int side = 0; side < 4; ++side) {
      const OpenSides open(12, static_cast<std::uint8_t>(1u << side));
      EXPECT_EQ(OnePoint(regular(), beyond[crossed], open).outcome, crossed == side ? Moved::left : Moved::put_back);
    }
}

TEST(MoveToNewCell, FollowsAPointThroughDistortedCells)
{
  const auto mesh = distorted_rectangle(4, 3, 0.25, 0.3, 41);
  Random random(42);
  for (int k = 0; k < 500; ++k) {
    const Vec<2> x{random.between(-0.1, 1.1), random.between(-0.1, 0.85)};
    const bool outside = x[0] < 0.0 || x[0] > 1.0 || x[1] < 0.0 || x[1] > 0.75;
    const OnePoint moved(mesh, x);
    ASSERT_EQ(moved.outcome, outside ? Moved::put_back : Moved::inside);
    ASSERT_EQ(moved.points.n_points(), 1);
    const Vec<2> there = place_in_cell(mesh, moved.cell(), {moved.row(Rows::xi), moved.row(Rows::xi + 1)});
    for (int d = 0; d < 2; ++d)
      EXPECT_NEAR(there[d], moved.row(Rows::x + d), 1e-15) << "local coordinates and place disagree";
    const Vec<2> nearest{std::clamp(x[0], 0.0, 1.0), std::clamp(x[1], 0.0, 0.75)};
    EXPECT_LT(std::hypot(there[0] - nearest[0], there[1] - nearest[1]), outside ? 0.1 : 1e-15)
        << "from " << x[0] << ", " << x[1];
  }
}

TEST(MoveToNewCell, KeepsTheMassOfAThousandWanderers)
{
  const auto mesh = distorted_rectangle(8, 6, 0.25, 0.3, 43);
  PointBlocks<2> points(mesh.n_cells(), 1);
  Random random(44);
  for (int id = 0; id < 1000; ++id)
    add_point(mesh, random.below(mesh.n_cells()),
        {.local = {random.between(-1.0, 1.0), random.between(-1.0, 1.0)}, .mass = 1.0 + id, .id = 1.0 * id}, points,
        id % 2);
  points.update_occupied();
  std::vector<Real> scratch(points.n_rows());
  int put_back = 0;
  for (int round = 0; round < 20; ++round) {
    std::vector<std::pair<Index, Index>> all;
    for (const Index cell : points.occupied())
      for_each_block(points, cell, [&](const PointBlock<2>& block, Index b) {
        for (Index lane = block.n - 1; lane >= 0; --lane) {  // from the last: a taken lane is filled from behind
          for (int d = 0; d < 2; ++d) block.row(Rows::x + d)[lane] += random.between(-0.15, 0.15);
          all.emplace_back(b, lane);
        }
      });
    for (const auto& [b, lane] : all)
      put_back += move_to_new_cell(mesh, closed(mesh), points, {b, lane}, scratch) == Moved::put_back;
    points.update_occupied();
  }
  Real mass = 0.0;
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) {
    mass += block.row(Rows::mass)[lane];
    const Vec<2> back = place_in_cell(mesh, block.cell, {block.row(Rows::xi)[lane], block.row(Rows::xi + 1)[lane]});
    EXPECT_NEAR(back[0], block.row(Rows::x)[lane], 1e-14);
    EXPECT_EQ(block.material, static_cast<Index>(block.row(Rows::id)[lane]) % 2);
  });
  EXPECT_EQ(points.n_points(), 1000);
  EXPECT_EQ(mass, 1000.0 * 1001.0 / 2.0);
  EXPECT_GT(put_back, 0);
}

}  // namespace move_test
