// What [flood] says: the water that the ground shall hold back. Not for: how it is judged (followers/flood.cpp).
#pragma once

#include "base/types.hpp"

#include <cmath>
#include <limits>

namespace terp {

/// The end of the section at which the river is.
enum class RiverSide { deduced, left, right };

struct FloodCase {
  Real water_level = std::numeric_limits<Real>::quiet_NaN();  ///< [m]; NaN: not given
  Real smallest_freeboard = 0.0;                              ///< height over the water level that must remain [m]
  Real smallest_width = 0.0;  ///< width of the ground at the water level that must remain [m]
  Real intact_below = 0.01;   ///< eps_eq_p below which soil counts as intact [-]
  RiverSide river = RiverSide::deduced;
};

/// The level that the ground is judged against [m]; NaN: none, and nothing is judged. The one place where a default
/// can stand.
inline Real flood_level(const FloodCase& flood) { return flood.water_level; }

}  // namespace terp
