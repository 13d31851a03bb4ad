// Points that left their cell: found again, moved to the block of their new cell, and never lost.
#pragma once

#include "mpm/mesh/mesh.hpp"
#include "mpm/points/point_blocks.hpp"

namespace terp {

/// What became of a point that left its cell.
enum class Moved {
  inside,    ///< it is in its new cell
  put_back,  ///< it was outside the mesh and is back on the wall that it crossed
  left,      ///< it crossed an open side and is no longer among the points
};

/// Sides of each cell that soil may leave by: bit s of entry e is set if side s of cell e is open, shape [n_cells].
using OpenSides = std::vector<std::uint8_t>;

/// Moves the point at (block, lane) to the cell that holds its position. values: shape [n_rows]; scratch, but its id
/// row is always the point's, and all rows are if it left.
Moved move_to_new_cell(
    const Mesh<2>& mesh, const OpenSides& open, PointBlocks<2>& points, PointPlace at, std::span<Real> values);

}  // namespace terp
