#include "model/libraries/law_trial.hpp"
#include "run/loop/simulation.hpp"
#include "support/law_cases.hpp"

namespace law_trial_test {

using LawTrialDeathTest = testing::Test;

void try_for(const MaterialCase& material, double limit_s)
{
  const Simulation s(free_box("mpm_gp", {0.5, 0.0}, {3.5, 1.0}, material), 1);
  LawTrial trial(s.model.materials[0], s.state.points.block(0), 0.25, s.model.dt, limit_s);
  trial.prepare({0.0, 0.0, 0.0, 1e-6});
  trial.call();
}

TEST(LawTrialDeathTest, EndsTheProgramWhereTheLawDoesNotReturn)
{
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(try_for(wrong_umat(loops), 0.2), testing::ExitedWithCode(3),
      "error: the law of material `rock` did not return from a trial in 0.[2-9]+ s: it may loop without end\n\n"
      "  where    [0-9]+ points of cell [0-9]+, the first at x = .*strain increment 0, 0, 0, 1e-06; dt = .*"
      "state 0\n.*left     nothing was run, and nothing was written");
}

TEST(LawTrialDeathTest, LeavesALawThatReturnsAlone)
{
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT((try_for(wrong_umat(elastic_law), 0.2), std::exit(0)), testing::ExitedWithCode(0), "");
}

TEST(LawTrial, GoesOnFromWhereTheLastCallLeftThePoints)
{
  const Simulation s(free_box("mpm_gp", {0.5, 0.0}, {3.5, 1.0}, wrong_umat(elastic_law)), 1);
  LawTrial trial(s.model.materials[0], s.state.points.block(0), 0.25, s.model.dt);
  trial.prepare({0.0, 0.0, 0.0, 1e-6});
  trial.call();
  trial.call();
  EXPECT_NEAR(trial.stress_change(0)[3], 4e-6 * shear, 1e-9 * shear);
  const auto n = static_cast<std::size_t>(s.state.points.block(0).n_padded());
  EXPECT_EQ(trial.stress_and_state()[4 * n], 2.0) << "the state counts the calls";
}

}  // namespace law_trial_test
