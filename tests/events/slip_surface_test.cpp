// The slip surface as a line, on soil that shears in a band drawn by hand.
#include "events/slip_surface.hpp"

#include "mesh/mesh.hpp"
#include "support/blocks.hpp"

#include <cmath>
#include <functional>

#include <gmock/gmock.h>

namespace terp {
namespace {

/// A block 8 m wide and 2 m high of cells of 0.25 m with one point each, whose strain grew by f(x).
struct Soil {
  Mesh<2> mesh = make_rectangle({0.0, 0.0}, {8.0, 2.0}, {32, 8});
  PointBlocks<2> points{mesh.n_cells(), 0};
  std::vector<float> growth;

  explicit Soil(const std::function<Real(Vec<2>)>& f)
  {
    for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
      test::add_point(mesh, cell, {.volume = 0.0625, .id = static_cast<Real>(cell)}, points);
      growth.push_back(static_cast<float>(f(mesh.centres[cell])));
    }
    points.update_occupied();
  }
};

const Columns columns{.left = 0.0, .width = 0.25, .n = 32};

TEST(SlipSurface, IsTheLowerEdgeOfTheBandThatShears)
{
  // A band 1 m high above the line y = x - 4, in 4 < x < 6.
  const Soil soil([](Vec<2> x) { return x[0] > 4.0 && x[0] < 6.0 && x[1] > x[0] - 4.0 && x[1] < x[0] - 3.0 ? 0.02 : 0.0; });
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

TEST(TotalGrowth, IsWeightedWithTheVolume)
{
  const Soil soil([](Vec<2> x) { return x[1] < 1.0 ? 0.5 : 0.0; });
  EXPECT_NEAR(total_growth(soil.points, soil.growth), 0.5 * 8.0, 1e-12);
}

}  // namespace
}  // namespace terp
