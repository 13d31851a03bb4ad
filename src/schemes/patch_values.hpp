// What blocks leave for the cells around them, with shares that overlap: scratch of one step.
// Not for: what is done with it (patch_group.hpp).
#pragma once

#include "mesh/patch.hpp"
#include "parallel/pack.hpp"

namespace terp {

/// Rows of a patch stand side by side for each slot, eight to a pack. `width` is the number of Reals in a slot.
struct PatchValues {
  PatchPartners cells;                  ///< of the mesh
  std::vector<BlockPartners> partners;  ///< by block; empty: to be found
  std::vector<Pack> sums, gauss;
  int sum_width = 0, gauss_width = 0;  ///< Reals of one slot, of one Gauss point
  int excess_place = 0;                ///< of the excess pressure among the sums

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
