// Plane polygons: the outlines of bodies.
#pragma once

#include "base/types.hpp"

#include <span>
#include <vector>

namespace terp {

using Polygon = std::vector<Vec<2>>;  ///< corners in order, either way round; closes itself

/// Even-odd rule; places on the outline belong to one side or the other.
bool contains(std::span<const Vec<2>> polygon, Vec<2> x);

/// Heights at which the vertical line through x crosses the outline [m], ascending.
std::vector<Real> crossings_of_vertical(std::span<const Vec<2>> polygon, Real x);

/// Area, positive when the corners run counter-clockwise [m^2].
Real signed_area(std::span<const Vec<2>> polygon);

}  // namespace terp
