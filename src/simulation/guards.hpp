// What makes a run stop itself, said so that the user can act.
#pragma once

#include "simulation/state.hpp"
#include "simulation/workspace.hpp"

#include <string>

namespace terp {

/// Points that may be put back at walls before the run stops, as a part of all [-].
inline constexpr Real most_clamped = 1e-3;

/// Energy that no work explains before the run stops, as a part of all energy exchanged [-]: it then has as much again.
inline constexpr Real most_gained = 1.0;

/// Mass of points whose waves cross the smallest cell within a step before the run stops, as a part of all [-],
/// if energy that no work explains says that it does harm (loose sand that bears nothing does none), as a part of all
/// energy exchanged [-].
inline constexpr Real most_overtaken = 0.05, gain_of_harm = 0.05;

/// The message for values that are not numbers: where, how fast before, the likely cause. speed: 99.9 % quantile [m/s].
std::string describe_not_finite(const Model& model, const State& state, const Workspace& work, Real speed);

/// The message for a run that must stop after the step just made, or nothing. speed: last known 99.9 % quantile [m/s].
std::string find_fault(const Model& model, const State& state, const Workspace& work, Real speed);

/// The message for a run that must stop at a row of its ledger, or nothing: energy out of nowhere, a time step that has
/// become too long.
std::string find_fault_in_balance(const Model& model, const State& state, const TableRow& row);

}  // namespace terp
