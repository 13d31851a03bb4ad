// Shares a convex quadrilateral out between bodies that lie on top of each other: areas and centroids of the parts,
// exact to round-off.
//
// The quadrilateral is cut into horizontal strips at every corner and every crossing of lines. In a strip no line
// begins, ends or crosses another, so the lines, sorted by x, part it into trapezoids, and each trapezoid lies in one
// topmost body or in none. Nothing is built that could be inconsistent, the trapezoids always fill the quadrilateral,
// and lines that coincide but for round-off give trapezoids of no area. Decision 0026. Not for: the lattice of points
// (cut_cell.hpp).
#pragma once

#include "model/bodies/body_outline.hpp"

namespace terp {

/// A closed line that may run through a cell, relative to the cell's centre [m].
struct Ring {
  Polygon corners;
  Index body;
  bool is_hole;
};

/// The bodies that matter in one cell.
struct Overlay {
  Index ground = -1;        ///< fills the whole cell beneath the rings; -1: nothing does
  std::vector<Ring> rings;  ///< by body, ascending, all above the ground; the holes of a body after its polygon
};

/// A part of a quadrilateral that belongs to one body.
struct Part {
  Index body;
  Real area;        ///< [m^2]
  Vec<2> centroid;  ///< in the part [m]
};

/// The topmost body at a place, or -1.
Index top_body(const Overlay& overlay, Vec<2> x);

/// True if the straight way from a to b stays in the body.
bool stays_in_body(const Overlay& overlay, Index body, Vec<2> a, Vec<2> b);

/// The parts of a convex quadrilateral, from bottom to top, then left to right. A part is connected and holds its
/// centroid: one that would not, such as a bent sliver, comes as several.
std::vector<Part> share_out(const Overlay& overlay, const std::array<Vec<2>, 4>& corners);

}  // namespace terp
