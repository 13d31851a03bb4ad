#include "model/water/water_pressure.hpp"
#include "support/test.hpp"

namespace water_pressure_test {

WaterCase river()
{
  WaterCase water;
  water.unit_weight = 10.0e3;
  water.start.phreatic_line = {{-10.0, 4.0}, {10.0, 1.0}};
  return water;
}

TEST(WaterPressure, ALineIsConstantBeyondItsEndsAndTakesTheLastPlaceOfAStep)
{
  const std::vector<Vec<2>> line{{0.0, 4.0}, {2.0, 3.0}, {2.0, 1.0}, {6.0, 0.0}};
  EXPECT_EQ(elevation_at(line, -5.0), 4.0);
  EXPECT_EQ(elevation_at(line, 1.0), 3.5);
  EXPECT_EQ(elevation_at(line, 2.0), 1.0);
  EXPECT_EQ(elevation_at(line, 3.0), 0.75);
  EXPECT_EQ(elevation_at(line, 60.0), 0.0);
  EXPECT_EQ(elevation_at(std::vector<Vec<2>>{{7.0, 2.5}}, -3.0), 2.5);
}

TEST(WaterPressure, IsHydrostaticBelowThePhreaticLineAndZeroAbove)
{
  const WaterCase water = river();
  EXPECT_DOUBLE_EQ(water_pressure(water, water.start, {0.0, 0.5}, 0.0), 10.0e3 * 2.0);
  EXPECT_EQ(water_pressure(water, water.start, {0.0, 3.0}, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(unlimited_pressure(water, water.start, {0.0, 3.0}, 0.0), -10.0e3 * 0.5);
}

TEST(WaterPressure, FollowsTheHeadsOfReferenceLines)
{
  WaterCase water = river();
  water.start.head_lines = {{"upper", {{0.0, 3.0}}}, {"aquifer", {{-10.0, 6.0}, {10.0, 2.0}}}};
  water.start.reference_lines = {{{{0.0, -6.0}}, "aquifer", "aquifer"}, {{{0.0, -2.0}}, "phreatic", "upper"}};
  const WaterColumn column(water.start, 0.0);  // phreatic 2.5, upper 3, aquifer 4
  EXPECT_DOUBLE_EQ(column.head(8.0), 2.5);
  EXPECT_DOUBLE_EQ(column.head(-1.0), 2.5);
  EXPECT_DOUBLE_EQ(column.head(-2.0), 2.5);
  EXPECT_DOUBLE_EQ(column.head(-3.0), 3.25);  // a quarter of the way from 3 to 4
  EXPECT_DOUBLE_EQ(column.head(-6.0), 4.0);
  EXPECT_DOUBLE_EQ(column.head(-9.0), 4.0);
  EXPECT_DOUBLE_EQ(water_pressure(water, water.start, {0.0, -3.0}, 0.0), 10.0e3 * 6.25);
}

TEST(WaterPressure, AFormulaTakesThePlaceOfLines)
{
  WaterCase water;
  water.start.formula = [](Vec<2> x, Real t) { return 100.0 * x[0] - 7.0 * x[1] + t; };
  EXPECT_DOUBLE_EQ(water_pressure(water, water.start, {2.0, 3.0}, 0.5), 179.5);
}

TEST(WaterPressure, KnotsAreTheStartAndTheTimedSituationsInOrder)
{
  WaterCase water = river();
  water.situations.resize(3);
  water.situations[0].time = 20.0;
  water.situations[1].name = "high";
  water.situations[2].time = 5.0;
  const auto knots = knots_of(water);
  ASSERT_EQ(knots.size(), 3u);
  EXPECT_EQ(knots[0].situation, 0u);
  EXPECT_EQ(knots[1].situation, 3u);
  EXPECT_EQ(knots[1].time, 5.0);
  EXPECT_EQ(knots[2].situation, 1u);
}

TEST(WaterTable, IsThePhreaticLineOrWhereAFormulaHasItsHighestWater)
{
  WaterCase water = river();
  EXPECT_EQ(water_table(water, water.start, {0.0, 0.0}, {9.0, 9.0}), water.start.phreatic_line);
  WaterSituation grid;  // still water 2 to 3 m above the base, and an aquifer of higher head below it
  grid.formula = [](Vec<2> x, Real) { return x[1] < 0.5 ? 60e3 : 10.0e3 * std::max(2.0 + 0.1 * x[0] - x[1], 0.0); };
  const auto table = water_table(water, grid, {0.0, 0.0}, {10.0, 7.0});
  ASSERT_EQ(table.size(), 201u);
  for (const Vec<2>& place : table) EXPECT_NEAR(place[1], 2.0 + 0.1 * place[0], 1e-9) << place[0];
  EXPECT_NEAR(water_table(water, grid, {0.0, 0.0}, {10.0, 1.0}).back()[1], 3.0, 1e-9) << "higher than the mesh";
  grid.formula_changes = true;
  EXPECT_THAT(water_table(water, grid, {0.0, 0.0}, {10.0, 7.0}), IsEmpty());
  grid.formula_changes = false;
  grid.formula = [](Vec<2>, Real) { return 0.0; };
  EXPECT_THAT(water_table(water, grid, {0.0, 0.0}, {10.0, 7.0}), IsEmpty());
}

}  // namespace water_pressure_test
