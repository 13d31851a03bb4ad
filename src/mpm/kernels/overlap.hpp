// Shares that overlap: a point is a square of the size of its own spacing, in the local coordinates of its cell. It
// counts in each sub-cell of the cell's patch by the part of the square that lies in it (decision 0042).
// Shares in a cell that holds no point of the same material and body go back to the nearest sub-cell of one that does.
// What comes from Gauss points to a point has the same shares, so that both ways are transposes of each other.
#pragma once

#include "mpm/mesh/patch.hpp"
#include "math/tables.hpp"
#include "mpm/kernels/cell_sums.hpp"

#include <algorithm>

namespace terp {

/// Rows of the sums over a patch, side by side for each slot: stress, then volume, then those that a law adds.
inline constexpr int patch_volume = n_sym<2>;
inline constexpr int patch_others = n_sym<2> + 1;

/// The sub-cell of a cell that is in a slot of its patch, or beside it.
inline constexpr std::array<int, Patch<Quad4>::n_slots> own_beside_slot{0, 0, 1, 1, 0, 0, 1, 1, 2, 2, 3, 3, 2, 2, 3, 3};

/// Blocks of the same material and body in the cells around.
inline BlockPartners find_block_partners(
    const PointBlocks<2>& points, const std::array<Index, Patch<Quad4>::n_outer>& partners, const BlockKey& key)
{
  using P = Patch<Quad4>;
  BlockPartners found;
  Index cell = -1, other = -1;  // the last one, and its block: both outer sub-cells across a side are in one cell
  for (int k = 0; k < P::n_outer; ++k) {
    found[k] = -1;
    if (partners[k] == outside) continue;
    if (partners[k] / P::n_outer != cell) {
      cell = partners[k] / P::n_outer;
      other = points.first_block(cell);
      while (other >= 0 && (points.block(other).material != key.material || points.block(other).body != key.body))
        other = points.block(other).next;
    }
    if (other >= 0) found[k] = P::n_slots * other + P::outer_slot[partners[k] % P::n_outer];
  }
  for (int q = 0; q < Quad4::n_corners; ++q) {  // a corner is reached by way of a side
    const auto [before, after] = P::beside_corner[q];
    if (found[before] < 0 && found[after] < 0) found[P::n_across_sides + q] = -1;
  }
  return found;
}

/// How large a point is in the local coordinates of its cell: its row of 1 / side of the square [1/m], and sqrt(V_e) of
/// the cell [m], two local units. A square is at most as large as a cell.
struct PatchSize {
  int inverse_extent;
  Real cell;

  /// 1 / side of the squares of the points p ... p + 7, in local units.
  Pack scale(const PointBlock<2>& block, Index p) const
  {
    return max(Pack::load(block.row(inverse_extent) + p) * Pack(0.5 * cell), Pack(0.5));
  }
};

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

/// Shares of the points p ... p + 7.
inline void set_shares(const PointBlock<2>& block, Index p, const PatchSize& size, PointShares& shares)
{
  const Pack scale = size.scale(block, p);
  set_shares_along(Pack::load(block.row(Rows::xi) + p), scale, shares.across);
  set_shares_along(Pack::load(block.row(Rows::xi + 1) + p), scale, shares.up);
}

/// The same of squares that reach two columns and two rows of the patch at most, as all do that are no larger than a
/// sub-cell: the parts in a window of 2 x 2 slots, with the bits that they have in PointShares.
struct PointWindow {
  std::array<Pack, 2> across, up;
  Pack first;  ///< slot of its lower left corner, as a place of a table (math/tables.hpp)

