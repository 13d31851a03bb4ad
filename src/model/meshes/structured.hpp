// Structured meshes beside the regular rectangle: graded, and mapped through four sides.
#pragma once

#include "mpm/mesh/mesh.hpp"

namespace terp {

/// Shares of a length at the n + 1 nodes of n cells that grow by a constant ratio; grading: last cell over first. From
/// 0 to 1, exact ends.
std::vector<Real> graded_shares(Index n, Real grading);

/// Rectangle whose cells grow geometrically; grading: last cell over first in x and y. Sides "left", "right", "bottom",
/// "top". Sizes, numbers of cells and grading are positive.
Mesh<2> make_graded_rectangle(Vec<2> origin, Vec<2> size, std::array<Index, 2> n, Vec<2> grading);

/// Transfinite interpolation through four polylines [m]: bottom, right, top, left; bottom and top run to +x, left and
/// right to +y, and they meet. Nodes on the sides are shares of arc length. A sheared or sloped grid comes out exact.
/// Sides "left", "right", "bottom", "top". The cells are not checked: see check_mesh().
Mesh<2> make_mapped_rectangle(const std::array<std::vector<Vec<2>>, 4>& sides, std::array<Index, 2> n, Vec<2> grading);

}  // namespace terp
