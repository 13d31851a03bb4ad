// What the step does for nonlocal softening (soil/laws/nonlocal.hpp): the increments of the points go to the nodes, are
// spread there, and come back to the points. Only soil that can soften takes part.
#pragma once

#include "mpm/features/softening.hpp"
#include "mpm/kernels/map_to_corners.hpp"
#include "mpm/points/rows_of_packs.hpp"
#include "mpm/step/walks.hpp"

#include <algorithm>

namespace terp {

/// Whether any point of a cell softened in this step.
inline bool softens(const StepModel& model, const PointBlocks<2>& points, Index cell)
{
  Pack most(0.0);
  for_each_block(points, cell, [&](const PointBlock<2>& block, Index) {
    const int row = model.materials[block.material].increment_row;
    for (Index p = 0; row >= 0 && p < block.n; p += pack_width) most = max(most, Pack::load(block.row(row) + p));
  });
  return any_of(most > Pack(0.0));
}

/// Finds the nodes that softening can reach in this step, and the cells around them: each sub-step reaches one ring of
/// cells further, one is for points that move to the next cell within the step, and one completes the outermost nodes.
/// Before points move and the slots of cells change. Returns true if any soil softens.
inline bool find_reach_of_softening(const StepModel& model, const StepState& state, Workspace& work)
{
  const Mesh<2>& mesh = *model.mesh;
  SofteningReach& reach = work.with.softening->reach;
  reach.clear();
  const std::vector<Index>& cells = state.points.occupied();
  for (std::size_t slot = 0; slot < cells.size(); ++slot)
    if (work.with.softening->cell_softens[slot] != 0) reach.enter(cells[slot]);
  std::size_t begin = 0;
  for (int ring = 0; ring < model.with.softening->diffusion.n_substeps + 2 && begin < reach.cells.size(); ++ring)
    for (const std::size_t end = reach.cells.size(); begin < end; ++begin)
      for (const Index i : mesh.cells[reach.cells[begin]]) {
        if (std::exchange(reach.has_node[i], 1) != 0) continue;
        for (Index k = mesh.first_cell_of_node[i]; k < mesh.first_cell_of_node[i + 1]; ++k)
          reach.enter(static_cast<Index>(mesh.cells_of_node[k].cell));
      }
  return begin > 0;
}

/// V, V z and V l^2 of the corners of a cell, from its points.
inline void collect_softening(
    const StepModel& model, const PointBlocks<2>& points, Index cell, CornerSoftening& corners)
{
  corners = {};
  for_each_block(points, cell, [&](const PointBlock<2>& block, Index) {
    const SoilMaterial& material = model.materials[block.material];
    const int row = material.increment_row;
    if (row < 0) return;
    auto volume = zero_packs<Quad4::n_corners>(), increment = zero_packs<Quad4::n_corners>();
    Pack most(0.0);
    for (Index p = 0; p < block.n; p += pack_width) most = max(most, Pack::load(block.row(row) + p));
    const bool softens = any_of(most > Pack(0.0));
    for (Index p = 0; p < block.n; p += pack_width) {
      const auto N = mapping_shares<Quad4>(load_rows<2>(block, Rows::xi, p));
      const Pack z = Pack::load(block.row(row) + p);
      const Pack omega = select(z >= Pack(0.0), Pack::load(block.row(Rows::volume) + p), Pack(0.0));
      for (int i = 0; i < Quad4::n_corners; ++i) volume[i] = fma(N[i], omega, volume[i]);
      if (!softens) continue;
      const Pack given = omega * max(z, Pack(0.0));
      for (int i = 0; i < Quad4::n_corners; ++i) increment[i] = fma(N[i], given, increment[i]);
    }
    PerCorner<Quad4> of_block{};
    add_lanes(volume, of_block);
    if (softens) add_lanes(increment, corners.increment);
    const Real length = material.softening.length;
    for (int i = 0; i < Quad4::n_corners; ++i) {
      corners.volume[i] += of_block[i];
      corners.length_squared[i] += of_block[i] * length * length;
    }
  });
}

/// Sums of the cells around a node: what it starts from.
inline void gather_softening(const StepModel& model, const StepState& state, Index i, SofteningScratch& softening)
{
  const Mesh<2>& mesh = *model.mesh;
  const NodeDiffusion& diffusion = model.with.softening->diffusion;
  NodeSpread& spread = softening.spread;
  Real volume = 0.0, increment = 0.0, length_squared = 0.0;
  for (Index k = mesh.first_cell_of_node[i]; k < mesh.first_cell_of_node[i + 1]; ++k) {
    const auto [cell, corner] = mesh.cells_of_node[k];
    const Index slot = state.points.slot_of_cell()[cell];
    if (slot < 0 || softening.reach.has_cell[cell] == 0) continue;
    const CornerSoftening& from = softening.corners[slot];
    volume += from.volume[corner];
    increment += from.increment[corner];
    length_squared += from.length_squared[corner];
  }
  const Real inverse = volume > 0.0 ? 1.0 / volume : 0.0;
  spread.inverse_volume[i] = inverse;
  spread.value[i] = increment * inverse;
  spread.filling[i] = volume / diffusion.full_volume[i];
  spread.variance[i] = variance_to_spread(length_squared * inverse, diffusion.mapping_variance[i]);
}

/// The same of the nodes of a group that softening can reach.
inline void gather_group(const StepModel& model, const StepState& state, SofteningScratch& softening, Index g)
{
  for (Index i = pack_width * g; i < pack_width * (g + 1); ++i)
    if (softening.reach.has_node[i] != 0) gather_softening(model, state, i, softening);
}

/// What the corners of a cell hold goes to its points, whose strength follows it in the next step.
inline void soften_points(const StepModel& model, PointBlocks<2>& points, Index cell, const NodeNumbers& value)
{
  std::array<PerCorner<Quad4>, 1> at;
  for (int i = 0; i < Quad4::n_corners; ++i) at[0][i] = value[model.mesh->cells[cell][i]];
  if (std::ranges::all_of(at[0], [](Real a) { return a == 0.0; })) return;
  for_each_block(points, cell, [&](const PointBlock<2>& block, Index) {
    const SoilMaterial& material = model.materials[block.material];
    if (material.increment_row < 0) return;
    alignas(64) Real spread[strip_length];
    for (Index first = 0; first < block.n_padded(); first += strip_length) {
      const Index n = std::min(strip_length, block.n_padded() - first);
      for (Index p = 0; p < n; p += pack_width)
        interpolate(at, Quad4::shape_functions(load_rows<2>(block, Rows::xi, first + p)))[0].store(spread + p);
      material.law->soften(material.softening,
          {.law = material.view(block, first), .spread = spread, .n = n, .n_points = block.n - first});
    }
  });
}

/// The strength of the next step follows what softened in this one, spread over the length of each material. Only
/// where that can reach.
inline void spread_softening(const StepModel& model, StepState& state, Workspace& work)
{
  const NodeDiffusion& diffusion = model.with.softening->diffusion;
  NodeSpread& spread = work.with.softening->spread;
  const SofteningReach& reach = work.with.softening->reach;
  std::vector<CornerSoftening>& corners = work.with.softening->corners;
  const auto for_each_cell = [&](auto&& f) {
    for_each_slot(state, work, [&](Index slot, Index) {
      const Index cell = state.points.occupied()[slot];
      if (reach.has_cell[cell] != 0) f(slot, cell);
    });
  };
  const auto for_each_node_group = [&](auto&& f) {
    work.threads.for_each_range(
        diffusion.n_groups(), nodes_per_chunk / pack_width, [&](Index begin, Index end, Index, int) {
          for (Index g = begin; g < end; ++g)
            if (reach.has_any_of_group(g)) f(g);
        });
  };
  for_each_cell([&](Index slot, Index cell) { collect_softening(model, state.points, cell, corners[slot]); });
  for (NodeNumbers* numbers : {&spread.value, &spread.next, &spread.filling}) numbers->clear();
  for_each_node_group([&](Index g) { gather_group(model, state, *work.with.softening, g); });
  for_each_node_group([&](Index g) { set_rates(diffusion, g, spread); });
  for (int n = 0; n < diffusion.n_substeps; ++n) {
    for_each_node_group([&](Index g) { spread_nodes(diffusion, g, spread); });
    std::swap(spread.value, spread.next);
  }
  for_each_cell([&](Index, Index cell) { soften_points(model, state.points, cell, spread.value); });
}

}  // namespace terp
