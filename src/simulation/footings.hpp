// What the footings of a case meet: their place in a step, the reaction of the soil, their work, the rows of
// footings.csv.
#pragma once

#include "base/errors.hpp"
#include "simulation/state.hpp"
#include "simulation/workspace.hpp"

#include <vector>

namespace terp {

/// Puts the footings where they are in the coming step. While the soil settles before t = 0 there are none.
void place_footings(const Model& model, const State& state, Workspace& work);

/// Adds what the soil did to the footings in a step. impulse: of the nodes on each footing's soil, that is against the
/// reaction [N s per m].
void add_footing_impulses(const Workspace& work, const std::array<Vec<2>, most_footings>& impulse, State& state);

/// footings.csv: its columns.
const std::shared_ptr<const RunTable>& footings_table();

/// One row per footing; the reaction is the mean since the rows before.
std::vector<TableRow> keep_footings(const Model& model, State& state);

/// A warning for each footing that touches no soil at t = 0, or comes so far that the nodes at its base leave it at its
/// top.
std::vector<Problem> find_idle_footings(const Model& model, const State& state);

}  // namespace terp
