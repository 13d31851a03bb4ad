// What a run would cost, from a trial of its first steps, and what it did cost.
#pragma once

#include "run/loop/simulation.hpp"

namespace terp {

/// Time of a step [s], mean over about `seconds` of steps actually made. Throws RunError if the run stops itself in
/// them.
double time_a_step(Simulation& simulation, double seconds = 0.2);

/// Time of the run with its output [s]; 0 where its first steps already fail.
double expected_seconds(Simulation& simulation, double trial_seconds);

/// Time of the steps of the whole run [s]. step_s: of a step in a trial.
double seconds_of_steps(const Model& model, double step_s);

/// What a run holds, frames and checkpoints in the making not counted.
std::int64_t bytes_of(const Model& model, const State& state);

/// Time of each pass of the steps made so far, and its share.
void print_passes(const Workspace& work);

}  // namespace terp
