// How a pass walks on the threads of a run: over groups of occupied cells, over nodes; and its clock.
#pragma once

#include "mpm/step/cell_passes.hpp"
#include "mpm/step/passes.hpp"

#include <chrono>

namespace terp {

template <class F>
void timed(Workspace& work, Pass pass, F&& f)
{
  const auto start = std::chrono::steady_clock::now();
  f();
  work.seconds[pass] += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Calls f(group, sums of the chunk, points_leaving of the thread) for the occupied cells in groups of eight
/// neighbours.
template <class F>
void for_each_group(const StepModel& model, StepState& state, Workspace& work, F&& f)
{
  static_assert(cells_per_chunk % pack_width == 0);
  work.threads.for_each_range(static_cast<Index>(state.points.occupied().size()), cells_per_chunk,
      [&](Index begin, Index end, Index chunk, int thread) {
        CellSums& sums = work.cell_sums[chunk];
        std::vector<PointPlace>& points_leaving = work.points_leaving[thread];
        sums.thread = thread;
        sums.first_leaving = points_leaving.size();
        for (Index slot = begin; slot < end; slot += pack_width)
          f(view_group(model, state, work, slot, std::min(slot + pack_width, end)), sums, points_leaving);
        sums.end_of_leaving = points_leaving.size();
      });
}

template <class F>
void for_each_node(Workspace& work, F&& f)
{
  work.threads.for_each_range(
      static_cast<Index>(work.active_nodes.size()), nodes_per_chunk, [&](Index begin, Index end, Index chunk, int) {
        for (Index k = begin; k < end; ++k) f(work.active_nodes[k], work.node_sums[chunk]);
      });
}

/// Calls f(slot, number of the chunk) for the occupied cells.
template <class F>
void for_each_slot(const StepState& state, Workspace& work, F&& f)
{
  work.threads.for_each_range(static_cast<Index>(state.points.occupied().size()), cells_per_chunk,
      [&](Index begin, Index end, Index chunk, int) {
        for (Index slot = begin; slot < end; ++slot) f(slot, chunk);
      });
}

}  // namespace terp
