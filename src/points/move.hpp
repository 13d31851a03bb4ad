// Points that left their cell: found again, moved to the block of their new cell, and never lost.
#pragma once

#include "mesh/mesh.hpp"
#include "points/point_blocks.hpp"

namespace terp {

/// Moves the point at (block, lane) to the cell that holds its position. A place outside the mesh is put back on the wall it
/// crossed (hazard 5). values: scratch, shape [n_rows]. Returns 1 if the point had to be put back, else 0.
int move_to_new_cell(const Mesh<2>& mesh, PointBlocks<2>& points, Index block, Index lane, std::span<Real> values);

}  // namespace terp
