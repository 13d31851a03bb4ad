// The loop of steps, which runs, searches for equilibrium, trials and measurements share, and the life of a run around
// it: start, outputs that are due, guards, end.
#pragma once

#include "run/loop/observer.hpp"
#include "run/loop/state.hpp"
#include "run/report/summary.hpp"

#include <atomic>
#include <functional>
#include <span>

namespace terp {

struct Workspace;

/// What bounds a loop of steps, and what follows each step.
struct StepPolicy {
  std::int64_t most_steps = 0;
  const std::atomic<bool>* stop = nullptr;  ///< read before each step: true ends the loop; null: nobody stops it
  std::int64_t least_steps = 0;             ///< made even if a stop was requested
  bool clock_stands = false;                ///< time and number of the step stay 0, as in the search for equilibrium
  std::function<bool()> after_step = {};    ///< called after the guards; false: the loop has reached what it is for
};

enum class LoopEnd { all_steps, enough, stopped, fault };

struct StepsMade {
  LoopEnd end = LoopEnd::all_steps;
  std::string fault = {};  ///< why the run must stop, of LoopEnd::fault (guards.hpp)
};

/// Makes steps, each followed by the guards, until the policy ends it.
StepsMade make_steps(const Model& model, State& state, Workspace& work, const StepPolicy& policy);

/// Finished: the run made all steps that it was to make.
enum class Outcome { finished, interrupted };

/// Solves from the state to the step `until`, or until `stop` is set: then the step is finished and a checkpoint
/// written. A run that has not started is first brought to its initial stress. The outputs of the end are written at
/// the model's last step. Throws RunError if the run must stop itself.
Outcome run(const Model& model, State& state, Workspace& work, std::span<Observer* const> observers,
    const std::atomic<bool>& stop, std::int64_t until);

/// Whether the initial stress is found and the outputs at t = 0 are written.
bool has_started(const State& state);

/// What the summary says of a run in this state.
Summary summarise(const Model& model, const State& state);

}  // namespace terp
