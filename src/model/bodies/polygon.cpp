// Each side counts its lower end and not its upper one, so that a ray through a corner is counted once; clipping takes
// places on a limit for inside. Neither uses a tolerance. Only `crosses` errs to the safe side, since it decides where
// an exact look is needed.

#include "model/bodies/polygon.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

/// Keeps what lies on one side of the line x[d] = limit: below it (sign = 1) or above it (sign = -1).
void clip(Polygon& polygon, int d, Real limit, Real sign, Polygon& clipped)
{
  clipped.clear();
  const auto beyond = [&](const Vec<2>& x) { return sign * (x[d] - limit) > 0.0; };
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec<2>&a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if (!beyond(a)) clipped.push_back(a);
    if (beyond(a) == beyond(b)) continue;
    Vec<2> x;
    x[d] = limit;
    x[1 - d] = a[1 - d] + (b[1 - d] - a[1 - d]) * ((limit - a[d]) / (b[d] - a[d]));
    clipped.push_back(x);
  }
  polygon.swap(clipped);
}

}  // namespace

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

Real signed_area(std::span<const Vec<2>> polygon)
{
  Real twice = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec<2>&a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    twice += a[0] * b[1] - b[0] * a[1];
  }
  return 0.5 * twice;
}

bool overlap(const BoundingBox& a, const BoundingBox& b)
{
  return a.low[0] <= b.high[0] && b.low[0] <= a.high[0] && a.low[1] <= b.high[1] && b.low[1] <= a.high[1];
}

bool crosses(const BoundingBox& box, Vec<2> a, Vec<2> b)
{
  if (std::max(a[0], b[0]) < box.low[0] || std::min(a[0], b[0]) > box.high[0]) return false;
  if (std::max(a[1], b[1]) < box.low[1] || std::min(a[1], b[1]) > box.high[1]) return false;
  const Vec<2> along{b[0] - a[0], b[1] - a[1]};
  const Vec<2> to_centre{0.5 * (box.low[0] + box.high[0]) - a[0], 0.5 * (box.low[1] + box.high[1]) - a[1]};
  const Real reach = std::abs(along[1]) * (box.high[0] - box.low[0]) + std::abs(along[0]) * (box.high[1] - box.low[1]);
  return 2.0 * std::abs(to_centre[0] * along[1] - to_centre[1] * along[0]) <=
         (1.0 + 1e-9) * reach;  // touching counts, in spite of round-off
}

Polygon clip_to_box(std::span<const Vec<2>> polygon, const BoundingBox& box)
{
  Polygon kept(polygon.begin(), polygon.end()), scratch;
  for (int d = 0; d < 2; ++d) {
    clip(kept, d, box.high[d], 1.0, scratch);
    clip(kept, d, box.low[d], -1.0, scratch);
  }
  return kept;
}

}  // namespace terp
