// From a case to the model and its first state.
#pragma once

#include "model/parts/model.hpp"
#include "mpm/step/step_state.hpp"

namespace terp {

/// Throws InputError with the key of the case that is at fault.
Model build_model(const Case& description, int threads);

/// The same on a mesh that is already there and may be shared; what the case says of the mesh is not used.
Model build_model(const Case& description, SharedMesh mesh, int threads);

/// Another stage of the run of a model, from the same parts. build_model builds the first stage.
Model build_stage(const Model& of_run, std::size_t number);

/// Another end with the time step that the model has: the first step at or after it [s]. For a run that goes on.
void move_end(Model& model, Real end);

/// Seeds the points and sets the initial stress (none or k0; "equilibrium" is sought by the run). Throws InputError.
StepState seed_soil(Model& model);

}  // namespace terp
