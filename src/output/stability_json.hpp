// stability.json and stability.txt: a factor of safety with its bracket, and the trials it rests on (docs/formats.md).
#pragma once

#include "stability/bisection.hpp"
#include "stability/reduce.hpp"

#include <string>
#include <vector>

namespace terp {

/// All that a search for a factor of safety leaves behind.
struct StabilityReport {
  std::string case_name, case_toml, scheme;
  std::vector<Strength> strengths;   ///< that were reduced, unreduced
  TrialRules rules;
  BisectionOptions options;
  Real height = 0.0;                 ///< H [m]
  Real displacement = 0.0;           ///< rho g H^2 / E [m]
  std::int64_t n_points = 0, rest_steps = 0;
  Bisection search;
};

/// Middle of the bracket; not a number without one.
Real factor_of(const Bisection& search);

std::string stability_json(const StabilityReport& report);
/// For a person: the factor, its bracket, the criterion, a line per trial.
std::string stability_text(const StabilityReport& report);

/// Writes both into a folder, which is made if need be. Throws FileError.
void write_stability(const std::string& folder, const StabilityReport& report);

}  // namespace terp
