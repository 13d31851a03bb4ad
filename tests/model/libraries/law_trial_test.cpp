#include "model/libraries/law_trial.hpp"
#include "run/loop/simulation.hpp"
#include "support/law_cases.hpp"

namespace law_trial_test {

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
