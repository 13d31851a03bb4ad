#include "simulation/ledger.hpp"

#include "simulation/failure.hpp"
#include "simulation/node_motion.hpp"
#include "simulation/totals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terp {
namespace {

using Rows = PointRows<2>;

/// What the audit remembers of a point as it is.
void remember(const SoilMaterial& material, const PointBlock<2>& block, Index lane, HistoryAudit& audit)
{
  const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
  const int strain = row_of(material, Role::plastic_strain);
  if (strain < 0) return;
  audit.last_eps_eq_p[id] = block.row(strain)[lane];
  if (has_strength(material) && !audit.last_su.empty()) audit.last_su[id] = strength_of(material, block, lane);
}

/// Takes up what the walk has found of the history.
void audit_history(const Model& model, const Totals& totals, State& state)
{
  for (const std::size_t id : totals.fell) state.audit.fell[id] = true;
  for (const std::size_t id : totals.rose) state.audit.rose[id] = true;
  for (Index b = 0; b < state.points.n_blocks(); ++b) {
    if (!totals.strained[b]) continue;
    const PointBlock<2>& block = state.points.block(b);
    const Real* eps = block.row(row_of(model.materials[block.material], Role::plastic_strain));
    for (Index lane = 0; lane < block.n; ++lane)
      state.audit.last_eps_eq_p[static_cast<std::size_t>(block.row(Rows::id)[lane])] = eps[lane];
  }
}

/// Of the points that left, when they did.
Real kinetic_and_elastic_energy(const std::vector<LeftPoint>& points)
{
  Real energy = 0.0;
  for (const LeftPoint& p : points) energy += 0.5 * p.mass * (p.v[0] * p.v[0] + p.v[1] * p.v[1]) + p.elastic;
  return energy;
}

}  // namespace

Real elastic_energy(Moduli moduli, std::array<Real, 4> sigma, Real volume)
{
  return volume * ElasticEnergy<Real>(moduli)(sigma[0], sigma[1], sigma[2], sigma[3]);
}

Real kinetic_and_elastic_energy(const Model& model, const State& state)
{
  Books books;
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    const SoilMaterial& material = model.materials[block.material];
    const ElasticEnergy<Real> energy(material.law->moduli());
    for (Index p = 0; p < block.n; p += pack_width) books.enter(material, energy, block, p);
  });
  return 0.5 * sum(books.twice_kinetic) + sum(books.elastic) + kinetic_and_elastic_energy(state.left);
}

Real energy_exchanged(const State& state) { return energy_exchanged(state.work) + state.start_energy; }

void start_audit(const Model& model, State& state)
{
  const auto n = static_cast<std::size_t>(state.n_ids());
  const bool needs_su = std::any_of(model.materials.begin(), model.materials.end(), [](const SoilMaterial& m) {
    return row_of(m, Role::plastic_strain) >= 0 && has_strength(m) && !strain_gives_strength(m);
  });
  state.audit.last_eps_eq_p.assign(n, 0.0);
  state.audit.last_su.assign(needs_su ? n : 0, std::numeric_limits<Real>::infinity());
  for (auto* flags : {&state.audit.fell, &state.audit.rose}) flags->assign(n, false);
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    remember(model.materials[block.material], block, lane, state.audit);
  });
}

LedgerRow keep_ledger(const Model& model, State& state, Workspace& work)
{
  const Totals totals = add_up(model, state, work.threads, moved_distance(state.section), shear_columns(state));
  LedgerRow row;
  row.time = state.time;
  row.step = state.step;
  row.mass = totals.mass;
  row.momentum_x = totals.momentum[0];
  row.momentum_y = totals.momentum[1];
  row.kinetic = totals.kinetic;
  row.elastic = totals.elastic;
  row.kinetic_nodal = state.step == 0 ? kinetic_energy(map_motion(model, state)) : work.kinetic_nodal;
  row.v_max = totals.v_max;
  row.v_999 = totals.v_999;
  row.plastic = state.work.plastic;
  row.gravity_work = state.work.gravity;
  row.damping_work = state.work.damping;
  row.boundary_work = state.work.boundary;
  row.left_energy = kinetic_and_elastic_energy(state.left);
  row.numerical = row.kinetic + row.elastic + row.left_energy + row.plastic - state.start_energy -
                  (row.gravity_work + row.damping_work + row.boundary_work);
  row.clamped = state.clamped;
  row.left = static_cast<std::int64_t>(state.left.size());
  state.largest_v_999 = std::max(state.largest_v_999, row.v_999);
  follow_failure(model, totals, state, row);
  audit_history(model, totals, state);
  ++state.ledger_rows;
  return row;
}

Real softened_fraction(const Model& model, const State& state)
{
  Real soft = 0.0, all = 0.0;
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    const SoilMaterial& material = model.materials[block.material];
    const bool softens = has_strength(material);
    for (Index lane = 0; lane < block.n; ++lane) {
      const Real volume = block.row(Rows::volume)[lane];
      all += volume;
      if (softens && strength_of(material, block, lane) < 0.5 * strength_at(material, block, lane, 0.0)) soft += volume;
    }
  });
  return all > 0.0 ? soft / all : 0.0;
}

}  // namespace terp
