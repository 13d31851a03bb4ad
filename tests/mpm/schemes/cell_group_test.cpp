#include "mpm/schemes/cell_group.hpp"
#include "support/blocks.hpp"
#include "support/meshes.hpp"

namespace cell_group_test {

/// n cells of 1 m x 1 m side by side, or distorted ones, with room for one state variable.
struct Row {
  Mesh<2> mesh;
  PointBlocks<2> points;
  std::vector<CornerSums<Quad4>> corners;
  std::vector<Real> pressure;
  std::vector<GaussValues<Quad4, Pack>> gauss;

  explicit Row(Index n) : Row(make_rectangle({0.0, 0.0}, {static_cast<Real>(n), 1.0}, {n, 1})) {}
  explicit Row(Mesh<2> of) : mesh(std::move(of)), points(mesh.n_cells(), 1), corners(mesh.n_cells()), gauss(2) {}

  CellGroup<Quad4> group(Index first, Index n)
  {
    pressure.resize(points.n_blocks());
    return {std::span(points.occupied()).subspan(first, n), mesh, points, std::span(corners).subspan(first, n),
        pressure, gauss};
  }
};

/// Eqs. (1) to (4), as in a step.
void gather(Row& row, const MethodOptions& method, Index first = 0, Index n = 1)
{
  const CellGroup<Quad4> group = row.group(first, n);
  PerGauss<Quad4, Pack> volume = zero_packs<Quad4::n_gauss>();
  for_each_layer(group, [&](const BlockLayer& layer) {
    sum_layer(group, layer, group.gauss_of(layer));
    for (int g = 0; g < Quad4::n_gauss; ++g) volume[g] += group.gauss_of(layer).volume[g];
  });
  const GeometryLanes<Quad4> geometry = geometry_of(group);
  for_each_layer(group, [&](const BlockLayer& layer) {
    GaussValues<Quad4, Pack>& gauss = group.gauss_of(layer);
    set_weights(geometry, volume, method, gauss);
    divide_by_volume(gauss);
    smooth_pressure(gauss);
    add_internal_force(group, geometry, layer, gauss, method.b_bar);
  });
}

/// Internal force on the corners of a cell with eight points under one stress, every second one of material `other`.
CornerSums<Quad4> force_of_uniform_stress(Index other, const MethodOptions& method, Real volume)
{
  Row cell(1);
  int k = 0;
  for (const Real eta : {-0.7, -0.2, 0.3, 0.6})
    for (const Real xi : {-0.5, 0.4})
      add_point(cell.mesh, 0,
          {.local = {xi, eta}, .volume = volume * (1.0 + 0.1 * k), .sigma = {-3e3, -5e3, -4e3, 1e3}, .state = {0.01}},
          cell.points, k++ % 2 == 0 ? 0 : other);
  cell.points.update_occupied();
  gather(cell, method);
  return cell.corners[0];
}

TEST(CellGroup, TwoMaterialsUnderOneStressShareTheWeightOfTheirCell)
{
  for (const Real volume : {0.1, 0.04}) {  // filled, and part-filled
    const auto one = force_of_uniform_stress(0, {}, volume), two = force_of_uniform_stress(1, {}, volume);
    for (int d = 0; d < 2; ++d)
      for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(two.internal_force[d][i], one.internal_force[d][i], 1e-9);
        EXPECT_GT(std::abs(one.internal_force[d][i]), 100.0);
      }
  }
}

/// Eight distorted cells with points at random, of one material or two; the last has few.
Row eight_distorted_cells()
{
  Row row(distorted_rectangle(4, 2, 1.0, 0.3, 7));
  Random random(5);
  for (Index cell = 0; cell < 8; ++cell)
    for (int k = 0; k < (cell == 7 ? 2 : 11 + cell); ++k)
      add_point(row.mesh, cell,
          {.local = {random.between(-1.0, 1.0), random.between(-1.0, 1.0)},
              .volume = random.between(0.02, 0.1),
              .sigma = {random.between(-9e3, 0.0), random.between(-9e3, 0.0), random.between(-9e3, 0.0),
                  random.between(-2e3, 2e3)},
              .state = {random.between(0.0, 0.1)}},
          row.points, cell % 3 == 1 && k % 2 == 0 ? 1 : 0);
  row.points.update_occupied();
  return row;
}

TEST(CellGroup, ALaneKnowsNothingOfItsNeighbours)
{
  Row together = eight_distorted_cells(), alone = eight_distorted_cells();
  MethodOptions method;
  gather(together, method, 0, 8);
  GroupVectors<Quad4> du{};
  Random random(6);
  for (auto& cell : du)
    for (auto& direction : cell)
      for (Real& value : direction) value = random.between(-0.01, 0.01);
  const auto strain = strain_by_cell(strain_of_group(geometry_of(together.group(0, 8)), du, true));
  for (Index c = 0; c < 8; ++c) {
    gather(alone, method, c, 1);
    GroupVectors<Quad4> own{};
    own[0] = du[c];
    const auto own_strain = strain_by_cell(strain_of_group(geometry_of(alone.group(c, 1)), own, true));
    EXPECT_EQ(together.corners[c].internal_force, alone.corners[c].internal_force) << "cell " << c;
    EXPECT_EQ(strain[c].d_eps, own_strain[0].d_eps) << "cell " << c;
    EXPECT_EQ(strain[c].d_spin, own_strain[0].d_spin) << "cell " << c;
    EXPECT_GT(std::abs(together.corners[c].internal_force[0][0]), 1.0);
  }
}

