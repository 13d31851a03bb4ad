// What the kernels of a step offer to the program, in the copy for this processor (os/kernel_table.hpp).
// Not for: laws and schemes, whose lists have copies of their own (soil/laws/material.hpp, mpm/schemes/scheme.hpp).
#pragma once

#include "mpm/step/score.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/totals.hpp"

#include <string_view>

namespace terp {

/// One explicit step with the scheme of the model, in this copy of the kernels (step.cpp): call it by way of
/// StepModel::step. The order of its passes is the method: docs/methods.md.
void step_compiled(const StepModel& model, StepState& state, Workspace& work);

/// Of soil that does not move: the force out of balance of each active node, without that of sides and of damping, as
/// `internal` of work.node; its mass as there.
void find_forces_compiled(const StepModel& model, StepState& state, Workspace& work);
/// The other half: strains the soil by the displacements v dt of the nodes of work.node. Points stay where they are.
void strain_compiled(const StepModel& model, StepState& state, Workspace& work);

/// The table of one copy. The other functions are declared, with what they take and return, where they are at home.
struct Kernels {
  std::string_view instructions;  ///< name of the set
  StepFunction step, find_forces, strain;
  decltype(&score_compiled) score;             ///< score.hpp
  decltype(&add_up_compiled) add_up;           ///< totals.hpp
  double (*measure_triad)(std::size_t bytes);  ///< os/machine.hpp
  double (*measure_multiply_add)();
};

/// Of set number `set` of instruction_sets().
const Kernels& kernels_of_set(std::size_t set);

/// Of this process. Throws InstructionsError.
const Kernels& kernels();

}  // namespace terp
