// Warnings of a section that has just been set up: soil that is drawn and is not there, and voids where none is drawn.
#pragma once

#include "math/errors.hpp"
#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

#include <vector>

namespace terp {

void find_missing_soil(const Model& model, const State& state, std::vector<Problem>& warnings);

}  // namespace terp
