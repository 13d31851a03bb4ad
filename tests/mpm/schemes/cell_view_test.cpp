#include "mpm/schemes/cell_view.hpp"
#include "support/blocks.hpp"

namespace cell_view_test {

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
  PointBlock<2>& block() { return only_block(points, 0); }
};

TEST(CellView, TiesGoToTheRightAndUpperSubCell)
{
  OneCell cell;
  for (const Real xi : {-2e-9, -0.5e-9, 0.0, 0.5e-9}) add_point(cell.mesh, 0, {.local = {xi, -xi}}, cell.points);
  const auto upper = upper_halves<Quad4>(cell.block(), 0);
  EXPECT_EQ(to_bits(upper[0]) & 0xf, 0b1110u);
  EXPECT_EQ(to_bits(upper[1]) & 0xf, 0b1111u);
}

TEST(CellView, PaddingAddsNothingToThePlasticWork)
{
  OneCell cell;
  for (int k = 0; k < 3; ++k) add_point(cell.mesh, 0, {.volume = 0.1 * (k + 1)}, cell.points);
  StripArrays<2> strip;
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

}  // namespace cell_view_test
