// Known limits (docs/limits.md) that a case meets, as far as they can be told before the run.
#pragma once

#include "base/errors.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

#include <vector>

namespace terp {

/// Each names its section of docs/limits.md.
void find_known_limits(const Model& model, const State& state, std::vector<Problem>& warnings);

}  // namespace terp
