// How the stages of a run follow one another: the model of each, what passes from one to the next, when one has ended.
// Not for: the loop of steps (run), nor how a case file writes stages (input).
#pragma once

#include "simulation/model.hpp"
#include "simulation/state.hpp"
#include "simulation/workspace.hpp"

namespace terp {

/// The case of a stage; of a run without stages the case itself.
const Case& case_of_stage(const Case& description, std::size_t number);

/// The water of a stage: from that of the stages before it to the last that one names; of a run without stages none.
StageWater water_of_stage(const Case& whole, std::size_t number);

/// Name of the file that keeps the state at the end of a stage: "stage_01_daily.h5".
std::string stage_file(std::size_t number, const std::string& name);

/// Sets gravity, loads and water of a stage, and their ramp as of a stage that begins at t = 0.
void set_ramp(const Case& whole, std::size_t number, Model& model);

/// Sets what the case says of the end of the stage of a model whose time step is known. Throws InputError for a stage
/// that is shorter than a time step.
void set_stage(const Case& whole, std::size_t number, Model& model);

/// The step at which the stage ends at the latest.
std::int64_t last_step_of_stage(const Model& model, const State& state);
/// The same of the run.
std::int64_t last_step_of_run(const Model& model, const State& state);

/// Whether the stage has ended, at rest or with its last step.
bool has_ended(const Model& model, const State& state);

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
