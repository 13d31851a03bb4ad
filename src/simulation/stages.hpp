// How the stages of a run follow one another: the model of each, what passes from one to the next, when one has ended.
// Not for: the loop of steps (run), nor how a case file writes stages (input).
#pragma once

#include "simulation/model.hpp"
#include "simulation/state.hpp"
#include "simulation/workspace.hpp"

namespace terp {

/// The case of a stage; of a run without stages the case itself.
const Case& case_of_stage(const Case& description, std::size_t number);

/// Number of the water situation at the end of the last stage: the last that a stage names; 0: none does.
std::size_t water_of_last_stage(const Case& whole);

/// Name of the file that keeps the state at the end of a stage: "stage_01_daily.h5".
std::string stage_file(std::size_t number, const std::string& name);

/// Sets what the case says of the end of the stage of a model whose time step is known, and its ramp as of a stage that
/// begins at t = 0. Throws InputError for a stage that is shorter than a time step.
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

/// Gives each point the material that its body has in the stage of the model. Stress, strain and what both laws know
/// stay; what only the new law knows begins anew, and the mass follows the density.
void change_materials(const Model& model, State& state);

/// Makes a state that another run has saved the beginning of this one: of the stages of the case those up to
/// `stage_that_ended` are done, if the case has one of this name, else none. Time goes on. The model becomes that of
/// the stage.
void begin_from(Model& model, const std::string& stage_that_ended, State& state);

/// The model of the stage that a state is in: this one, or another of the same case.
Model model_for(Model model, const State& state);

/// On to the next stage, at the state where the last one ended. Energy that the change of stiffness or density gives
/// counts as energy of the start.
void enter_next_stage(Model& model, State& state, Workspace& work);

}  // namespace terp
