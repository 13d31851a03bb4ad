// What a stage is: its case, its water, its ramp and its end. Not for: how one stage follows another (stages), nor how
// a case file writes stages (io/case).
#pragma once

#include "model/parts/model.hpp"

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

}  // namespace terp
