#include "events/surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terp {

std::vector<Real> surface_heights(const PointBlocks<2>& points, const Columns& columns)
{
  std::vector<Real> heights(columns.n, -std::numeric_limits<Real>::infinity());
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) {
    const Real place = (block.row(PointRows<2>::x)[lane] - columns.left) / columns.width;
    if (!(place >= 0.0 && place < columns.n)) return;
    Real& height = heights[static_cast<Index>(place)];
    height = std::max(height, block.row(PointRows<2>::x + 1)[lane]);
  });
  return heights;
}

Real front(const PointBlocks<2>& points)
{
  Real x = points.n_points() > 0 ? -std::numeric_limits<Real>::infinity() : std::numeric_limits<Real>::quiet_NaN();
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) { x = std::max(x, block.row(PointRows<2>::x)[lane]); });
  return x;
}

Real lowest(const PointBlocks<2>& points)
{
  Real y = std::numeric_limits<Real>::infinity();
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) { y = std::min(y, block.row(PointRows<2>::x + 1)[lane]); });
  return y;
}

}  // namespace terp
