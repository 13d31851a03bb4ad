// What is said when the search for equilibrium finds none: where, and what to do. Not for: the search itself
// (equilibrium.hpp).
#pragma once

#include "simulation/state.hpp"
#include "simulation/workspace.hpp"

namespace terp {

/// The soil runs away in the search: a hundredth of it had moved further than `moved` [m]. stiffening: of the model.
std::string describe_failure(const Model& model, const State& state, Real moved, Real stiffening);

/// After all steps the soil is not at rest; `work` is that of the last one.
std::string describe_no_equilibrium(const Model& model, const State& state, const Workspace& work, Real stiffening);

}  // namespace terp
