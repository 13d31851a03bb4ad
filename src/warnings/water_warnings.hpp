// Warnings of a case that has just been set up: water that does not fit the soil.
#pragma once

#include "base/errors.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

#include <vector>

namespace terp {

/// Water that touches no soil, stands above all of it or lifts it; lines and grids that do not reach over it.
void find_odd_water(const Model& model, const State& state, std::vector<Problem>& warnings);

}  // namespace terp
