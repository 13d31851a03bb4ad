// Which sides of the mesh the soil comes to: from then on they act on it, whether they are meant as walls or not.
#pragma once

#include "simulation/model.hpp"
#include "simulation/state.hpp"
#include "simulation/summary.hpp"

namespace terp {

/// Notes the sides where soil lies now, as those that it did not come to during the run.
void start_following_sides(const Model& model, State& state);

/// Notes the sides that soil has come to since: a point in a cell at the side gives mass to its nodes. Where soil lay
/// from the start, at a steep side that is free, a roller or fixed: those at which it has come to the second cell above
/// it. Less is heave, and one cell more may be a matter of round-off.
void follow_sides(const Model& model, State& state);

/// In order of time, then of the mesh. An open side is none: soil is meant to leave there.
std::vector<ReachedSide> list_reached_sides(const Model& model, const State& state);

}  // namespace terp
