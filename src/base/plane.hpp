// Lines between places of the plane.
#pragma once

#include "base/types.hpp"

#include <cmath>

namespace terp {

/// The place at the share t of the way from a to b.
inline Vec<2> between(Vec<2> a, Vec<2> b, Real t) { return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])}; }

inline Real distance(Vec<2> a, Vec<2> b) { return std::hypot(b[0] - a[0], b[1] - a[1]); }

/// Twice the area of the triangle a, b, c; positive where c lies left of the way from a to b.
inline Real cross(Vec<2> a, Vec<2> b, Vec<2> c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

}  // namespace terp
