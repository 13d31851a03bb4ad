// The sums of a step over its chunks: to zero, and into the state.
// Not for: the sums of one feature alone (mpm/features).
#pragma once

#include "mpm/step/now.hpp"

#include <algorithm>

namespace terp {

inline void enter(const StressSums& of, CellSums& sums)
{
  sums.plastic += of.plastic_work;
  sums.slip += of.slip_work;
  sums.taken += sum(of.taken);
  sums.reset += sum(of.reset);
}

inline void start_sums(Workspace& work)
{
  for (NodeSums& sums : work.node_sums) sums = {};
  for (CellSums& sums : work.cell_sums) sums = {};
  for (auto& list : work.points_leaving) list.clear();
}

/// In order of chunk.
inline void finish_sums(StepNow& now)
{
  StepState& state = now.state;
  Workspace& work = now.work;
  NodeSums total;
  for (const NodeSums& sums : work.node_sums) {
    total.gravity += sums.gravity;
    total.damping += sums.damping;
    total.boundary += sums.boundary;
    total.clamps += sums.clamps;
    for (int kind = 0; kind < n_outer_kinds; ++kind) total.outer[kind] += sums.outer[kind];
    total.internal += sums.internal;
    total.unbalanced += sums.unbalanced;
    total.weight += sums.weight;
    total.kinetic += sums.kinetic;
    total.finite &= sums.finite;
  }
  state.work.gravity += total.gravity;
  state.work.damping += total.damping;
  state.work.boundary += total.boundary;
  state.work.clamps += total.clamps;
  state.work.internal += total.internal;
  Real outer = 0.0;
  for (int kind = 0; kind < n_outer_kinds; ++kind) {
    state.work.outer[kind] += total.outer[kind];
    outer += total.outer[kind];
  }
  state.work.last_step = total.gravity + total.damping + total.boundary + total.clamps + outer + total.internal;
  for (const CellSums& sums : work.cell_sums) {
    state.work.plastic += sums.plastic;
    state.work.slip += sums.slip;
    state.work.taken += sums.taken;
    state.work.reset += sums.reset;
    state.work.relaxation += sums.relaxation;
  }
  state.work.from_outside = std::max(state.work.from_outside, state.work.size_of_outside());
  state.work.exchanged = energy_exchanged(state.work);
  work.finite = total.finite;
  work.kinetic_nodal = total.kinetic;
  work.unbalanced_ratio = total.weight > 0.0 ? total.unbalanced / total.weight : 0.0;
}

}  // namespace terp
