// Orders and limits of known sequences.
#include "verification/convergence.hpp"
#include "support/test.hpp"

namespace {

TEST(Convergence, OrdersFromErrorsAndFromDifferences)
{
  EXPECT_NEAR(log_slope({0.5, 0.25, 0.125}, {8.0, 2.0, 0.5}), 2.0, 1e-12);
  EXPECT_TRUE(std::isnan(log_slope({0.5, 0.5}, {8.0, 2.0})));
  EXPECT_NEAR(observed_order({0.125, 0.5, 0.25}, {7.0 + 0.125, 7.5, 7.25}), 1.0, 1e-12);
}

TEST(Convergence, ExtrapolatesASequenceOfOneOrderToItsLimit)
{
  for (const Real order : {0.6, 1.0, 1.7}) {
    const auto y = [&](Real h) { return 3.0 - 0.4 * std::pow(h, order); };
    const Limit limit =
        extrapolate({0.5, 0.125, 0.25, 1.0}, {y(0.5), y(0.125), y(0.25), 100.0});  // the coarsest is not used
    EXPECT_NEAR(limit.value, 3.0, 1e-12);
    EXPECT_NEAR(limit.uncertainty, 1.25 * 0.4 * std::pow(0.125, order), 1e-12);
  }
}

TEST(Convergence, TakesNoOrderBeyondItsBounds)
{
  const Limit steep =
      extrapolate({0.25, 0.5, 1.0}, {1.0, 1.0 + 1.0 / 64.0, 1.0 + 1.0 / 64.0 + 1.0});  // order 6: taken as 2
  EXPECT_NEAR(steep.value, 1.0 - 1.0 / 64.0 / 3.0, 1e-12);
}

TEST(Convergence, IsNoNumberWhereNothingConverges)
{
  EXPECT_TRUE(std::isnan(extrapolate({0.25, 0.5}, {1.0, 1.1}).value));
  EXPECT_TRUE(std::isnan(extrapolate({0.25, 0.5, 1.0}, {1.0, 1.3, 1.4}).value));  // the differences grow
  EXPECT_TRUE(std::isnan(extrapolate({0.25, 0.5, 1.0}, {1.0, 0.9, 1.4}).value));  // it swings
}

}  // namespace
