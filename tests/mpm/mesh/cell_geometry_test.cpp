#include "math/pack.hpp"
#include "mpm/mesh/cell_geometry.hpp"
#include "support/meshes.hpp"

namespace cell_geometry_test {

// Width 2 at the bottom, 1.5 at the top, height 1: detJ = (1.75 - 0.25 eta) / 4.
constexpr std::array<Vec<2>, 4> trapezium{{{0.0, 0.0}, {2.0, 0.0}, {1.5, 1.0}, {0.0, 1.0}}};

Real det_jacobian(const CellGeometry<Quad4>& cell, Real xi, Real eta)
{
  const auto j = Quad4::jacobian(cell.map, Vec<2>{xi, eta});
  return j[0][0] * j[1][1] - j[0][1] * j[1][0];
}

TEST(CellGeometry, TrapeziumHasTheVolumesOfTheHandCalculation)
{
  const auto cell = make_cell_geometry<Quad4>(trapezium);
  const Real low = (1.75 + 0.25 / std::sqrt(3.0)) / 4.0, high = (1.75 - 0.25 / std::sqrt(3.0)) / 4.0;
  EXPECT_THAT(cell.gauss_volume, ElementsAre(DoubleEq(low), DoubleEq(low), DoubleEq(high), DoubleEq(high)));
  EXPECT_DOUBLE_EQ(cell.volume, 1.75);
  EXPECT_FALSE(cell.map.affine);
}

TEST(CellGeometry, TrapeziumHasTheCentreGradientsOfTheHandCalculation)
{
  // J at the centre: dx/dxi = 0.875, dx/deta = -0.125, dy/deta = 0.5.
  const auto cell = make_cell_geometry<Quad4>(trapezium);
  for (int i = 0; i < 4; ++i) {
    const Real dxi = 0.25 * Quad4::corner_place[i][0], deta = 0.25 * Quad4::corner_place[i][1];
    EXPECT_DOUBLE_EQ(cell.centre_gradient[i][0], dxi / 0.875);
    EXPECT_DOUBLE_EQ(cell.centre_gradient[i][1], (deta + 0.125 * dxi / 0.875) / 0.5);
  }
}

TEST(CellGeometry, AltitudeIsTheSmallestHeightOverASide)
{
  EXPECT_DOUBLE_EQ(make_cell_geometry<Quad4>(trapezium).altitude, 1.0);
  EXPECT_DOUBLE_EQ(make_cell_geometry<Quad4>({{{0.0, 0.0}, {1.0, 0.0}, {1.8, 0.6}, {0.8, 0.6}}}).altitude, 0.6);
  // Corner (2, 0) over the side from (2, 0.4) to (0, 1), of length sqrt(4.36).
  EXPECT_DOUBLE_EQ(
      make_cell_geometry<Quad4>({{{0.0, 0.0}, {2.0, 0.0}, {2.0, 0.4}, {0.0, 1.0}}}).altitude, 0.8 / std::sqrt(4.36));
  // A parallelogram of area 1 over sides of length 1 and 1.25.
  EXPECT_DOUBLE_EQ(make_cell_geometry<Quad4>({{{0.0, 0.0}, {1.0, -0.75}, {1.0, 0.25}, {0.0, 1.0}}}).altitude, 0.8);
}

TEST(CellGeometry, TurnedOverCellHasANegativeAltitude)
{
  EXPECT_LT(make_cell_geometry<Quad4>({{{0.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}, {1.0, 0.0}}}).altitude, 0.0);
}

TEST(CellGeometry, ParallelogramIsAffineWithEqualVolumes)
{
  const auto cell = make_cell_geometry<Quad4>({{{0.0, 0.0}, {1.0, 0.2}, {1.3, 1.1}, {0.3, 0.9}}});
  EXPECT_TRUE(cell.map.affine);
  EXPECT_THAT(cell.gauss_volume, Each(DoubleEq(0.25 * (0.9 - 0.3 * 0.2))));
}

TEST(CellGeometry, GradientsReproduceLinearFieldsInAnyQuadrilateral)
{
  Random random(3);
  for (int repeat = 0; repeat < 200; ++repeat) {
    const auto corners = distorted_square(0.3, random);
    const auto cell = make_cell_geometry<Quad4>(corners);
    for (int g = 0; g < 4; ++g)
      for (int d = 0; d < 2; ++d) {
        Real of_one = 0.0, of_x = 0.0, of_y = 0.0;
        for (int i = 0; i < 4; ++i) {
          of_one += cell.gradient[i][d][g];
          of_x += cell.gradient[i][d][g] * corners[i][0];
          of_y += cell.gradient[i][d][g] * corners[i][1];
        }
        EXPECT_NEAR(of_one, 0.0, 1e-13);
        EXPECT_NEAR(of_x, d == 0 ? 1.0 : 0.0, 1e-13);
        EXPECT_NEAR(of_y, d == 1 ? 1.0 : 0.0, 1e-13);
      }
  }
}

TEST(CellGeometry, CentreGradientIsTheMeanGradientOfAPlaneQuadrilateral)  // reading R5
{
  Random random(4);
  for (int repeat = 0; repeat < 200; ++repeat) {
    const auto cell = make_cell_geometry<Quad4>(distorted_square(0.3, random));
    for (int i = 0; i < 4; ++i)
      for (int d = 0; d < 2; ++d) {
        Real integral = 0.0;
        for (int g = 0; g < 4; ++g) integral += cell.gauss_volume[g] * cell.gradient[i][d][g];
        EXPECT_NEAR(integral / cell.volume, cell.centre_gradient[i][d], 1e-13);
      }
    EXPECT_NEAR(cell.volume, 4.0 * det_jacobian(cell, 0.0, 0.0), 1e-14);
  }
}

TEST(CellGeometry, OffsetRunsThroughTheCorners)
{
  Random random(5);
  const auto corners = distorted_square(0.3, random);
  const auto cell = make_cell_geometry<Quad4>(corners);
  for (int i = 0; i < 4; ++i) {
    const auto offset = Quad4::offset_from_centre(cell.map, Quad4::corner_place[i]);
    for (int d = 0; d < 2; ++d) {
      const Real centre = 0.25 * (corners[0][d] + corners[1][d] + corners[2][d] + corners[3][d]);
      EXPECT_NEAR(centre + offset[d], corners[i][d], 1e-15);
    }
  }
}

TEST(CellGeometry, JacobianIsTheSlopeOfTheOffset)
{
  Random random(6);
  const auto cell = make_cell_geometry<Quad4>(distorted_square(0.3, random));
  const Real xi = 0.4, eta = -0.7, step = 0.5;  // the map is linear in each coordinate: any step is exact
  const auto j = Quad4::jacobian(cell.map, Vec<2>{xi, eta});
  const auto here = Quad4::offset_from_centre(cell.map, Vec<2>{xi, eta});
  const auto right = Quad4::offset_from_centre(cell.map, Vec<2>{xi + step, eta}),
             up = Quad4::offset_from_centre(cell.map, Vec<2>{xi, eta + step});
  for (int d = 0; d < 2; ++d) {
    EXPECT_NEAR(j[d][0], (right[d] - here[d]) / step, 1e-15);
    EXPECT_NEAR(j[d][1], (up[d] - here[d]) / step, 1e-15);
  }
}

/// Corners moved by the full `share`, every second square towards the eight compass points, where the worst shapes lie.
std::array<Vec<2>, 4> hard_square(Real share, int k, Random& random)
{
  std::array<Vec<2>, 4> corners{{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}};
  for (auto& x : corners) {
    const Real angle = k % 2 ? std::numbers::pi / 4 * random.below(8) : random.between(0.0, 2.0 * std::numbers::pi);
    x = {x[0] + share * std::cos(angle), x[1] + share * std::sin(angle)};
  }
  return corners;
}

/// Largest distance [of the side] from a position to what its local coordinates, up to `reach`, map back to.
template <class Inverse>
Real worst_return(Real share, Real reach, Inverse&& inverse)
{
  Random random(7);
  Real worst = 0.0;
  for (int k = 0; k < 4000; ++k) {
    const auto cell = make_cell_geometry<Quad4>(hard_square(share, k, random));
    for (int place = 0; place < 24; ++place) {
      Real xi = random.between(-reach, reach), eta = random.between(-reach, reach);
      if (place % 2) xi = std::copysign(reach, xi);  // corners and sides are the difficult positions
      if (place % 4 >= 2) eta = std::copysign(reach, eta);
      const auto x = Quad4::offset_from_centre(cell.map, Vec<2>{xi, eta});
      const auto back = Quad4::offset_from_centre(cell.map, inverse(cell, x[0], x[1]));
      worst = std::fmax(worst, std::hypot(back[0] - x[0], back[1] - x[1]));
    }
  }
  return worst;
}

Real worst_return(Real share, Real reach)
{
  return worst_return(share, reach, [](const auto& cell, Real x, Real y) {
    return Quad4::local_coordinates(cell.map, Vec<2>{x, y});
  });
}

TEST(InverseMap, ReachesRoundOff)
{
  EXPECT_LT(worst_return(0.10, 1.5), 1e-15);
  EXPECT_LT(worst_return(0.25, 1.2), 1e-15);
  EXPECT_LT(worst_return(0.30, 1.0), 1e-15);
}

TEST(InverseMap, ReachesRoundOffWhereACornerIsAlmostStraight) { EXPECT_LT(worst_return(0.35, 1.0), 1e-15); }

TEST(InverseMap, IsNotANumberOrReturnsBeyondTheFoldOfTheMap)
{
  const auto cell =
      make_cell_geometry<Quad4>({{{0.0, 0.0}, {1.0, 0.0}, {0.51, 0.51}, {0.0, 1.0}}});  // almost a triangle
  const auto back = Quad4::offset_from_centre(cell.map, Quad4::local_coordinates(cell.map, Vec<2>{2.0, 2.0}));
  EXPECT_FALSE(std::hypot(back[0] - 2.0, back[1] - 2.0) < 1e-9);
}

TEST(InverseMap, IsExactInAParallelogramHoweverFar)
{
  const auto cell = make_cell_geometry<Quad4>({{{0.0, 0.0}, {1.0, 0.2}, {1.3, 1.1}, {0.3, 0.9}}});
  for (const Vec<2> local : {Vec<2>{0.3, -0.8}, Vec<2>{-40.0, 17.0}, Vec<2>{1.0, 1.0}}) {
    const auto x = Quad4::offset_from_centre(cell.map, local);
    EXPECT_THAT(
        Quad4::local_coordinates(cell.map, x), ElementsAre(DoubleNear(local[0], 1e-14), DoubleNear(local[1], 1e-14)));
  }
}

TEST(InverseMap, IsTheSameInAPackAndAlone)
{
  Random random(8);
  for (int repeat = 0; repeat < 200; ++repeat) {
    const auto cell = make_cell_geometry<Quad4>(distorted_square(0.3, random));
    const Real x = random.between(-0.4, 0.4), y = random.between(-0.4, 0.4);
    const auto alone = Quad4::local_coordinates(cell.map, Vec<2>{x, y});
    const auto packed = Quad4::local_coordinates(cell.map, std::array{Pack(x), Pack(y)});
    for (int d = 0; d < 2; ++d) EXPECT_EQ(packed[d][3], alone[d]);
  }
}

}  // namespace cell_geometry_test
