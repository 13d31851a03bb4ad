// Whether the footings of a case can do what they are for.
// Not for: the reaction of the soil on them (run/measure/footings).
#pragma once

#include "math/errors.hpp"
#include "model/parts/model.hpp"
#include "mpm/step/step_state.hpp"

#include <vector>

namespace terp {

/// A warning for each footing that touches no soil at t = 0, or comes so far that the nodes at its base leave it at its
/// top.
std::vector<Problem> find_idle_footings(const Model& model, const StepState& state);

}  // namespace terp
