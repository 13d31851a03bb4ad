#include "mpm/features/volume_gradient.hpp"

#include "support/blocks.hpp"
#include "support/meshes.hpp"

namespace volume_gradient_test {

/// Nine distorted cells; points in those that `soil` names, four in each.
struct Cells {
  Mesh<2> mesh = distorted_rectangle(3, 3, 1.0, 0.25, 9);
  PointBlocks<2> points{mesh.n_cells(), 0};
  std::vector<CornerSums<Quad4>> corners{9};
  std::vector<VolumeGradient<Quad4>> gradients{1};

  explicit Cells(const std::vector<Index>& soil)
  {
    Random random(2);
    for (const Index cell : soil)
      for (int k = 0; k < 4; ++k)
        add_point(mesh, cell,
            {.local = {random.between(-1.0, 1.0), random.between(-1.0, 0.2)}, .volume = random.between(0.05, 0.1)},
            points, k % 2);
    points.update_occupied();
  }
  CellGroup<Quad4> group(Index slot)
  {
    return {std::span(points.occupied()).subspan(slot, 1), mesh, points, std::span(corners).subspan(slot, 1), {}, {}};
  }
};

std::vector<Index> all_but(Index left_out)
{
  std::vector<Index> cells;
  for (Index cell = 0; cell < 9; ++cell)
    if (cell != left_out) cells.push_back(cell);
  return cells;
}

TEST(VolumeGradient, TheSurfaceIsWhereACellAroundACornerIsEmptyOrTheMeshEnds)
{
  Cells inside(all_but(-1));
  EXPECT_FALSE(is_at_surface(inside.group(4), 4));
  EXPECT_TRUE(is_at_surface(inside.group(3), 3));
  for (const Index empty : {0, 1, 5, 8}) {
    Cells cells(all_but(empty));
    EXPECT_TRUE(is_at_surface(cells.group(3), 4)) << empty;
    EXPECT_EQ(is_within_soil(cells.group(empty < 4 ? 3 : 4), Pack(0.0))[0], 0.0);
  }
  EXPECT_EQ(is_within_soil(inside.group(4), Pack(0.0))[0], 1.0);
  EXPECT_EQ(is_within_soil(inside.group(3), Pack(0.0))[0], 0.0);
  EXPECT_EQ(is_within_soil(inside.group(3), Pack(1.0))[0], 1.0);  // filled
}

/// Over the points of both materials, each with its own weight in the force.
TEST(VolumeGradient, IsTheMeanOverTheSoilOfACutCell)
{
  Cells cells({4});
  const CellGroup<Quad4> group = cells.group(0);
  GeometryLanes<Quad4> geometry = geometry_of(group);
  const Pack centre = geometry.centre_gradient[0][0];
  const std::array<Real, 2> weight{0.3, 0.7};
  set_volume_gradient(
      group, Pack(0.0),
      [&](const BlockLayer& layer) {
        return PerGauss<Quad4, Pack>{Pack(weight[layer.material]), Pack(0.0), Pack(0.0), Pack(0.0)};
      },
      geometry, cells.gradients[0]);
  PerCorner<Quad4, Vec<2>> expected{};
  for_each_block(cells.points, 4, [&](const PointBlock<2>& block, Index) {
    Real volume = 0.0;
    for (Index p = 0; p < block.n; ++p) volume += block.row(Rows::volume)[p];
    for (Index p = 0; p < block.n; ++p) {
      const PerDirection<Quad4, Pack> at{Pack(block.row(Rows::xi)[p]), Pack(block.row(Rows::xi + 1)[p])};
      const auto gradient = gradients_at(cells.mesh.geometry(4), at);
      for (int i = 0; i < 4; ++i)
        for (int d = 0; d < 2; ++d)
          expected[i][d] += weight[block.material] * block.row(Rows::volume)[p] / volume * gradient[i][d][0];
    }
  });
  for (int i = 0; i < 4; ++i)
    for (int d = 0; d < 2; ++d) {
      EXPECT_NEAR(geometry.centre_gradient[i][d][0], expected[i][d], 1e-14);
      EXPECT_EQ(cells.gradients[0][i][d][0], geometry.centre_gradient[i][d][0]);
    }
  EXPECT_GT(std::abs(geometry.centre_gradient[0][0][0] - centre[0]), 0.02);
}

/// So a rigid motion and a uniform strain are exact, whatever the soil fills.
TEST(VolumeGradient, IsExactForLinearFields)
{
  Cells cells({4});
  const CellGroup<Quad4> group = cells.group(0);
  GeometryLanes<Quad4> geometry = geometry_of(group);
  set_volume_gradient(
      group, Pack(0.0),
      [&](const BlockLayer&) {
        return PerGauss<Quad4, Pack>{Pack(1.0), Pack(0.0), Pack(0.0), Pack(0.0)};
      },
      geometry, cells.gradients[0]);
  for (int d = 0; d < 2; ++d)
    for (int e = 0; e < 2; ++e) {
      Real sum = 0.0;
      for (int i = 0; i < 4; ++i)
        sum += geometry.centre_gradient[i][d][0] * cells.mesh.nodes[cells.mesh.cells[4][i]][e];
      EXPECT_NEAR(sum, d == e ? 1.0 : 0.0, 1e-14);
    }
}

TEST(VolumeGradient, WithinTheSoilIsThatOfTheCentre)
{
  Cells cells({4});
  const CellGroup<Quad4> group = cells.group(0);
  GeometryLanes<Quad4> geometry = geometry_of(group);
  const Pack centre = geometry.centre_gradient[1][0];
  set_volume_gradient(
      group, Pack(1.0), [&](const BlockLayer&) { return PerGauss<Quad4, Pack>{}; }, geometry, cells.gradients[0]);
  EXPECT_EQ(geometry.centre_gradient[1][0][0], centre[0]);
  EXPECT_EQ(cells.gradients[0][1][0][0], centre[0]);
}

}  // namespace volume_gradient_test
