// What can be computed but is hardly meant, and shows before a mesh is made: gravity, damping, softening, locking.
// Not for: quantities that are compared with the size of the soil (simulation/scale_warnings.hpp).
#pragma once

#include "base/errors.hpp"
#include "simulation/case.hpp"

namespace terp {

/// Adds warnings. The values were read, and may be incomplete.
void check_physics(const Case& values, std::vector<Problem>& warnings);

}  // namespace terp
