// The loop: steps, the schedule of outputs, the guards, and the end.
#pragma once

#include "simulation/observer.hpp"
#include "simulation/step.hpp"
#include "simulation/summary.hpp"

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

}  // namespace terp