  static constexpr std::array<int, 4> slots{0, 1, 4, 5};  ///< from the first on
  Pack in_slot(int k) const { return up[k / 2] * across[k % 2]; }
};

/// Parts of an interval in two neighbouring columns, and the number of the first. Below 1 in lanes where a third one
/// has a part.
inline Pack set_window_along(Pack place, Pack scale, std::array<Pack, 2>& shares, Pack& column)
{
  const Pack zero(0.0), one(1.0), middle = Pack(0.5) - place * scale, low = middle - scale, high = middle + scale;
  const Mask in_low = low > zero, in_middle = middle > zero;
  shares[0] = min(max(select(in_low, low, select(in_middle, middle, high)), zero), one);
  shares[1] = one - shares[0];
  column = select(in_low, zero, select(in_middle, one, Pack(2.0)));
  return select(in_low, middle, select(in_middle, high, one));
}

/// Windows of the points p ... p + 7. False: a square does not fit into one.
inline bool set_window(const PointBlock<2>& block, Index p, const PatchSize& size, PointWindow& window)
{
  const Pack scale = size.scale(block, p);
  Pack column, row;
  const Pack across = set_window_along(Pack::load(block.row(Rows::xi) + p), scale, window.across, column);
  const Pack up = set_window_along(Pack::load(block.row(Rows::xi + 1) + p), scale, window.up, row);
  window.first = fma(row, Pack(4.0), column) + Pack(place_base);
  const unsigned in_use = block.n - p < pack_width ? (1u << (block.n - p)) - 1u : 0xffu;
  return (to_bits(min(across, up) < Pack(1.0)) & in_use) == 0;
}

/// Calls f with the shares of the points p ... p + 7. Not inlined: where windows serve, GCC would take what this needs
/// out of loops that never call it.
template <class F>
[[gnu::noinline]] void with_wide_shares(const PointBlock<2>& block, Index p, const PatchSize& size, const F& f)
{
  PointShares shares;
  set_shares(block, p, size, shares);
  f(shares);
}

/// Calls f with what at_points takes fastest: the windows or the shares of the points p ... p + 7.
template <class F>
void with_shares(const PointBlock<2>& block, Index p, const PatchSize& size, const F& f)
{
  if constexpr (looks_up_at_once) {
    PointWindow window;
    if (set_window(block, p, size, window))
      f(window);
    else
      with_wide_shares(block, p, size, f);
  } else {
    PointShares shares;
    set_shares(block, p, size, shares);
    f(shares);
  }
}

/// Sums over the points of a block: of share * Omega_p * row, and of share * Omega_p, into sums[slot * width + row].
/// others: rows beyond the stress; width: Reals for each slot.
void sum_over_patch(
    const PointBlock<2>& block, const PatchSize& size, std::span<const int> others, int width, Real* sums);

/// The same of one row alone, added to sums[slot * width].
void sum_row_over_patch(const PointBlock<2>& block, int row, const PatchSize& size, int width, Real* sums);

/// Part of a share that each outer sub-cell of a block takes: of its partner (`PatchValues::taken`), 0 without one.
/// The rest of what lies across a side goes back to the cell's own sub-cell there, the rest of what lies across a
/// corner to the outer sub-cells beside it that have a partner (decision 0066).
using TakenShares = std::array<Real, Patch<Quad4>::n_outer>;

/// Part of their shares that other cells leave in a block: all, once its own points fill an eighth of the cell. A block
/// with next to no soil has next to no mass, and could not carry the stiffness of its neighbours (decision 0066).
inline Real taken_by(Real own_volume, Real cell_volume)
{
  constexpr Real fills = 1.0 / 8.0;
  return std::min(1.0, own_volume / (fills * cell_volume));
}

/// Moves what outer sub-cells do not take to where it goes back to.
void fold_sums(const BlockPartners& partners, const TakenShares& taken, int width, Real* sums);

/// What the Gauss points around a block hold, row by row.
class PatchView {
  using P = Patch<Quad4>;

 public:
  static constexpr int most_rows = 32;

  /// values(block): its values [g * width + row].
  template <class Values>
  PatchView(const BlockPartners& partners, const TakenShares& taken, Index block, Values&& values, int width)
  {
    const Real* own = values(block);
    std::array<const Real*, P::n_slots> slots;
    std::array<std::array<Real, most_rows>, P::n_outer> means;  // of sub-cells that do not take all
    for (int g = 0; g < Quad4::n_gauss; ++g) slots[P::own_slot[g]] = own + g * width;
    const auto there = [&](int k) {
      return values(partners[k] / P::n_slots) + own_beside_slot[partners[k] % P::n_slots] * width;
    };
    const auto blend = [&](int k, Real part, const Real* a, const Real* b) {
      for (int r = 0; r < width; ++r) means[k][r] = part * a[r] + (1.0 - part) * b[r];
      return means[k].data();
    };
    for (int k = 0; k < P::n_across_sides; ++k) {
      const Real* back = own + P::own_beside[k] * width;
      slots[P::outer_slot[k]] = partners[k] < 0   ? back
                                : taken[k] >= 1.0 ? there(k)
                                                  : blend(k, taken[k], there(k), back);
    }
    for (int q = 0; q < Quad4::n_corners; ++q) {
      const int k = P::n_across_sides + q;
      const Real*& slot = slots[P::outer_slot[k]];
      if (taken[k] >= 1.0) {
        slot = there(k);
        continue;
      }
      const auto [before, after] = P::beside_corner[q];
      const Real *a = slots[P::outer_slot[before]], *b = slots[P::outer_slot[after]];
      slot = partners[before] < 0 ? b : partners[after] < 0 ? a : blend(k, 0.5, a, b);
      if (partners[k] >= 0) slot = blend(k, taken[k], there(k), slot);
    }
    for (int first = 0; first < width; first += pack_width)
      for (int part = 0; part < P::n_slots; part += pack_width) {
        std::array<Pack, pack_width> of_slots;
        const int n = std::min(pack_width, width - first);
        for (int k = 0; k < pack_width; ++k) of_slots[k] = load_some(slots[part + k] + first, n);
        const auto of_rows = turn(of_slots);
        for (int r = 0; r < pack_width; ++r) of_rows[r].store(rows_[first + r] + part);
      }
  }
  PatchView(const PatchView&) = delete;

  /// Rows first ... first + n - 1 at eight points.
  template <int n>
  std::array<Pack, n> at_points(const PointShares& shares, int first) const
  {
    std::array<Pack, n> value = zero_packs<n>();
    for (int slot = 0; slot < P::n_slots; ++slot) {
      const Pack share = shares.in_slot(slot);
      for (int r = 0; r < n; ++r) value[r] = fma(share, Pack(rows_[first + r][slot]), value[r]);
    }
    return value;
  }
  /// The same bits: slots outside the windows add nothing.
  template <int n>
  std::array<Pack, n> at_points(const PointWindow& window, int first) const
  {
    std::array<Pack, n> value = zero_packs<n>();
    for (int k = 0; k < 4; ++k) {
      const Pack share = window.in_slot(k), places = window.first + Pack(static_cast<Real>(PointWindow::slots[k]));
      for (int r = 0; r < n; ++r) value[r] = fma(share, look_up(rows_[first + r], places), value[r]);
    }
    return value;
  }

 private:
  alignas(64) Real rows_[most_rows][P::n_slots];
};

}  // namespace terp
