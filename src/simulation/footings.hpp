// Where the footings of a case are in a step, and whether they can do what they are for.
// Not for: the reaction of the soil on them (followers/footings).
#pragma once

#include "base/errors.hpp"
#include "simulation/state.hpp"
#include "simulation/workspace.hpp"

#include <vector>

namespace terp {

/// Puts the footings where they are in the coming step. While the soil settles before t = 0 there are none.
void place_footings(const Model& model, const State& state, Workspace& work);

/// A warning for each footing that touches no soil at t = 0, or comes so far that the nodes at its base leave it at its
/// top.
std::vector<Problem> find_idle_footings(const Model& model, const State& state);

}  // namespace terp
