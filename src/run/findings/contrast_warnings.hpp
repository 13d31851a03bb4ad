// Warnings of soils that look swapped, and of undrained strengths that no soil has below such a weight.
#pragma once

#include "math/errors.hpp"
#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

#include <vector>

namespace terp {

void find_odd_contrasts(const Model& model, const State& state, std::vector<Problem>& warnings);

}  // namespace terp
