// What [flood] says: the water that the ground shall hold back. Not for: how it is judged (followers/flood.cpp).
#pragma once

#include "base/types.hpp"

#include <limits>

namespace terp {

/// The end of the section at which the river is.
enum class RiverSide { deduced, left, right };

struct FloodCase {
  bool given = false;                                         ///< the case has [flood]
  Real water_level = std::numeric_limits<Real>::quiet_NaN();  ///< [m]; NaN: not given
  Real smallest_freeboard = 0.0;                              ///< height over the water level that must remain [m]
  Real smallest_width = 0.0;  ///< width of the ground at the water level that must remain [m]
  Real intact_below = 0.01;   ///< eps_eq_p below which soil counts as intact [-]
  RiverSide river = RiverSide::deduced;

  bool asks() const { return given || water_level == water_level; }
};

}  // namespace terp
