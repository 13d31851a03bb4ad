// The material points that make the surface of the ground, seen from above.
#pragma once

#include "mpm/points/point_blocks.hpp"

#include <vector>

namespace terp {

struct TopPoint {
  PointPlace place;
  Vec<2> x;   ///< [m]
  Real size;  ///< side of a square of its volume [m]
};

/// The points between two x with nothing above them, sorted by x. A point hides what lies below it: within 0.4 of its
/// size to the left and right, and beyond that, up to 1.5 sizes, what lies steeper than 1.5 : 1 below it.
/// held_row: points with a negative value there are taken for gone; -1: there is no such row.
std::vector<TopPoint> find_top_points(const PointBlocks<2>& points, Real left, Real right, int held_row = -1);

}  // namespace terp
