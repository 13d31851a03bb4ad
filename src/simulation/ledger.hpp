// The ledger of a run: energy, mass and momentum over time, and what the followers measure. The columns of the balance
// stand in one table in ledger.cpp, those of a follower in its own file.
#pragma once

#include "simulation/ledger_context.hpp"
#include "simulation/workspace.hpp"

#include <algorithm>
#include <cmath>

namespace terp {

/// Elastic energy stored in a point [J per m]; sigma: xx yy zz xy [Pa], volume [m^2].
Real elastic_energy(Moduli moduli, std::array<Real, 4> sigma, Real volume);

/// Stored in a point of a material and in its pore water [J per m]; values: its rows.
Real elastic_energy(const SoilMaterial& material, std::span<Real> values);

/// Kinetic energy of the points plus elastic energy stored in them and in their pore water, and what those that left
/// took along [J per m].
Real kinetic_and_stored_energy(const Model& model, const State& state);

/// What the works moved so far, and the energy of the start [J per m]: the scale of the energy balance.
Real energy_exchanged(const State& state);

/// What came from outside so far, and the energy of the start [J per m]: the scale of what nothing explains.
Real energy_from_outside(const State& state);

/// The part of the works in it [J per m].
inline Real energy_exchanged(const WorkTotals& w)
{
  Real of_forces = std::abs(w.gravity) + std::abs(w.damping) + std::abs(w.boundary);
  for (const Real work : w.outer) of_forces += std::abs(work);
  return std::max(w.exchanged, of_forces + w.plastic + std::abs(w.slip));
}

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
