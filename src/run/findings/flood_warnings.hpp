// Warnings of a case whose ground does not hold the water of [flood] from the start.
#pragma once

#include "math/errors.hpp"
#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

#include <vector>

namespace terp {

std::vector<Problem> find_flood_warnings(const Model& model, const State& state);

}  // namespace terp
