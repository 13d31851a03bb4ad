// What blocks leave for the cells around them, with shares that overlap: scratch of one step.
// Not for: what is done with it (patch_group.hpp).
#pragma once

#include "mpm/mesh/patch.hpp"
#include "math/pack.hpp"
#include "mpm/kernels/overlap.hpp"

namespace terp {

/// Rows of a patch stand side by side for each slot, eight to a pack. `width` is the number of Reals in a slot.
struct PatchValues {
  PatchPartners cells;                  ///< of the mesh
  std::vector<BlockPartners> partners;  ///< by block; empty: to be found
  std::vector<Real> taken;              ///< by block: part of their shares that partners leave in it (taken_by)
  std::vector<std::uint8_t> folds;      ///< by block: what it leaves elsewhere goes back in part, see Folds
  std::vector<Pack> sums, gauss;
  enum Folds : std::uint8_t { lacks_partner = 1, has_small_partner = 2 };
  int sum_width = 0, gauss_width = 0;  ///< Reals of one slot, of one Gauss point
  int excess_place = 0;                ///< of the excess pressure among the sums

  /// Room for n blocks whose partners are still to be found.
  void start_blocks(Index n)
  {
    partners.resize(n);
    taken.assign(n, 1.0);
    folds.assign(n, 0);
  }
  /// Of the outer sub-cells of block b.
  TakenShares taken_shares(Index b) const
  {
    TakenShares shares;
    shares.fill(1.0);
    if (folds[b] == 0) return shares;
    for (int k = 0; k < Patch<Quad4>::n_outer; ++k)
      shares[k] = partners[b][k] < 0 ? 0.0 : taken[partners[b][k] / Patch<Quad4>::n_slots];
    return shares;
  }
  /// Marks the blocks whose partners do not take all; `taken` is that of this step.
  void mark_small_partners()
  {
    for (std::uint8_t& of_block : folds) of_block &= lacks_partner;
    for (std::size_t b = 0; b < taken.size(); ++b)
      if (taken[b] < 1.0)
        for (const Index partner : partners[b])
          if (partner >= 0) folds[partner / Patch<Quad4>::n_slots] |= has_small_partner;
  }

  /// Over the patch of block b, shape [n_slots][sum_width].
  Real* sums_of(Index b)
  {
    return reinterpret_cast<Real*>(sums.data()) + std::ptrdiff_t{b} * Patch<Quad4>::n_slots * sum_width;
  }
  /// At its Gauss points, shape [n_gauss][gauss_width].
  Real* gauss_of(Index b)
  {
    return reinterpret_cast<Real*>(gauss.data()) + std::ptrdiff_t{b} * Quad4::n_gauss * gauss_width;
  }
};

}  // namespace terp
