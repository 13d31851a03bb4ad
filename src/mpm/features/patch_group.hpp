// Shares that overlap, for the schemes that integrate at Gauss points: what a group of cells leaves for the cells
// around it, and takes from them. Each pass writes for its own blocks and reads what the pass before wrote.
// Not for: where a point counts (mpm/kernels/overlap.hpp).
#pragma once

#include "mpm/features/overlap.hpp"
#include "mpm/schemes/cell_group.hpp"
#include "mpm/features/patch_values.hpp"
#include "mpm/features/share_ratio.hpp"
#include "mpm/kernels/overlap.hpp"
#include "mpm/step/workspace.hpp"

namespace terp {

inline PatchValues& patches_of(Workspace& work) { return work.with.overlap->patches; }

/// Fetches the extents of the points of the cell after cell c: their row lies apart from those that are read in order.
template <class Element>
void prefetch_extents(int inverse_extent, const CellGroup<Element>& group, int c)
{
  const Index next = c + 1 < group.n() ? group.cells[c + 1] : group.next_cell;
  if (next < 0) return;
  for_each_block(group.points, next, [&](const auto& block, Index) { prefetch(block.row(inverse_extent), block.n); });
}

/// Fetches what an update from patches needs of a block, before its patch is put together.
template <int Dim>
void prefetch_for_update(int inverse_extent, const PointBlock<Dim>& block)
{
  using Rows = PointRows<Dim>;
  const auto fetch = [&](int first, int end) {
    prefetch(block.row(first), static_cast<std::ptrdiff_t>(end - first) * block.capacity);
  };
  fetch(Rows::xi, Rows::v);
  fetch(Rows::volume, Rows::id);
  fetch(Rows::state, inverse_extent);  // its row follows those of the laws
}

/// Of the squares of the points of a cell.
template <class Element>
PatchSize patch_size(int inverse_extent, const CellGroup<Element>& group, Index cell)
{
  return {inverse_extent, std::sqrt(group.mesh.geometry(cell).volume)};
}

/// Sets the partners of the blocks of a group: wherever a block was made or left since they were found.
template <class Element>
void set_partners(const CellGroup<Element>& group, PatchValues& patches)
{
  for (const Index cell : group.cells)
    for_each_block(group.points, cell, [&](const auto& block, Index b) {
      const BlockPartners& found = patches.partners[b] = find_block_partners(group.points, patches.cells[cell], block);
      const bool lacks = std::ranges::any_of(found, [](Index partner) { return partner < 0; });
      patches.folds[b] = lacks ? PatchValues::lacks_partner : 0;
    });
}

/// First pass: sums of each block over its patch. others(block): rows beyond the stress.
template <class Element, class Others>
void sum_over_patches(
    const SchemeContext& context, const CellGroup<Element>& group, PatchValues& patches, Others&& others)
{
  const int width = patches.sum_width;
  for (int c = 0; c < group.n(); ++c) {
    const Index cell = group.cells[c];
    prefetch_extents(context.inverse_extent, group, c);
    const PatchSize size = patch_size(context.inverse_extent, group, cell);
    for_each_block(group.points, cell, [&](const auto& block, Index b) {
      sum_over_patch(block, size, others(block), width, patches.sums_of(b));
      if (const int row = context.materials[block.material].excess_row; row >= 0)
        sum_row_over_patch(block, row, size, width, patches.sums_of(b) + patches.excess_place);
      Real volume = 0.0;
      for (int slot = 0; slot < Patch<Quad4>::n_slots; ++slot)
        volume += patches.sums_of(b)[slot * width + patch_volume];
      patches.taken[b] = taken_by(volume, group.mesh.geometry(cell).volume);
    });
  }
}

/// After the first pass of all groups, and `mark_small_partners`: what is not taken goes back.
template <class Element>
void fold_patches(const CellGroup<Element>& group, PatchValues& patches)
{
  for (const Index cell : group.cells)
    for_each_block(group.points, cell, [&](const auto&, Index b) {
      if (patches.folds[b] != 0)
        fold_sums(patches.partners[b], patches.taken_shares(b), patches.sum_width, patches.sums_of(b));
    });
}

/// Outer sub-cells whose partners reach into each sub-cell of a cell.
constexpr std::array<std::array<int, 3>, Quad4::n_gauss> outer_beside_own()
{
  std::array<std::array<int, 3>, Quad4::n_gauss> beside{};
  std::array<int, Quad4::n_gauss> n{};
  for (int k = 0; k < Patch<Quad4>::n_outer; ++k) {
    const int g = Patch<Quad4>::own_beside[k];
    beside[g][n[g]++] = k;
  }
  return beside;
}

/// Eight rows at the Gauss points of eight cells, shape [g][row].
using GaussRows = std::array<std::array<Pack, pack_width>, Quad4::n_gauss>;

/// Sums `first` to `first` + 7 of the blocks of a layer at their Gauss points, with what their partners leave there.
template <class Element>
GaussRows collect_sums(const CellGroup<Element>& group, PatchValues& patches, const BlockLayer& layer, int first)
{
  using P = Patch<Quad4>;
  constexpr auto beside = outer_beside_own();
  const int width = patches.sum_width, n = std::min(pack_width, width - first);
  const Real* const all = patches.sums_of(0) + first;
  GaussRows sums;
  for (auto& of_cells : sums) of_cells.fill(Pack(0.0));
  for (int c = 0; c < group.n(); ++c) {
    const Index b = layer.block[c];
    if (b < 0) continue;
    const BlockPartners& partners = patches.partners[b];
    for (int g = 0; g < Quad4::n_gauss; ++g) {
      Pack sum = load_some(all + (std::ptrdiff_t{b} * P::n_slots + P::own_slot[g]) * width, n);
      for (const int k : beside[g])
        if (partners[k] >= 0) sum += load_some(all + partners[k] * std::ptrdiff_t{width}, n);
      sums[g][c] = sum;
    }
  }
  for (auto& of_cells : sums) of_cells = turn(of_cells);
  return sums;
}

/// Sums of the blocks of a layer at the Gauss points, one lane per cell: stress and volume into `gauss`, n_others more
/// rows into `others`.
template <class Element>
void collect_layer(const CellGroup<Element>& group, PatchValues& patches, const BlockLayer& layer,
    GaussValues<Element, Pack>& gauss, GaussRow<Element>* others, int n_others)
{
  for (int first = 0; first < patch_others + n_others; first += pack_width) {
    const GaussRows sums = collect_sums(group, patches, layer, first);
    for (int g = 0; g < Element::n_gauss; ++g)
      for (int r = first; r < std::min(first + pack_width, patch_others + n_others); ++r)
        (r < patch_volume       ? gauss.sigma[r]
            : r == patch_volume ? gauss.volume
                                : others[r - patch_others])[g] = sums[g][r - first];
  }
}

/// Rows that the Gauss points of a layer leave for the points around them; those that are not set hold anything.
template <class Element>
class LeftRows {
 public:
  void set(int row, const PerGauss<Element, Pack>& lanes)
  {
    for (int g = 0; g < Element::n_gauss; ++g) rows_[g][row / pack_width][row % pack_width] = lanes[g];
  }
  /// What a row has changed by since it was set.
  void set_change(int row, const PerGauss<Element, Pack>& lanes)
  {
    for (int g = 0; g < Element::n_gauss; ++g) {
      Pack& value = rows_[g][row / pack_width][row % pack_width];
      value = lanes[g] - value;
    }
  }
  /// A number of each block. from: by block number.
  void set(int row, const BlockLayer& layer, std::span<const Real> from)
  {
    alignas(64) std::array<Real, pack_width> numbers{};
    for (int c = 0; c < pack_width; ++c)
      if (layer.block[c] >= 0) numbers[c] = from[layer.block[c]];
    PerGauss<Element, Pack> lanes;
    lanes.fill(Pack::load(numbers.data()));
    set(row, lanes);
  }

