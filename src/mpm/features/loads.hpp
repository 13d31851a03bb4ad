// The loads in a step, and forces.body. Not for: one load and its pressure over time (load.hpp), nor which points carry
// it (model/loads/loads).
#pragma once

#include "mpm/features/load.hpp"

#include <span>
#include <vector>

namespace terp {

struct StepModel;
struct StepState;
struct Workspace;

struct LoadsModel {
  std::vector<Load> all;
  BodyForce body_force = {};  ///< beside gravity; empty: none
};

struct LoadsScratch {
  std::vector<Real> pressure;  ///< of each load in this step [Pa]
};

/// Of the model; empty: none.
std::span<const Load> loads_of(const StepModel& model);

/// Pressure of a load of the model at a time [Pa].
Real pressure_of(const StepModel& model, const Load& load, Real time);

/// Pressures of the loads in this step [Pa]; empty: no loads.
std::span<const Real> load_pressures(const Workspace& work);

/// Says which loads act in the coming step, and with which pressure: that in the middle of the step.
void set_load_pressures(const StepModel& model, const StepState& state, Workspace& work);

}  // namespace terp
