// The clock of a section: how long a shear wave takes through its soil. Not for: the time step (time_step.hpp).
#pragma once

#include "model/parts/model.hpp"
#include "mpm/step/step_state.hpp"

namespace terp {

/// Time in which a shear wave crosses the soil along gravity, by the mean of its slowness; of a fluid a sound wave [s].
/// Twice the time is a window of the search for equilibrium, four times the longest period of soil that swings.
Real time_to_cross(const Model& model, const StepState& state);

}  // namespace terp
