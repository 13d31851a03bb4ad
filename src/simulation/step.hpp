// One explicit step. The order of its passes is the method: docs/methods.md.
#pragma once

#include "simulation/model.hpp"
#include "simulation/state.hpp"
#include "simulation/workspace.hpp"

#include <string_view>

namespace terp {

/// The step of a scheme by its name in schemes.def, or nullptr.
StepFunction find_step(std::string_view scheme);

}  // namespace terp
