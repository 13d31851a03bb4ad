// history.csv: the named points over time. Its columns stand in one table in history.cpp.
#pragma once

#include "model/parts/model.hpp"
#include "run/report/run_table.hpp"
#include "run/loop/state.hpp"

namespace terp {

const std::shared_ptr<const RunTable>& history_table();

/// One row per named point. places: where they were stored at the last call, empty at the first; looked up anew if one
/// is no longer there.
std::vector<TableRow> make_history(const Model& model, const State& state, std::vector<PointPlace>& places);

}  // namespace terp