TEST(CellGroup, GivesWhatOneCellInScalarsGives)
{
  Row row = eight_distorted_cells();
  const auto layer_of = [&](Index cell) {
    BlockLayer layer{0, 0, {}};
    layer.block.fill(-1);
    layer.block[cell] = row.points.first_block(cell);
    return layer;
  };
  MethodOptions method;
  gather(row, method, 0, 8);
  for (const Index c : {Index{0}, Index{5}, Index{6}}) {  // of one material
    GaussValues<Quad4> gauss{};
    CornerSums<Quad4> expected{};
    sum_over_sub_cells(only_block(row.points, c), gauss);
    set_weights(row.mesh.geometry(c), gauss.volume, method, gauss);
    divide_by_volume(gauss);
    smooth_pressure(gauss);
    add_internal_force(row.mesh.geometry(c), gauss, method.b_bar, expected);
    EXPECT_EQ(row.corners[c].internal_force, expected.internal_force) << "cell " << c;
    EXPECT_EQ(row.gauss[0].pressure[static_cast<int>(c)], gauss.pressure);
    for (int g = 0; g < 4; ++g) EXPECT_EQ(row.gauss[0].sigma[3][g][static_cast<int>(c)], gauss.sigma[3][g]);
    const auto sums = sum_row_over_sub_cells<Quad4>(only_block(row.points, c), Rows::state);
    const GaussRow<Quad4> lanes = sum_row(row.group(0, 8), layer_of(c), Rows::state);
    for (int g = 0; g < 4; ++g) EXPECT_EQ(lanes[g][static_cast<int>(c)], sums[g]);
  }
}

TEST(CellGroup, TwoBodiesOfOneMaterialHaveGaussValuesOfTheirOwn)
{
  Row cell(1);
  for (const Index body : {0, 1})
    add_point(cell.mesh, 0, {.volume = 0.5, .sigma = {body == 0 ? -3e3 : -7e3, 0.0, 0.0, 0.0}}, cell.points, 0, body);
  cell.points.update_occupied();
  MethodOptions method;
  gather(cell, method);
  const CellGroup<Quad4> group = cell.group(0, 1);
  std::vector<std::pair<Index, Index>> layers;
  for_each_layer(group, [&](const BlockLayer& layer) {
    layers.emplace_back(layer.material, layer.body);
    EXPECT_DOUBLE_EQ(group.gauss_of(layer).pressure[0], (layer.body == 0 ? -3e3 : -7e3) / 3.0);
  });
  EXPECT_THAT(layers, ElementsAre(std::pair(0, 0), std::pair(0, 1)));
}

TEST(CellGroup, LayersAreTheMaterialsInOrderWithTheCellsThatHoldThem)
{
  Row row(3);
  for (const auto& [cell, material] : {std::pair{0, 1}, {1, 0}, {1, 1}, {2, 0}})
    add_point(row.mesh, cell, {}, row.points, material);
  row.points.update_occupied();
  std::vector<std::pair<Index, std::vector<int>>> layers;
  for_each_layer(row.group(0, 3), [&](const BlockLayer& layer) {
    layers.push_back({layer.material, {}});
    for (int c = 0; c < pack_width; ++c) {
      if (layer.block[c] < 0) continue;
      layers.back().second.push_back(c);
      EXPECT_EQ(row.points.block(layer.block[c]).cell, c);
      EXPECT_EQ(row.points.block(layer.block[c]).material, layer.material);
    }
  });
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_THAT(layers[0], testing::Pair(0, ElementsAre(1, 2)));
  EXPECT_THAT(layers[1], testing::Pair(1, ElementsAre(0, 1)));
  EXPECT_FALSE(has_one_layer(row.group(0, 3)));
  EXPECT_TRUE(has_one_layer(row.group(2, 1)));
}

TEST(CellGroup, FetchingAheadChangesNothingAndEndsWithTheLastCell)
{
  Row row = eight_distorted_cells();
  CellGroup<Quad4> group = row.group(0, 7);
  group.prefetch_points = true;
  group.next_cell = 7;
  const PointBlock<2>& last = only_block(row.points, 7);
  const std::vector<Real> before(last.data, last.data + last.capacity * row.points.n_rows());
  for (int c = 0; c < group.n(); ++c) prefetch_next(group, c);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), last.data));
  group.next_cell = -1;
  prefetch_next(group, 6);
}

}  // namespace cell_group_test
