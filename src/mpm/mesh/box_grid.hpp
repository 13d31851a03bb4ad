// Finds the boxes around a position without testing all of them: equal buckets, each with the boxes that touch it. Not
// for: deciding which cell contains a position (locate.hpp).
#pragma once

#include "math/types.hpp"

#include <span>
#include <vector>

namespace terp {

struct BoundingBox {
  Vec<2> low, high;  ///< [m]
};

/// Smallest box around positions; at least one position.
BoundingBox box_around(std::span<const Vec<2>> places);

/// Distance of x from the straight line between a and b [m].
Real distance_to_line(Vec<2> a, Vec<2> b, Vec<2> x);

/// The box with a margin of `share` of its diagonal on every side.
BoundingBox widened(const BoundingBox& box, Real share);

struct BoxGrid {
  Vec<2> low{0.0, 0.0};                ///< lower left corner of the first bucket [m]
  Vec<2> high{0.0, 0.0};               ///< upper right corner of the last bucket [m]
  Vec<2> buckets_per_metre{0.0, 0.0};  ///< [1/m]
  std::array<Index, 2> n{0, 0};        ///< buckets in x and y
  std::vector<Index> first_of_bucket;  ///< into boxes, shape [n_buckets + 1]
  std::vector<Index> boxes;            ///< ascending within a bucket
};

/// About one bucket for four boxes. Memory stays below 16 entries per box, whatever the sizes of the boxes.
BoxGrid make_box_grid(std::span<const BoundingBox> boxes);

/// Numbers, ascending, of boxes that may contain the position; none that does is left out. Empty for a position that is
/// not finite.
std::span<const Index> boxes_near(const BoxGrid& grid, Vec<2> place);

}  // namespace terp
