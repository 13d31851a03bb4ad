// What every step does at the nodes: sums of the cells, forces, and the works of the step. Kernels of the core
// (core_kernels.cpp), over a batch of nodes.
#pragma once

#include "mpm/step/now.hpp"

#include <algorithm>
#include <cmath>

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

/// Adds the forces of one kind to those out of balance, and keeps them for their work. more(i): what it has beside
/// those of the corners.
template <class More>
void add_outer_forces(Nodes& nodes, OuterForces& kind, More&& more)
{
  if (!kind.acts) return;
  for (int k = 0; k < nodes.n; ++k) {
    const Index i = nodes.number[k];
    Vec<2>& force = kind.node[i] = sum_outer(nodes.step.model, nodes.step.state, kind, i);
    more(i, force);
    for (int d = 0; d < 2; ++d) nodes.out_of_balance[k][d] += force[d];
  }
}

inline void add_outer_forces(Nodes& nodes, OuterForces& kind)
{
  add_outer_forces(nodes, kind, [](Index, Vec<2>&) {});
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

/// Mass, velocity and force out of balance without forces from outside. Light nodes do not move.
inline void gather_nodes(Nodes& nodes)
{
  const StepModel& model = nodes.step.model;
  Workspace& work = nodes.step.work;
  for (const Index i : nodes.active) {
    const NodeGather sum = sum_cells(model, nodes.step.state, work, i);
    NodeValues& node = work.node[i];
    node = {};
    node.mass = sum.mass;
    if (!(sum.mass >= mass_limit(model, i))) {
      for (OuterForces& kind : work.outer)
        if (kind.acts) kind.node[i] = {0.0, 0.0};
      nodes.sums.finite &= sum.mass == sum.mass;
      continue;
    }
    const int k = nodes.n;
    nodes.enter(i, sum.mass);
    Vec<2>& v_0 = nodes.v_0[k];
    for (int d = 0; d < 2; ++d) {
      v_0[d] = sum.momentum[d] / sum.mass;
      nodes.out_of_balance[k][d] = sum.mass * work.gravity[d] - sum.internal_force[d];
      node.internal[d] = -sum.internal_force[d];
    }
    nodes.sums.kinetic += 0.5 * sum.mass * (v_0[0] * v_0[0] + v_0[1] * v_0[1]);
  }
}

inline void free_nodes(Nodes& nodes)
{
  for (int k = 0; k < nodes.n; ++k) nodes.force[k] = nodes.out_of_balance[k], nodes.v[k] = nodes.v_0[k];
}

/// Step 2: damping and acceleration.
inline void accelerate_nodes(Nodes& nodes)
{
  const Damping& damping = nodes.step.work.damping;
  const Real dt = nodes.step.model.dt;
  for (int k = 0; k < nodes.n; ++k) {
    const Real mass = nodes.mass[k];
    const Vec<2> force = nodes.damping[k] = damping_force(damping, nodes.force[k], mass, nodes.v[k]);
    for (int d = 0; d < 2; ++d)
      nodes.v_free[k][d] = nodes.v_0[k][d] + (nodes.out_of_balance[k][d] + force[d]) / mass * dt;
    nodes.v_star[k] = nodes.v_free[k];
  }
}

inline void book_nodes(Nodes& nodes)
{
  Workspace& work = nodes.step.work;
  const Real dt = nodes.step.model.dt;
  NodeSums& sums = nodes.sums;
  for (int k = 0; k < nodes.n; ++k) {
    NodeValues& node = work.node[nodes.number[k]];
    const Real mass = nodes.mass[k];
    node.v = nodes.v_star[k];
    node.damping = nodes.damping[k];
    for (int d = 0; d < 2; ++d) {
      node.dv[d] = node.v[d] - nodes.v_0[k][d];
      node.boundary[d] = mass * (node.v[d] - nodes.v_free[k][d]) / dt;
      sums.unbalanced += std::abs(mass * node.dv[d] / dt - node.damping[d]);
      sums.weight += std::abs(mass * work.gravity[d]);
      sums.finite &= std::isfinite(node.dv[d]);
    }
  }
}

/// Force out of balance of soil that does not move, as `internal` of the node; of a light node none.
inline void book_forces(Nodes& nodes)
{
  for (int k = 0; k < nodes.n; ++k) {
    nodes.step.work.node[nodes.number[k]].internal = nodes.out_of_balance[k];
    for (int d = 0; d < 2; ++d) nodes.sums.finite &= std::isfinite(nodes.out_of_balance[k][d]);
  }
}

/// Step 4: velocity from the updated momentum of the points (MUSL). However light the node: a mean of the velocities of
/// the points around it is always sound, and a node left at rest would strain the cell (decision 0027).
inline void remap_velocities(Nodes& nodes)
{
  for (const Index i : nodes.active) {
    const NodeValues& node = nodes.step.work.node[i];
    if (!(node.mass > 0.0)) continue;
    const NodeGather sum = sum_cells(nodes.step.model, nodes.step.state, nodes.step.work, i);
    const int k = nodes.n;
    nodes.enter(i, node.mass);
    nodes.v_0[k] = node.v;
    for (int d = 0; d < 2; ++d) nodes.v_free[k][d] = sum.momentum[d] / node.mass;
    nodes.v_star[k] = nodes.v_free[k];
  }
}

/// Works of the step with the remapped velocity, which moves and strains the points, and of the forces on what clamps
/// take from it, which the points keep. They add up to the change of the points' kinetic energy plus 1/2 sum m_p
/// |dv_p|^2 exactly (docs/methods.md, energy).
inline void book_works(Nodes& nodes)
{
  Workspace& work = nodes.step.work;
  NodeSums& sums = nodes.sums;
  const bool has_outer = std::ranges::any_of(work.outer, [](const OuterForces& kind) { return kind.acts; });
  for (int k = 0; k < nodes.n; ++k) {
    const Index i = nodes.number[k];
    NodeValues& node = work.node[i];
    node.v = nodes.v_star[k];
    for (int d = 0; d < 2; ++d) {
      sums.clamps += node.mass * node.dv[d] * (nodes.v_free[k][d] - node.v[d]);
      const Real path = node.v[d] * nodes.step.model.dt;
      sums.gravity += node.mass * work.gravity[d] * path;
      sums.damping += node.damping[d] * path;
      sums.internal += node.internal[d] * path;
      sums.boundary += node.boundary[d] * path;
      for (int kind = 0; has_outer && kind < n_outer_kinds; ++kind)
        if (work.outer[kind].acts) sums.outer[kind] += work.outer[kind].node[i][d] * path;
    }
  }
}

}  // namespace terp
