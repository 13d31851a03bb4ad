// Whole steps against the NumPy twin, which was written from the paper and the readings and not from the C++.
#include "mpm/step/kernels.hpp"
#include "support/twin.hpp"

namespace step_test {

/// Largest difference over the field's largest value; over 1 where the field is zero.
Real relative_error(const std::vector<Real>& got, const std::vector<Real>& expected)
{
  if (got.size() != expected.size()) return INFINITY;
  Real difference = 0.0, largest = 0.0;
  for (std::size_t k = 0; k < got.size(); ++k) {
    if (!std::isfinite(got[k])) return INFINITY;
    difference = std::max(difference, std::abs(got[k] - expected[k]));
    largest = std::max(largest, std::abs(expected[k]));
  }
  return difference / (largest > 0.0 ? largest : 1.0);
}

/// By number: to name them, each test of this program would first read the file.
class TwinStep : public TestWithParam<std::size_t> {};

TEST_P(TwinStep, IsThatOfTheNumPyTwinToRoundOff)
{
  Scenario scenario = load_scenario(scenario_names().at(GetParam()));
  SCOPED_TRACE(scenario.name);
  Simulation s(std::move(scenario.model), std::move(scenario.state));
  make_steps(s, scenario.n_steps);
  for (const auto& [field, expected] : scenario.expected)
    EXPECT_LE(relative_error(field_values(s.state, field), expected), 1e-12) << field;
}

INSTANTIATE_TEST_SUITE_P(Scenarios, TwinStep, testing::Range<std::size_t>(0, 20));

TEST(Step, TheTwinHasScenariosForEveryScheme)
{
  EXPECT_EQ(scenario_names().size(), 20u);
  for (const char* scheme : {"standard_mpm", "mpm_mixed", "mpm_gp"})
    EXPECT_THAT(scenario_names(), Contains(StartsWith(scheme)));
}

TEST(Step, CountsItselfAndKeepsTimeAsAMultipleOfDt)
{
  Scenario scenario = load_scenario("mpm_gp_regular");
  Simulation s(std::move(scenario.model), std::move(scenario.state));
  make_steps(s, 3);
  EXPECT_EQ(s.state.step, 3);
  EXPECT_EQ(s.state.time, 3.0 * s.model.dt);
}

}  // namespace step_test
