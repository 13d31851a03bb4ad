// The scenarios of the NumPy twin (tests/reference/one_step.json) as models and states.
#pragma once

#include "support/simulations.hpp"

namespace terp::test {

/// What the twin expects of the points, by id: shape [n_points, n_components], row-major.
struct ExpectedField {
  std::string name;  ///< "x", "v", "volume", "sigma", "strain", "eps_eq_p"
  std::vector<Real> values;
};

struct Scenario {
  std::string name;
  std::int64_t n_steps = 0;
  Model model;
  State state;
  std::vector<ExpectedField> expected;
};

std::vector<std::string> scenario_names();
Scenario load_scenario(const std::string& name);
/// The same points without boundaries and damping.
Scenario load_free_scenario(const std::string& name);

std::vector<Real> field_values(const State& state, const std::string& name);

}  // namespace terp::test
