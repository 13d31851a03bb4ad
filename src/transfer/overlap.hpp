// Shares that overlap: a point is a square of the size of its own spacing, in the local coordinates of its cell. It
// counts in each sub-cell of the cell's patch by the part of the square that lies in it (decision 0042).
// Shares in a cell that holds no point of the same material and body go back to the nearest sub-cell of one that does.
// What comes from Gauss points to a point has the same shares, so that both ways are transposes of each other.
#pragma once

#include "mesh/patch.hpp"
#include "parallel/lanes.hpp"
#include "transfer/cell_sums.hpp"

namespace terp {

/// Rows of a patch stand side by side for each slot, eight to a pack: stress, then volume, then those of the law.
inline constexpr int patch_volume = n_sym<2>;
inline constexpr int patch_others = n_sym<2> + 1;

/// Blocks of the same material and body in the cells around.
inline BlockPartners find_block_partners(
    const PointBlocks<2>& points, const std::array<Index, Patch<Quad4>::n_outer>& partners, const BlockKey& key)
{
  using P = Patch<Quad4>;
  BlockPartners found;
  for (int k = 0; k < P::n_outer; ++k) {
    found[k] = -1;
    if (partners[k] == outside) continue;
    for (Index b = points.first_block(partners[k] / P::n_outer); b >= 0; b = points.block(b).next)
      if (points.block(b).material == key.material && points.block(b).body == key.body)
        found[k] = P::n_outer * b + partners[k] % P::n_outer;
  }
  for (int q = 0; q < Quad4::n_corners; ++q) {  // a corner is reached by way of a side
    const auto [before, after] = P::beside_corner[q];
    if (found[before] < 0 && found[after] < 0) found[P::n_across_sides + q] = -1;
  }
  return found;
}

/// Parts of eight squares along both local coordinates, by column and row of the patch.
struct PointShares {
  std::array<Pack, 4> across, up;

  /// Part of the square in a slot.
  Pack in_slot(int slot) const { return up[slot / 4] * across[slot % 4]; }
};

/// Parts below -1, from -1 to 0, from 0 to 1 and above 1 of an interval around `place`; scale: 1 / its length. Written
/// where they stay: a copy of packs that were just written waits for them.
inline void set_shares_along(Pack place, Pack scale, std::array<Pack, 4>& shares)
{
  const Pack zero(0.0), one(1.0), below_0 = Pack(0.5) - place * scale;
  const auto clamp = [&](Pack a) { return min(max(a, zero), one); };
  const Pack low = clamp(below_0 - scale), middle = clamp(below_0), high = clamp(below_0 + scale);
  shares[0] = low;
  shares[1] = middle - low;
  shares[2] = high - middle;
  shares[3] = one - high;
}

/// Shares of the points p ... p + 7. inverse_extent: their row of 1 / side of the square [1/m]; cell_size: sqrt(V_e)
/// [m], two local units. A square is at most as large as a cell.
inline void set_shares(const PointBlock<2>& block, Index p, int inverse_extent, Real cell_size, PointShares& shares)
{
  const Pack scale = max(Pack::load(block.row(inverse_extent) + p) * Pack(0.5 * cell_size), Pack(0.5));
  set_shares_along(Pack::load(block.row(PointRows<2>::xi) + p), scale, shares.across);
  set_shares_along(Pack::load(block.row(PointRows<2>::xi + 1) + p), scale, shares.up);
}

/// How large a point is in the local coordinates of its cell: its row of 1 / side of the square [1/m], and sqrt(V_e) of
/// the cell [m].
struct PatchSize {
  int inverse_extent;
  Real cell;
};

/// Sums over the points of a block: of share * Omega_p * row, and of share * Omega_p, into sums[slot * width + row].
/// others: rows beyond the stress; width: Reals for each slot, a multiple of pack_width.
void sum_over_patch(
    const PointBlock<2>& block, int inverse_extent, Real cell_size, std::span<const int> others, int width, Real* sums);

/// The same of one row alone, added to sums[slot * width].
void sum_row_over_patch(const PointBlock<2>& block, int row, const PatchSize& size, int width, Real* sums);

/// Moves the sums of outer sub-cells without a partner to where they go back to.
void fold_sums(const BlockPartners& partners, int width, Real* sums);

/// What the Gauss points around a block hold, by slot.
class PatchView {
 public:
  /// values(block): its values [g * width + row]. Rows of corners without a partner are made here, up to `n_rows`.
  template <class Values>
  PatchView(const BlockPartners& partners, Index block, Values&& values, int width, int n_rows)
  {
    using P = Patch<Quad4>;
    const Real* own = values(block);
    for (int g = 0; g < Quad4::n_gauss; ++g) slot_[P::own_slot[g]] = own + g * width;
    const auto at = [&](int k) {
      return partners[k] < 0 ? own + P::own_beside[k] * width
                             : values(partners[k] / P::n_outer) + P::own_beside[partners[k] % P::n_outer] * width;
    };
    for (int k = 0; k < P::n_across_sides; ++k) slot_[P::outer_slot[k]] = at(k);
    for (int q = 0; q < Quad4::n_corners; ++q) {
      const int k = P::n_across_sides + q;
      const auto [before, after] = P::beside_corner[q];
      const Real*& slot = slot_[P::outer_slot[k]];
      if (partners[k] >= 0) {
        slot = at(k);
      } else if (partners[before] >= 0 && partners[after] >= 0) {
        const Real *a = at(before), *b = at(after);
        for (int r = 0; r < n_rows; ++r) mean_[q][r] = 0.5 * (a[r] + b[r]);
        slot = mean_[q].data();
      } else {
        slot = at(partners[before] >= 0 ? before : after);
      }
    }
  }
  PatchView(const PatchView&) = delete;

  /// Rows first ... first + n - 1 at eight points.
  template <int n>
  std::array<Pack, n> at_points(const PointShares& shares, int first) const
  {
    std::array<Pack, n> value = zero_packs<n>();
    for (int slot = 0; slot < Patch<Quad4>::n_slots; ++slot) {
      const Pack share = shares.in_slot(slot);
      for (int r = 0; r < n; ++r) value[r] = fma(share, Pack(slot_[slot][first + r]), value[r]);
    }
    return value;
  }

  static constexpr int most_rows = 32;

 private:
  std::array<const Real*, Patch<Quad4>::n_slots> slot_;
  std::array<std::array<Real, most_rows>, Quad4::n_corners> mean_;
};

}  // namespace terp
