// Points to Gauss points: means, weights, pressure. Eqs. (1) to (3) and readings R3, R6, R7, R8, R9.
#include "mpm/kernels/gauss_average.hpp"
#include "support/blocks.hpp"
#include "support/random.hpp"

namespace gauss_average_test {

/// A cell of 2 m x 2 m, so that V_e = 4 and each Gauss weight is 1, with the points that a test puts in.
struct Cell {
  Mesh<2> mesh = make_rectangle({0.0, 0.0}, {2.0, 2.0}, {1, 1});
  PointBlocks<2> points{1, 2};
  GaussValues<Quad4> gauss{};
  std::array<std::array<Real, 4>, 2> state{};

  explicit Cell(const std::vector<PointValues>& values)
  {
    for (const auto& point : values) add_point(mesh, 0, point, points);
  }
  void average(const MethodOptions& method = {})
  {
    sum_over_sub_cells(only_block(points, 0), gauss);
    set_weights(mesh.geometry(0), gauss.volume, method, gauss);
    const SubCellMeans mean(gauss);
    for (int k = 0; k < 2; ++k) {
      state[k] = sum_row_over_sub_cells<Quad4>(only_block(points, 0), Rows::state + k);
      mean(state[k]);
    }
    divide_by_volume(gauss);
  }
};

constexpr Vec<2> low_left{-0.5, -0.5}, low_right{0.5, -0.5}, up_left{-0.5, 0.5}, up_right{0.5, 0.5};

/// Different numbers of points, volumes and stresses in all four sub-cells; a full cell of V = 4.
std::vector<PointValues> uneven_cell()
{
  return {{.local = low_left, .volume = 0.3, .sigma = {10.0, 20.0, 30.0, 1.0}, .state = {0.1, 5.0}},
      {.local = {-0.1, -0.9}, .volume = 0.9, .sigma = {50.0, 60.0, 40.0, 3.0}, .state = {0.3, 7.0}},
      {.local = low_right, .volume = 1.4, .sigma = {-7.0, 3.0, -2.0, 4.0}, .state = {0.02, 1.0}},
      {.local = up_left, .volume = 0.6, .sigma = {8.0, -6.0, 1.0, -5.0}, .state = {0.5, 2.0}},
      {.local = up_right, .volume = 0.8, .sigma = {100.0, 200.0, 300.0, 50.0}, .state = {0.0, 3.0}}};
}

TEST(GaussAverage, Eq1_IsTheVolumeWeightedMeanOfEachSubCell)
{
  Cell cell(uneven_cell());
  cell.average();
  EXPECT_THAT(cell.gauss.volume, ElementsAre(DoubleEq(1.2), 1.4, 0.6, 0.8));
  EXPECT_THAT(cell.gauss.sigma[0],
      ElementsAre(DoubleEq((0.3 * 10.0 + 0.9 * 50.0) / 1.2), DoubleEq(-7.0), DoubleEq(8.0), DoubleEq(100.0)));
  EXPECT_THAT(cell.gauss.sigma[1],
      ElementsAre(DoubleEq((0.3 * 20.0 + 0.9 * 60.0) / 1.2), DoubleEq(3.0), DoubleEq(-6.0), DoubleEq(200.0)));
  EXPECT_THAT(cell.gauss.sigma[2],
      ElementsAre(DoubleEq((0.3 * 30.0 + 0.9 * 40.0) / 1.2), DoubleEq(-2.0), DoubleEq(1.0), DoubleEq(300.0)));
  EXPECT_THAT(cell.gauss.sigma[3],
      ElementsAre(DoubleEq((0.3 * 1.0 + 0.9 * 3.0) / 1.2), DoubleEq(4.0), DoubleEq(-5.0), DoubleEq(50.0)));
  EXPECT_THAT(cell.state[0], ElementsAre(DoubleEq((0.3 * 0.1 + 0.9 * 0.3) / 1.2), DoubleEq(0.02), DoubleEq(0.5), 0.0));
  EXPECT_THAT(
      cell.state[1], ElementsAre(DoubleEq((0.3 * 5.0 + 0.9 * 7.0) / 1.2), DoubleEq(1.0), DoubleEq(2.0), DoubleEq(3.0)));
}

TEST(GaussAverage, Eq1_HoldsForAnyNumberOfPoints)
{
  Random random(101);
  for (const int n : {1, 7, 8, 9, 25, 40}) {
    std::vector<PointValues> values;
    Real volume[4] = {}, stress[4] = {};
    for (int k = 0; k < n; ++k) {
      const Vec<2> local{random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
      values.push_back({.local = local,
          .volume = random.between(0.1, 0.3),
          .sigma = {random.between(-9.0, 9.0)},
          .state = {0.0, 0.0}});
      const int g = (local[0] >= 0.0) + 2 * (local[1] >= 0.0);
      volume[g] += values.back().volume;
      stress[g] += values.back().volume * values.back().sigma[0];
    }
    Cell cell(values);
    cell.average();
    for (int g = 0; g < 4; ++g) {
      EXPECT_NEAR(cell.gauss.volume[g], volume[g], 1e-14);
      if (volume[g] == 0.0) continue;
      EXPECT_NEAR(cell.gauss.sigma[0][g], stress[g] / volume[g], 1e-13);
    }
  }
}

TEST(GaussAverage, PointsOnTheSplitGoRightAndUp)  // reading R7: a 5 x 5 lattice has 4, 6, 6, 9 points in its sub-cells
{
  std::vector<PointValues> values;
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i) values.push_back({.local = {-0.8 + 0.4 * i, -0.8 + 0.4 * j}, .volume = 0.16});
  Cell cell(values);
  cell.average();
  EXPECT_THAT(
      cell.gauss.volume, ElementsAre(DoubleEq(4 * 0.16), DoubleEq(6 * 0.16), DoubleEq(6 * 0.16), DoubleEq(9 * 0.16)));
  Cell shaken({{.local = {-0.9e-9, -0.9e-9}}, {.local = {-1.1e-9, -1.1e-9}, .volume = 0.5}});
  shaken.average();
  EXPECT_THAT(shaken.gauss.volume, ElementsAre(0.5, 0.0, 0.0, 0.25));
}

TEST(GaussAverage, AnEmptySubCellTakesTheMeanInAFilledCellAndHasNoWeightElsewhere)  // reading R8
{
  const PointValues low{.local = low_left, .volume = 3.0, .sigma = {10.0, 0.0, 0.0, 0.0}, .state = {0.2}};
  PointValues high{.local = up_right, .volume = 1.0, .sigma = {50.0, 0.0, 0.0, 8.0}, .state = {0.6}};
  Cell filled({low, high});
  filled.average();
  EXPECT_THAT(filled.gauss.sigma[0], ElementsAre(DoubleEq(10.0), DoubleEq(20.0), DoubleEq(20.0), DoubleEq(50.0)));
  EXPECT_THAT(filled.gauss.sigma[3], ElementsAre(0.0, DoubleEq(2.0), DoubleEq(2.0), DoubleEq(8.0)));
  EXPECT_THAT(filled.state[0], ElementsAre(DoubleEq(0.2), DoubleEq(0.3), DoubleEq(0.3), DoubleEq(0.6)));
  EXPECT_THAT(filled.gauss.weight, Each(DoubleEq(1.0)));
  high.volume = 0.5;
  Cell part({low, high});
  part.average();
  EXPECT_THAT(part.gauss.weight, ElementsAre(DoubleEq(3.0), 0.0, 0.0, DoubleEq(0.5)));
}

TEST(
    Weights, AFilledCellHasGaussWeightsAndAnyOtherItsPointsVolume)  // reading R3: filled from nine tenths of V_e = 4 on
{
  Cell filled({{.local = low_left, .volume = 3.61}});
  filled.average();
  EXPECT_THAT(filled.gauss.weight, Each(DoubleEq(1.0)));
  Cell part({{.local = low_left, .volume = 3.0}, {.local = up_left, .volume = 0.59}});
  part.average();
  EXPECT_THAT(part.gauss.weight, ElementsAre(DoubleEq(3.0), 0.0, DoubleEq(0.59), 0.0));
}

TEST(Weights, ChangeAtTheThresholdThatIsAsked)
{
  Cell cell({{.local = low_left, .volume = 3.0}});
  cell.average({.filled_fraction = 0.75});
  EXPECT_THAT(cell.gauss.weight, Each(DoubleEq(1.0)));
  cell.average({.filled_fraction = 0.76});
  EXPECT_THAT(cell.gauss.weight, ElementsAre(DoubleEq(3.0), 0.0, 0.0, 0.0));
}

TEST(Weights, MayBeTheVolumesOfThePointsEverywhere)
{
  Cell full(uneven_cell());
  full.average({.weights = Weights::summed});
  EXPECT_THAT(full.gauss.weight, ElementsAre(DoubleEq(1.2), 1.4, 0.6, 0.8));
}

TEST(Weights, OfSeveralMaterialsInAFilledCellShareTheGaussWeight)
{
  const auto mesh = make_rectangle({0.0, 0.0}, {2.0, 2.0}, {1, 1});
  GaussValues<Quad4> clay{}, sand{};
  clay.volume = {0.3, 1.0, 0.0, 0.5};
  sand.volume = {0.9, 0.0, 0.0, 1.5};
  const std::array<Real, 4> both{1.2, 1.0, 0.0, 2.0};
  set_weights(mesh.geometry(0), both, {}, clay);
  set_weights(mesh.geometry(0), both, {}, sand);
  EXPECT_THAT(clay.weight, ElementsAre(DoubleEq(0.25), DoubleEq(1.0), DoubleEq(1.8 / 4.2), DoubleEq(0.25)));
  for (int g = 0; g < 4; ++g) EXPECT_DOUBLE_EQ(clay.weight[g] + sand.weight[g], 1.0);
}

GaussValues<Quad4> uneven_gauss()
{
  GaussValues<Quad4> gauss{};
  gauss.sigma = {
      {{10.0, -7.0, 8.0, 100.0}, {20.0, 3.0, -6.0, 200.0}, {30.0, -2.0, 1.0, 300.0}, {1.0, 4.0, -5.0, 50.0}}};
  gauss.weight = {0.5, 1.0, 2.0, 0.1};
  return gauss;
}

TEST(SmoothPressure, Eq2_IsTheWeightedMeanOfTheGaussPressures)
{
  auto gauss = uneven_gauss();
  smooth_pressure(gauss);
  EXPECT_DOUBLE_EQ(gauss.pressure, (0.5 * 20.0 + 1.0 * -2.0 + 2.0 * 1.0 + 0.1 * 200.0) / 3.6);
}

TEST(SmoothPressure, Eq2_LeavesOutEmptySubCellsOfAPartFilledCell)
{
  Cell cell({{.local = low_left, .volume = 1.0, .sigma = {30.0, 30.0, 30.0, 0.0}},
      {.local = up_left, .volume = 0.5, .sigma = {60.0, 60.0, 60.0, 0.0}}});
  cell.average();
  smooth_pressure(cell.gauss);
  EXPECT_DOUBLE_EQ(cell.gauss.pressure, 40.0);
}

TEST(SmoothPressure, Eq3_ReplacesThePressureAndKeepsTheDeviator)  // reading R6: 3-D deviator, tr/3
{
  const auto before = uneven_gauss();
  auto after = before;
  smooth_pressure(after);
  for (int g = 0; g < 4; ++g) {
    EXPECT_NEAR((after.sigma[0][g] + after.sigma[1][g] + after.sigma[2][g]) / 3.0, after.pressure, 1e-13);
    EXPECT_NEAR(after.sigma[0][g] - after.sigma[1][g], before.sigma[0][g] - before.sigma[1][g], 1e-13);
    EXPECT_NEAR(after.sigma[1][g] - after.sigma[2][g], before.sigma[1][g] - before.sigma[2][g], 1e-13);
    EXPECT_EQ(after.sigma[3][g], before.sigma[3][g]);
  }
}

TEST(SmoothPressure, KeepsTheMeanStressOfTheCell)
{
  auto gauss = uneven_gauss();
  const auto total = [&] {
    Real sum = 0.0;
    for (int g = 0; g < 4; ++g) sum += gauss.weight[g] * (gauss.sigma[0][g] + gauss.sigma[1][g] + gauss.sigma[2][g]);
    return sum;
  };
  const Real before = total();
  smooth_pressure(gauss);
  EXPECT_NEAR(total(), before, 1e-12);
}

TEST(AverageOverCell, GivesAllGaussPointsTheMeanWithTheWeightsOfEq2)  // reading R9
{
  std::array<Real, 4> state{0.1, 0.2, 0.4, 0.8};
  average_over_cell(uneven_gauss().weight, state);
  EXPECT_THAT(state, Each(DoubleEq((0.5 * 0.1 + 1.0 * 0.2 + 2.0 * 0.4 + 0.1 * 0.8) / 3.6)));
}

}  // namespace gauss_average_test
