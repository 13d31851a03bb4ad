// How much too large the cells make a factor of safety: from searches on several sizes, or from what meshes of known
// slopes gave. Measurements: docs/stability.md.
#pragma once

#include "math/types.hpp"

#include <limits>
#include <vector>

namespace terp {

struct SizedFactor {
  Real cell = 0.0;                       ///< [m]
  Real factor = 0.0, uncertainty = 0.0;  ///< [-]
  /// The least that failed or, where none did, the largest that crept; NaN: not known [-].
  Real highest = std::numeric_limits<Real>::quiet_NaN();
  Real cells_over_depth = std::numeric_limits<Real>::infinity();  ///< of what moves [-]
};

/// The factor in the limit of small cells.
struct FactorLimit {
  Real factor = 0.0, low = 0.0, high = 0.0;                   ///< [-]
  Real order = 0.0;                                           ///< in the size of the cells [-]
  bool order_is_observed = false;                             ///< on three sizes; else that of known slopes
  Real order_found = std::numeric_limits<Real>::quiet_NaN();  ///< on three sizes, usable or not; NaN: none
  bool is_extrapolated = true;  ///< else finer cells gave no less, and it is the lowest of both sizes
};

/// Orders that known slopes have: the usual one, and their range.
inline constexpr Real usual_order = 1.0, lowest_order = 0.6, highest_order = 1.4;

/// From the two finest sizes, by the order of known slopes or, with three, by their own where it is between 1/2 and 2.
/// The range has that of the order and the uncertainties of the factors, and ends where the finest cells failed. Finer
/// cells that give more are no error of the mesh: then the lower of both counts. sizes: two or more, different, any
/// order.
FactorLimit extrapolate_factor(std::vector<SizedFactor> sizes);

/// Fewer cells over the depth of what moves give a bound, no factor.
inline constexpr Real fewest_cells = 5.0;

/// Largest relative error on slopes of other authors with so many cells over the depth of what moves: the least is
/// about 0 [-].
Real largest_mesh_error(Real cells_over_depth);

}  // namespace terp
