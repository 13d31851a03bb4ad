// Bilinear shape functions: values and derivatives by hand, and what they must reproduce.

#include "mesh/shape_functions.hpp"

#include "parallel/pack.hpp"

#include <gmock/gmock.h>

namespace terp {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

TEST(ShapeFunctions, HaveTheValuesOfTheirFormula)
{
  EXPECT_THAT(shape_functions(0.6, -0.2),
      ElementsAre(DoubleEq(0.2 * 0.6), DoubleEq(0.8 * 0.6), DoubleEq(0.8 * 0.4), DoubleEq(0.2 * 0.4)));
}

TEST(ShapeFunctions, AreOneAtTheirOwnCornerAndZeroAtTheOthers)
{
  for (int i = 0; i < 4; ++i) {
    const auto N = shape_functions(corner_place[i][0], corner_place[i][1]);
    for (int k = 0; k < 4; ++k) EXPECT_EQ(N[k], i == k ? 1.0 : 0.0);
  }
}

TEST(ShapeFunctions, AddUpToOneAndReproduceThePlace)
{
  const Real xi = 0.37, eta = -0.91;
  const auto N = shape_functions(xi, eta);
  Real one = 0.0, x = 0.0, y = 0.0;
  for (int i = 0; i < 4; ++i) {
    one += N[i];
    x += N[i] * corner_place[i][0];
    y += N[i] * corner_place[i][1];
  }
  EXPECT_DOUBLE_EQ(one, 1.0);
  EXPECT_DOUBLE_EQ(x, xi);
  EXPECT_DOUBLE_EQ(y, eta);
}

TEST(ShapeFunctions, HaveTheDerivativesOfTheirFormula)
{
  const auto dN = shape_derivatives(0.6, -0.2);
  EXPECT_THAT(dN[0], ElementsAre(DoubleEq(-0.25 * 1.2), DoubleEq(-0.25 * 0.4)));
  EXPECT_THAT(dN[1], ElementsAre(DoubleEq(0.25 * 1.2), DoubleEq(-0.25 * 1.6)));
  EXPECT_THAT(dN[2], ElementsAre(DoubleEq(0.25 * 0.8), DoubleEq(0.25 * 1.6)));
  EXPECT_THAT(dN[3], ElementsAre(DoubleEq(-0.25 * 0.8), DoubleEq(0.25 * 0.4)));
}

TEST(ShapeFunctions, AreTheSameInAPackAndAlone)
{
  const auto N = shape_functions(0.3, 0.7);
  const auto dN = shape_derivatives(0.3, 0.7);
  const auto packed = shape_functions(Pack(0.3), Pack(0.7));
  const auto packed_derivatives = shape_derivatives(Pack(0.3), Pack(0.7));
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(packed[i][5], N[i]);
    for (int d = 0; d < 2; ++d) EXPECT_EQ(packed_derivatives[i][d][5], dN[i][d]);
  }
}

TEST(GaussPoints, AreNumberedBySubCell)
{
  for (int g = 0; g < 4; ++g) {
    const Vec<2> at = gauss_place(g);
    EXPECT_EQ((at[0] >= 0.0 ? 1 : 0) + (at[1] >= 0.0 ? 2 : 0), g);
  }
}

TEST(GaussPoints, IntegrateCubicsExactly)
{
  Real constant = 0.0, square = 0.0, cube = 0.0;
  for (int g = 0; g < 4; ++g) {
    const auto [xi, eta] = gauss_place(g);
    constant += 1.0;
    square += xi * xi;
    cube += xi * xi * xi * eta * eta + eta;
  }
  EXPECT_EQ(constant, 4.0);
  EXPECT_DOUBLE_EQ(square, 4.0 / 3.0);
  EXPECT_NEAR(cube, 0.0, 1e-16);
}

}  // namespace
}  // namespace terp
