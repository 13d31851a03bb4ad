// What water that follows the soil starts from: the ground and the water as they are drawn, by columns.
// Not for: what soil that has moved makes of it (carried_water.hpp).
#pragma once

#include "mpm/points/surface.hpp"

#include <vector>

namespace terp {

struct DrawnWater {
  Columns columns;                             ///< of the width of a typical cell, over the whole mesh
  std::vector<Real> ground = {};               ///< in the middle of each [m]; without soil the lowest place of the mesh
  std::vector<std::vector<Real>> levels = {};  ///< by situation: to which the water at the ground rises, by column [m]
};

}  // namespace terp
