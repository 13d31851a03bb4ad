#include "run/loop/reporter.hpp"
#include "support/test.hpp"

namespace reporter_test {

TEST(Due, IsTheStepNearestToEachMultiple)
{
  std::vector<std::int64_t> steps;
  for (std::int64_t step = 0; step <= 14; ++step)
    if (due(step, 0.3, 1.0)) steps.push_back(step);
  EXPECT_THAT(steps, ElementsAre(0, 3, 7, 10, 13));  // 0, 0.9, 2.1, 3.0, 3.9 s
}

TEST(Due, EveryStepIsDueWhenTheIntervalIsShorterThanAStep)
{
  for (std::int64_t step = 0; step < 20; ++step) EXPECT_TRUE(due(step, 0.3, 0.1)) << step;
}

TEST(Due, NothingIsDueWithoutAnInterval)
{
  for (std::int64_t step = 0; step < 5; ++step) EXPECT_FALSE(due(step, 0.3, 0.0));
}

}  // namespace reporter_test
