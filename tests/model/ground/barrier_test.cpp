#include "model/ground/barrier.hpp"
#include "model/meshes/structured.hpp"
#include "support/blocks.hpp"

namespace barrier_test {

constexpr Real size = 0.5;  // of a cell [m]
constexpr int n_x = 40, n_y = 12;
const Mesh<2> mesh = make_rectangle({0.0, 0.0}, {n_x * size, n_y* size}, {n_x, n_y});
const Columns columns{.left = 0.0, .width = size, .n = n_x};
constexpr Index soil = 0, water = 1;

/// A picture of soil: sixteen points in a cell; state 0 is eps_eq_p.
class Drawing {
 public:
  /// Fills what lies in a box; mark says which strain the points have.
  Drawing& box(Vec<2> low, Vec<2> high, Index material = soil, Real strain = 0.0)
  {
    constexpr int n = 4;
    const Real h = size / n;
    for (int i = 0; i < n_x * n; ++i)
      for (int j = 0; j < n_y * n; ++j) {
        const Vec<2> x{(i + 0.5) * h, (j + 0.5) * h};
        if (x[0] > low[0] && x[0] < high[0] && x[1] > low[1] && x[1] < high[1]) point(x, h * h, material, strain);
      }
    return *this;
  }
  Drawing& point(Vec<2> x, Real volume, Index material = soil, Real strain = 0.0)
  {
    const Location at = locate(mesh, x, 0);
    add_point(mesh, at.cell, {.local = at.local, .volume = volume, .state = {strain}}, points_, material);
    return *this;
  }
  StandingGround look(Real level)
  {
    points_.update_occupied();
    const std::vector<std::uint8_t> ground{1, 0};
    const std::vector<int> strain{Rows::state, -1};
    return look_at_ground(
        mesh, points_, {.columns = columns, .ground = ground, .strain = strain, .intact_below = 0.01, .level = level});
  }
  Barrier at(Real level, std::optional<Facing> river = std::nullopt)
  {
    const StandingGround ground = look(level);
    return find_barrier(ground, columns_of_barrier(ground, river));
  }

