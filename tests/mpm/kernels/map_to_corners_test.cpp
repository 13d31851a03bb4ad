#include "mpm/kernels/map_to_corners.hpp"
#include "support/blocks.hpp"
#include "support/random.hpp"

namespace map_to_corners_test {

struct Cell {
  Mesh<2> mesh = make_rectangle({0.0, 0.0}, {2.0, 1.0}, {1, 1});
  PointBlocks<2> points{1, 0};
  PointBlock<2>& block() { return only_block(points, 0); }
  void add(const PointValues& point) { add_point(mesh, 0, point, points); }
};

Cell random_cell(int n, std::uint64_t seed)
{
  Cell cell;
  Random random(seed);
  for (int k = 0; k < n; ++k)
    cell.add({.local = {random.between(-1.0, 1.0), random.between(-1.0, 1.0)},
        .mass = random.between(1.0, 3.0),
        .v = {random.between(-2.0, 2.0), random.between(-2.0, 2.0)}});
  return cell;
}

Real total(const std::array<Real, 4>& a) { return a[0] + a[1] + a[2] + a[3]; }

TEST(MapMassAndMomentum, SpreadsOnePointByItsShapeFunctions)
{
  Cell cell;
  cell.add({.local = {0.6, -0.2}, .mass = 100.0, .v = {3.0, -0.5}});
  CornerSums<Quad4> sums{};
  map_mass_and_momentum(cell.block(), sums);
  EXPECT_THAT(sums.mass, ElementsAre(DoubleEq(12.0), DoubleEq(48.0), DoubleEq(32.0), DoubleEq(8.0)));
  EXPECT_THAT(sums.momentum[0], ElementsAre(DoubleEq(36.0), DoubleEq(144.0), DoubleEq(96.0), DoubleEq(24.0)));
  EXPECT_THAT(sums.momentum[1], ElementsAre(DoubleEq(-6.0), DoubleEq(-24.0), DoubleEq(-16.0), DoubleEq(-4.0)));
}

TEST(MapMassAndMomentum, APointOnASideGivesTheCornersAcrossItsVelocity)
{
  Cell cell;
  cell.add({.local = {-1.0, 0.5}, .mass = 100.0, .v = {3.0, -0.5}});
  CornerSums<Quad4> sums{};
  map_mass_and_momentum(cell.block(), sums);
  EXPECT_THAT(sums.mass, ElementsAre(25.0, 100.0 * least_share, 100.0 * least_share, 75.0));
  for (int i = 0; i < 4; ++i) {
    EXPECT_DOUBLE_EQ(sums.momentum[0][i] / sums.mass[i], 3.0);
    EXPECT_DOUBLE_EQ(sums.momentum[1][i] / sums.mass[i], -0.5);
  }
  sums.momentum = {};
  map_momentum(cell.block(), sums);
  EXPECT_DOUBLE_EQ(sums.momentum[0][1] / sums.mass[1], 3.0);
}

TEST(MapMassAndMomentum, KeepsTheTotalsOfAnyNumberOfPoints)
{
  for (const int n : {1, 7, 8, 9, 25}) {
    Cell cell = random_cell(n, 111);
    Real mass = 0.0, px = 0.0, py = 0.0;
    for (Index p = 0; p < n; ++p) {
      mass += cell.block().row(Rows::mass)[p];
      px += cell.block().row(Rows::mass)[p] * cell.block().row(Rows::v)[p];
      py += cell.block().row(Rows::mass)[p] * cell.block().row(Rows::v + 1)[p];
    }
    CornerSums<Quad4> sums{};
    map_mass_and_momentum(cell.block(), sums);
    EXPECT_NEAR(total(sums.mass), mass, 1e-13);
    EXPECT_NEAR(total(sums.momentum[0]), px, 1e-13);
    EXPECT_NEAR(total(sums.momentum[1]), py, 1e-13);
  }
}

TEST(MapMassAndMomentum, AddsToWhatIsThere)
{
  Cell cell;
  cell.add({.local = {0.0, 0.0}, .mass = 4.0, .v = {1.0, 2.0}});
  CornerSums<Quad4> sums{};
  sums.mass[2] = 10.0;
  sums.momentum[1][2] = 20.0;
  map_mass_and_momentum(cell.block(), sums);
  EXPECT_DOUBLE_EQ(sums.mass[2], 11.0);
  EXPECT_DOUBLE_EQ(sums.momentum[1][2], 22.0);
}

TEST(MapMomentum, IsTheMomentumOfTheFirstPassToRoundOff)
{
  Cell cell = random_cell(13, 112);
  CornerSums<Quad4> first{}, second{};
  map_mass_and_momentum(cell.block(), first);
  map_momentum(cell.block(), second);
  for (int d = 0; d < 2; ++d)
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(second.momentum[d][i], first.momentum[d][i], 1e-14);
  EXPECT_THAT(second.mass, Each(0.0));
}

TEST(AcceleratePoints, AddsTheInterpolatedIncrement)  // pure FLIP
{
  Cell cell;
  cell.add({.local = {0.6, -0.2}, .v = {3.0, -0.5}});
  const CornerVectors<Quad4> dv{{{1.0, 2.0, 3.0, 4.0}, {-10.0, 0.0, 0.0, 20.0}}},
      v_star{{{9.0, 9.0, 9.0, 9.0}, {9.0, 9.0, 9.0, 9.0}}};
  EXPECT_EQ(accelerate_points<Quad4>(dv, v_star, 1.0, cell.block()), 0.0);
  EXPECT_DOUBLE_EQ(cell.block().row(Rows::v)[0], 3.0 + 0.12 * 1.0 + 0.48 * 2.0 + 0.32 * 3.0 + 0.08 * 4.0);
  EXPECT_NEAR(cell.block().row(Rows::v + 1)[0], -0.5 - 0.12 * 10.0 + 0.08 * 20.0, 1e-14);
}

TEST(AcceleratePoints, TakesTheGridsVelocityWithPurePic)
{
  Cell cell;
  cell.add({.local = {0.6, -0.2}, .v = {3.0, -0.5}});
  const CornerVectors<Quad4> dv{{{1.0, 2.0, 3.0, 4.0}, {-10.0, 0.0, 0.0, 20.0}}},
      v_star{{{5.0, 6.0, 7.0, 8.0}, {1.0, 1.0, 1.0, 1.0}}};
  accelerate_points<Quad4>(dv, v_star, 0.0, cell.block());
  EXPECT_DOUBLE_EQ(cell.block().row(Rows::v)[0], 0.12 * 5.0 + 0.48 * 6.0 + 0.32 * 7.0 + 0.08 * 8.0);
  EXPECT_DOUBLE_EQ(cell.block().row(Rows::v + 1)[0], 1.0);
}

TEST(AcceleratePoints, BlendsFlipAndPic)
{
  Cell cell;
  cell.add({.local = {0.0, 0.0}, .v = {3.0, 0.0}});
  const CornerVectors<Quad4> dv{{{1.0, 1.0, 1.0, 1.0}, {}}}, v_star{{{8.0, 8.0, 8.0, 8.0}, {}}};
  const Real gained = accelerate_points<Quad4>(dv, v_star, 0.75, cell.block());
  EXPECT_DOUBLE_EQ(cell.block().row(Rows::v)[0], 0.75 * 4.0 + 0.25 * 8.0);
  EXPECT_DOUBLE_EQ(gained, 0.5 * cell.block().row(Rows::mass)[0] * (5.0 * 5.0 - 4.0 * 4.0));
}

TEST(AcceleratePoints, LeavesPaddingWithoutMomentum)
{
  Cell cell = random_cell(3, 113);
  const CornerVectors<Quad4> dv{{{1.0, 2.0, 3.0, 4.0}, {-10.0, 0.0, 0.0, 20.0}}};
  accelerate_points<Quad4>(dv, dv, 1.0, cell.block());
  CornerSums<Quad4> sums{};
  map_momentum(cell.block(), sums);
  Real px = 0.0;
  for (Index p = 0; p < 3; ++p) px += cell.block().row(Rows::mass)[p] * cell.block().row(Rows::v)[p];
  EXPECT_NEAR(total(sums.momentum[0]), px, 1e-13);
}

TEST(Interpolate, ReproducesALinearField)
{
  const CornerVectors<Quad4> a{{{-1.0, 1.0, 1.0, -1.0}, {-2.0, -2.0, 2.0, 2.0}}};  // xi and 2 eta
  const auto value = interpolate(a, Quad4::shape_functions(std::array{Pack(0.3), Pack(-0.7)}));
  EXPECT_DOUBLE_EQ(value[0][6], 0.3);
  EXPECT_DOUBLE_EQ(value[1][6], -1.4);
}

}  // namespace map_to_corners_test
