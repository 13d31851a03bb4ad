#include "run/stability/bisection.hpp"
#include "support/test.hpp"

namespace bisection_test {

Trial trial(Real factor, TrialVerdict verdict)
{
  Trial made;
  made.factor = factor, made.verdict = verdict;
  return made;
}

/// Searches among trials that stand below `limit`, creep up to `creep`, and fail above.
Bisection search(Real limit, const BisectionOptions& options, Real creep = 0.0)
{
  Bisection found;
  while (const auto factor = next_factor(found, options))
    enter(trial(*factor, *factor < limit   ? TrialVerdict::stable
                         : *factor < creep ? TrialVerdict::undecided
                                           : TrialVerdict::failed),
        found);
  return found;
}

std::vector<Real> factors(const Bisection& b)
{
  std::vector<Real> list;
  for (const Trial& t : b.trials) list.push_back(t.factor);
  return list;
}

TEST(Bisection, HalvesBetweenTwoGuesses)
{
  const Bisection b = search(1.3, {1.0, 2.0, 0.25});
  EXPECT_THAT(factors(b), ElementsAre(1.0, 2.0, 1.5, 1.25));
  EXPECT_EQ(b.stable, 1.25);
  EXPECT_EQ(b.failed, 1.5);
}

TEST(Bisection, EndsWithTheBracketAsWideAsAsked)
{
  for (const Real limit : {0.07, 0.31, 0.97, 1.0, 2.6, 55.0}) {
    const Bisection b = search(limit, {{}, {}, 0.01});
    ASSERT_TRUE(b.found()) << limit;
    EXPECT_LE(*b.failed - *b.stable, 0.01 * (1.0 + 1e-6));
    EXPECT_LT(*b.stable, limit);
    EXPECT_GE(*b.failed, limit);
  }
}

TEST(Bisection, LooksBeyondGuessesThatDoNotHold)
{
  const Bisection below = search(0.5, {1.0, 2.0, 0.02}), above = search(3.1, {1.0, 2.0, 0.02});
  EXPECT_NEAR(*below.stable, 0.5, 0.02);
  EXPECT_NEAR(*above.failed, 3.1, 0.02);
}

TEST(Bisection, WhatCreepsMayStandOrFailSoBothEndsAreSought)
{
  const Bisection b = search(1.2, {1.0, 2.0, 0.01}, 1.4);
  EXPECT_LT(*b.stable, 1.2);
  EXPECT_GE(*b.not_stable, 1.2);
  EXPECT_LT(*b.not_stable, 1.22);
  EXPECT_GE(*b.failed, 1.4);
  EXPECT_LT(*b.failed, 1.42);
  EXPECT_EQ(b.highest(), b.failed);
}

TEST(Bisection, LooksBeyondCreepForATrialThatFails)
{
  const Bisection b = search(1.2, {1.0, 1.25, 0.02}, 1.4);  // 1.25 creeps
  EXPECT_GE(*b.failed, 1.4);
  EXPECT_LT(*b.failed, 1.44);
}

TEST(Bisection, GivesUpWhereAllCreeps)
{
  const Bisection b = search(1.2, {1.0, 1.25, 0.02}, 1e9);
  EXPECT_FALSE(b.failed.has_value());
  EXPECT_GT(*b.highest(), 1.5) << "up to a factor of 1.5 over what stands";
  EXPECT_LT(*b.highest(), 2.0);
}

TEST(Bisection, WhatStandsAboveAFailureDoesNotCount)
{
  Bisection b;
  for (const auto& [factor, verdict] : {std::pair{1.0, TrialVerdict::stable}, {1.2, TrialVerdict::failed},
           {1.3, TrialVerdict::stable}, {1.1, TrialVerdict::undecided}})
    enter(trial(factor, verdict), b);
  EXPECT_EQ(b.stable, 1.0);
  EXPECT_EQ(b.not_stable, 1.1);
  EXPECT_EQ(b.failed, 1.2);
}

TEST(Bisection, GivesUpWhereNothingFailsOrNothingStands)
{
  const Bisection strong = search(1e9, {{}, {}, 0.1}), weak = search(0.0, {{}, {}, 0.1});
  EXPECT_FALSE(strong.found());
  EXPECT_GT(*strong.stable, 50.0);
  EXPECT_FALSE(weak.found());
  EXPECT_LT(*weak.failed, 0.02);
}

TEST(Bisection, GuessesHowManyTrialsAreLeft)
{
  Bisection b;
  const BisectionOptions options{1.0, 2.0, 0.25};
  EXPECT_EQ(trials_left(b, options), 4);
  int left = 4;
  while (const auto factor = next_factor(b, options)) {
    EXPECT_EQ(trials_left(b, options), left--);
    enter(trial(*factor, *factor < 1.3 ? TrialVerdict::stable : TrialVerdict::failed), b);
  }
}

}  // namespace bisection_test
