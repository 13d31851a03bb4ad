// Refuses a mesh on which the method would not work: a cell turned inside out, and every fault that loses a point or a
// force. Not for: how good a mesh is that does work (mesh_quality.hpp), or what is wrong with a file (gmsh_file.hpp).
#pragma once

#include "mesh/mesh_error.hpp"

namespace terp {

/// Part of a length, or sine of an angle, below which a cell has no size to speak of, and two places are one.
inline constexpr Real degenerate_share = 1e-6;

/// Needs nodes and cells only, so it may come before connect(). Throws MeshError with cells, nodes, coordinates and
/// advice for: a cell that is inverted, crossed, not convex or degenerate (detJ > 0 at all four corners), or there
/// twice; a side of more than two cells; cells that overlap; a node inside another cell's side (hanging); two nodes at
/// one place. A mesh of several parts passes: see MeshQuality::n_parts.
void check_mesh(const Mesh<2>& mesh);

}  // namespace terp
