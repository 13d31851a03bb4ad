// What a body fills: a polygon with holes, or whole cells of the mesh.
// Not for: the points in it (seed.hpp).
#pragma once

#include "mpm/mesh/mesh.hpp"
#include "model/bodies/polygon.hpp"

#include <string>

namespace terp {

/// What to fill with points. Either a polygon or cells.
struct BodyOutline {
  Polygon polygon;                       ///< [m]
  std::array<Index, 2> points_per_cell;  ///< along xi and eta
  std::vector<Polygon> holes = {};       ///< in the polygon, apart from each other [m]
  std::vector<Index> cells = {};         ///< not empty: the body is these cells, and has no polygon
};

/// Inside the polygon and in none of its holes. A body of cells has no polygon and covers no place in this sense.
bool covers(const BodyOutline& body, Vec<2> x);

/// A straight part of an outline [m].
struct Side {
  Vec<2> a, b;
};

/// The sides of polygon and holes, or those of the cells that have no other cell of the body behind them; in no order.
/// A place is in the body if a line from it to far away crosses an odd number of them.
std::vector<Side> outline_sides(const Mesh<2>& mesh, const BodyOutline& body);

/// Height of a side, or of the line through it, at x [m].
inline Real height_at(const Side& s, Real x) { return s.a[1] + (s.b[1] - s.a[1]) * (x - s.a[0]) / (s.b[0] - s.a[0]); }

/// Heights at which the vertical line through x crosses the sides [m], ascending.
std::vector<Real> crossings_of_vertical(std::span<const Side> sides, Real x);

/// Whether a place lies within these sides of a body.
bool encloses(std::span<const Side> sides, Vec<2> x);

/// Area of the polygon less that of its holes [m^2].
Real area(const BodyOutline& body);

/// What makes the outline no body, one text each with coordinates: too few corners, no area, sides that cross, holes
/// outside the polygon or in each other. Empty: all is well. A polygon may touch itself, and may repeat a corner.
std::vector<std::string> check_outline(const BodyOutline& body);

}  // namespace terp
