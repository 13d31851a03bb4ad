#include "math/pack.hpp"
#include "mpm/mesh/quad4.hpp"
#include "support/test.hpp"

namespace quad4_test {

TEST(ShapeFunctions, HaveTheValuesOfTheirFormula)
{
  EXPECT_THAT(Quad4::shape_functions(Vec<2>{0.6, -0.2}),
      ElementsAre(DoubleEq(0.2 * 0.6), DoubleEq(0.8 * 0.6), DoubleEq(0.8 * 0.4), DoubleEq(0.2 * 0.4)));
}

TEST(ShapeFunctions, AreOneAtTheirOwnCornerAndZeroAtTheOthers)
{
  for (int i = 0; i < 4; ++i) {
    const auto N = Quad4::shape_functions(Quad4::corner_place[i]);
    for (int k = 0; k < 4; ++k) EXPECT_EQ(N[k], i == k ? 1.0 : 0.0);
  }
}

TEST(ShapeFunctions, AddUpToOneAndReproduceThePlace)
{
  const Real xi = 0.37, eta = -0.91;
  const auto N = Quad4::shape_functions(Vec<2>{xi, eta});
  Real one = 0.0, x = 0.0, y = 0.0;
  for (int i = 0; i < 4; ++i) {
    one += N[i];
    x += N[i] * Quad4::corner_place[i][0];
    y += N[i] * Quad4::corner_place[i][1];
  }
  EXPECT_DOUBLE_EQ(one, 1.0);
  EXPECT_DOUBLE_EQ(x, xi);
  EXPECT_DOUBLE_EQ(y, eta);
}

TEST(ShapeFunctions, HaveTheDerivativesOfTheirFormula)
{
  const auto dN = Quad4::shape_derivatives(Vec<2>{0.6, -0.2});
  EXPECT_THAT(dN[0], ElementsAre(DoubleEq(-0.25 * 1.2), DoubleEq(-0.25 * 0.4)));
  EXPECT_THAT(dN[1], ElementsAre(DoubleEq(0.25 * 1.2), DoubleEq(-0.25 * 1.6)));
  EXPECT_THAT(dN[2], ElementsAre(DoubleEq(0.25 * 0.8), DoubleEq(0.25 * 1.6)));
  EXPECT_THAT(dN[3], ElementsAre(DoubleEq(-0.25 * 0.8), DoubleEq(0.25 * 0.4)));
}

TEST(ShapeFunctions, AreTheSameInAPackAndAlone)
{
  const auto N = Quad4::shape_functions(Vec<2>{0.3, 0.7});
  const auto dN = Quad4::shape_derivatives(Vec<2>{0.3, 0.7});
  const auto packed = Quad4::shape_functions(std::array{Pack(0.3), Pack(0.7)});
  const auto packed_derivatives = Quad4::shape_derivatives(std::array{Pack(0.3), Pack(0.7)});
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(packed[i][5], N[i]);
    for (int d = 0; d < 2; ++d) EXPECT_EQ(packed_derivatives[i][d][5], dN[i][d]);
  }
}

TEST(Sides, LieWhereTheirCornersDo)
{
  for (int s = 0; s < Quad4::n_sides; ++s) {
    const Quad4::Side& side = Quad4::sides[s];
    for (const int corner : side.corners) EXPECT_EQ(Quad4::corner_place[corner][side.direction], side.place);
    EXPECT_EQ(side.corners[1], Quad4::sides[(s + 1) % Quad4::n_sides].corners[0]);
    EXPECT_EQ(Quad4::side_at(side.direction, side.place > 0.0), s);
  }
}

TEST(AtSubCell, IsForEachLaneTheValueOfTheGaussPointOnItsSide)
{
  const std::array<Real, 4> values{10.0, 11.0, 12.0, 13.0};  // not in the order of corners
  alignas(64) std::array<Real, pack_width> xi, eta, chosen;
  for (int k = 0; k < pack_width; ++k) {
    xi[k] = k % 2 == 0 ? -0.5 : 0.5;
    eta[k] = k % 4 < 2 ? -0.5 : 0.5;
  }
  const auto upper = Quad4::upper_halves(std::array{Pack::load(xi.data()), Pack::load(eta.data())});
  Quad4::at_sub_cell(values, upper).store(chosen.data());
  for (int k = 0; k < pack_width; ++k)
    EXPECT_EQ(chosen[k], values[(xi[k] > 0.0 ? 1 : 0) + (eta[k] > 0.0 ? 2 : 0)]) << "lane " << k;
}

TEST(InSubCell, IsTheValueThereAndZeroElsewhere)
{
  for (int g = 0; g < Quad4::n_gauss; ++g) {
    const auto parts = Quad4::in_sub_cell(7.0, Quad4::upper_halves(Quad4::gauss_place(g)));
    for (int k = 0; k < Quad4::n_gauss; ++k) EXPECT_EQ(parts[k], k == g ? 7.0 : 0.0);
  }
}

TEST(GaussPoints, AreNumberedBySubCell)
{
  for (int g = 0; g < 4; ++g) {
    const Vec<2> at = Quad4::gauss_place(g);
    EXPECT_EQ((at[0] >= 0.0 ? 1 : 0) + (at[1] >= 0.0 ? 2 : 0), g);
  }
}

TEST(GaussPoints, IntegrateCubicsExactly)
{
  Real constant = 0.0, square = 0.0, cube = 0.0;
  for (int g = 0; g < 4; ++g) {
    const auto [xi, eta] = Quad4::gauss_place(g);
    constant += 1.0;
    square += xi * xi;
    cube += xi * xi * xi * eta * eta + eta;
  }
  EXPECT_EQ(constant, 4.0);
  EXPECT_DOUBLE_EQ(square, 4.0 / 3.0);
  EXPECT_NEAR(cube, 0.0, 1e-16);
}

}  // namespace quad4_test