 private:
  PointBlocks<2> points_{mesh.n_cells(), 1};
};

/// Ground of 1 m over the whole width, and a dike of 3 m more between x = 8 and 12 m.
Drawing dike()
{
  Drawing drawing;
  drawing.box({0.0, 0.0}, {20.0, 1.0}).box({8.0, 1.0}, {12.0, 4.0});
  return drawing;
}

TEST(Barrier, IsTheHighestGroundAndAsWideAsItIsAtTheLevel)
{
  const Barrier barrier = dike().at(2.5);
  EXPECT_DOUBLE_EQ(barrier.height, 4.0);  // not that of the highest points, 3.94 m
  EXPECT_NEAR(barrier.width, 4.0, 0.51);  // its sides are between two columns
  EXPECT_DOUBLE_EQ(barrier.intact_width, barrier.width);
  EXPECT_EQ(dike().at(4.5).width, 0.0);
}

/// Ground of 1 m, on it a dike with slopes of 1:2 and a crest of 4 m at y = 4 m, from x = 8 m on.
Drawing sloped_dike()
{
  Drawing drawing;
  drawing.box({0.0, 0.0}, {20.0, 1.0});
  for (int k = 0; k < 30; ++k)  // 0.1 m each
    drawing.box({2.0 + 0.2 * k, 1.0 + 0.1 * k}, {18.0 - 0.2 * k, 1.1 + 0.1 * k});
  return drawing;
}

TEST(Barrier, HasRoomForAProfileOrNot)
{
  Drawing drawing = sloped_dike();
  const StandingGround ground = drawing.look(3.0);  // 8 m wide there, from x = 6 to 14 m
  const ColumnRange all = columns_of_barrier(ground, std::nullopt);
  const auto place = [&](Real width, Real slope) { return place_of_profile(ground, all, width, slope); };
  ASSERT_TRUE(place(7.0, 2.0));
  EXPECT_NEAR(*place(7.0, 2.0), 6.2, 0.3);
  EXPECT_FALSE(place(8.5, 2.0)) << "wider than the dike";
  EXPECT_TRUE(place(4.0, 3.0)) << "4 m of slopes of 1:3 end 6 m beyond, where the dike has left 2 m of 2 m";
  EXPECT_FALSE(place(5.0, 3.0));
  EXPECT_FALSE(place(7.0, 3.5));
}

TEST(Barrier, OfAHoleInTheDikeTheProfileGoesBesideIt)
{
  Drawing drawing;
  drawing.box({0.0, 0.0}, {20.0, 1.0}).box({2.0, 1.0}, {6.0, 4.0}).box({8.0, 1.0}, {15.0, 4.0});
  const StandingGround ground = drawing.look(2.0);
  const auto place = [&](Real width) {
    return place_of_profile(ground, columns_of_barrier(ground, std::nullopt), width, 1.0);
  };
  ASSERT_TRUE(place(1.5));
  EXPECT_NEAR(*place(1.5), 3.0, 0.6) << "1 m down by 1:1";
  ASSERT_TRUE(place(4.0));
  EXPECT_NEAR(*place(4.0), 9.0, 0.6) << "4 m do not fit in the first one";
  EXPECT_FALSE(place(6.5));
}

TEST(Barrier, IsNotHigherThanTheGroundWhereCellsLieAskew)  // by the shares of cells: 4.25 m
{
  const std::array<Vec<2>, 4> corner{{{0.0, -10.0}, {20.0, 10.0}, {0.0, 30.0}, {-20.0, 10.0}}};
  const Mesh<2> askew = make_mapped_rectangle(
      {{{corner[0], corner[1]}, {corner[1], corner[2]}, {corner[3], corner[2]}, {corner[0], corner[3]}}}, {56, 56},
      {1.0, 1.0});  // cells of 0.505 m, turned by 45 degrees
  PointBlocks<2> points(askew.n_cells(), 1);
  constexpr Real spacing = 0.1;
  for (int i = -60; i < 60; ++i)
    for (int j = -140; j < 40; ++j) {
      const Vec<2> x{(i + 0.5) * spacing, (j + 0.5) * spacing};
      if (std::abs(x[0]) > x[1] + 9.99) continue;  // below the mesh
      const Location at = locate(askew, x, 0);
      add_point(askew, at.cell, {.local = at.local, .volume = spacing * spacing, .state = {0.0}}, points, soil);
    }
  points.update_occupied();
  const std::vector<std::uint8_t> ground{1, 0};
  const StandingGround found = look_at_ground(
      askew, points, {.columns = {.left = -5.0, .width = size, .n = 20}, .ground = ground, .level = 3.0});
  EXPECT_NEAR(find_barrier(found, columns_of_barrier(found, std::nullopt)).height, 4.0, 1e-9);
}

TEST(Barrier, OfASlopeIsCutWhereTheLineBetweenColumnsMeetsTheLevel)
{
  Drawing drawing;  // steps of a cell: 0.5, 1, 1.5 ... 3 m to x = 3 m, and 3 m beyond
  for (int k = 0; k < n_x; ++k) drawing.box({k * size, 0.0}, {(k + 1) * size, size * std::min(k + 1, 6)});
  EXPECT_NEAR(drawing.at(2.0).width, 20.0 - (3.5 * size), 1e-9);   // the middle of the column of 2 m
  EXPECT_NEAR(drawing.at(2.25).width, 20.0 - (4.0 * size), 1e-9);  // half way to the next
}

TEST(Barrier, CountsAThinLayerByItsVolumeAndLooseSoilHardly)
{
  EXPECT_NEAR(dike().box({8.0, 4.0}, {12.0, 4.25}).at(2.5).height, 4.25, 1e-9);
  EXPECT_NEAR(dike().point({10.1, 4.4}, 1.0 / 64.0).at(2.5).height, 4.0 + size / 16.0, 1e-9);  // one point of sixteen
}

/// The dike, moved as a whole, with n x n points in a cell.
Drawing moved_dike(Vec<2> by, int n)
{
  const Real h = size / n;
  Drawing drawing;
  for (int i = 0; i < n_x * n; ++i)
    for (int j = 0; j < n_y * n; ++j) {
      const Vec<2> x{(i + 0.5) * h, (j + 0.5) * h};
      const bool is_dike = x[1] > 1.0 && x[1] < 4.0 && x[0] > 8.0 && x[0] < 12.0;
      if (is_dike) drawing.point({x[0] + by[0], x[1] + by[1]}, h * h);
      if (x[1] < 1.0 && (by[1] >= 0.0 || !is_dike)) drawing.point(x, h * h);
    }
  return drawing;
}

TEST(Barrier, SinksWithTheGroundAndNotByRowsOfPoints)  // by points of which each is in one cell: 0.12 m off
{
  for (const int n : {2, 3, 4})
    for (const Real sinks : {0.01, 0.05, 0.12, 0.2, 0.3, 0.37, 0.49, 0.6})
      for (const Real aside : {0.0, 0.1, -0.3}) {
        EXPECT_NEAR(moved_dike({aside, -sinks}, n).at(2.5).height, 4.0 - sinks, aside == 0.0 ? 1e-9 : 0.06)
            << n << " x " << n << " points, " << sinks << " m, " << aside << " m aside";
      }
}

TEST(Barrier, SoilThatAllShearedIsNotIntactWhateverTheShapeOfItsPoints)
{
  Drawing thin;  // slivers on full cells, at whose height the level is
  thin.box({0.0, 0.0}, {20.0, 3.0}, soil, 1.0);
  for (int i = 0; i < 4 * n_x; ++i) thin.point({(i + 0.5) * 0.125, 3.01}, 0.125 * 0.02, soil, 1.0);
  EXPECT_NEAR(thin.at(3.005).width, 20.0, 1e-9);
  EXPECT_NEAR(thin.at(3.005).intact_width, 0.0, 1e-9);
}

TEST(Barrier, OfALevelLayerIsExactWhateverTheShapeOfItsPoints)
{
  Drawing flat, thin;  // 2 x 4 points in a cell; a layer of 0.02 m on full cells
  for (int i = 0; i < 2 * n_x; ++i)
    for (int j = 0; j < 4 * 6; ++j) flat.point({(i + 0.5) * 0.25, (j + 0.5) * 0.125}, 0.25 * 0.125);
  EXPECT_NEAR(flat.at(1.0).height, 3.0, 1e-9);
  thin.box({0.0, 0.0}, {20.0, 3.0});
  for (int i = 0; i < 4 * n_x; ++i) thin.point({(i + 0.5) * 0.125, 3.01}, 0.125 * 0.02);
  EXPECT_NEAR(thin.at(1.0).height, 3.02, 1e-9);
}

TEST(Barrier, IsNoSoilInTheAir)
{
  EXPECT_DOUBLE_EQ(dike().box({9.0, 5.0}, {10.0, 5.5}).at(2.5).height, 4.0);
  EXPECT_DOUBLE_EQ(dike().box({9.0, 4.0}, {10.0, 5.0}).at(2.5).height, 5.0);  // this stands on it
}

TEST(Barrier, IsNoThreadOfPoints)
{
  Drawing drawing = dike();
  for (int k = 0; k < 10; ++k) drawing.point({10.1, 4.1 + 0.125 * k}, 1.0 / 64.0);  // a cell of it is a quarter full
  EXPECT_NEAR(drawing.at(2.5).height, 4.0 + size / 4.0, 1e-9);
  EXPECT_NEAR(dike().box({9.0, 4.0}, {9.25, 5.0}).at(2.5).height, 4.75, 1e-9);  // a wall of half a cell
}

TEST(Barrier, MayOverhang)  // water finds no way through a hollow that leads nowhere
{
  const Barrier barrier = dike().box({12.0, 3.5}, {14.0, 4.5}).at(3.75);
  EXPECT_DOUBLE_EQ(barrier.height, 4.5);
  EXPECT_NEAR(barrier.width, 6.0, 0.51);
}

TEST(Barrier, IsNeitherWaterNorALoad)
{
  Drawing drawing = dike();
  drawing.box({0.0, 1.0}, {8.0, 4.5}, water).box({9.0, 4.0}, {11.0, 5.0}, water);
  EXPECT_DOUBLE_EQ(drawing.at(2.5).height, 4.0);
  EXPECT_NEAR(drawing.at(2.5).width, 4.0, 0.51);
}

TEST(Barrier, IsWhatIsLeftBetweenTwoSlides)
{
  Drawing drawing;  // the crest of 4 m is cut from both sides to a wall between x = 9.5 and 10.5 m, 3.98 m high
  drawing.box({0.0, 0.0}, {20.0, 1.0}).box({6.0, 1.0}, {9.5, 2.0}).box({10.5, 1.0}, {14.0, 2.0});
  drawing.box({9.5, 1.0}, {10.5, 3.5});
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 4; ++j) drawing.point({9.5 + 0.125 * (i + 0.5), 3.5 + 0.12 * (j + 0.5)}, 0.125 * 0.12);
  EXPECT_NEAR(drawing.at(3.0).height, 3.98, 1e-9);
  EXPECT_NEAR(drawing.at(3.0).width, 1.0, 0.51);
}

