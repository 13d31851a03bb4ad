#include "mpm/kernels/point_gradients.hpp"
#include "support/blocks.hpp"
#include "support/meshes.hpp"

namespace point_gradients_test {

Mesh<2> one_cell(const std::array<Vec<2>, 4>& corners)
{
  Mesh<2> mesh;
  mesh.nodes.assign(corners.begin(), corners.end());
  mesh.cells = {{0, 1, 2, 3}};
  connect(mesh);
  return mesh;
}

TEST(GradientsAt, AgreeWithTheCellsOwnAtGaussPointsAndCentre)
{
  Random random(91);
  const auto cell = make_cell_geometry<Quad4>(distorted_square(0.3, random));
  for (int g = 0; g < 4; ++g) {
    const auto gradient = gradients_at(cell, {Pack(Quad4::gauss_place(g)[0]), Pack(Quad4::gauss_place(g)[1])});
    for (int i = 0; i < 4; ++i)
      for (int d = 0; d < 2; ++d) EXPECT_NEAR(gradient[i][d][3], cell.gradient[i][d][g], 1e-13);
  }
  const auto centre = gradients_at(cell, {Pack(0.0), Pack(0.0)});
  for (int i = 0; i < 4; ++i)
    for (int d = 0; d < 2; ++d) EXPECT_NEAR(centre[i][d][0], cell.centre_gradient[i][d], 1e-13);
}

TEST(GradientsAt, InARectangleAreThoseOfTheHandCalculation)
{
  const auto cell = make_cell_geometry<Quad4>({{{0.0, 0.0}, {2.0, 0.0}, {2.0, 0.5}, {0.0, 0.5}}});
  const auto gradient = gradients_at(cell, {Pack(0.6), Pack(-0.2)});
  EXPECT_DOUBLE_EQ(gradient[2][0][0], 0.25 * 0.8 / 1.0);   // dN/dxi over half the width
  EXPECT_DOUBLE_EQ(gradient[2][1][0], 0.25 * 1.6 / 0.25);  // dN/deta over half the height
}

TEST(DisplacementGradient, IsExactForALinearField)
{
  Random random(92);
  const auto corners = distorted_square(0.3, random);
  const auto cell = make_cell_geometry<Quad4>(corners);
  CornerVectors<Quad4> du;
  for (int i = 0; i < 4; ++i) {
    du[0][i] = 1e-3 * corners[i][0] + 4e-3 * corners[i][1];
    du[1][i] = -2e-3 * corners[i][0] + 5e-3 * corners[i][1];
  }
  const auto l = displacement_gradient(gradients_at(cell, {Pack(0.3), Pack(-0.8)}), du);
  EXPECT_NEAR(l[0][0][4], 1e-3, 1e-15);
  EXPECT_NEAR(l[0][1][4], 4e-3, 1e-15);
  EXPECT_NEAR(l[1][0][4], -2e-3, 1e-15);
  EXPECT_NEAR(l[1][1][4], 5e-3, 1e-15);
}

TEST(InternalForceOfPoints, IsTheSumOfBTransposedTimesStressTimesVolume)
{
  Random random(93);
  const auto mesh = one_cell(distorted_square(0.3, random));
  PointBlocks<2> points(1, 0);
  CornerSums<Quad4> expected{}, sums{};
  sums.internal_force[0][1] = expected.internal_force[0][1] = 5.0;  // it adds to what is there
  for (int k = 0; k < 11; ++k) {
    PointValues point{
        .local = {random.between(-1.0, 1.0), random.between(-1.0, 1.0)}, .volume = random.between(0.01, 0.1)};
    for (Real& s : point.sigma) s = random.between(-1e4, 1e4);
    add_point(mesh, 0, point, points);
    const auto gradient = gradients_at(mesh.geometry(0), {Pack(point.local[0]), Pack(point.local[1])});
    for (int i = 0; i < 4; ++i) {
      const Real gx = gradient[i][0][0], gy = gradient[i][1][0];
      expected.internal_force[0][i] += point.volume * (point.sigma[0] * gx + point.sigma[3] * gy);
      expected.internal_force[1][i] += point.volume * (point.sigma[1] * gy + point.sigma[3] * gx);
    }
  }
  add_internal_force_of_points(mesh.geometry(0), only_block(points, 0), sums);
  for (int d = 0; d < 2; ++d)
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(sums.internal_force[d][i], expected.internal_force[d][i], 1e-10);
}

TEST(InternalForceOfPoints, IsInEquilibriumWithItself)
{
  Random random(94);
  const auto mesh = one_cell(distorted_square(0.3, random));
  PointBlocks<2> points(1, 0);
  for (int k = 0; k < 5; ++k)
    add_point(mesh, 0, {.local = {0.1 * k, -0.2 * k}, .sigma = {1e3, -2e3, 5e2, 7e2}}, points);
  CornerSums<Quad4> sums{};
  add_internal_force_of_points(mesh.geometry(0), only_block(points, 0), sums);
  for (const auto& f : sums.internal_force) EXPECT_NEAR(f[0] + f[1] + f[2] + f[3], 0.0, 1e-9);
}

}  // namespace point_gradients_test
