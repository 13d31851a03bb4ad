// left_the_mesh.csv: the points that crossed an open side.
#pragma once

#include "simulation/run_table.hpp"
#include "simulation/state.hpp"

namespace terp {

const std::shared_ptr<const RunTable>& left_table();

/// One row per point that left since this was last called.
std::vector<TableRow> list_left_since(State& state);

}  // namespace terp
