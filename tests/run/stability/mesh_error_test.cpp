#include "run/stability/mesh_error.hpp"
#include "support/test.hpp"

namespace mesh_error_test {

Real factor_at(Real cell, Real order) { return 1.3 + 0.1 * std::pow(cell, order); }

TEST(MeshError, TwoSizesAreExtrapolatedByTheUsualOrderWithTheRangeOfOrders)
{
  const FactorLimit limit = extrapolate_factor({{0.5, factor_at(0.5, 1.0), 0.0}, {1.0, factor_at(1.0, 1.0), 0.0}});
  EXPECT_NEAR(limit.factor, 1.3, 1e-12);
  EXPECT_EQ(limit.order, 1.0);
  EXPECT_FALSE(limit.order_is_observed);
  const Real fine = factor_at(0.5, 1.0), step = factor_at(1.0, 1.0) - fine;
  EXPECT_NEAR(limit.low, fine - step / (std::pow(2.0, 0.6) - 1.0), 1e-12);
  EXPECT_NEAR(limit.high, fine - step / (std::pow(2.0, 1.4) - 1.0), 1e-12);
}

TEST(MeshError, TheBracketsOfTheFactorsWidenTheRange)
{
  const FactorLimit sharp = extrapolate_factor({{0.5, 1.35, 0.0}, {1.0, 1.4, 0.0}}),
                    wide = extrapolate_factor({{1.0, 1.4, 0.01}, {0.5, 1.35, 0.01}});
  EXPECT_EQ(wide.factor, sharp.factor);
  const Real most = 0.01 + 0.02 / (std::pow(2.0, 0.6) - 1.0);
  EXPECT_NEAR(sharp.low - wide.low, most, 1e-12);
  EXPECT_NEAR(wide.high, std::min(sharp.high + most, 1.36), 1e-12) << "at most what failed on the finest cells";
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
  // Cells over the depth, and what the factor was above: a vertical cut (limit analysis), one with phi = 20, then P5,
  // P10, P9, P1, P15 and P12 of docs/stability.md above the middle of what their authors found.
  for (const auto& [n, error] : {std::pair{8.0, 0.114}, {16.0, 0.066}, {32.0, 0.038}, {10.0, 0.132}, {5.0, 0.025},
           {5.2, 0.037}, {4.7, 0.052}, {7.0, 0.075}, {14.0, 0.033}, {8.7, 0.036}, {12.2, 0.048}, {24.9, 0.027}})
    EXPECT_GE(largest_mesh_error(n), error) << n;
  EXPECT_LT(largest_mesh_error(32.0), 0.05);
}

}  // namespace mesh_error_test
