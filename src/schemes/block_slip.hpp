// What the soil of one block of a cut cell slips against the rest of its cell: scratch of one step.
// Not for: what is done with it (cut_cells.hpp).
#pragma once

#include "base/tensor.hpp"
#include "base/types.hpp"

namespace terp {

/// The strain of a slip g is g (t n + n t)/2, with n across the border and t along it: g = held + rate * d_gamma, where
/// d_gamma = 2 t.d_eps.n is the shear of the whole cell.
struct BlockSlip {
  Real weight = 0.0;               ///< volume that the block counts with [m^2]
  SymTensor<Real, 2> sigma = {};   ///< its mean stress, with the pressure of Eq. (2) [Pa]
  Real normal = 0.0, shear = 0.0;  ///< xx = -yy and xy of (t n + n t)/2; both zero: the block does not slip
  Real held = 0.0, rate = 0.0;     ///< [-]

  bool acts() const { return normal != 0.0 || shear != 0.0; }
};

}  // namespace terp
