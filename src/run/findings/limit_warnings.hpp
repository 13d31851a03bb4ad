// Known limits (docs/limits.md) that a case meets, as far as they can be told before the run.
#pragma once

#include "math/errors.hpp"
#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

#include <vector>

namespace terp {

/// Each names its section of docs/limits.md.
void find_known_limits(const Model& model, const State& state, std::vector<Problem>& warnings);

}  // namespace terp
