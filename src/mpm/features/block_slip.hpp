// What the soil of one block of a cut cell slips against the rest of its cell: scratch of one step.
// Not for: what is done with it (cut_cells.hpp).
#pragma once

#include "math/tensor.hpp"
#include "math/types.hpp"

#include <array>

namespace terp {

/// Where the border lies in a cut cell, and how far its soils slipped past each other as one of them yielded.
struct Kink {
  Vec<2> along{0.0, 0.0};       ///< t
  std::array<Real, 4> above{};  ///< distance of the corners to the border, 0 on the side of soil b [m]
  Real share = 0.0;             ///< of soil a in the volume of both
  Real slipped = 0.0;           ///< shear strain that soil a left when it yielded; 0: the cell has no kink [-]
  Real force = 0.0;             ///< sum of above times the internal force along t of the corners [N]
};

/// The strain of a slip g is g (t n + n t)/2, with n across the border and t along it.
struct BlockSlip {
  Real weight = 0.0;               ///< volume that the block counts with [m^2]
  SymTensor<Real, 2> sigma = {};   ///< its mean stress, with the pressure of Eq. (2) [Pa]
  Real normal = 0.0, shear = 0.0;  ///< xx = -yy and xy of (t n + n t)/2; both zero: the block does not slip
  Real g = 0.0;                    ///< [-]
  Real before = 0.0;               ///< mean t.sigma.n of its points before the update of the law [Pa]
  Kink kink = {};                  ///< of the cell, at its first block

  bool acts() const { return normal != 0.0 || shear != 0.0; }
};

}  // namespace terp
