// Forces beside gravity and Eq. (4) that enter at the corners of cells: loads, water, the slope of the pressure within
// the cells (mpm/features/pressure_balance.hpp). Each kind has a work of its own in the ledger. A new kind is a word
// here, what fills its corners in each step (features), and its work in `balance` (ledger.cpp).
#pragma once

#include "mpm/kernels/cell_sums.hpp"

#include <array>
#include <vector>

namespace terp {

/// Those of the world around the soil, then those of the method.
enum OuterKind { outer_load, outer_water, n_kinds_around, outer_balance = n_kinds_around, n_outer_kinds };

/// Of one kind, in one step.
struct OuterForces {
  bool acts = false;
  std::vector<CornerVectors<Quad4>> corners;  ///< of each occupied cell [N per m], shape [n_occupied]; empty: none
  std::vector<Vec<2>> node;                   ///< its sums [N per m], shape [n_nodes]
};

/// Work of each kind [J per m].
using OuterWork = std::array<Real, n_outer_kinds>;

}  // namespace terp
