// The surface of the ground as the material points draw it: the highest point in each column of one cell's width.
#pragma once

#include "mpm/points/ground.hpp"
#include "mpm/mesh/mesh.hpp"
#include <vector>

namespace terp {

/// Columns of equal width side by side.
struct Columns {
  Real left = 0.0;   ///< left edge of the first column [m]
  Real width = 0.0;  ///< [m]
  Index n = 0;
  Real right() const { return left + width * n; }  ///< right edge of the last column [m]
};

/// Height of the highest point in each column [m], shape [n]; minus infinity where a column holds no point. Looks only
/// into cells that reach above what was found so far, the last cells first.
std::vector<Real> surface_heights(
    const Mesh<2>& mesh, const PointBlocks<2>& points, const Columns& columns, Ground ground = {});

/// Smallest and largest x of the ground [m]; NaN if there is none.
std::array<Real, 2> extent_in_x(const Mesh<2>& mesh, const PointBlocks<2>& points, Ground ground = {});

/// Smallest y of the ground [m].
Real lowest(const PointBlocks<2>& points, Ground ground = {});

}  // namespace terp
