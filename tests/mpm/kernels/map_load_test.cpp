#include "mpm/kernels/map_load.hpp"
#include "mpm/mesh/mesh.hpp"
#include "support/blocks.hpp"
#include "support/meshes.hpp"

namespace map_load_test {

constexpr int row = Rows::state;

/// Force of one point that carries a width of 0.2 m under 5 kPa.
CornerVectors<Quad4> force_of(const Mesh<2>& mesh, Vec<2> local, Real size)
{
  PointBlocks<2> points(mesh.n_cells(), 1);
  add_point(mesh, 0, {.local = local, .volume = size * size, .state = {0.2}}, points);
  CornerVectors<Quad4> force{};
  map_load<Quad4>(only_block(points, 0), row, 5e3, mesh.geometry(0), mesh.centres[0], force);
  return force;
}

Real sum_of(const PerCorner<Quad4>& values) { return values[0] + values[1] + values[2] + values[3]; }

TEST(MapLoad, ActsHalfASizeAboveThePoint)
{
  const Mesh<2> mesh = make_rectangle({0.0, 0.0}, {1.0, 1.0}, {1, 1});
  const auto force = force_of(mesh, {0.0, -0.5}, 0.25);  // y = 0.25, top at 0.375
  EXPECT_NEAR(force[1][0], -1000.0 * 0.5 * 0.625, 1e-9);
  EXPECT_NEAR(force[1][3], -1000.0 * 0.5 * 0.375, 1e-9);
  EXPECT_EQ(force[0], PerCorner<Quad4>{});
}

TEST(MapLoad, ActsOnTheUpperSideWhereThePointLiesAtIt)
{
  const auto force = force_of(make_rectangle({0.0, 0.0}, {1.0, 1.0}, {1, 1}), {0.4, 0.9}, 0.25);
  EXPECT_EQ(force[1][0], 0.0);
  EXPECT_EQ(force[1][1], 0.0);
  EXPECT_NEAR(force[1][2], -700.0, 1e-9);
  EXPECT_NEAR(force[1][3], -300.0, 1e-9);
}

TEST(MapLoad, KeepsSumAndLineOfActionInCellsOfAnyShape)
{
  Random random(7);
  for (int trial = 0; trial < 50; ++trial) {
    Mesh<2> mesh;
    const auto corners = distorted_square(0.25, random);
    mesh.nodes.assign(corners.begin(), corners.end());
    mesh.cells = {{0, 1, 2, 3}};
    connect(mesh);
    const Vec<2> local{random.between(-0.9, 0.9), random.between(-0.9, 0.9)};
    const auto force = force_of(mesh, local, 0.2);
    EXPECT_NEAR(sum_of(force[1]), -1000.0, 1e-9);
    Real moment = 0.0;
    for (int i = 0; i < 4; ++i) moment += force[1][i] * corners[i][0];
    const bool cut = local[1] > 0.4 || std::abs(local[0]) > 0.6;  // there the line of a twisted cell is bent
    EXPECT_NEAR(moment / -1000.0, place_in_cell(mesh, 0, local)[0], cut ? 0.03 : 1e-12);
    for (int i = 0; i < 4; ++i) EXPECT_LE(force[1][i], 1e-9);
  }
}

TEST(MapLoad, PassesOverPointsThatCarryNone)
{
  const Mesh<2> mesh = make_rectangle({0.0, 0.0}, {1.0, 1.0}, {1, 1});
  PointBlocks<2> points(1, 1);
  for (int k = 0; k < 11; ++k) add_point(mesh, 0, {.local = {0.0, 0.5}, .volume = 0.01, .state = {0.0}}, points);
  CornerVectors<Quad4> force{};
  map_load<Quad4>(only_block(points, 0), row, 5e3, mesh.geometry(0), mesh.centres[0], force);
  EXPECT_EQ(force[1], PerCorner<Quad4>{});
}

}  // namespace map_load_test
