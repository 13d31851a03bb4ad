// Warnings of a case that has just been set up: times that do not fit the waves in the soil, or the time step.
#pragma once

#include "math/errors.hpp"
#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

#include <vector>

namespace terp {

/// Rest that a turning point of a vibration is taken for, a relaxation that never ends, outputs of every step.
void find_odd_times(const Model& model, const State& state, std::vector<Problem>& warnings);

}  // namespace terp
