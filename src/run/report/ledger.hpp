// The ledger of a run: energy, mass and momentum over time, and what the followers measure. The columns of the balance
// stand in one table in ledger.cpp, those of a follower in its own file.
#pragma once

#include "run/report/ledger_context.hpp"

#include <algorithm>
#include <cmath>

namespace terp {

struct Workspace;

/// What the works moved so far, and the energy of the start [J per m]: the scale of the energy balance.
Real energy_exchanged(const State& state);

/// What came from outside so far, and the energy of the start [J per m]: the scale of what nothing explains.
Real energy_from_outside(const State& state);

/// ledger.csv: the balance, and the columns of these followers.
std::shared_ptr<const RunTable> ledger_table(const FollowerTypes& followers);

/// A row of the ledger as of now, computed on the threads of the run. Enters the speed into state.largest_v_999, and
/// calls the followers of the state.
TableRow keep_ledger(const Model& model, State& state, Workspace& work);

/// True if S_u of some material must be remembered beside its strain.
bool must_remember_strength(const Model& model);

/// The strain and strength of the points as they are.
StrainMemory remember_strain(const Model& model, const State& state);

/// Number of the entry called `name`; -1: none.
int find_name(auto infos, std::string_view name)
{
  for (std::size_t k = 0; k < infos.size(); ++k)
    if (infos[k].name == name) return static_cast<int>(k);
  return -1;
}

}  // namespace terp
