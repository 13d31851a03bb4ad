// When a trial counts as standing or failing, from its windows and on a small column.
#include "stability/trial.hpp"

#include "base/errors.hpp"
#include "simulation/setup_mesh.hpp"
#include "support/cases.hpp"

#include <gmock/gmock.h>

namespace terp {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const TrialRules rules{.damping = 0.5, .rest = 1e-4, .failure = 1.0, .most_windows = 40};
const std::atomic<bool> go{false};

/// Windows of these displacements [m] that are never at rest.
std::vector<TrialWindow> moving(std::initializer_list<Real> displacements)
{
  std::vector<TrialWindow> windows;
  for (const Real d : displacements) windows.push_back({0.1 * static_cast<Real>(windows.size() + 1), d, 0.02});
  return windows;
}

TEST(Judge, StandsWhenForcesAreInBalance)
{
  auto windows = moving({0.01, 0.015});
  EXPECT_EQ(judge(windows, rules, 0.05), TrialVerdict::undecided);
  windows.back().out_of_balance = 0.9e-4;
  EXPECT_EQ(judge(windows, rules, 0.05), TrialVerdict::stable);
}

TEST(Judge, FailsWhenItMovedFarAndDoesNotSlowDown)
{
  EXPECT_EQ(judge(moving({0.01, 0.03, 0.06}), rules, 0.05), TrialVerdict::failed);
  EXPECT_EQ(judge(moving({0.01, 0.03, 0.045}), rules, 0.05), TrialVerdict::undecided);  // not far
  EXPECT_EQ(judge(moving({0.01, 0.04, 0.06}), rules, 0.05), TrialVerdict::undecided);   // slows down
  EXPECT_EQ(judge(moving({0.05, 0.2}), rules, 0.05), TrialVerdict::undecided);          // too early to say
  EXPECT_EQ(judge({}, rules, 0.05), TrialVerdict::undecided);
}

/// The column of model 1 on a rough base, which stands up to a factor of about 0.8.
struct Column {
  Case quiet;
  Mesh<2> mesh;
  ElasticStart start;
  Column() : quiet(quiet_case(make())), mesh(build_mesh(quiet)), start(settle_elastically(quiet, mesh, 1, go)) {}
  static Case make()
  {
    Case c = test::column_without_softening("mpm_mixed");
    c.footings.emplace_back();
    c.bodies[0].velocity = {1.0, 0.0};
    return c;
  }
  Trial at(Real factor, const TrialRules& r = rules) const
  {
    return run_trial(quiet, mesh, start, factor, r, 1, go, [](const Trial&) {});
  }
};

TEST(ElasticStart, IsAtRestWithScalesOfTheSoil)
{
  const Column column;
  EXPECT_TRUE(column.quiet.footings.empty());
  EXPECT_EQ(column.quiet.bodies[0].velocity, (Vec<2>{0.0, 0.0}));
  EXPECT_EQ(column.start.rest.step, 0);
  EXPECT_GT(column.start.steps, 10);
  const Real height = 1.9;  // between the outer rows of points, 5 per cell of 0.5 m
  EXPECT_NEAR(column.start.height, height, 1e-9);
  EXPECT_NEAR(column.start.traversal, height / std::sqrt(2.0e6 / 1990.0), 1e-12);
  EXPECT_NEAR(column.start.displacement, 1990.0 * 9.81 * height * height / (2.0 * 2.0e6 * 1.48), 1e-9);
}

TEST(ElasticStart, NeedsGravity)
{
  Case c = Column::make();
  c.forces.gravity = {0.0, 0.0};
  EXPECT_THROW(settle_elastically(quiet_case(c), build_mesh(c), 1, go), InputError);
}

TEST(Trial, StandsWithMoreStrengthAndRunsAwayWithLess)
{
  const Column column;
  const Trial strong = column.at(0.5), weak = column.at(2.0);
  EXPECT_EQ(strong.verdict, TrialVerdict::stable);
  EXPECT_THAT(strong.reason, StartsWith("at rest: out of balance"));
  EXPECT_LT(strong.windows.back().out_of_balance, 1e-4);
  EXPECT_EQ(weak.verdict, TrialVerdict::failed);
  EXPECT_THAT(weak.reason, HasSubstr("rho g H^2/E"));
  EXPECT_GT(weak.windows.back().displacement, column.start.displacement);
  EXPECT_LT(std::ssize(weak.windows), 40);  // early
}

TEST(Trial, IsTheSameEachTime)
{
  const Column column;
  const Trial a = column.at(1.1), b = column.at(1.1);
  ASSERT_EQ(a.windows.size(), b.windows.size());
  EXPECT_EQ(a.windows.back().displacement, b.windows.back().displacement);
}

TEST(Trial, EndsUndecidedWhenItsTimeIsUp)
{
  TrialRules impatient = rules;
  impatient.most_windows = 3;
  impatient.rest = 1e-12;
  const Trial trial = Column().at(0.5, impatient);
  EXPECT_EQ(trial.verdict, TrialVerdict::undecided);
  EXPECT_EQ(trial.windows.size(), 3u);
  EXPECT_THAT(trial.reason, StartsWith("creeps: "));
}

TEST(Trial, StopsWhenAsked)
{
  const Column column;
  const std::atomic<bool> stop{true};
  EXPECT_THROW(run_trial(column.quiet, column.mesh, column.start, 1.0, rules, 1, stop, [](const Trial&) {}), RunError);
}

}  // namespace
}  // namespace terp
