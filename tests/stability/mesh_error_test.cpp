#include "stability/mesh_error.hpp"
#include "support/test.hpp"

namespace mesh_error_test {

Real factor_at(Real cell, Real order) { return 1.3 + 0.1 * std::pow(cell, order); }

TEST(MeshError, TwoSizesAreExtrapolatedByTheUsualOrderWithTheRangeOfOrders)
{
  const FactorLimit limit = extrapolate_factor({{0.5, factor_at(0.5, 0.8), 0.0}, {1.0, factor_at(1.0, 0.8), 0.0}});
  EXPECT_NEAR(limit.factor, 1.3, 1e-12);
  EXPECT_EQ(limit.order, 0.8);
  EXPECT_FALSE(limit.order_is_observed);
  const Real fine = factor_at(0.5, 0.8), step = factor_at(1.0, 0.8) - fine;
  EXPECT_NEAR(limit.low, fine - step / (std::pow(2.0, 0.6) - 1.0), 1e-12);
  EXPECT_NEAR(limit.high, fine - step / (std::pow(2.0, 1.2) - 1.0), 1e-12);
}

TEST(MeshError, TheBracketsOfTheFactorsWidenTheRange)
{
  const FactorLimit sharp = extrapolate_factor({{0.5, 1.35, 0.0}, {1.0, 1.4, 0.0}}),
                    wide = extrapolate_factor({{1.0, 1.4, 0.01}, {0.5, 1.35, 0.01}});
  EXPECT_EQ(wide.factor, sharp.factor);
  const Real most = 0.01 + 0.02 / (std::pow(2.0, 0.6) - 1.0);
  EXPECT_NEAR(sharp.low - wide.low, most, 1e-12);
  EXPECT_NEAR(wide.high - sharp.high, most, 1e-12);
}

TEST(MeshError, ThreeSizesShowTheirOwnOrder)
{
  std::vector<SizedFactor> sizes;
  for (const Real cell : {2.0, 1.0, 0.5}) sizes.push_back({cell, factor_at(cell, 1.5), 0.0});
  const FactorLimit limit = extrapolate_factor(sizes);
  EXPECT_TRUE(limit.order_is_observed);
  EXPECT_NEAR(limit.order, 1.5, 1e-9);
  EXPECT_NEAR(limit.factor, 1.3, 1e-9);
  EXPECT_GE(limit.high, 1.3 - 1e-9);
  EXPECT_LT(limit.low, 1.3);
}

TEST(MeshError, TheBoundHoldsForTheSlopesItWasMeasuredOn)
{
  for (const auto& [n, error] : {std::pair{8.0, 0.114}, {16.0, 0.066}, {32.0, 0.038}, {5.0, 0.136}, {10.0, 0.066}}) {
    EXPECT_GE(largest_mesh_error(n), error) << n;
    EXPECT_LE(largest_mesh_error(n), 0.17) << n;
  }
  EXPECT_LT(largest_mesh_error(32.0), 0.04);
}

}  // namespace mesh_error_test
