// Straight lines between given places.
#pragma once

#include "math/types.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace terp {

/// y at x on a line through places (x, y), x ascending, at least one; constant beyond both ends. Where two places have
/// one x: that of the second from there on.
inline Real interpolate(std::span<const Vec<2>> line, Real x)
{
  const auto after = std::ranges::find_if(line, [x](const Vec<2>& place) { return place[0] > x; });
  if (after == line.begin()) return (*after)[1];
  const Vec<2>& a = *(after - 1);
  if (after == line.end()) return a[1];
  return std::lerp(a[1], (*after)[1], (x - a[0]) / ((*after)[0] - a[0]));
}

}  // namespace terp
