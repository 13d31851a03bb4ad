// What makes a run stop itself, said so that the user can act.
#pragma once

#include "run/loop/state.hpp"

#include <string>

namespace terp {

struct Workspace;

/// Points that may be put back at walls before the run stops, as a part of all [-].
inline constexpr Real most_clamped = 1e-3;

/// Energy that nothing explains, as a part of what came from outside [-]: from where on a run is warned of, counts as
/// failed in a study, and stops. docs/troubleshooting.md says how they were chosen.
inline constexpr Real unexplained_that_warns = 0.02, unexplained_that_fails = 0.05, most_unexplained = 0.5;

/// Plastic work that may be given back, as a part of the same [-]: the round-off of sums and of the last step.
inline constexpr Real most_undone = 1e-3;

/// Mass of points whose waves cross the smallest cell within a step before the run stops, as a part of all [-], if
/// unexplained energy says that it does harm (loose sand that bears nothing does none).
inline constexpr Real most_overtaken = 0.05;

/// The message for values that are not numbers: where, how fast before, the likely cause. speed: 99.9 % quantile [m/s].
std::string describe_not_finite(const Model& model, const State& state, const Workspace& work, Real speed);

/// The message for a run that must stop after the step just made, or nothing. speed: last known 99.9 % quantile [m/s].
std::string find_fault(const Model& model, const State& state, const Workspace& work, Real speed);

/// The most energy so far that nothing explains, as a part of what came from outside [-].
Real unexplained_share(const State& state);

/// Enters a row of the ledger in the marks of the state. The message for a run that must stop there, or nothing: energy
/// that comes from nowhere, is lost, or comes back from plastic work, however it is booked; a time step that has become
/// too long.
std::string find_fault_in_balance(const Model& model, State& state, const TableRow& row);

}  // namespace terp
