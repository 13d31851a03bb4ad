// Plane polygons: what outlines of bodies are made of.
// Not for: bodies with holes (body_outline.hpp), sharing a cell between bodies (overlay.hpp).
#pragma once

#include "mpm/mesh/box_grid.hpp"

#include <vector>

namespace terp {

using Polygon = std::vector<Vec<2>>;  ///< corners in order, either way round; closes itself

/// Even-odd rule; places on the outline belong to one side or the other.
bool contains(std::span<const Vec<2>> polygon, Vec<2> x);

/// Area, positive when the corners run counter-clockwise [m^2].
Real signed_area(std::span<const Vec<2>> polygon);

/// True if closed boxes share a place.
bool overlap(const BoundingBox& a, const BoundingBox& b);

/// True if the line from a to b and the closed box share a place, or nearly do.
bool crosses(const BoundingBox& box, Vec<2> a, Vec<2> b);

/// The part of a polygon in a box. Where the polygon leaves the box it is closed along the box, there and back again if
/// need be: areas and the even-odd rule inside the box are those of the polygon.
Polygon clip_to_box(std::span<const Vec<2>> polygon, const BoundingBox& box);

}  // namespace terp
