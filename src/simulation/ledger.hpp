// The ledger of a run: energy, mass and momentum over time, and the audit of the strain history. Its columns stand in
// one table in ledger.cpp.
#pragma once

#include "simulation/model.hpp"
#include "simulation/observer.hpp"
#include "simulation/state.hpp"
#include "simulation/workspace.hpp"

#include <algorithm>
#include <cmath>

namespace terp {

/// Elastic energy stored in a point [J per m]; sigma: xx yy zz xy [Pa], volume [m^2].
Real elastic_energy(Moduli moduli, std::array<Real, 4> sigma, Real volume);

/// Kinetic energy of the points plus elastic energy stored in them, and what those that left took along [J per m].
Real kinetic_and_elastic_energy(const Model& model, const State& state);

/// What the works moved so far, and the energy of the start [J per m]: the scale of the energy balance.
Real energy_exchanged(const State& state);

/// The part of the works in it [J per m].
inline Real energy_exchanged(const WorkTotals& w)
{
  return std::max(w.exchanged, std::abs(w.gravity) + std::abs(w.damping) + std::abs(w.boundary) + w.plastic);
}

/// ledger.csv: its columns.
const std::shared_ptr<const RunTable>& ledger_table();

/// A row of the ledger as of now, computed on the threads of the run; follows the failure, enters the speed into
/// state.largest_v_999, and audits the history: a point whose eps_eq_p fell, or whose S_u rose, since the row before is
/// marked for good.
TableRow keep_ledger(const Model& model, State& state, Workspace& work);

/// Sizes the audit for the points of a new state.
void start_audit(const Model& model, State& state);

/// Takes the strain and strength of the points as they are for those of the last row: after somebody else set them.
void remember_history(const Model& model, State& state);

/// Share of the volume with S_u below half of its value at no plastic strain; 0 where no material has S_u [-].
Real softened_fraction(const Model& model, const State& state);

/// Number of the entry called `name`; -1: none.
int find_name(auto infos, std::string_view name)
{
  for (std::size_t k = 0; k < infos.size(); ++k)
    if (infos[k].name == name) return static_cast<int>(k);
  return -1;
}

}  // namespace terp
