// Shares that overlap, for the schemes that integrate at Gauss points: what a group of cells leaves for the cells
// around it, and takes from them. Each pass writes for its own blocks and reads what the pass before wrote.
// Not for: where a point counts (transfer/overlap.hpp).
#pragma once

#include "schemes/cell_group.hpp"
#include "schemes/patch_values.hpp"
#include "transfer/overlap.hpp"

namespace terp {

/// Fetches the extents of the points of the cell after cell c: their row lies apart from those that are read in order.
template <class Element>
void prefetch_extents(const SchemeContext& context, const CellGroup<Element>& group, int c)
{
  const Index next = c + 1 < group.n() ? group.cells[c + 1] : group.next_cell;
  if (next < 0) return;
  for_each_block(
      group.points, next, [&](const auto& block, Index) { prefetch(block.row(context.inverse_extent), block.n); });
}

/// First pass: sums of each block over its patch. others(block): rows beyond the stress.
template <class Element, class Others>
void sum_over_patches(const SchemeContext& context, const CellGroup<Element>& group, Others&& others)
{
  PatchValues& patches = *group.patches;
  for (int c = 0; c < group.n(); ++c) {
    const Index cell = group.cells[c];
    prefetch_extents(context, group, c);
    const Real size = std::sqrt(group.mesh.geometry(cell).volume);
    for_each_block(group.points, cell, [&](const auto& block, Index b) {
      patches.partners[b] = find_block_partners(group.points, patches.cells[cell], block);
      sum_over_patch(block, context.inverse_extent, size, others(block), patches.sum_width, patches.sums_of(b));
      if (const int row = context.materials[block.material].excess_row; row >= 0)
        sum_row_over_patch(
            block, row, {context.inverse_extent, size}, patches.sum_width, patches.sums_of(b) + patches.excess_place);
      fold_sums(patches.partners[b], patches.sum_width, patches.sums_of(b));
    });
  }
}

/// Sums of a block at its own Gauss points, with what its partners leave there: sums[g * sum_width + row].
inline void collect_sums(PatchValues& patches, Index b, Real* sums)
{
  using P = Patch<Quad4>;
  const int width = patches.sum_width;
  const Real* own = patches.sums_of(b);
  const auto add = [&](const Real* from, Real* to, bool first) {
    for (int r = 0; r < width; r += pack_width)
      (first ? Pack::load(from + r) : Pack::load(to + r) + Pack::load(from + r)).store(to + r);
  };
  for (int g = 0; g < Quad4::n_gauss; ++g) add(own + P::own_slot[g] * width, sums + g * width, true);
  const BlockPartners& partners = patches.partners[b];
  for (int k = 0; k < P::n_outer; ++k)
    if (partners[k] >= 0)
      add(patches.sums_of(partners[k] / P::n_outer) + P::outer_slot[partners[k] % P::n_outer] * width,
          sums + P::own_beside[k] * width, false);
}

/// Sums of the blocks of a layer at the Gauss points, one lane per cell: stress and volume into `gauss`, n_others more
/// rows into `others`.
template <class Element>
void collect_layer(const CellGroup<Element>& group, const BlockLayer& layer, GaussValues<Element, Pack>& gauss,
    GaussRow<Element>* others, int n_others)
{
  constexpr int most = PatchView::most_rows;
  const int width = group.patches->sum_width;
  alignas(64) std::array<Real, Element::n_gauss * most> sums[pack_width];
  for (int c = 0; c < pack_width; ++c) {
    if (layer.block[c] >= 0)
      collect_sums(*group.patches, layer.block[c], sums[c].data());
    else
      std::fill_n(sums[c].data(), Element::n_gauss * width, 0.0);
  }
  for (int g = 0; g < Element::n_gauss; ++g)
    for (int first = 0; first < patch_others + n_others; first += 4) {
      const auto rows = to_lanes([&](int c) { return sums[c].data() + g * width + first; });
      for (int r = first; r < std::min(first + 4, patch_others + n_others); ++r)
        (r < patch_volume       ? gauss.sigma[r]
            : r == patch_volume ? gauss.volume
                                : others[r - patch_others])[g] = rows[r - first];
    }
}

/// Writes a row of a layer for the patches around: lanes[g], one lane per cell.
template <class Element>
void leave_row(const CellGroup<Element>& group, const BlockLayer& layer, int row, const PerGauss<Element, Pack>& lanes)
{
  std::array<PerGauss<Element>, pack_width> values;
  from_lanes(lanes, [&](int c) { return values[c].data(); });
  for (int c = 0; c < group.n(); ++c)
    if (layer.block[c] >= 0)
      for (int g = 0; g < Element::n_gauss; ++g)
        group.patches->gauss_of(layer.block[c])[g * group.patches->gauss_width + row] = values[c][g];
}

/// The same with rows first ... first + 3 at once.
template <class Element, class Rows>
void leave_four_rows(const CellGroup<Element>& group, const BlockLayer& layer, int first, Rows&& rows)
{
  for (int g = 0; g < Element::n_gauss; ++g) {
    std::array<std::array<Real, 4>, pack_width> values;
    from_lanes(
        std::array<Pack, 4>{rows(0)[g], rows(1)[g], rows(2)[g], rows(3)[g]}, [&](int c) { return values[c].data(); });
    for (int c = 0; c < group.n(); ++c)
      if (layer.block[c] >= 0)
        std::copy_n(
            values[c].data(), 4, group.patches->gauss_of(layer.block[c]) + g * group.patches->gauss_width + first);
  }
}

/// What the Gauss points around block b hold, up to n_rows.
template <class Element>
PatchView view_patch(const CellGroup<Element>& group, Index b, int n_rows)
{
  PatchValues& patches = *group.patches;
  return PatchView(
      patches.partners[b], b, [&](Index other) { return patches.gauss_of(other); }, patches.gauss_width, n_rows);
}

}  // namespace terp
