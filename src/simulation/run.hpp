// The loop: steps, the schedule of outputs, the guards, and the end.
#pragma once

#include "simulation/observer.hpp"
#include "simulation/state.hpp"
#include "simulation/summary.hpp"
#include "simulation/workspace.hpp"

#include <atomic>
#include <span>

namespace terp {

enum class Outcome { finished, interrupted };

/// Solves from the state to the model's end time, or until `stop` is set: then the step is finished and a checkpoint
/// written. A state at step 0 is first brought to its initial stress. Throws RunError if the run must stop itself.
Outcome run(const Model& model, State& state, Workspace& work, std::span<Observer* const> observers,
    const std::atomic<bool>& stop);

/// What the summary says of a run in this state.
Summary summarise(const Model& model, const State& state);

/// True at the steps nearest to whole multiples of `every` [s]; never if every is 0.
bool due(std::int64_t step, Real dt, Real every);

/// How many of the steps from 0 to `step` are due.
std::int64_t count_due(std::int64_t step, Real dt, Real every);

}  // namespace terp
