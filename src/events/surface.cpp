#include "events/surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terp {

namespace {

using Rows = PointRows<2>;

/// Smallest and largest value of a row over the points of a block; of a value that is not a number nothing, but of the first.
std::array<Real, 2> range_of(const PointBlock<2>& block, int row)
{
  const Real* values = block.row(row);
  const Pack first(values[0]);
  Pack low = first, high = first;
  for (Index p = 0; p < block.n; p += pack_width) {
    const Pack value = select(lane_numbers() < Pack(static_cast<Real>(block.n - p)), Pack::load(values + p), first);
    low = min(value, low);
    high = max(value, high);
  }
  std::array<Real, 2> range{low[0], high[0]};
  for (int k = 1; k < pack_width; ++k) range = {std::min(range[0], low[k]), std::max(range[1], high[k])};
  return range;
}

/// Column of a place: less than 0 or at least n if it lies beside them; not a number stays so.
Real column_at(const Columns& columns, Real x) { return (x - columns.left) / columns.width; }

/// True if no point of a block is higher than the columns around it already are.
bool lies_below(const PointBlock<2>& block, const Columns& columns, const std::vector<Real>& heights)
{
  const auto x = range_of(block, Rows::x), y = range_of(block, Rows::x + 1);
  const Real first = column_at(columns, x[0]), last = column_at(columns, x[1]);
  if (!(first >= 0.0 && last < columns.n)) return false;
  for (auto c = static_cast<Index>(first); c <= static_cast<Index>(last); ++c)
    if (!(y[1] <= heights[c])) return false;
  return true;
}

}  // namespace

std::vector<Real> surface_heights(const PointBlocks<2>& points, const Columns& columns)
{
  std::vector<Real> heights(columns.n, -std::numeric_limits<Real>::infinity());
  const auto enter = [&](const PointBlock<2>& block, Index) {
    if (block.n == 0 || lies_below(block, columns, heights)) return;
    for (Index lane = 0; lane < block.n; ++lane) {
      const Real place = column_at(columns, block.row(Rows::x)[lane]);
      if (!(place >= 0.0 && place < columns.n)) continue;
      Real& height = heights[static_cast<Index>(place)];
      height = std::max(height, block.row(Rows::x + 1)[lane]);
    }
  };
  const auto& cells = points.occupied();
  std::for_each(cells.rbegin(), cells.rend(), [&](Index cell) { for_each_block(points, cell, enter); });  // a grid's highest come last
  return heights;
}

std::array<Real, 2> extent_in_x(const PointBlocks<2>& points)
{
  if (points.n_points() == 0) return {std::nan(""), std::nan("")};
  std::array<Real, 2> extent{std::numeric_limits<Real>::infinity(), -std::numeric_limits<Real>::infinity()};
  for_each_block(points, [&](const PointBlock<2>& block) {
    if (block.n == 0) return;
    const auto x = range_of(block, Rows::x);
    extent = {std::min(extent[0], x[0]), std::max(extent[1], x[1])};
  });
  return extent;
}

Real lowest(const PointBlocks<2>& points)
{
  Real y = std::numeric_limits<Real>::infinity();
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) { y = std::min(y, block.row(PointRows<2>::x + 1)[lane]); });
  return y;
}

}  // namespace terp
