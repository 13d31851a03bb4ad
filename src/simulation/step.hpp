// One explicit step. The order of its passes is the method: docs/methods.md.
#pragma once

#include "simulation/model.hpp"
#include "simulation/state.hpp"
#include "simulation/workspace.hpp"

#include <string_view>

namespace terp {

/// The step of a scheme by its name in schemes.def, or nullptr; compiled for this processor (parallel/kernels.hpp).
inline StepFunction find_step(std::string_view scheme) { return kernels().find_step(scheme); }

/// The same in one copy of the kernels: what their table holds.
StepFunction find_compiled_step(std::string_view scheme);

}  // namespace terp
