// What single keys cannot show: keys that contradict each other, names that lead nowhere, a law's own limits.
// Not for: geometry against the mesh (simulation/setup).
#pragma once

#include "input/document.hpp"
#include "input/values.hpp"
#include "simulation/case.hpp"

namespace terp {

/// Adds what is wrong or doubtful. `values` were read from `root`; what could not be read is left out of the checks.
void check_case(const Node& root, const Case& values, Findings& findings);

}  // namespace terp
