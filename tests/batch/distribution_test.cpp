// Quantiles against those of another program (SciPy 1.10), to its digits.
#include "batch/distribution.hpp"

#include "support/test.hpp"

namespace distribution_test {

TEST(Distribution, QuantilesAreThoseOfMeanAndStandardDeviation)
{
  const Distribution log{.kind = DistributionKind::lognormal, .mean = 20e3, .sd = 6e3};
  EXPECT_NEAR(log.quantile(1e-4), 6429.440597815203, 1e-6);
  EXPECT_NEAR(log.quantile(0.5), 19156.525704423017, 1e-6);
  EXPECT_NEAR(log.quantile(0.975), 34056.16917170124, 1e-6);
  const Distribution largest{.kind = DistributionKind::gumbel, .mean = 3.0, .sd = 0.5};
  EXPECT_NEAR(largest.quantile(1e-3), 2.02153493774942, 1e-12);
  EXPECT_NEAR(largest.quantile(0.99), 4.568334214884786, 1e-12);
  const Distribution normal{.kind = DistributionKind::normal, .mean = -2.0, .sd = 3.0};
  EXPECT_NEAR(normal.quantile(0.975), -2.0 + 3.0 * 1.959963984540054, 1e-12);
  const Distribution between{.kind = DistributionKind::uniform, .lowest = 2.0, .highest = 6.0};
  EXPECT_DOUBLE_EQ(between.quantile(0.25), 3.0);
}

TEST(Distribution, ATruncatedOneStaysBetweenItsEnds)
{
  const Distribution cut{
      .kind = DistributionKind::truncated_normal, .mean = 10.0, .sd = 4.0, .lowest = 0.0, .highest = 15.0};
  EXPECT_NEAR(cut.quantile(1e-4), 0.020140371093367193, 1e-10);
  EXPECT_NEAR(cut.quantile(0.3), 7.58075048238499, 1e-10);
  EXPECT_NEAR(cut.quantile(0.9), 13.446254757371864, 1e-10);
  EXPECT_GE(cut.quantile(1e-15), 0.0);
  EXPECT_LE(cut.quantile(1.0 - 1e-15), 15.0);
}

TEST(Distribution, ATableIsLinearBetweenItsQuantiles)
{
  const Distribution table{
      .kind = DistributionKind::quantiles, .table = {{0.0, 1.0}, {0.5, 2.0}, {0.9, 10.0}, {1.0, 10.0}}};
  EXPECT_DOUBLE_EQ(table.quantile(0.25), 1.5);
  EXPECT_DOUBLE_EQ(table.quantile(0.7), 6.0);
  EXPECT_DOUBLE_EQ(table.quantile(0.95), 10.0);
}

TEST(Distribution, ProbabilityIsTheInverseOfTheQuantile)
{
  using enum DistributionKind;
  const Distribution all[] = {{.kind = normal, .mean = -2.0, .sd = 3.0}, {.kind = lognormal, .mean = 20e3, .sd = 6e3},
      {.kind = truncated_normal, .mean = 10.0, .sd = 4.0, .lowest = 0.0, .highest = 15.0},
      {.kind = uniform, .lowest = 2.0, .highest = 6.0}, {.kind = gumbel, .mean = 3.0, .sd = 0.5},
      {.kind = quantiles, .table = {{0.0, 1.0}, {0.5, 2.0}, {1.0, 10.0}}}};
  for (const Distribution& d : all) {
    for (const Real p : {0.01, 0.3, 0.5, 0.9, 0.999})
      EXPECT_NEAR(d.probability(d.quantile(p)), p, 1e-12) << static_cast<int>(d.kind);
    EXPECT_NEAR(d.probability(-1e6), 0.0, 1e-12);
    EXPECT_NEAR(d.probability(1e9), 1.0, 1e-12);
  }
}

// F = exp(-exp(-(h - location)/s)): at the location 1/e; high up a decimation height makes exceedance ten times rarer.
TEST(Distribution, AGumbelOneByLocationAndDecimationHeight)
{
  const Distribution water = gumbel_of(3.0, 0.6);
  EXPECT_NEAR(water.probability(3.0), std::exp(-1.0), 1e-14);
  EXPECT_NEAR((1.0 - water.probability(6.0)) / (1.0 - water.probability(6.6)), 10.0, 1e-3);
}

TEST(Distribution, KindsStandInTheOrderOfTheirTable)
{
  for (std::size_t k = 0; k < all_distributions().size(); ++k)
    EXPECT_EQ(static_cast<std::size_t>(all_distributions()[k].kind), k);
}

}  // namespace distribution_test
