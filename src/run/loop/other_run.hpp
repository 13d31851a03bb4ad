// A state that another run has saved, as the beginning of this one.
// Not for: the stages of one run (stages), nor where the files of the other run are (src/cli/run.cpp).
#pragma once

#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

namespace terp {

/// Makes a state of another run the beginning of this one: of the stages of the case those up to `stage_that_ended` are
/// done, if the case has one of this name, else none. Time goes on. The model, that of the first stage, becomes that of
/// the stage. before: the model that the state is of. What drainage, densities, fields and loads of this case make of
/// the soil is done; what that gives it counts as energy of the start. Throws InputError where no stage is left, or
/// there is no ground under a load.
void begin_from(const Model& before, const std::string& stage_that_ended, Model& model, State& state);

}  // namespace terp