TEST(Barrier, TheWidestStretchCounts)
{
  Drawing drawing = dike();
  drawing.box({15.0, 1.0}, {16.0, 3.0});
  EXPECT_NEAR(drawing.at(2.5).width, 4.0, 0.51);
}

TEST(Barrier, SoilThatShearedIsNotIntact)
{
  Drawing drawing;
  drawing.box({0.0, 0.0}, {20.0, 1.0}).box({8.0, 1.0}, {10.5, 4.0}).box({10.5, 1.0}, {12.0, 4.0}, soil, 0.02);
  EXPECT_NEAR(drawing.at(2.25).width - drawing.at(2.25).intact_width, 1.5, 0.26);  // the half step at its side
}

TEST(Barrier, HighLandBehindThePolderHoldsNoWater)
{
  Drawing drawing = dike();
  drawing.box({17.0, 1.0}, {20.0, 5.0});
  const StandingGround ground = drawing.look(3.0);
  const ColumnRange range = columns_of_barrier(ground, std::nullopt);
  EXPECT_EQ(range.first, 0);
  EXPECT_EQ(range.last, 34);
  EXPECT_DOUBLE_EQ(find_barrier(ground, range).height, 4.0);
  Drawing short_of_the_end;  // the soil ends before the mesh
  short_of_the_end.box({0.0, 0.0}, {18.0, 1.0}).box({8.0, 1.0}, {12.0, 4.0}).box({15.0, 1.0}, {18.0, 5.0});
  EXPECT_DOUBLE_EQ(short_of_the_end.at(3.0).height, 4.0);
  Drawing bank;  // high land alone is the barrier itself
  bank.box({0.0, 0.0}, {20.0, 1.0}).box({8.0, 1.0}, {20.0, 4.0});
  EXPECT_NEAR(bank.at(3.0).width, 12.0, 0.26);
  EXPECT_DOUBLE_EQ(bank.at(3.0).height, 4.0);
}

