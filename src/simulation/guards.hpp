// What makes a run stop itself, said so that the user can act.
#pragma once

#include "simulation/state.hpp"
#include "simulation/workspace.hpp"

#include <string>

namespace terp {

/// Points that may be put back at walls before the run stops, as a part of all [-].
inline constexpr Real most_clamped = 1e-3;

/// The message for values that are not numbers: where, how fast before, the likely cause. speed: 99.9 % quantile [m/s].
std::string describe_not_finite(const Model& model, const State& state, const Workspace& work, Real speed);

/// The message for a run that must stop after the step just made, or nothing. speed: last known 99.9 % quantile [m/s].
std::string find_fault(const Model& model, const State& state, const Workspace& work, Real speed);

}  // namespace terp
