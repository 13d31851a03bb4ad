#include "import/dstability/soil_strength.hpp"

#include "support/test.hpp"

namespace soil_strength_test {

TEST(SoilStrength, TakesTheFivePercentFractileOfTheLognormalDistributionAsDesignValue)
{
  EXPECT_NEAR(lognormal_fractile_5(0.30, 0.05), 0.225386, 5e-7);
  EXPECT_NEAR(lognormal_fractile_5(15e3, 3.5e3), 10.00e3, 5.0);
  EXPECT_EQ(lognormal_fractile_5(0.9, 0.0), 0.9);
  EXPECT_EQ(lognormal_fractile_5(0.0, 0.1), 0.0);
}

TEST(SoilStrength, TakesMeanOrFractileOnlyOfWhatIsProbabilistic)
{
  StixParameter s{.value = 0.23, .mean = 0.30, .deviation = 0.05, .is_probabilistic = true};
  EXPECT_EQ(value_of(s, StixBasis::deterministic), 0.23);
  EXPECT_EQ(value_of(s, StixBasis::mean), 0.30);
  EXPECT_NEAR(value_of(s, StixBasis::design), 0.225386, 5e-7);
  s.is_probabilistic = false;
  EXPECT_EQ(value_of(s, StixBasis::design), 0.23);
  EXPECT_EQ(value_of(s, StixBasis::mean), 0.23);
}

TEST(SoilStrength, FollowsTheKindOfTheCalculation)
{
  EXPECT_EQ(basis_of(StixCalculationKind::design), StixBasis::design);
  EXPECT_EQ(basis_of(StixCalculationKind::mean), StixBasis::mean);
  EXPECT_EQ(basis_of(StixCalculationKind::deterministic), StixBasis::deterministic);
  EXPECT_EQ(basis_of(StixCalculationKind::probabilistic), StixBasis::deterministic);
}

TEST(SoilStrength, OfShansepIsZeroWithoutEffectiveStress)
{
  // a slice of the tutorial: S 0.23, m 0.9, sigma' 99.02748 kPa, sigma_y 109.02748 kPa
  EXPECT_NEAR(shansep_strength(0.23, 0.9, 99027.48201120052, 109027.48201120052), 24836.236894367598, 1e-6);
  EXPECT_EQ(shansep_strength(0.23, 0.9, 0.0, 20e3), 0.0);
}

TEST(SoilStrength, OfATableIsLinearBetweenItsRowsAndConstantBeyond)
{
  const StixTable table{.rows = {{10e3, 5e3}, {20e3, 9e3}}};
  EXPECT_DOUBLE_EQ(table_strength(table, 15e3, StixBasis::deterministic), 7e3);
  EXPECT_EQ(table_strength(table, 5e3, StixBasis::deterministic), 5e3);
  EXPECT_EQ(table_strength(table, 90e3, StixBasis::deterministic), 9e3);
  EXPECT_TRUE(std::isnan(table_strength({}, 1e3, StixBasis::deterministic)));
}

TEST(SoilStrength, IsReducedByDavisWithTheDilatancy)
{
  // psi = 0: tan phi* = sin phi, c* = c cos phi; CohesionOutput of D-Stability for 7 kPa and 30 degrees is 6.0622 kPa
  const DavisStrength flat = davis_reduced(7e3, 30.0, 0.0);
  EXPECT_NEAR(flat.cohesion, 6062.177826, 1e-5);
  EXPECT_NEAR(std::tan(flat.friction * std::numbers::pi / 180.0), 0.5, 1e-12);
  const DavisStrength associated = davis_reduced(7e3, 30.0, 30.0);
  EXPECT_NEAR(associated.cohesion, 7e3, 1e-9);
  EXPECT_NEAR(associated.friction, 30.0, 1e-12);
  const DavisStrength some = davis_reduced(7e3, 30.0, 10.0);  // d = 1 - 0.173648 / 2 = 0.913176
  EXPECT_NEAR(some.cohesion, 7e3 * 0.984808 * 0.866025 / 0.913176, 0.1);
}

}  // namespace soil_strength_test
