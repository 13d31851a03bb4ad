#include "run/measure/slip_surface.hpp"
#include "support/blocks.hpp"
#include <functional>

namespace slip_surface_test {

/// A block 8 m wide and 2 m high of cells of 0.25 m with one point each, whose strain grew by f(x).
struct Soil {
  Mesh<2> mesh = make_rectangle({0.0, 0.0}, {8.0, 2.0}, {32, 8});
  PointBlocks<2> points{mesh.n_cells(), 0};
  std::vector<float> growth;

  explicit Soil(const std::function<Real(Vec<2>)>& f)
  {
    for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
      add_point(mesh, cell, {.volume = 0.0625, .id = static_cast<Real>(cell)}, points);
      growth.push_back(static_cast<float>(f(mesh.centres[cell])));
    }
    points.update_occupied();
  }
};

const Columns columns{.left = 0.0, .width = 0.25, .n = 32};

TEST(SlipSurface, IsTheLowerEdgeOfTheBandThatShears)
{
  // A band 1 m high above the line y = x - 4, in 4 < x < 6.
  const Soil soil(
      [](Vec<2> x) { return x[0] > 4.0 && x[0] < 6.0 && x[1] > x[0] - 4.0 && x[1] < x[0] - 3.0 ? 0.02 : 0.0; });
  const auto line = find_slip_line(soil.points, soil.growth, columns);
  ASSERT_EQ(line.size(), 7);
  for (const Vec<2>& x : line) EXPECT_NEAR(x[1], x[0] - 3.75, 1e-12);  // the lowest point above the line
  EXPECT_NEAR(line.front()[0], 4.125, 1e-12);
  EXPECT_NEAR(line.back()[0], 5.625, 1e-12);
}

TEST(SlipSurface, LooksPastSlowShearBelowAFastBand)
{
  const Soil soil([](Vec<2> x) { return x[1] > 1.0 && x[1] < 1.25 ? 0.02 : 0.004; });
  for (const Vec<2>& x : find_slip_line(soil.points, soil.growth, columns)) EXPECT_EQ(x[1], 1.125);
}

TEST(SlipSurface, LeavesOutColumnsThatHardlyShear)
{
  const Soil soil([](Vec<2> x) { return x[0] < 2.0 ? 0.02 : 0.0019; });
  EXPECT_EQ(find_slip_line(soil.points, soil.growth, columns).size(), 8);
  const Soil still([](Vec<2>) { return 0.0; });
  EXPECT_TRUE(find_slip_line(still.points, still.growth, columns).empty());
}

TEST(SlipSurface, OfASlopeIsThePartBelowGroundThatGoesItsWay)
{
  Soil soil([](Vec<2> x) { return x[1] > 0.5 ? 0.02 : 0.0; });
  for_each_point(soil.points, [](const PointBlock<2>& block,
                                  Index lane) {  // parts at x = 3 m; what lies below the band
    const Real x = block.row(Rows::x)[lane], y = block.row(Rows::x + 1)[lane];  // moves the other way
    block.row(Rows::v)[lane] = (y > 0.5 ? 1.0 : -5.0) * (x > 3.0 && std::abs(x - 7.0) > 0.2 ? 1.0 : -1.0);
  });
  const auto line = find_slip_line(soil.points, soil.growth, columns);
  ASSERT_EQ(line.size(), 32);
  const auto part = [&](Facing facing) { return part_below_motion(line, soil.points, {}, columns, facing); };
  EXPECT_EQ(part(Facing::right).front()[0], 3.125);
  EXPECT_EQ(part(Facing::right).back()[0], 6.625);  // the longest part
  EXPECT_EQ(part(Facing::left).front()[0], 0.125);
  EXPECT_EQ(part(Facing::left).back()[0], 2.875);
}

TEST(MeanOverNodes, KeepsWhatIsLinearAndErasesACheckerboard)
{
  const Soil linear([](Vec<2> x) { return 0.01 * x[0] + 0.02 * x[1]; });
  const auto smooth = mean_over_nodes(linear.mesh, linear.points, linear.growth);
  const Soil board([](Vec<2> x) {
    return 0.01 + ((std::lround(4.0 * x[0] - 0.5) + std::lround(4.0 * x[1] - 0.5)) % 2 == 0 ? 0.01 : -0.01);
  });
  const auto even = mean_over_nodes(board.mesh, board.points, board.growth);
  for (Index cell = 0; cell < linear.mesh.n_cells(); ++cell) {
    const Vec<2> x = linear.mesh.centres[cell];
    if (x[0] < 0.25 || x[0] > 7.75 || x[1] < 0.25 || x[1] > 1.75) continue;  // beside a wall nodes have two cells
    EXPECT_NEAR(smooth[static_cast<std::size_t>(cell)], 0.01 * x[0] + 0.02 * x[1], 1e-6);
    EXPECT_NEAR(even[static_cast<std::size_t>(cell)], 0.01, 1e-6);
  }
}

TEST(SlipSurface, OfABandThatAlternatesFromCellToCellIsStraightOverTheNodes)
{
  // A level band 1 m high, in every second cell only, as on a board of chess.
  const Soil soil([](Vec<2> x) {
    const bool band = x[1] > 0.5 && x[1] < 1.5;
    return band && (std::lround(4.0 * x[0] - 0.5) + std::lround(4.0 * x[1] - 0.5)) % 2 == 0 ? 0.04 : 0.0;
  });
  const auto kinks = [](const std::vector<Vec<2>>& line) {
    Real sum = 0.0;
    for (std::size_t k = 2; k < line.size(); ++k) sum += std::abs(line[k][1] - 2.0 * line[k - 1][1] + line[k - 2][1]);
    return sum;
  };
  const Real before = kinks(find_slip_line(soil.points, soil.growth, columns));
  const Real after = kinks(find_slip_line(soil.points, mean_over_nodes(soil.mesh, soil.points, soil.growth), columns));
  EXPECT_NEAR(before, 30 * 0.5, 1e-9);  // up and down by a cell in each column
  EXPECT_NEAR(after, 0.0, 1e-9);
}

}  // namespace slip_surface_test
