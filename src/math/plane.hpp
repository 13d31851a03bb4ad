// Vectors of the plane, and lines between its places.
#pragma once

#include "math/types.hpp"

#include <cmath>

namespace terp {

/// The place at the share t of the way from a to b.
inline Vec<2> between(Vec<2> a, Vec<2> b, Real t) { return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])}; }

inline Vec<2> between(Vec<2> from, Vec<2> to) { return {to[0] - from[0], to[1] - from[1]}; }
inline Real dot(Vec<2> a, Vec<2> b) { return a[0] * b[0] + a[1] * b[1]; }
inline Real cross(Vec<2> a, Vec<2> b) { return a[0] * b[1] - a[1] * b[0]; }
inline Real length(Vec<2> a) { return std::hypot(a[0], a[1]); }

inline Real distance(Vec<2> a, Vec<2> b) { return std::hypot(b[0] - a[0], b[1] - a[1]); }

/// Twice the area of the triangle a, b, c; positive where c lies left of the way from a to b.
inline Real cross(Vec<2> a, Vec<2> b, Vec<2> c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Where the lines a-b and c-d cross, both in their interiors.
inline bool lines_cross(Vec<2> a, Vec<2> b, Vec<2> c, Vec<2> d, Vec<2>& x)
{
  const Real at_a = cross(c, d, a), at_b = cross(c, d, b), at_c = cross(a, b, c), at_d = cross(a, b, d);
  if (!(at_a * at_b < 0.0 && at_c * at_d < 0.0)) return false;
  x = between(a, b, at_a / (at_a - at_b));
  return true;
}

}  // namespace terp
