// How the stages of a run follow one another: what passes from one to the next, when one has ended.
// Not for: what a stage is (stage_case), nor the loop of steps (run).
#pragma once

#include "model/parts/stage_case.hpp"
#include "run/loop/state.hpp"

namespace terp {

struct Workspace;

/// The step at which the stage ends at the latest.
std::int64_t last_step_of_stage(const Model& model, const State& state);
/// The same of the run.
std::int64_t last_step_of_run(const Model& model, const State& state);

/// Whether the stage has ended, at rest or with its last step.
bool has_ended(const Model& model, const State& state);

/// Whether a later stage shows what the soil of this one would do: it holds the soil, or the next one goes on with the
/// same soil, water and loads. Then it decides nothing that soil still moves at its end.
bool is_decided_later(const Case& c, std::size_t stage);

/// Whether a stage has more strength than the case gives, for a later one to take it away.
bool holds_soil(const Case& c, std::size_t stage);

/// After a step: counts how long the soil has been at rest.
void watch_rest(const Model& model, const Workspace& work, State& state);

/// True at the very step with which the stage ends; enters it in the records of the state.
bool ends_now(const Model& model, const Workspace& work, State& state);

/// The model of the stage that a state is in: this one, or another of the same case.
Model model_for(Model model, const State& state);

/// On to the next stage, at the state where the last one ended. Energy that the change of stiffness or density gives
/// counts as energy of the start.
void enter_next_stage(Model& model, State& state, Workspace& work);

}  // namespace terp
