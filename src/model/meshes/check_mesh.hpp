// Refuses a mesh on which the method would not work: an inverted cell, and every fault that loses a point or a force.
// Not for: the quality of a usable mesh (mesh_quality.hpp), or faults of a file (gmsh_file.hpp).
#pragma once

#include "model/meshes/mesh_error.hpp"

namespace terp {

/// Fraction of a length, or sine of an angle, below which a cell counts as degenerate, and two positions as one.
inline constexpr Real degenerate_share = 1e-6;

/// Corner by corner: detJ, and detJ over the lengths of the two sides (the sine of the angle).
struct CornerShape {
  std::array<Real, 4> det, sine;
  Real longest = 0.0;  ///< of the sides [m]
  bool side_without_length = false;
};
CornerShape shape_of_corners(const std::array<Vec<2>, 4>& x);

/// Needs nodes and cells only, so it may be called before connect(). Throws MeshError with cells, nodes, coordinates
/// and advice for: a cell that is inverted, crossed, not convex or degenerate (detJ > 0 at all four corners), or exists
/// twice; a side of more than two cells; cells that overlap; a node inside another cell's side (hanging); two nodes at
/// one position. A mesh of several parts passes: see MeshQuality::n_parts.
void check_mesh(const Mesh<2>& mesh);

}  // namespace terp
