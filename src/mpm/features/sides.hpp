// The sides of the mesh in a step. Every model that makes steps has them. Not for: what a side does (conditions.hpp).
#pragma once

#include "mpm/features/conditions.hpp"
#include "mpm/points/move.hpp"

namespace terp {

struct SidesModel {
  Boundary boundary;
  OpenSides open;  ///< sides that soil may leave by, shape [n_cells]
};

}  // namespace terp
