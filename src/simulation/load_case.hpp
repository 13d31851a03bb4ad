// A [[load]] as the case file has it.
#pragma once

#include "base/types.hpp"

#include <limits>
#include <string>

namespace terp {

/// A vertical pressure on a stretch of the surface of the soil.
struct LoadCase {
  std::string name = "load";
  Real from = 0.0, to = 0.0;                            ///< x of the ends of the stretch where the load begins [m]
  Real pressure = 0.0;                                  ///< force per width, down positive [Pa]
  Real start = -std::numeric_limits<Real>::infinity();  ///< [s]; -infinity: it was always there
  Real end = std::numeric_limits<Real>::infinity();     ///< [s]; infinity: it stays
  Real ramp = 0.0;  ///< time over which it grows from `start` on, and falls from `end` on [s]
};

}  // namespace terp
