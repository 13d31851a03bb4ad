// Warnings of the sides of a mesh that has just been filled with soil.
#pragma once

#include "math/errors.hpp"
#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

#include <vector>

namespace terp {

/// Sides that do not lie where their names say, push soil over one cell at most, or let soil run out.
void find_odd_sides(const Model& model, const State& state, std::vector<Problem>& warnings);

}  // namespace terp
