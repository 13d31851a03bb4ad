// One run of a verification case, in this process, without files: its quantities.
#pragma once

#include "verification/expected.hpp"

#include <atomic>
#include <string>
#include <vector>

namespace terp {

/// One run with one scheme.
struct Solve {
  const Expected* file;
  const Variant* variant;
  std::string scheme;
};

/// What came of a quantity in one run, and the numbers that it is judged with; NaN where there is none.
struct Finding {
  const Quantity* quantity;
  std::string run;                 ///< "h = 0.25 m"
  std::string scheme;
  Real value, reference;
  Real tolerance, relative, at_least, at_most;
  std::map<std::string, Real> constants;  ///< of the run
};

struct Solved {
  std::vector<Finding> findings;
  std::string fault;               ///< why there are none: the run stopped, or its case cannot be used
  double seconds = 0.0;
};

/// Runs of the case: each variant with each of its schemes.
std::vector<Solve> list_solves(const Expected& file, bool with_short, bool with_long);

/// Never throws. Stops early when `stop` is set; then the fault says so.
Solved solve_variant(const Solve& solve, const std::atomic<bool>& stop);

/// Quantities of the case that this run measures.
bool measures(const Quantity& quantity, const Variant& variant);

}  // namespace terp
