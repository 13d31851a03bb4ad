// One explicit step. The order of its passes is the method: docs/methods.md.
// Part of the kernels: call by way of Model::step.
#pragma once

#include "simulation/model.hpp"
#include "simulation/state.hpp"
#include "simulation/workspace.hpp"

namespace terp {

/// One step with the scheme of the model, in this copy of the kernels.
void step_compiled(const Model& model, State& state, Workspace& work);

}  // namespace terp
