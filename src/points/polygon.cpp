#include "points/polygon.hpp"

#include <algorithm>

namespace terp {

bool contains(std::span<const Vec<2>> polygon, Vec<2> x)
{
  bool inside = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec<2>&a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if ((a[1] > x[1]) == (b[1] > x[1])) continue;
    if (x[0] < a[0] + (b[0] - a[0]) * (x[1] - a[1]) / (b[1] - a[1])) inside = !inside;
  }
  return inside;
}

std::vector<Real> crossings_of_vertical(std::span<const Vec<2>> polygon, Real x)
{
  std::vector<Real> heights;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec<2>&a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if ((a[0] > x) == (b[0] > x)) continue;
    heights.push_back(a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]));
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

Real signed_area(std::span<const Vec<2>> polygon)
{
  Real twice = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec<2>&a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    twice += a[0] * b[1] - b[0] * a[1];
  }
  return 0.5 * twice;
}

}  // namespace terp
