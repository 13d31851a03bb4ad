// Quantities that are compared with each other: a stiffness, strength or velocity in another unit is within the fixed
// range of usual values, but not beside the weight and the height of the soil.
// Not for: ranges of single values (ParameterInfo::usual), nor for places (section_warnings.hpp).
#pragma once

#include "base/errors.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

#include <vector>

namespace terp {

/// Adds what is off by orders of magnitude. The state is that of t = 0.
void find_odd_scales(const Model& model, const State& state, std::vector<Problem>& warnings);

}  // namespace terp
