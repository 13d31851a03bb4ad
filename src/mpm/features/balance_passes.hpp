// The acceleration of the cells for the slope of their pressure (mpm/features/pressure_balance.hpp), within the step:
//
//   m_i a_i = R_i - sum_K k_K,i (a_K - g),   a_K = sum_j m_j^K a_j / sum_j m_j^K
//
// R: all other forces without damping; m_j^K: what cell K gives to the mass of its corner j, so that a light node of a
// part-filled cell counts little. Shortened to 1.2 g: waves in a stiff body are faster than any slide, and the term
// with a_K alone is not symmetric, so that it would feed them (decision 0068).
#pragma once

#include "mpm/features/balance.hpp"
#include "mpm/features/footings.hpp"
#include "mpm/features/search.hpp"
#include "mpm/features/sides.hpp"
#include "mpm/step/node_passes.hpp"
#include "mpm/step/walks.hpp"

namespace terp {

/// Largest acceleration of a cell that its pressure follows, in parts of gravity.
inline constexpr Real most_followed = 1.2;

/// Force of the slope of the pressure within the cells around a node, but for what `outer` has (pressure_balance.hpp).
inline Vec<2> sum_balance(const StepModel& model, const StepState& state, const Workspace& work, Index node)
{
  Vec<2> sum{0.0, 0.0};
  for (Index k = model.mesh->first_cell_of_node[node]; k < model.mesh->first_cell_of_node[node + 1]; ++k) {
    const auto [cell, corner] = model.mesh->cells_of_node[k];
    const Index slot = state.points.slot_of_cell()[cell];
    if (slot < 0) continue;
    const CellBalance& of_cell = work.with.balance->cells[slot];
    const Vec<2> force =
        of_cell.force(corner, {of_cell.acceleration[0] - work.gravity[0], of_cell.acceleration[1] - work.gravity[1]});
    for (int d = 0; d < 2; ++d) sum[d] -= force[d];
  }
  return sum;
}

/// What the sweeps need of a node.
inline void start_balance(const StepModel& model, const StepState& state, Index i, Workspace& work)
{
  const NodeGather sum = sum_cells(model, state, work, i);
  BalanceNode& node = work.with.balance->nodes[i];
  node = {};
  if (!(sum.mass >= mass_limit(model, i))) return;
  node.mass = sum.mass;
  for (int d = 0; d < 2; ++d) {
    node.v[d] = sum.momentum[d] / sum.mass;
    node.force[d] = sum.mass * work.gravity[d] - sum.internal_force[d];
  }
  for (const OuterForces& kind : work.outer) {
    if (!kind.acts) continue;
    const Vec<2> outer = sum_outer(model, state, kind, i);
    for (int d = 0; d < 2; ++d) node.force[d] += outer[d];
  }
}

/// Acceleration of a node, without damping, by the accelerations of the cells of the sweep before.
inline void accelerate_for_balance(const StepModel& model, const StepState& state, Index i, Workspace& work)
{
  BalanceNode& node = work.with.balance->nodes[i];
  if (node.mass == 0.0) return;
  Vec<2> force = sum_balance(model, state, work, i);
  for (int d = 0; d < 2; ++d) force[d] += node.force[d];
  if (const SearchScratch* search = work.with.search.get()) {
    const Real held = 1.0 - search->share;
    if (search->share == 0.0)
      force = {0.0, 0.0};  // all is held in this step
    else
      for (int d = 0; d < 2; ++d) force[d] += held * search->held[i][d];
  }
  Vec<2> v;
  for (int d = 0; d < 2; ++d) v[d] = node.v[d] + force[d] / node.mass * model.dt;
  const Boundary& boundary = model.with.sides->boundary;
  if (boundary.at(i) != nullptr)
    boundary.constrain(i, node.mass, {model.dt, model.at_strength(model.time_of(state.step + 1))}, v);
  if (const int k = footing_at(work, model.mesh->nodes[i]); k >= 0) work.with.footings->placed[k].hold(v);
  for (int d = 0; d < 2; ++d) node.acceleration[d] = (v[d] - node.v[d]) / model.dt;
}

/// Acceleration of a cell from its corners.
inline void set_cell_acceleration(const StepModel& model, const StepState& state, Index slot, Workspace& work)
{
  const Index cell = state.points.occupied()[slot];
  const PerCorner<Quad4>& mass = work.corners[slot].mass;
  Vec<2> a{0.0, 0.0};
  Real all = 0.0;
  for (int i = 0; i < Quad4::n_corners; ++i) {
    const Vec<2>& of_node = work.with.balance->nodes[model.mesh->cells[cell][i]].acceleration;
    all += mass[i];
    for (int d = 0; d < 2; ++d) a[d] += mass[i] * of_node[d];
  }
  const auto squared = [](const Vec<2>& v) { return v[0] * v[0] + v[1] * v[1]; };
  const Real most = most_followed * most_followed * squared(work.gravity) * all * all, size = squared(a);
  const Real part = size > most ? std::sqrt(most / size) : 1.0;
  for (int d = 0; d < 2; ++d) work.with.balance->cells[slot].acceleration[d] = part * a[d] / all;
}

/// The acceleration of each cell in this step, for the slope of its pressure: Jacobi sweeps, of which each takes a
/// tenth of the error (decision 0068).
inline void balance_pressure(StepNow& now)
{
  const StepModel& model = now.model;
  const StepState& state = now.state;
  Workspace& work = now.work;
  constexpr int n_sweeps = 3;
  for_each_node(work, [&](Index i, NodeSums&) { start_balance(model, state, i, work); });
  for (int sweep = 0; sweep < n_sweeps; ++sweep) {
    for_each_node(work, [&](Index i, NodeSums&) { accelerate_for_balance(model, state, i, work); });
    for_each_slot(state, work, [&](Index slot, Index) { set_cell_acceleration(model, state, slot, work); });
  }
}

}  // namespace terp
