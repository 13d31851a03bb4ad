// How a score walks on the threads of a run: over groups of occupied cells, over nodes.
#pragma once

#include "mpm/step/cell_passes.hpp"
#include "mpm/step/chunk_sums.hpp"
#include "mpm/step/passes.hpp"

#include <algorithm>
#include <chrono>

namespace terp {

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

/// The clock of the passes.
class Clock {
 public:
  explicit Clock(Workspace& work) : work_(work) {}
  ~Clock() { go_on(n_passes); }
  Clock(const Clock&) = delete;

  void go_on(int pass)
  {
    if (pass == pass_) return;
    const auto now = std::chrono::steady_clock::now();
    if (pass_ != n_passes) work_.seconds[pass_] += std::chrono::duration<double>(now - since_).count();
    pass_ = pass;
    since_ = now;
  }

 private:
  Workspace& work_;
  int pass_ = n_passes;
  std::chrono::steady_clock::time_point since_;
};

template <class Now>
void run_all(std::span<const Kernel* const> kernels, Now& now)
{
  for (const Kernel* kernel : kernels) (*std::get_if<void (*)(Now&)>(&kernel->run))(now);
}

/// The blocks of a group, cell by cell.
inline void run_blocks(std::span<const Kernel* const> kernels, GroupNow& now, bool prefetches)
{
  const CellGroup<Quad4>& group = now.group;
  for (int c = 0; c < group.n(); ++c) {
    if (prefetches) prefetch_next(group, c);
    for_each_block(group.points, group.cells[c], [&](const PointBlock<2>&, Index b) {
      BlockNow block(now, b, c);
      run_all(kernels, block);
    });
  }
}

/// The blocks of a layer.
inline void run_blocks(std::span<const Kernel* const> kernels, LayerNow& now)
{
  const CellGroup<Quad4>& group = now.at.group;
  for (int c = 0; c < group.n(); ++c) {
    if (now.layer.block[c] < 0) continue;
    prefetch_next(group, c);
    BlockNow block(now.at, now.layer.block[c], c, &now);
    run_all(kernels, block);
  }
}

/// Kernels over the same range, one after the other in each group; layer by layer, those of the blocks of a layer
/// before the next one, where stress lives so.
inline void walk_group(const Score& score, const ScoreWalk& of, GroupNow& now)
{
  const std::span<const ScoreSegment> segments = score.of(of);
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const auto kernels = score.of(segments[k]);
    switch (segments[k].over) {
      case Over::layer: {
        const bool blocks_follow =
            score.home == layers_first && k + 1 < segments.size() && segments[k + 1].over == Over::block;
        for_each_layer(now.group, [&](const BlockLayer& blocks) {
          LayerNow layer(now, blocks);
          run_all(kernels, layer);
          if (blocks_follow) run_blocks(score.of(segments[k + 1]), layer);
        });
        k += blocks_follow ? 1 : 0;
        break;
      }
      case Over::block: run_blocks(kernels, now, of.pass == stress); break;
      default: run_all(kernels, now);
    }
  }
  if (of.pass == stress) enter(now.stress, now.sums);
}

inline void walk(StepNow& now, const ScoreWalk& of)
{
  const Score& score = now.score;
  if (of.over == Over::once) {
    for (const ScoreSegment& segment : score.of(of)) run_all(score.of(segment), now);
  } else if (of.over == Over::nodes) {
    now.work.threads.for_each_range(static_cast<Index>(now.work.active_nodes.size()), nodes_per_chunk,
        [&](Index begin, Index end, Index chunk, int) {
          Nodes nodes(
              now, now.work.node_sums[chunk], chunk, std::span(now.work.active_nodes).subspan(begin, end - begin));
          for (const ScoreSegment& segment : score.of(of)) run_all(score.of(segment), nodes);
        });
  } else {
    const bool has_layers =
        std::ranges::any_of(score.of(of), [](const ScoreSegment& s) { return s.over == Over::layer; });
    const bool keeps = now.model.scheme->keeps_gauss_values;
    for_each_group(now.model, now.state, now.work, [&](const CellGroup<Quad4>& group, CellSums& sums, auto& leaving) {
      GroupNow of_group(now, group, leaving, sums);
      of_group.one_layer = has_layers && !keeps && has_one_layer(group);
      walk_group(score, of, of_group);
    });
  }
}

}  // namespace terp
