// Which material points the named places of the case stand for.
#pragma once

#include "math/errors.hpp"
#include "model/parts/model.hpp"
#include "mpm/step/step_state.hpp"

#include <vector>

namespace terp {

/// Sets model.history_ids: the material point nearest to each named place at t = 0 (reading R21).
void follow_history_points(Model& model, const StepState& state);

/// A warning for each named place that lies more than a cell from the point that is followed. The state is that of t =
/// 0.
std::vector<Problem> find_far_history_points(const Model& model, const StepState& state);

}  // namespace terp
