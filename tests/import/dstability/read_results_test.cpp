#include "archives.hpp"

namespace read_results_test {

TEST(ReadResults, TakesSuFromTheInputWhereTheOutputIsDividedByTheFactor)
{
  const StixProject project = read_stix(sample_path("tutorial-2026.01"));
  EXPECT_NEAR(project.scenarios[0].calculations[0].result->slices[20].su, 24836.237, 1e-3);
  EXPECT_TRUE(project.scenarios[4].stages[0].water.is_mesh);
  EXPECT_THAT(project.scenarios[4].stages[0].water.mesh, SizeIs(4711));
}

TEST(ReadResults, TakeShearStressAsTheStrengthButNotOfSpencer)
{
  const StixProject project = read_stix(sample_path("tutorial-2023"));
  const auto& calculations = project.scenarios[1].calculations;
  const StixSlice& bishop = calculations[0].result->slices[20];
  EXPECT_NEAR(bishop.strength, bishop.su, 1e-6 * bishop.su);
  const StixSlice& spencer = calculations[1].result->slices[20];
  EXPECT_NEAR(spencer.strength, spencer.su, 1e-6 * spencer.su);
}

TEST(ReadResults, OfReliabilityHaveAnIndexAndNoSlices)
{
  const StixCalculation c = read_stix(sample_path("tutorial-2023")).scenarios[1].calculations[3];
  EXPECT_EQ(c.kind, StixCalculationKind::probabilistic);
  ASSERT_TRUE(c.result.has_value());
  EXPECT_TRUE(c.result->is_reliability);
  EXPECT_NEAR(c.result->reliability_index, 2.134, 5e-4);
  EXPECT_EQ(c.result->converged, true);
  EXPECT_THAT(c.result->slices, IsEmpty());
  EXPECT_TRUE(std::isnan(c.result->factor_of_safety));
}

TEST(ReadResults, LeaveOutSlicesWithoutAFoot)
{
  const std::string member = "results/bishopbruteforce/bishopbruteforceresult.json";
  const StixProject project = read_changed(member, "\"BottomLeft\":{\"X\":", "\"BottomLeft\":{\"X\":\"NaN\",\"Y\":");
  EXPECT_THAT(project.scenarios[0].calculations[0].result->slices, SizeIs(30));
  EXPECT_THAT(remarks_of(project), ElementsAre(member + ": 1 slices have no foot. Left out."));
}

}  // namespace read_results_test
