// Warnings of a case that has just been set up: water that does not fit the soil.
#pragma once

#include "math/errors.hpp"
#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

#include <vector>

namespace terp {

/// Water that touches no soil, stands above all of it or lifts it; lines and grids that do not reach over it.
void find_odd_water(const Model& model, const State& state, std::vector<Problem>& warnings);

/// Free water that slopes, changes its side, stands on the land or on a load.
void find_odd_free_water(const Model& model, const State& state, std::vector<Problem>& warnings);

/// Computed water: levels that touch no soil, aquifers without a head at their side, thin layers.
void find_odd_seepage(const Model& model, std::vector<Problem>& warnings);

}  // namespace terp
