// Excess pore pressure in a step. Not for: what schemes do with it (mpm/features/excess_pressure.hpp).
#pragma once

#include "math/types.hpp"

#include <vector>

namespace terp {

struct StepModel;
struct StepState;

struct ExcessScratch {
  std::vector<Real> pressure;  ///< u_e [Pa], shape [n_blocks]
};

/// Whether any soil of the run has it.
bool has_excess_pressure(const StepModel& model);

/// Part of its excess pressure that soil keeps which has become drained: it falls to zero over the ramp of the stage.
Real excess_kept(const StepModel& model, const StepState& state);

}  // namespace terp
