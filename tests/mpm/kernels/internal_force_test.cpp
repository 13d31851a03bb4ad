// Internal force, Eq. (4), against explicit B-bar matrices, and the strain increment that is work-conjugate to it.
#include "mpm/kernels/internal_force.hpp"
#include "support/meshes.hpp"

namespace internal_force_test {

GaussValues<Quad4> random_gauss(Random& random)
{
  GaussValues<Quad4> gauss{};
  for (int g = 0; g < 4; ++g) {
    for (int c = 0; c < 4; ++c) gauss.sigma[c][g] = random.between(-5e4, 5e4);
    gauss.weight[g] = random.between(0.05, 0.4);
  }
  return gauss;
}

CornerVectors<Quad4> random_displacements(Random& random)
{
  CornerVectors<Quad4> du;
  for (auto& direction : du)
    for (Real& value : direction) value = random.between(-1e-3, 1e-3);
  return du;
}

/// Rows xx yy zz 2xy of B-bar at Gauss point g for corner i and direction d, written from reading R5.
std::array<Real, 4> b_bar_column(const std::array<Vec<2>, 4>& corners, int g, int i, int d)
{
  const auto gradient_at = [&](Vec<2> at) {
    Real j[2][2] = {};  // dx_a/dxi_b by the sum over corners
    for (int k = 0; k < 4; ++k)
      for (int a = 0; a < 2; ++a) {
        j[a][0] += 0.25 * Quad4::corner_place[k][0] * (1.0 + Quad4::corner_place[k][1] * at[1]) * corners[k][a];
        j[a][1] += 0.25 * Quad4::corner_place[k][1] * (1.0 + Quad4::corner_place[k][0] * at[0]) * corners[k][a];
      }
    const Real det = j[0][0] * j[1][1] - j[0][1] * j[1][0];
    const Real n_xi = 0.25 * Quad4::corner_place[i][0] * (1.0 + Quad4::corner_place[i][1] * at[1]);
    const Real n_eta = 0.25 * Quad4::corner_place[i][1] * (1.0 + Quad4::corner_place[i][0] * at[0]);
    return Vec<2>{(n_xi * j[1][1] - n_eta * j[1][0]) / det, (n_eta * j[0][0] - n_xi * j[0][1]) / det};
  };
  const Vec<2> at_g = gradient_at(Quad4::gauss_place(g)), at_centre = gradient_at({0.0, 0.0});
  std::array<Real, 4> column{d == 0 ? at_g[0] : 0.0, d == 1 ? at_g[1] : 0.0, 0.0, at_g[1 - d]};
  for (int c = 0; c < 3; ++c) column[c] += (at_centre[d] - at_g[d]) / 3.0;
  return column;
}

TEST(InternalForce, Eq4_IsTheSumOfBBarTransposedTimesStressTimesWeight)  // decision on reading R4
{
  Random random(81);
  for (int repeat = 0; repeat < 100; ++repeat) {
    const auto corners = distorted_square(0.25, random);
    const auto gauss = random_gauss(random);
    CornerSums<Quad4> sums{};
    sums.internal_force[1][2] = 17.0;  // it adds to what is there
    add_internal_force(make_cell_geometry<Quad4>(corners), gauss, true, sums);
    for (int i = 0; i < 4; ++i)
      for (int d = 0; d < 2; ++d) {
        Real expected = i == 2 && d == 1 ? 17.0 : 0.0;
        for (int g = 0; g < 4; ++g) {
          const auto column = b_bar_column(corners, g, i, d);
          for (int c = 0; c < 4; ++c) expected += column[c] * gauss.sigma[c][g] * gauss.weight[g];
        }
        EXPECT_NEAR(sums.internal_force[d][i], expected, 1e-10);
      }
  }
}

TEST(InternalForce, DoesTheWorkOfTheStressOnTheStrain)  // for both operators with their own strain
{
  Random random(82);
  for (const bool b_bar : {true, false})
    for (int repeat = 0; repeat < 100; ++repeat) {
      const auto cell = make_cell_geometry<Quad4>(distorted_square(0.25, random));
      const auto gauss = random_gauss(random);
      const auto du = random_displacements(random);
      CornerSums<Quad4> sums{};
      add_internal_force(cell, gauss, b_bar, sums);
      const auto strain = strain_at_gauss_points(cell, du, b_bar);
      Real of_nodes = 0.0, of_stress = 0.0;
      for (int i = 0; i < 4; ++i)
        for (int d = 0; d < 2; ++d) of_nodes += sums.internal_force[d][i] * du[d][i];
      for (int g = 0; g < 4; ++g)
        for (int c = 0; c < 4; ++c)
          of_stress += gauss.weight[g] * (c == 3 ? 2.0 : 1.0) * gauss.sigma[c][g] * strain.d_eps[c][g];
      EXPECT_NEAR(of_nodes, of_stress, 1e-12);
    }
}

TEST(InternalForce,
    PullsTheCornersOfATensionedCellInwards)  // f_int = integral of B^T sigma: outwards on the side, by hand
{
  const auto cell = make_cell_geometry<Quad4>({{{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {0.0, 1.0}}});
  GaussValues<Quad4> gauss{};
  gauss.sigma[0].fill(30.0);
  gauss.sigma[3].fill(4.0);
  gauss.weight.fill(0.5);
  CornerSums<Quad4> sums{};
  add_internal_force(cell, gauss, true, sums);
  EXPECT_THAT(sums.internal_force[0], Pointwise(DoubleNear(1e-13), {-15.0 - 4.0, 15.0 - 4.0, 15.0 + 4.0, -15.0 + 4.0}));
  EXPECT_THAT(sums.internal_force[1], Pointwise(DoubleNear(1e-13), {-2.0, 2.0, 2.0, -2.0}));
}

/// Largest force on an inner node of a mesh full of soil under one pressure p [Pa], whose points crowd some sub-cells.
Real largest_inner_force(bool b_bar, Real p, Real share)
{
  const auto mesh = distorted_rectangle(5, 4, 1.0, share, 83);
  Random random(84);
  std::vector<Vec<2>> force(mesh.nodes.size(), {0.0, 0.0});
  for (Index e = 0; e < mesh.n_cells(); ++e) {
    GaussValues<Quad4> gauss{};
    for (int c = 0; c < 3; ++c) gauss.sigma[c].fill(p);
    Real total = 0.0;
    for (Real& w : gauss.weight) total += w = random.between(0.1, 0.9);
    for (Real& w : gauss.weight) w *= mesh.geometry(e).volume / total;  // summed weights of a full cell
    CornerSums<Quad4> sums{};
    add_internal_force(mesh.geometry(e), gauss, b_bar, sums);
    for (int i = 0; i < 4; ++i)
      for (int d = 0; d < 2; ++d) force[mesh.cells[e][i]][d] += sums.internal_force[d][i];
  }
  Real largest = 0.0;
  for (std::size_t i = 0; i < force.size(); ++i) {
    const auto [x, y] = mesh.nodes[i];
    if (x > 1e-9 && x < 5.0 - 1e-9 && y > 1e-9 && y < 4.0 - 1e-9)
      largest = std::max({largest, std::abs(force[i][0]), std::abs(force[i][1])});
  }
  return largest;
}

TEST(InternalForce, Eq4_UniformPressureOverUnevenSubCellsGivesNoInteriorForce)
{
  EXPECT_LT(largest_inner_force(true, -1e4, 0.0), 1e-10);
  EXPECT_LT(largest_inner_force(true, -1e4, 0.3), 1e-10);
}

TEST(InternalForce,
    UniformPressureOverUnevenSubCellsGivesAnInteriorForceWithPlainB)  // why reading R4 takes B-bar transposed
{
  EXPECT_GT(largest_inner_force(false, -1e4, 0.0), 100.0);
  EXPECT_GT(largest_inner_force(false, -1e4, 0.3), 100.0);
}

TEST(InternalForce, IsTheSameForBothOperatorsWithGaussWeightsAndUniformPressure)
{
  Random random(85);
  const auto cell = make_cell_geometry<Quad4>(distorted_square(0.25, random));
  GaussValues<Quad4> gauss{};
  for (int c = 0; c < 3; ++c) gauss.sigma[c].fill(-2e4);
  gauss.weight = cell.gauss_volume;
  CornerSums<Quad4> with_b{}, with_b_bar{};
  add_internal_force(cell, gauss, false, with_b);
  add_internal_force(cell, gauss, true, with_b_bar);
  for (int i = 0; i < 4; ++i)
    for (int d = 0; d < 2; ++d) EXPECT_NEAR(with_b.internal_force[d][i], with_b_bar.internal_force[d][i], 1e-10);
}

TEST(StrainAtGaussPoints, OfAUniformGradientIsThatGradient)
{
  Random random(86);
  const auto corners = distorted_square(0.25, random);
  CornerVectors<Quad4> du;
  for (int i = 0; i < 4; ++i) {
    du[0][i] = 1e-3 * corners[i][0] + 4e-3 * corners[i][1] + 0.7;
    du[1][i] = -2e-3 * corners[i][0] + 5e-3 * corners[i][1] - 0.3;
  }
  for (const bool b_bar : {true, false}) {
    const auto strain = strain_at_gauss_points(make_cell_geometry<Quad4>(corners), du, b_bar);
    for (int g = 0; g < 4; ++g) {
      EXPECT_NEAR(strain.d_eps[0][g], 1e-3, 1e-14);
      EXPECT_NEAR(strain.d_eps[1][g], 5e-3, 1e-14);
      EXPECT_NEAR(strain.d_eps[2][g], 0.0, 1e-14);
      EXPECT_NEAR(strain.d_eps[3][g], 1e-3, 1e-14);
      EXPECT_NEAR(strain.d_spin[g], -3e-3, 1e-14);
    }
  }
}

TEST(StrainAtGaussPoints, BBarKeepsTheDeviatorAndTakesTheTraceOfTheCentre)  // reading R5
{
  Random random(87);
  for (int repeat = 0; repeat < 50; ++repeat) {
    const auto cell = make_cell_geometry<Quad4>(distorted_square(0.25, random));
    const auto du = random_displacements(random);
    const auto bar = strain_at_gauss_points(cell, du, true), plain = strain_at_gauss_points(cell, du, false);
    Real theta_0 = 0.0;
    for (int i = 0; i < 4; ++i)
      for (int d = 0; d < 2; ++d) theta_0 += cell.centre_gradient[i][d] * du[d][i];
    for (int g = 0; g < 4; ++g) {
      EXPECT_NEAR(bar.d_eps[0][g] + bar.d_eps[1][g] + bar.d_eps[2][g], theta_0, 1e-16);
      EXPECT_NEAR(bar.d_eps[0][g] - bar.d_eps[1][g], plain.d_eps[0][g] - plain.d_eps[1][g], 1e-16)
          << "the deviator changed";
      EXPECT_NEAR(bar.d_eps[0][g] - bar.d_eps[2][g], plain.d_eps[0][g], 1e-16);
      EXPECT_EQ(bar.d_eps[3][g], plain.d_eps[3][g]);
      EXPECT_EQ(plain.d_eps[2][g], 0.0);
    }
  }
}

}  // namespace internal_force_test
