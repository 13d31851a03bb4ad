#include "mpm/features/load.hpp"
#include "support/test.hpp"

namespace load_test {

constexpr Real never = std::numeric_limits<Real>::infinity();

Load traffic(Real start, Real end, Real ramp) { return {"traffic", 1.0, 3.0, 13e3, start, end, ramp, 17}; }

TEST(Load, OneThatWasAlwaysThereActsInFull)
{
  const Load load = traffic(-never, never, 0.0);
  EXPECT_TRUE(load.is_permanent());
  EXPECT_EQ(load.pressure_at(0.0), 13e3);
  EXPECT_EQ(load.pressure_at(1e4), 13e3);
  EXPECT_EQ(load.first_step(0.01), -1);
}

TEST(Load, GrowsFromItsStartAndFallsFromItsEnd)
{
  const Load load = traffic(2.0, 5.0, 0.5);
  EXPECT_FALSE(load.is_permanent());
  EXPECT_EQ(load.pressure_at(1.999), 0.0);
  EXPECT_DOUBLE_EQ(load.pressure_at(2.125), 0.25 * 13e3);
  EXPECT_EQ(load.pressure_at(2.5), 13e3);
  EXPECT_EQ(load.pressure_at(4.999), 13e3);
  EXPECT_DOUBLE_EQ(load.pressure_at(5.375), 0.25 * 13e3);
  EXPECT_EQ(load.pressure_at(5.5), 0.0);
}

TEST(Load, WithoutARampIsThereAtOnce)
{
  EXPECT_EQ(traffic(2.0, never, 0.0).pressure_at(2.0), 13e3);
  EXPECT_EQ(traffic(-never, 3.0, 0.0).pressure_at(3.0), 0.0);
}

TEST(Load, BeginsWithTheStepThatHoldsItsStart)
{
  EXPECT_EQ(traffic(0.0, never, 0.0).first_step(0.01), 0);
  EXPECT_EQ(traffic(0.3, never, 0.0).first_step(0.1), 3);  // 0.3 / 0.1 is less than 3 by round-off
  EXPECT_EQ(traffic(0.35, never, 0.0).first_step(0.1), 3);
}

}  // namespace load_test
