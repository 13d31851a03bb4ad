// What the step does at one node: sum of the cells, forces, boundary, and the works of the step.
#pragma once

#include "mpm/features/balance.hpp"
#include "mpm/features/footings.hpp"
#include "mpm/features/mean_force.hpp"
#include "mpm/features/rest.hpp"
#include "mpm/features/search.hpp"
#include "mpm/features/sides.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/step_state.hpp"

#include <algorithm>

namespace terp {

struct NodeGather {
  Real mass = 0.0;
  Vec<2> momentum{0.0, 0.0}, internal_force{0.0, 0.0};
};

/// Adds the contributions of the occupied cells around a node, in order of cell number.
inline NodeGather sum_cells(const StepModel& model, const StepState& state, const Workspace& work, Index node)
{
  NodeGather sum;
  for (Index k = model.mesh->first_cell_of_node[node]; k < model.mesh->first_cell_of_node[node + 1]; ++k) {
    const auto [cell, corner] = model.mesh->cells_of_node[k];
    const Index slot = state.points.slot_of_cell()[cell];
    if (slot < 0) continue;
    const CornerSums<Quad4>& from = work.corners[slot];
    sum.mass += from.mass[corner];
    for (int d = 0; d < 2; ++d) {
      sum.momentum[d] += from.momentum[d][corner];
      sum.internal_force[d] += from.internal_force[d][corner];
    }
  }
  return sum;
}

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

/// The same of forces from outside, of one kind.
inline Vec<2> sum_outer(const StepModel& model, const StepState& state, const OuterForces& outer, Index node)
{
  Vec<2> sum{0.0, 0.0};
  if (outer.corners.empty()) return sum;
  for (Index k = model.mesh->first_cell_of_node[node]; k < model.mesh->first_cell_of_node[node + 1]; ++k) {
    const auto [cell, corner] = model.mesh->cells_of_node[k];
    const Index slot = state.points.slot_of_cell()[cell];
    if (slot < 0) continue;
    for (int d = 0; d < 2; ++d) sum[d] += outer.corners[slot][d][corner];
  }
  return sum;
}

/// Any force from outside acts in this step.
inline bool has_outer_forces(const Workspace& work)
{
  return std::ranges::any_of(work.outer, [](const OuterForces& kind) { return kind.acts; });
}

/// Adds the forces from outside on a node to those out of balance, and keeps each kind for its work.
inline void add_outer_forces(const StepModel& model, const StepState& state, Index node, Workspace& work, Vec<2>& force)
{
  for (OuterForces& kind : work.outer) {
    if (!kind.acts) continue;
    kind.node[node] = sum_outer(model, state, kind, node);
    if (&kind == &work.outer[outer_balance]) {
      const Vec<2> slope = sum_balance(model, state, work, node);
      for (int d = 0; d < 2; ++d) kind.node[node][d] += slope[d];
    }
    for (int d = 0; d < 2; ++d) force[d] += kind.node[node][d];
  }
}

/// A part of the mass of a full cell, rho V_e of the first cell around a node [kg per m].
inline Real part_of_full_mass(const StepModel& model, Index node, Real part)
{
  const auto& first = model.mesh->first_cell_of_node;
  return part * model.largest_density * model.mesh->geometry(model.mesh->cells_of_node[first[node]].cell).volume;
}

/// Smallest mass of a node that may move: small_mass rho V_e [kg per m].
inline Real mass_limit(const StepModel& model, Index node)
{
  return part_of_full_mass(model, node, model.method.small_mass);
}

/// Least part of the mass of a full cell at a node that counts for rest: below it a single grain moves the node.
inline constexpr Real part_that_rests = 0.05;

/// Step 2: out-of-balance force, damping, acceleration, boundary.
inline void accelerate_node(
    const StepModel& model, StepState& state, const NodeGather& sum, Index i, Workspace& work, NodeSums& sums)
{
  NodeValues& node = work.node[i];
  node = {};
  node.mass = sum.mass;
  if (!(sum.mass >= mass_limit(model, i))) {
    for (OuterForces& kind : work.outer)
      if (kind.acts) kind.node[i] = {0.0, 0.0};
    sums.finite &= sum.mass == sum.mass;
    return;
  }
  SearchScratch* const search = work.with.search.get();
  Damping damping = model.damping;
  if (search != nullptr) damping.local = search->damping_local;
  Vec<2> v_0, v_free, out_of_balance;
  for (int d = 0; d < 2; ++d) {
    v_0[d] = sum.momentum[d] / sum.mass;
    out_of_balance[d] = sum.mass * work.gravity[d] - sum.internal_force[d];
    node.internal[d] = -sum.internal_force[d];
  }
  if (has_outer_forces(work)) add_outer_forces(model, state, i, work, out_of_balance);
  if (search != nullptr) hold_back(*search, i, out_of_balance);
  sums.kinetic += 0.5 * sum.mass * (v_0[0] * v_0[0] + v_0[1] * v_0[1]);
  const int k = footing_at(work, model.mesh->nodes[i]);
  const PlacedFooting* const footing = k < 0 ? nullptr : &work.with.footings->placed[k];
  const Boundary& boundary = model.with.sides->boundary;
  const bool on_side = boundary.at(i) != nullptr;  // most nodes are on none, and take the short way
  Vec<2> force = out_of_balance, v = v_0;
  if (on_side) {
    force = boundary.free_force(i, out_of_balance);
    v = boundary.free_velocity(i, v_0, out_of_balance);
  }
  if (footing != nullptr) {
    force = footing->free_part(force);
    v = footing->free_part(v);
  }
  if (search != nullptr) {
    damping.viscous += search->viscous;
    follow_motion(*search, i, force, v, sum.mass * model.dt, sums);
  } else if (damping.averaging_time > 0.0) {
    Vec<2>& mean = state.with.mean_force->force[i];
    follow_force(damping, force, model.dt, mean);
    force = mean;
  }
  node.damping = damping_force(damping, force, sum.mass, v);
  for (int d = 0; d < 2; ++d) v_free[d] = v_0[d] + (out_of_balance[d] + node.damping[d]) / sum.mass * model.dt;
  node.v = v_free;
  if (on_side) boundary.constrain(i, sum.mass, model.dt, node.v);
  if (footing != nullptr)
    push_by_footing(*footing, sum.mass, node.v, work.with.footings->chunk_impulses[work.chunk_of(sums)][k]);
  for (int d = 0; d < 2; ++d) {
    node.dv[d] = node.v[d] - v_0[d];
    node.boundary[d] = sum.mass * (node.v[d] - v_free[d]) / model.dt;
    sums.unbalanced += std::abs(sum.mass * node.dv[d] / model.dt - node.damping[d]);
    sums.weight += std::abs(sum.mass * work.gravity[d]);
    sums.finite &= std::isfinite(node.dv[d]);
  }
}

/// Force out of balance of soil that does not move, as `internal` of the node; of a light node none.
inline void find_force(
    const StepModel& model, const StepState& state, const NodeGather& sum, Index i, Workspace& work, NodeSums& sums)
{
  NodeValues& node = work.node[i];
  node = {};
  node.mass = sum.mass;
  sums.finite &= sum.mass == sum.mass;
  if (!(sum.mass >= mass_limit(model, i))) return;
  for (int d = 0; d < 2; ++d) node.internal[d] = sum.mass * work.gravity[d] - sum.internal_force[d];
  if (has_outer_forces(work)) add_outer_forces(model, state, i, work, node.internal);
  for (int d = 0; d < 2; ++d) sums.finite &= std::isfinite(node.internal[d]);
}

/// Works of the step with the remapped velocity, which moves and strains the points, and of the forces on what clamps
/// take from it, which the points keep. They add up to the change of the points' kinetic energy plus 1/2 sum m_p
/// |dv_p|^2 exactly (docs/methods.md, energy). remapped: before the clamps [m/s].
inline void add_works(const StepModel& model, const Workspace& work, Index i, Vec<2> remapped, NodeSums& sums)
{
  const NodeValues& node = work.node[i];
  const bool has_outer = has_outer_forces(work);
  for (int d = 0; d < 2; ++d) {
    sums.clamps += node.mass * node.dv[d] * (remapped[d] - node.v[d]);
    const Real path = node.v[d] * model.dt;
    sums.gravity += node.mass * work.gravity[d] * path;
    sums.damping += node.damping[d] * path;
    sums.internal += node.internal[d] * path;
    sums.boundary += node.boundary[d] * path;
    for (int kind = 0; has_outer && kind < n_outer_kinds; ++kind)
      if (work.outer[kind].acts) sums.outer[kind] += work.outer[kind].node[i][d] * path;
  }
}

/// Step 4: velocity from the updated momentum of the points (MUSL), clamped at the boundary. However light the node: a
/// mean of the velocities of the points around it is always sound, and a node left at rest would strain the cell
/// (decision 0027).
inline void remap_velocity(const StepModel& model, const NodeGather& sum, Index i, Workspace& work, NodeSums& sums)
{
  NodeValues& node = work.node[i];
  if (!(node.mass > 0.0)) return;
  const Vec<2> v_1 = node.v;
  for (int d = 0; d < 2; ++d) node.v[d] = sum.momentum[d] / node.mass;
  const Vec<2> remapped = node.v;
  const Boundary& boundary = model.with.sides->boundary;
  if (boundary.at(i) != nullptr) {
    const bool across_alone = model.method.remap_contact == RemapContact::across;
    boundary.clamp(i, node.mass, model.dt, v_1, node.boundary, node.v, across_alone);
  }
  if (const int k = footing_at(work, model.mesh->nodes[i]); k >= 0) work.with.footings->placed[k].hold(node.v);
  add_works(model, work, i, remapped, sums);
  if (work.with.rest && node.mass >= part_of_full_mass(model, i, part_that_rests))
    sums.fastest = std::max(sums.fastest, node.v[0] * node.v[0] + node.v[1] * node.v[1]);
}

}  // namespace terp