TEST(Barrier, AQuayAtTheRiversEndHoldsTheWaterThoughARidgeStandsBehind)
{
  Drawing drawing;
  drawing.box({0.0, 0.0}, {20.0, 1.0}).box({0.0, 1.0}, {7.0, 4.0}).box({15.0, 1.0}, {18.0, 5.0});
  EXPECT_NEAR(drawing.at(2.5, Facing::left).width, 7.0, 0.26);
  EXPECT_DOUBLE_EQ(drawing.at(2.5, Facing::left).height, 5.0);  // lower land lies behind the ridge, too
  drawing.box({18.0, 1.0}, {20.0, 5.0});                        // now it is high land
  EXPECT_DOUBLE_EQ(drawing.at(2.5, Facing::left).height, 4.0);
  EXPECT_NEAR(drawing.at(2.5, Facing::right).width, 5.0, 0.26);
}

TEST(Barrier, WithoutGroundIsNone)
{
  Drawing drawing;
  drawing.box({0.0, 0.0}, {20.0, 1.0}, water);
  EXPECT_EQ(drawing.at(0.5).height, -INFINITY);
  EXPECT_EQ(drawing.at(0.5).width, 0.0);
}

TEST(Barrier, OnSlantingCellsIsThatOfTheSameDrawing)
{
  std::vector<Vec<2>> nodes;  // cells of 0.5 m whose sides lean by a cell's height
  for (int j = 0; j <= 8; ++j)
    for (int i = 0; i <= 20; ++i) nodes.push_back({0.5 * i, 0.5 * j + 0.1 * i});
  const Mesh<2> leaning = make_grid(std::move(nodes), {20, 8});
  PointBlocks<2> points(leaning.n_cells(), 1);
  for (Index cell = 0; cell < 20 * 3; ++cell)  // three rows: the surface rises from 1.5 m to 3.5 m
    add_point(leaning, cell, {.local = {0.0, 0.0}, .volume = 0.25}, points);
  points.update_occupied();
  const StandingGround ground =
      look_at_ground(leaning, points, {.columns = {.left = 0.0, .width = 0.5, .n = 20}, .level = 2.5});
  for (int k = 0; k < 20; ++k) EXPECT_NEAR(ground.heights[k], 1.5 + 0.1 * (k + 0.5), 1e-9);
  EXPECT_NEAR(find_barrier(ground, {0, 20}).width, 5.0, 1e-9);
}

}  // namespace barrier_test
