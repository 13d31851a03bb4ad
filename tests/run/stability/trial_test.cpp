#include "run/stability/trial.hpp"
#include "support/cases.hpp"

namespace trial_test {

const TrialRules rules{.damping = 0.5, .rest = 1e-4, .failure = 1.0, .most_windows = 40, .stiffening = 1000.0};
const std::atomic<bool> go{false};

/// Windows of these displacements [m].
std::vector<TrialWindow> moving(std::initializer_list<Real> displacements)
{
  std::vector<TrialWindow> windows;
  for (const Real d : displacements) windows.push_back({0.1 * static_cast<Real>(windows.size() + 1), d, 0.02});
  return windows;
}

/// Soil that is as far as 0.05 m at rho g H^2/E, and moves 10 m more per window where nothing holds it: 1 mm is rest.
ElasticStart scales()
{
  ElasticStart start;
  start.displacement = 0.05;
  start.free_motion = 10.0;
  return start;
}

TEST(Judge, StandsWhenItHardlyMovedInThreeWindowsInARow)
{
  EXPECT_EQ(judge(moving({0.02, 0.0205, 0.0203, 0.0212}), rules, scales()), TrialVerdict::stable);
  EXPECT_EQ(judge(moving({0.02, 0.0220, 0.0221, 0.0222}), rules, scales()), TrialVerdict::undecided);  // only in two
  EXPECT_EQ(judge(moving({0.02, 0.0185, 0.0184, 0.0183}), rules, scales()), TrialVerdict::undecided);  // swings back
  EXPECT_EQ(judge(moving({0.0002, 0.0003}), rules, scales()), TrialVerdict::undecided);  // too early to say
  EXPECT_EQ(judge(moving({0.0002, 0.0003, 0.0004}), rules, scales()), TrialVerdict::stable);
}

TEST(Judge, DoesNotFailFarFromItsStartOnceItStopsOrSpringsBack)
{
  EXPECT_EQ(judge(moving({0.1, 0.2500, 0.2505, 0.2505}), rules, scales()), TrialVerdict::undecided);  // stops
  EXPECT_EQ(judge(moving({0.1, 0.2500, 0.2505, 0.2504}), rules, scales()), TrialVerdict::undecided);  // springs back
  EXPECT_EQ(judge(moving({0.1, 0.2500, 0.2400, 0.2300}), rules, scales()), TrialVerdict::undecided);  // goes on so
  EXPECT_EQ(judge(moving({0.1, 0.2500, 0.2400, 0.2500}), rules, scales()), TrialVerdict::undecided);  // swings
  EXPECT_EQ(judge(moving({0.1, 0.2500, 0.2505, 0.2510, 0.2515}), rules, scales()), TrialVerdict::stable);
}

TEST(Judge, FailsWhenItMovedFarAndDoesNotSlowDown)
{
  EXPECT_EQ(judge(moving({0.01, 0.03, 0.06}), rules, scales()), TrialVerdict::failed);
  EXPECT_EQ(judge(moving({0.01, 0.03, 0.045}), rules, scales()), TrialVerdict::undecided);  // not far
  EXPECT_EQ(judge(moving({0.01, 0.04, 0.06}), rules, scales()), TrialVerdict::undecided);   // slows down
  EXPECT_EQ(judge(moving({0.05, 0.2}), rules, scales()), TrialVerdict::undecided);          // too early to say
  EXPECT_EQ(judge({}, rules, scales()), TrialVerdict::undecided);
}

/// Of the column of model 1 on a rough base, which stands up to a factor of about 0.8.
Trials trials(const TrialRules& of_all = rules, const std::atomic<bool>& stop = go)
{
  return {column_without_softening("mpm_mixed"), of_all, 1, stop};
}

TEST(Trial, StandsWithMoreStrengthAndRunsAwayWithLess)
{
  const Trials column = trials();
  const Trial strong = column.run(0.5), weak = column.run(2.0);
  EXPECT_EQ(strong.verdict, TrialVerdict::stable);
  EXPECT_THAT(strong.reason, StartsWith("at rest: out of balance"));
  EXPECT_LT(strong.windows.back().out_of_balance, 1e-2);
  EXPECT_EQ(weak.verdict, TrialVerdict::failed);
  EXPECT_THAT(weak.reason, HasSubstr("rho g H^2/E"));
  EXPECT_GT(weak.windows.back().displacement, column.start.displacement);
  EXPECT_LT(std::ssize(weak.windows), 40);  // early
  EXPECT_EQ(strong.mechanism, nullptr);
  ASSERT_NE(weak.mechanism, nullptr);
  EXPECT_EQ(weak.mechanism->factor, 2.0);
  EXPECT_EQ(weak.mechanism->stiffening, rules.stiffening);
  ASSERT_TRUE(weak.mechanism->moving.has_value());
  EXPECT_EQ(weak.mechanism->moving->way, Facing::right);
}

TEST(Trial, IsTheSameEachTime)
{
  const Trials column = trials();
  const Trial a = column.run(1.1), b = column.run(1.1);
  ASSERT_EQ(a.windows.size(), b.windows.size());
  EXPECT_EQ(a.windows.back().displacement, b.windows.back().displacement);
}

// Stresses do not depend on the stiffening, strains go with one over it: the same place in the same scales.
TEST(Trial, DoesNotDependOnHowSmallTheDisplacementsAre)
{
  const auto stiffened = [](Real stiffening) {
    TrialRules other = rules;
    other.stiffening = stiffening;
    return trials(other);
  };
  const Trials little = stiffened(1e2), much = stiffened(1e4);
  const Trial a = little.run(0.6), b = much.run(0.6);
  ASSERT_EQ(a.verdict, TrialVerdict::stable);
  ASSERT_EQ(b.verdict, TrialVerdict::stable);
  EXPECT_NEAR(a.windows.back().displacement, b.windows.back().displacement, 0.01 * much.start.displacement);
  EXPECT_NEAR(a.windows.front().time, b.windows.front().time, 1e-2 * b.windows.front().time);  // whole steps
}

TEST(Trial, EndsUndecidedWhenItsTimeIsUp)
{
  TrialRules impatient = rules;
  impatient.most_windows = 3;
  impatient.rest = 1e-15;
  const Trial trial = trials(impatient).run(0.5);
  EXPECT_EQ(trial.verdict, TrialVerdict::undecided);
  EXPECT_EQ(trial.windows.size(), 3u);
  EXPECT_THAT(trial.reason, StartsWith("creeps: "));
}

TEST(Trial, StopsWhenAsked)
{
  std::atomic<bool> stop{false};
  const Trials column = trials(rules, stop);
  stop = true;
  const Trial trial = column.run(1.0);
  EXPECT_EQ(trial.verdict, TrialVerdict::undecided);
  EXPECT_TRUE(trial.windows.empty());
}

}  // namespace trial_test
