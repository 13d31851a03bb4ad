#include "sections.hpp"

namespace water_column_test {

/// Water of 10 kN/m3: phreatic line at 2 m, an aquifer below z = -8 m with its head at 5 m.
StixWater aquifer()
{
  StixWater water{.unit_weight = 10e3};
  water.head_lines = {{"p", "", {{0.0, 2.0}, {10.0, 2.0}}}, {"a", "", {{3.0, 5.0}}}};
  water.phreatic = 0;
  water.reference_lines = {{"top", {{4.0, -8.0}}, 1, 1}};  // lines of one place are level
  return water;
}

TEST(WaterColumn, IsHydrostaticWithoutReferenceLinesAndDryAboveThePhreaticLine)
{
  StixWater water = aquifer();
  water.reference_lines.clear();
  const StixWaterColumn column(water, 5.0, 6.0);
  EXPECT_EQ(column.pressure(2.0), 0.0);
  EXPECT_EQ(column.pressure(3.0), 0.0);
  EXPECT_DOUBLE_EQ(column.pressure(-3.0), 50e3);
  EXPECT_EQ(column.free_water(), 0.0);
}

TEST(WaterColumn, IsLinearFromThePhreaticLineToAReferenceLineAndHydrostaticBelowTheLast)
{
  const StixWaterColumn column(aquifer(), 5.0, 6.0);
  EXPECT_DOUBLE_EQ(column.pressure(-8.0), 130e3);  // 10 (5 + 8)
  EXPECT_DOUBLE_EQ(column.pressure(-3.0), 65e3);   // half-way from 0 at z = 2
  EXPECT_DOUBLE_EQ(column.pressure(-10.0), 150e3);
}

TEST(WaterColumn, BeginsAtTheGroundUnderFreeWater)
{
  const StixWaterColumn column(aquifer(), 5.0, 0.0);
  EXPECT_EQ(column.free_water(), 2.0);
  EXPECT_DOUBLE_EQ(column.pressure(1.0), 10e3);
  EXPECT_DOUBLE_EQ(column.pressure(0.0), 20e3);
  EXPECT_DOUBLE_EQ(column.pressure(-4.0), 75e3);  // half-way from 20 to 130
}

TEST(WaterColumn, IgnoresAReferenceLineAboveTheGround)
{
  StixWater water = aquifer();
  water.reference_lines.push_back({"ditch", {{4.0, 1.0}}, 1, 1});
  EXPECT_DOUBLE_EQ(StixWaterColumn(water, 5.0, 0.0).pressure(-4.0), 75e3);
  EXPECT_DOUBLE_EQ(StixWaterColumn(water, 5.0, 6.0).pressure(1.0), 40e3);  // above 6 m of ground it counts
}

TEST(WaterColumn, JumpsAtALineWithTwoHeads)
{
  StixWater water = aquifer();
  water.reference_lines[0].bottom_head = 0;
  const StixWaterColumn column(water, 5.0, 6.0);
  EXPECT_NEAR(column.pressure(-8.0 + 1e-9), 130e3, 1e-3);
  EXPECT_DOUBLE_EQ(column.pressure(-9.0), 110e3);  // 10 (2 + 9)
}

TEST(WaterColumn, TakesThePartToTheRightAtAVerticalStep)
{
  StixWater water = aquifer();
  water.reference_lines.clear();
  water.head_lines[0].line = {{0.0, 4.0}, {5.0, 4.0}, {5.0, 1.0}, {9.0, 0.0}};
  EXPECT_EQ(StixWaterColumn(water, 4.999, 9.0).phreatic(), 4.0);
  EXPECT_EQ(StixWaterColumn(water, 5.0, 9.0).phreatic(), 1.0);
  EXPECT_EQ(StixWaterColumn(water, 7.0, 9.0).phreatic(), 0.5);
  EXPECT_EQ(StixWaterColumn(water, 99.0, 9.0).phreatic(), 0.0);
  EXPECT_EQ(StixWaterColumn(water, -9.0, 9.0).phreatic(), 4.0);
}

TEST(WaterColumn, IsDryWithoutAPhreaticLine)
{
  StixWater water = aquifer();
  water.phreatic.reset();
  const StixWaterColumn column(water, 5.0, 0.0);
  EXPECT_EQ(column.pressure(-9.0), 0.0);
  EXPECT_EQ(column.free_water(), 0.0);
}

TEST(WaterColumn, IsLinearInTheTrianglesOfAMesh)
{
  StixWater water{.unit_weight = 10e3, .is_mesh = true};
  // u = 10 (3 - z) + x over a square of 4 m, in kPa, from z = 0 to 4
  const auto u = [](Vec<2> p) { return 1e3 * (10.0 * (3.0 - p[1]) + p[0]); };
  const std::array<Vec<2>, 4> c{{{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}}};
  water.mesh = {{{c[0], c[1], c[2]}, {u(c[0]), u(c[1]), u(c[2])}}, {{c[0], c[2], c[3]}, {u(c[0]), u(c[2]), u(c[3])}}};
  const StixWaterColumn column(water, 1.0, 4.0);
  EXPECT_NEAR(column.pressure(0.5), 26e3, 1e-9);
  EXPECT_NEAR(column.pressure(2.5), 6e3, 1e-9);
  EXPECT_NEAR(column.phreatic(), 3.1, 1e-12);
  EXPECT_EQ(column.pressure(3.2), 0.0);
  EXPECT_NEAR(StixWaterColumn(water, 9.0, 4.0).pressure(1.0), 24e3, 1e-9);  // beyond: as at its end
}

TEST(WaterColumn, HasNoSuctionInAMesh)
{
  StixWater water{.unit_weight = 10e3, .is_mesh = true};
  const auto strip = [&](Real low, Real high, Real at_low, Real at_high) {  // x from 0 to 2, linear in z
    water.mesh.push_back({{{{0.0, low}, {2.0, low}, {0.0, high}}}, {at_low, at_low, at_high}});
    water.mesh.push_back({{{{2.0, low}, {2.0, high}, {0.0, high}}}, {at_low, at_high, at_high}});
  };
  strip(2.0, 4.0, 5e3, -5e3);    // wet up to z = 3
  strip(0.0, 2.0, -5e3, 5e3);    // dry under it, down to z = 1
  strip(-2.0, 0.0, 15e3, -5e3);  // wet again below z = -0.5
  const StixWaterColumn column(water, 1.0, 4.0);
  EXPECT_NEAR(column.phreatic(), 3.0, 1e-12);
  EXPECT_EQ(column.pressure(0.5), 0.0);
  EXPECT_FALSE(column.is_below(0.5));
  EXPECT_TRUE(column.is_below(2.5));
  EXPECT_NEAR(column.pressure(-1.5), 10e3, 1e-9);
}

}  // namespace water_column_test
