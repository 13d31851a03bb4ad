// Where two soils of a cell have their border, from the points around it (docs/methods.md, section 3; decision 0071).
// Not for: how far they slip along it (cut_cells.hpp).
#pragma once

#include "mpm/mesh/mesh.hpp"
#include "mpm/points/point_blocks.hpp"
#include "math/lanes.hpp"

#include <array>

namespace terp {

/// How two soils of a cell lie to each other.
struct Border {
  Vec<2> across{0.0, 0.0};  ///< n, towards the first; zero: their points show none
  int band = -1;            ///< 0, 1: this one lies as a band within the other; -1: there is one plane between them
  Real height = 0.0;        ///< of the middle of the band along n, from the centre of the cell [m]
};

/// The border of two materials in a cell, from the points of both around its centre.
Border find_border(const Mesh<2>& mesh, const PointBlocks<2>& points, Index cell, std::array<Index, 2> materials);

/// Distance of the corners of a cell to the line across n above which the cell has this share of its area [m]; 0 below.
std::array<Real, 4> above_border(const Mesh<2>& mesh, Index cell, Vec<2> n, Real share);

/// How much of the distance along n from the lowest corner lies in the first soil, which has this share of the area of
/// the cell [m]: what the corners move when it alone is sheared. With one plane: above_border().
std::array<Real, 4> within_soil(const Mesh<2>& mesh, Index cell, const Border& border, Real share);

}  // namespace terp
