// How much of its permeability a soil has above the water, and how much of its pores is full.
#pragma once

#include "math/types.hpp"

namespace terp {

/// Over a band of pressure heads whose middle is p = 0, so that what the fringe adds above the surface it lacks below.
struct SuctionBand {
  Real width = 1.0;  ///< [m]

  static constexpr Real least = 1e-3;  ///< relative permeability of dry soil [-]

  /// 0 dry, 1 full. psi: pressure head [m].
  Real saturation(Real psi) const
  {
    const Real s = 0.5 + psi / width;
    return s < 0.0 ? 0.0 : s > 1.0 ? 1.0 : s;
  }
  Real saturation_slope(Real psi) const
  {
    const Real s = 0.5 + psi / width;
    return s > 0.0 && s < 1.0 ? 1.0 / width : 0.0;
  }
  /// Of the saturated permeability.
  Real relative_permeability(Real psi) const
  {
    const Real s = saturation(psi);
    return least + (1.0 - least) * s * s * (3.0 - 2.0 * s);
  }
};

}  // namespace terp
