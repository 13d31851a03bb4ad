// The weight of bodies that stages place or dig away, as a step holds it.
// Not for: which points come and go (run/loop/placed_bodies), nor the force (mpm/kernels/map_held_weight.hpp).
#pragma once

#include "mpm/kernels/held_shares.hpp"

#include <cstdint>

namespace terp {

struct StepModel;
struct StepState;
struct Workspace;

struct BodiesModel {
  int held_row = -1;                     ///< of the points: whose weight is held
  bool places = false, removes = false;  ///< in the stage
};

struct BodiesScratch {
  HeldShares held;  ///< in this step
};

/// -1: no stage places or removes bodies.
int held_row_of(const StepModel& model);

/// Step before which the points of bodies that the stage digs away are taken out.
std::int64_t step_of_removal(const StepModel& model, const StepState& state);

/// Which part of the weight of the points of bodies that come or go is held in the coming step: that in its middle.
void set_held_shares(const StepModel& model, const StepState& state, Workspace& work);

}  // namespace terp
