#include "run/measure/moved_depth.hpp"

#include <cmath>
#include <limits>

namespace terp {
namespace {

/// Of a place below the surface of its column [m]; infinite beside the columns.
Real depth_at(const Section& first, Real x, Real y)
{
  const Real column = std::floor((x - first.columns.left) / first.columns.width);
  if (!(column >= 0.0 && column < first.columns.n)) return std::numeric_limits<Real>::infinity();
  return first.heights[static_cast<std::size_t>(column)] - y;
}

}  // namespace

MovedByDepth moved_by_depth(const PointBlocks<2>& points, std::span<const Real> x_initial, Real distance,
    const Section& first, Ground ground, Real least_depth)
{
  MovedByDepth moved;
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) {
    if (!is_ground(ground, block)) return;
    const Real* from = &x_initial[2 * static_cast<std::size_t>(block.row(Rows::id)[lane])];
    const Real dx = block.row(Rows::x)[lane] - from[0], dy = block.row(Rows::x + 1)[lane] - from[1];
    if (!(dx * dx + dy * dy > distance * distance)) return;
    const Real volume = block.row(Rows::volume)[lane], depth = depth_at(first, from[0], from[1]);
    if (depth > least_depth)
      (dx < 0.0 ? moved.deep_left : moved.deep_right) += volume;
    else
      moved.ravelled += volume, moved.ravelled_depth = std::max(moved.ravelled_depth, depth);
  });
  return moved;
}

}  // namespace terp
