// Sums of eight points at a time stay in registers for one slot, for all points of a strip of the block. Slots that no
// point of the strip reaches are left out.
#include "mpm/kernels/overlap.hpp"

#include <algorithm>

namespace terp {
namespace {

using P = Patch<Quad4>;

constexpr Index strip_packs = 8;
constexpr int n_stress = n_sym<2>;

/// Shares of the points of a strip, columns times Omega_p.
struct StripShares {
  std::array<PointShares, strip_packs> of;
  Index n = 0;                         ///< packs
  std::array<bool, 4> across{}, up{};  ///< columns and rows that any point reaches

  bool reach(int slot) const { return up[slot / 4] && across[slot % 4]; }
};

void set_strip(const PointBlock<2>& block, Index first, const PatchSize& size, StripShares& shares)
{
  auto across = zero_packs<4>(), up = zero_packs<4>();
  shares.n = std::min(strip_packs, (block.n_padded() - first) / pack_width);
  for (Index k = 0; k < shares.n; ++k) {
    const Index p = first + k * pack_width;
    PointShares& of = shares.of[k];
    set_shares(block, p, size, of);
    const Pack volume = Pack::load(block.row(Rows::volume) + p);
    for (int i = 0; i < 4; ++i) {
      of.across[i] = of.across[i] * volume;
      across[i] = max(across[i], of.across[i]);
      up[i] = max(up[i], of.up[i]);
    }
  }
  for (int i = 0; i < 4; ++i) {
    shares.across[i] = any_of(across[i] > Pack(0.0));
    shares.up[i] = any_of(up[i] > Pack(0.0));
  }
}

void add_stress_and_volume(const PointBlock<2>& block, Index first, const StripShares& shares, int width, Real* sums)
{
  for (int slot = 0; slot < P::n_slots; ++slot) {
    if (!shares.reach(slot)) continue;
    auto parts = zero_packs<pack_width>();
    for (Index k = 0; k < shares.n; ++k) {
      const Pack share = shares.of[k].in_slot(slot);
      for (int r = 0; r < n_stress; ++r) {
        const Real* sigma = block.row(Rows::sigma + r) + first + k * pack_width;
        parts[r] = fma(share, Pack::load(sigma), parts[r]);
      }
      parts[patch_volume] += share;
    }
    Real* at = sums + slot * width;
    store_some(load_some(at, patch_others) + sum_eight(parts), at, patch_others);
  }
}

/// The same bits for at most eight points: one after the other, with its stress and 1 in lanes, added as sum() does.
void add_few_points(const PointBlock<2>& block, const StripShares& shares, int width, Real* sums)
{
  auto rows = zero_packs<pack_width>();
  for (int r = 0; r < n_stress; ++r) rows[r] = Pack::load(block.row(Rows::sigma + r));
  rows[patch_volume] = Pack(1.0);
  const auto points = turn(rows);
  for (int slot = 0; slot < P::n_slots; ++slot) {
    if (!shares.reach(slot)) continue;
    alignas(64) Real share[pack_width];
    shares.of[0].in_slot(slot).store(share);
    const auto term = [&](int k) { return Pack(share[k]) * points[k]; };
    const auto pair = [&](int k) { return block.n > 4 ? term(k) + term(k + 4) : term(k); };
    const Pack total = (pair(0) + pair(2)) + (pair(1) + pair(3));
    store_some(Pack(0.0) + total, sums + slot * width, patch_others);
  }
}

void add_row(const Real* row, const StripShares& shares, int width, Real* sums)
{
  for (int j = 0; j < 4; ++j) {
    if (!shares.up[j]) continue;
    auto part = zero_packs<4>();
    for (Index k = 0; k < shares.n; ++k) {
      const Pack value = shares.of[k].up[j] * Pack::load(row + k * pack_width);
      for (int i = 0; i < 4; ++i) part[i] = fma(value, shares.of[k].across[i], part[i]);
    }
    const auto total = sum_each(part);
    for (int i = 0; i < 4; ++i) sums[(4 * j + i) * width] += total[i];
  }
}

}  // namespace

void sum_over_patch(
    const PointBlock<2>& block, const PatchSize& size, std::span<const int> others, int width, Real* sums)
{
  static_assert(P::n_slots % pack_width == 0);
  for (int k = 0; k < P::n_slots * width; k += pack_width) store_some(Pack(0.0), sums + k, pack_width);
  for (Index first = 0; first < block.n_padded(); first += strip_packs * pack_width) {
    StripShares shares;
    set_strip(block, first, size, shares);
    if (block.n <= pack_width)
      add_few_points(block, shares, width, sums);
    else
      add_stress_and_volume(block, first, shares, width, sums);
    for (std::size_t r = 0; r < others.size(); ++r)
      add_row(block.row(others[r]) + first, shares, width, sums + patch_others + r);
  }
}

void sum_row_over_patch(const PointBlock<2>& block, int row, const PatchSize& size, int width, Real* sums)
{
  auto parts = zero_packs<P::n_slots>();
  for (Index p = 0; p < block.n; p += pack_width) {
    PointShares shares;
    set_shares(block, p, size, shares);
    const Pack value = Pack::load(block.row(row) + p) * Pack::load(block.row(Rows::volume) + p);
    for (int slot = 0; slot < P::n_slots; ++slot) parts[slot] = fma(value, shares.in_slot(slot), parts[slot]);
  }
  for (int slot = 0; slot < P::n_slots; ++slot) sums[slot * width] += sum(parts[slot]);
}

void fold_sums(const BlockPartners& partners, const TakenShares& taken, int width, Real* sums)
{
  const auto at = [&](int slot, int first) { return sums + slot * width + first; };
  const auto move = [&](int from, int to, Real part) {
    for (int first = 0; first < width; first += pack_width) {
      const int n = std::min(pack_width, width - first);
      store_some(load_some(at(to, first), n) + Pack(part) * load_some(at(from, first), n), at(to, first), n);
    }
  };
  const auto keep = [&](int slot, Real part) {
    for (int first = 0; first < width; first += pack_width) {
      const int n = std::min(pack_width, width - first);
      store_some(Pack(part) * load_some(at(slot, first), n), at(slot, first), n);
    }
  };
  for (int q = 0; q < Quad4::n_corners; ++q) {
    const int k = P::n_across_sides + q;
    const Real back = 1.0 - taken[k];
    if (back == 0.0) continue;
    const auto [before, after] = P::beside_corner[q];
    const int from = P::outer_slot[k];
    if (partners[before] >= 0 && partners[after] >= 0) {
      move(from, P::outer_slot[before], 0.5 * back);
      move(from, P::outer_slot[after], 0.5 * back);
    } else {
      move(from, P::outer_slot[partners[before] >= 0 ? before : after], back);
    }
    keep(from, taken[k]);
  }
  for (int k = 0; k < P::n_across_sides; ++k) {
    const Real back = 1.0 - taken[k];
    if (back == 0.0) continue;
    move(P::outer_slot[k], P::own_slot[P::own_beside[k]], back);
    keep(P::outer_slot[k], taken[k]);
  }
}

}  // namespace terp
