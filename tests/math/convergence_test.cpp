#include "math/convergence.hpp"
#include "support/test.hpp"

namespace convergence_test {

/// y = 3 + a x^p at three sizes.
RefinementEstimate estimate_of(Real a, Real p, const std::vector<Real>& x)
{
  std::vector<Real> y;
  for (const Real size : x) y.push_back(3.0 + a * std::pow(size, p));
  return estimate_limit(x, y);
}

TEST(Convergence, FindsOrderLimitAndIndexWhateverTheRatios)
{
  for (const Real a : {-0.4, 0.7})
    for (const Real p : {0.6, 1.0, 1.7})
      for (const auto& x : {std::vector<Real>{0.9, 0.3, 0.2}, {0.2, 0.15, 0.05}, {0.1, 0.4, 0.2}}) {
        const RefinementEstimate e = estimate_of(a, p, x);
        const Real finest = *std::ranges::min_element(x);
        EXPECT_EQ(e.trend, Trend::monotone);
        EXPECT_NEAR(e.order, p, 1e-10);
        EXPECT_NEAR(e.limit, 3.0, 1e-11);
        EXPECT_NEAR(e.uncertainty, 1.25 * std::abs(a) * std::pow(finest, p), 1e-11);
        EXPECT_TRUE(e.order_is_usable());
      }
}

TEST(Convergence, GivesTheNumbersOfThePublishedExample)
{
  // Celik et al. (2008), Table 1: reattachment length, 18000, 8000, 4500 cells, p = 1.53, limit 6.1685, GCI 2.2 %.
  const RefinementEstimate e = estimate_limit(
      {1.0 / std::sqrt(18000.0), 1.0 / std::sqrt(8000.0), 1.0 / std::sqrt(4500.0)}, {6.063, 5.972, 5.863});
  EXPECT_NEAR(e.order, 1.53, 0.005);
  EXPECT_NEAR(e.limit, 6.1685, 0.0005);
  EXPECT_NEAR(100.0 * e.uncertainty / 6.063, 2.2, 0.05);
}

TEST(Convergence, SaysWhatASequenceDoesThatHasNoOrder)
{
  const auto trend = [](const std::vector<Real>& x, const std::vector<Real>& y) { return estimate_limit(x, y).trend; };
  EXPECT_EQ(trend({1.0, 0.5}, {1.0, 1.1}), Trend::unknown);
  EXPECT_EQ(trend({1.0, 0.5, 0.25}, {1.4, 0.9, 1.0}), Trend::oscillating);
  EXPECT_EQ(trend({1.0, 0.5, 0.25}, {1.4, 1.3, 1.0}), Trend::diverging);
  EXPECT_EQ(trend({1.0, 0.5, 0.25}, {1.4, 1.2, 1.0}), Trend::diverging);  // order 0: as log x
  EXPECT_EQ(trend({1.0, 0.5, 0.25}, {1.4, 1.0, 1.0}), Trend::unchanged);
  EXPECT_EQ(trend({1.0, 0.5, 0.25}, {1.0, 1.0, 1.2}), Trend::diverging);
  EXPECT_EQ(trend({1.0, 0.5, 0.25, 0.125}, {9.0, 1.4, 1.1, 1.0}), Trend::monotone);  // the coarsest is not used
  // Differences of equal size where the last refinement is the weaker one: no order, though they seem to stand.
  EXPECT_EQ(trend({0.4, 0.2, 0.18}, {1.4, 1.2, 1.0}), Trend::diverging);
  EXPECT_TRUE(std::isnan(estimate_limit({1.0, 0.5, 0.25}, {1.4, 1.2, 1.0}).order));
  EXPECT_TRUE(std::isnan(estimate_limit({1.0, 0.5, 0.25}, {1.4, 1.2, 1.0}).limit));
}

TEST(Convergence, BoundsTheErrorOfASequenceWithoutAnOrder)
{
  const auto uncertainty = [](const std::vector<Real>& y) { return estimate_limit({1.0, 0.5, 0.25}, y).uncertainty; };
  EXPECT_NEAR(uncertainty({4.1, 5.8, 5.79}), 0.85, 1e-12);  // half of its range
  EXPECT_NEAR(uncertainty({5.0, 5.2, 4.0}), 0.6, 1e-12);
  EXPECT_NEAR(uncertainty({1.0, 1.1, 1.3}), 3.0 * 0.2 / (std::sqrt(2.0) - 1.0), 1e-12);
  EXPECT_EQ(uncertainty({1.0, 1.3, 1.3}), 0.0);
}

TEST(Convergence, TrustsAnOrderBeyondItsBoundsLess)
{
  const RefinementEstimate steep = estimate_of(0.5, 6.0, {1.0, 0.5, 0.25}),
                           slow = estimate_of(0.5, 0.2, {1.0, 0.5, 0.25});
  EXPECT_NEAR(steep.order, 6.0, 1e-10);
  EXPECT_FALSE(steep.order_is_usable());
  EXPECT_NEAR(steep.uncertainty, 3.0 * 0.5 * (std::pow(0.5, 6.0) - std::pow(0.25, 6.0)) / 3.0, 1e-12);
  EXPECT_FALSE(slow.order_is_usable());
  EXPECT_NEAR(slow.uncertainty, 3.0 * 0.5 * (std::pow(0.5, 0.2) - std::pow(0.25, 0.2)) / (std::sqrt(2.0) - 1.0), 1e-12);
}

TEST(Convergence, TakesNoOrderBeyondItsBounds)
{
  const RefinementEstimate steep = estimate_limit({0.25, 0.5, 1.0}, {1.0, 1.0 + 1.0 / 64.0, 2.0 + 1.0 / 64.0});
  EXPECT_NEAR(steep.limit, 1.0 - 1.0 / 64.0 / 3.0, 1e-12);  // order 6: taken as 2
}

}  // namespace convergence_test
