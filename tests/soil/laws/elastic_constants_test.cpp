#include "soil/laws/elastic_constants.hpp"
#include "support/test.hpp"

namespace elastic_constants_test {

TEST(ElasticConstants, BulkModulusIsThatOfTheHandbook)
{
  EXPECT_DOUBLE_EQ(bulk_from_poisson(3.0, 0.0), 2.0);           // K = 2 G / 3
  EXPECT_DOUBLE_EQ(bulk_from_poisson(3.0, 0.25), 5.0);          // lambda = G: K = 5 G / 3
  EXPECT_NEAR(bulk_from_poisson(2e6, 0.48), 49.3333e6, 100.0);  // the paper's clay
}

TEST(ElasticConstants, TheConstrainedModulusAgreesWithYoungsModulus)
{
  const Real shear = 4e6, poisson = 0.3;
  const Real young = 2.0 * shear * (1.0 + poisson);
  const Real constrained = young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  EXPECT_NEAR(bulk_from_poisson(shear, poisson) + 4.0 / 3.0 * shear, constrained, 1e-8 * constrained);
}

TEST(ElasticConstants, TakeNoIncompressibleSoilAndNoNegativeRatio)
{
  EXPECT_TRUE(poisson_ratio_info.range.contains(0.0));
  EXPECT_TRUE(poisson_ratio_info.range.contains(0.499));
  EXPECT_FALSE(poisson_ratio_info.range.contains(0.5));
  EXPECT_FALSE(poisson_ratio_info.range.contains(-0.1));
  EXPECT_FALSE(shear_modulus_info.range.contains(0.0));
}

}  // namespace elastic_constants_test
