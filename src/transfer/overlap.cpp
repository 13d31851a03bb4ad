// Sums of eight points at a time stay in registers for one row of four slots, for all points of a strip of the block.
#include "transfer/overlap.hpp"

#include "parallel/lanes.hpp"

#include <algorithm>

namespace terp {
namespace {

constexpr Index strip_packs = 8;
constexpr int n_stress = n_sym<2>;

/// share * Omega_p of the points of a strip: columns times volume, and rows.
struct StripShares {
  std::array<PointShares, strip_packs> of;
  Index n = 0;  ///< packs
};

void add_stress_and_volume(const PointBlock<2>& block, Index first, const StripShares& shares, int width, Real* sums)
{
  for (int j = 0; j < 4; ++j) {
    std::array<std::array<Pack, n_stress>, 4> stress;
    for (auto& column : stress) column = zero_packs<n_stress>();
    auto volume = zero_packs<4>();
    for (Index k = 0; k < shares.n; ++k) {
      const auto sigma = load_rows<n_stress>(block, PointRows<2>::sigma, first + k * pack_width);
      for (int i = 0; i < 4; ++i) {
        const Pack share = shares.of[k].up[j] * shares.of[k].across[i];
        volume[i] += share;
        for (int r = 0; r < n_stress; ++r) stress[i][r] = fma(share, sigma[r], stress[i][r]);
      }
    }
    const auto total = sum_each(volume);
    for (int i = 0; i < 4; ++i) {
      Real* slot = sums + (4 * j + i) * width;
      const auto of_rows = sum_each(stress[i]);
      for (int r = 0; r < n_stress; ++r) slot[r] += of_rows[r];
      slot[patch_volume] += total[i];
    }
  }
}

void add_row(const Real* row, const StripShares& shares, int width, Real* sums)
{
  for (int j = 0; j < 4; ++j) {
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
    const PointBlock<2>& block, int inverse_extent, Real cell_size, std::span<const int> others, int width, Real* sums)
{
  std::fill_n(sums, Patch<Quad4>::n_slots * width, 0.0);
  for (Index first = 0; first < block.n_padded(); first += strip_packs * pack_width) {
    StripShares shares;
    shares.n = std::min(strip_packs, (block.n_padded() - first) / pack_width);
    for (Index k = 0; k < shares.n; ++k) {
      const Index p = first + k * pack_width;
      set_shares(block, p, inverse_extent, cell_size, shares.of[k]);
      const Pack volume = Pack::load(block.row(PointRows<2>::volume) + p);
      for (Pack& share : shares.of[k].across) share = share * volume;
    }
    add_stress_and_volume(block, first, shares, width, sums);
    for (std::size_t r = 0; r < others.size(); ++r)
      add_row(block.row(others[r]) + first, shares, width, sums + patch_others + r);
  }
}

void sum_row_over_patch(const PointBlock<2>& block, int row, const PatchSize& size, int width, Real* sums)
{
  auto parts = zero_packs<Patch<Quad4>::n_slots>();
  for (Index p = 0; p < block.n; p += pack_width) {
    PointShares shares;
    set_shares(block, p, size.inverse_extent, size.cell, shares);
    const Pack value = Pack::load(block.row(row) + p) * Pack::load(block.row(PointRows<2>::volume) + p);
    for (int slot = 0; slot < Patch<Quad4>::n_slots; ++slot)
      parts[slot] = fma(value, shares.in_slot(slot), parts[slot]);
  }
  for (int slot = 0; slot < Patch<Quad4>::n_slots; ++slot) sums[slot * width] += sum(parts[slot]);
}

void fold_sums(const BlockPartners& partners, int width, Real* sums)
{
  using P = Patch<Quad4>;
  const auto move = [&](int from, int to, Real part) {
    for (int r = 0; r < width; ++r) sums[to * width + r] += part * sums[from * width + r];
  };
  const auto clear = [&](int slot) { std::fill_n(sums + slot * width, width, 0.0); };
  for (int q = 0; q < Quad4::n_corners; ++q) {
    const int k = P::n_across_sides + q;
    if (partners[k] >= 0) continue;
    const auto [before, after] = P::beside_corner[q];
    const int from = P::outer_slot[k];
    if (partners[before] >= 0 && partners[after] >= 0) {
      move(from, P::outer_slot[before], 0.5);
      move(from, P::outer_slot[after], 0.5);
    } else {
      move(from, P::outer_slot[partners[before] >= 0 ? before : after], 1.0);
    }
    clear(from);
  }
  for (int k = 0; k < P::n_across_sides; ++k) {
    if (partners[k] >= 0) continue;
    move(P::outer_slot[k], P::own_slot[P::own_beside[k]], 1.0);
    clear(P::outer_slot[k]);
  }
}

}  // namespace terp
