// The helpers that schemes share: rotation, sums over padded blocks, ties, and two materials in one cell.
#include "schemes/cell_view.hpp"

#include "mesh/mesh.hpp"
#include "support/blocks.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace terp {
namespace {

using test::add_point;
using Rows = PointRows<2>;

TEST(RotateStress, IsARotationToFirstOrder)
{
  const Real w = 1e-5;  // counter-clockwise
  SymTensor<Real, 2> sigma{{-300.0, 120.0, 55.0, 70.0}};
  rotate_stress(sigma, w);
  const Real c = std::cos(w), s = std::sin(w);  // R sigma R^T with R = (c -s; s c)
  EXPECT_NEAR(sigma[0], c * c * -300.0 - 2.0 * s * c * 70.0 + s * s * 120.0, 1e-7);
  EXPECT_NEAR(sigma[1], s * s * -300.0 + 2.0 * s * c * 70.0 + c * c * 120.0, 1e-7);
  EXPECT_NEAR(sigma[3], s * c * (-300.0 - 120.0) + (c * c - s * s) * 70.0, 1e-7);
  EXPECT_EQ(sigma[2], 55.0);
}

/// One cell of 1 m x 1 m with room for one state variable.
struct OneCell {
  Mesh<2> mesh = make_rectangle({0.0, 0.0}, {1.0, 1.0}, {1, 1});
  PointBlocks<2> points{1, 1};
  PointBlock<2>& block() { return test::only_block(points, 0); }
};

TEST(CellView, TiesGoToTheRightAndUpperSubCell)
{
  OneCell cell;
  for (const Real xi : {-2e-9, -0.5e-9, 0.0, 0.5e-9}) add_point(cell.mesh, 0, {.local = {xi, -xi}}, cell.points);
  EXPECT_EQ(to_bits(right_half(cell.block(), 0)) & 0xf, 0b1110u);
  EXPECT_EQ(to_bits(upper_half(cell.block(), 0)) & 0xf, 0b1111u);
}

TEST(CellView, PaddingAddsNothingToThePlasticWork)
{
  OneCell cell;
  for (int k = 0; k < 3; ++k) add_point(cell.mesh, 0, {.volume = 0.1 * (k + 1)}, cell.points);
  StripArrays strip;
  for (Real& work : strip.plastic_work) work = 7.0;
  EXPECT_DOUBLE_EQ(sum_plastic_work(cell.block(), 0, cell.block().n_padded(), strip), 7.0 * 0.6);
}

TEST(CellView, StrainIsAddedUpAndChangesTheVolumeByItsTrace)
{
  OneCell cell;
  add_point(cell.mesh, 0, {.volume = 0.2}, cell.points);
  const SymTensor<Pack, 2> d_eps{{Pack(0.01), Pack(-0.03), Pack(0.005), Pack(0.02)}};
  for (int step = 0; step < 2; ++step) scale_volume(cell.block(), 0, accumulate_strain(cell.block(), 0, d_eps));
  EXPECT_DOUBLE_EQ(cell.block().row(Rows::strain + 1)[0], -0.06);
  EXPECT_DOUBLE_EQ(cell.block().row(Rows::strain + 3)[0], 0.04);
  EXPECT_DOUBLE_EQ(cell.block().row(Rows::volume)[0], 0.2 * (1.0 - 0.015) * (1.0 - 0.015));
}

std::vector<SoilMaterial> two_names_of_one_soil()
{
  const MaterialType* type = find_material("tresca_softening");
  const std::vector<Real> values{2.0e6, 0.4, 8.0e3, 2.0e3, 50.0};
  std::vector<SoilMaterial> materials;
  for (const char* name : {"upper", "lower"}) materials.push_back({name, type, type->make(values), 1990.0});
  return materials;
}

/// Internal force on the corners of a cell with eight points under one stress, every second one of material `other`.
CornerSums<2> force_of_uniform_stress(Index other, const MethodOptions& method, Real volume)
{
  OneCell cell;
  int k = 0;
  for (const Real eta : {-0.7, -0.2, 0.3, 0.6})
    for (const Real xi : {-0.5, 0.4})
      add_point(cell.mesh, 0, {.local = {xi, eta}, .volume = volume * (1.0 + 0.1 * k), .sigma = {-3e3, -5e3, -4e3, 1e3}, .state = {0.01}},
                cell.points, k++ % 2 == 0 ? 0 : other);
  cell.points.update_occupied();
  const auto materials = two_names_of_one_soil();
  std::vector<GaussValues<2>> gauss(cell.points.n_blocks());
  CornerSums<2> corners{};
  gather_at_gauss_points({method, materials}, {0, cell.mesh.geometry(0), cell.points, gauss, {}, corners}, [&](Index b) -> GaussValues<2>& { return gauss[b]; },
                         [](const auto&) { return 1; }, [](const auto&, auto&) {});
  return corners;
}

TEST(CellView, TwoMaterialsUnderOneStressShareTheWeightOfTheirCell)
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

/// Whether the pressure of a cell with one point under tension is cut, and the largest force it then gives.
std::pair<bool, Real> cut_tension(Real limit, Real volume)
{
  OneCell cell;
  add_point(cell.mesh, 0, {.local = {0.3, 0.3}, .volume = volume, .sigma = {5e3, 5e3, 5e3, 0.0}, .state = {0.0}}, cell.points);
  cell.points.update_occupied();
  const auto materials = two_names_of_one_soil();
  MethodOptions method;
  method.tension_limit = limit;
  std::vector<GaussValues<2>> gauss(cell.points.n_blocks());
  CornerSums<2> corners{};
  const bool cut = gather_at_gauss_points({method, materials}, {0, cell.mesh.geometry(0), cell.points, gauss, {}, corners}, [&](Index b) -> GaussValues<2>& { return gauss[b]; },
                                          [](const auto&) { return 0; }, [](const auto&, auto&) {});
  return {cut, corners.internal_force[0][1]};
}

TEST(CellView, TensionIsCutInPartFilledCellsOnlyAndOnlyBeyondTheLimit)
{
  const auto [free_cut, free_force] = cut_tension(INFINITY, 0.25);
  EXPECT_FALSE(free_cut);
  const auto [cut, force] = cut_tension(1e3, 0.25);
  EXPECT_TRUE(cut);
  EXPECT_NEAR(force, free_force / 5.0, 1e-12 * free_force);
  EXPECT_FALSE(cut_tension(6e3, 0.25).first);
  EXPECT_FALSE(cut_tension(1e3, 1.0).first);
}

}  // namespace
}  // namespace terp
