#include "cli/progress.hpp"
#include "support/test.hpp"

namespace progress_test {

Progress search(Real out_of_balance, std::int64_t step, bool at_most)
{
  Progress p{};
  p.step = step, p.n_steps = 20000, p.eta_s = 75.0;
  p.out_of_balance = out_of_balance, p.limit = 1e-4, p.at_most = at_most;
  return p;
}

TEST(SearchText, NamesATimeOnceItFollowsFromSteps)
{
  EXPECT_EQ(search_text(search(2.5e-3, 19, true)),
      "search for equilibrium: out of balance 2.5e-03 of the weight, limit 1.0e-04  step 19 of at most 20000");
  EXPECT_EQ(search_text(search(2.5e-3, 20, true)),
      "search for equilibrium: out of balance 2.5e-03 of the weight, limit 1.0e-04  step 20 of at most 20000  ETA at "
      "most 1 min 15 s");
  EXPECT_THAT(search_text(search(2.5e-3, 500, false)), testing::EndsWith("  ETA 1 min 15 s"));
}

TEST(SearchText, SaysWhyItGoesOnBelowTheLimit)
{
  EXPECT_EQ(search_text(search(9e-5, 500, false)),
      "search for equilibrium: out of balance 9.0e-05 of the weight, limit 1.0e-04 reached, the soil still moves  step "
      "500 of at most 20000  ETA 1 min 15 s");
  EXPECT_THAT(search_text(search(1.1e-4, 500, false)), testing::Not(HasSubstr("reached")));
}

TEST(ReadableDuration, IsInTheUnitsOfAPerson)
{
  EXPECT_EQ(readable_duration(9.94), "9.9 s");
  EXPECT_EQ(readable_duration(59.4), "59 s");
  EXPECT_EQ(readable_duration(75.0), "1 min 15 s");
  EXPECT_EQ(readable_duration(7620.0), "2 h 07 min");
}

}  // namespace progress_test
