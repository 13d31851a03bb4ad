// One run of a verification case, in this process, without files: its quantities.
#pragma once

#include "verify/expected.hpp"
#include "verify/scope.hpp"

#include <atomic>
#include <cmath>
#include <string>
#include <vector>

namespace terp {

struct Solve {
  const Expected* file;
  const Variant* variant;
  std::string scheme;
};

/// A quantity measured in one run, and the numbers that judge it; NaN where there is none.
struct Finding {
  const Quantity* quantity = nullptr;
  std::string run, scheme;  ///< "h = 0.25 m"
  Real value = NAN, reference = NAN;
  Real tolerance = NAN, relative = NAN, at_least = NAN, at_most = NAN;
  std::map<std::string, Real> constants = {};  ///< of the run
  std::string fault = {};                      ///< why it could not be measured; then the numbers have no meaning
};

struct Solved {
  std::vector<Finding> findings;
  std::string fault;  ///< why there are no findings: the run stopped, or its case cannot be used
  double seconds = 0.0;
};

/// Runs of the case: each variant with each of its schemes.
std::vector<Solve> list_solves(const Expected& file, bool with_short, bool with_long);

/// Never throws. Stops early when `stop` is set; then the fault says so.
Solved solve_variant(const Solve& solve, const std::atomic<bool>& stop);

/// Fills in tolerance and bounds. Throws CaseError for one that is not finite, or a tolerance below 0.
void read_bounds(const Scope& scope, Finding& finding);

/// Quantities of the case that this run measures.
bool measures(const Quantity& quantity, const Variant& variant);

}  // namespace terp
