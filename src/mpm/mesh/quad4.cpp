#include "mpm/mesh/quad4.hpp"

#include <algorithm>
#include <limits>

namespace terp {
namespace {

Vec<2> combine(const Quad4::PerCorner<Vec<2>>& x, const Quad4::PerCorner<Real>& sign)
{
  Vec<2> sum{0.0, 0.0};
  for (int i = 0; i < Quad4::n_corners; ++i)
    for (int d = 0; d < Quad4::dim; ++d) sum[d] += 0.25 * sign[i] * x[i][d];
  return sum;
}

}  // namespace

Quad4::Map Quad4::make_map(const PerCorner<Vec<2>>& corners)
{
  Map map;
  map.axis_xi = combine(corners, {-1, 1, 1, -1});
  map.axis_eta = combine(corners, {-1, -1, 1, 1});
  map.twist = combine(corners, {1, -1, 1, -1});
  const Real size = std::hypot(map.axis_xi[0], map.axis_xi[1]) + std::hypot(map.axis_eta[0], map.axis_eta[1]);
  map.affine = std::hypot(map.twist[0], map.twist[1]) <= 1e-13 * size;  // below: round-off of equal corners
  if (map.affine) map.twist = {0.0, 0.0};
  return map;
}

Real Quad4::smallest_altitude(const PerCorner<Vec<2>>& corners)
{
  Real smallest = std::numeric_limits<Real>::infinity();
  for (int side = 0; side < n_sides; ++side) {
    const Vec<2>&a = corners[sides[side].corners[0]], &b = corners[sides[side].corners[1]];
    const Real length = std::hypot(b[0] - a[0], b[1] - a[1]);
    for (const int other : sides[(side + 2) % n_sides].corners) {
      const Real area = (b[0] - a[0]) * (corners[other][1] - a[1]) - (b[1] - a[1]) * (corners[other][0] - a[0]);
      smallest = std::min(smallest, area / length);
    }
  }
  return smallest;
}

}  // namespace terp