  /// Row `ratio` becomes 1. Where the way back is the transpose of the way there, rows 0 to `end` - 1 are then weighed;
  /// with_pore: and the pore pressure.
  void end_with(int ratio, int end, bool with_pore)
  {
    PerGauss<Element, Pack> lanes;
    lanes.fill(Pack(1.0));
    set(ratio, lanes);
    n_weighed_ = end;
    weighs_pore_ = with_pore;
  }
  /// The pore pressure of each block. from: by block number.
  void set_pore(int row, const BlockLayer& layer, std::span<const Real> from)
  {
    set(row, layer, from);
    if (weighs_pore_) pore_row_ = row;
  }
  void weigh(const ShareRatio<Element, Pack>& weights)
  {
    const auto weigh_row = [&](int r) {
      PerGauss<Element, Pack> lanes;
      for (int g = 0; g < Element::n_gauss; ++g) lanes[g] = rows_[g][r / pack_width][r % pack_width];
      set(r, weights.weigh(lanes));
    };
    for (int r = 0; r < n_weighed_; ++r) weigh_row(r);
    if (pore_row_ >= 0) weigh_row(pore_row_);
  }

  void leave(const CellGroup<Element>& group, PatchValues& patches, const BlockLayer& layer) const
  {
    const int width = patches.gauss_width;
    for (int g = 0; g < Element::n_gauss; ++g)
      for (int first = 0; first < width; first += pack_width) {
        const auto of_cells = turn(rows_[g][first / pack_width]);
        for (int c = 0; c < group.n(); ++c)
          if (layer.block[c] >= 0)
            store_some(
                of_cells[c], patches.gauss_of(layer.block[c]) + g * width + first, std::min(pack_width, width - first));
      }
  }

 private:
  int n_weighed_ = 0, pore_row_ = -1;
  bool weighs_pore_ = false;
  std::array<std::array<std::array<Pack, pack_width>, PatchView::most_rows / pack_width>, Element::n_gauss> rows_;
};

}  // namespace terp
