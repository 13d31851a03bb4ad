// Cells are visited from the last to the first, as the highest cells of a grid come last. Boxes are widened a little,
// and comparisons are written so that a place that is not a number is looked at: the shortcut never changes the result.

#include "mpm/points/surface.hpp"

#include <algorithm>
#include <limits>

namespace terp {

namespace {

/// The box around a cell, a little wider than its points can lie, whose places are known to round-off.
struct CellBox {
  Vec<2> low, high;
};

CellBox box_of(const Mesh<2>& mesh, Index cell)
{
  constexpr Real margin = 1e-6;  // of its size
  const auto x = mesh.corners(cell);
  CellBox box{x[0], x[0]};
  for (int i = 1; i < 4; ++i)
    for (int d = 0; d < 2; ++d) {
      box.low[d] = std::min(box.low[d], x[i][d]);
      box.high[d] = std::max(box.high[d], x[i][d]);
    }
  for (int d = 0; d < 2; ++d) {
    const Real wide = margin * (box.high[d] - box.low[d]);
    box.low[d] -= wide;
    box.high[d] += wide;
  }
  return box;
}

/// Column of a place: less than 0 or at least n if it lies beside them; not a number stays so.
Real column_at(const Columns& columns, Real x) { return (x - columns.left) / columns.width; }

bool lies_below(const CellBox& box, const Columns& columns, const std::vector<Real>& heights)
{
  const Real first = column_at(columns, box.low[0]), last = column_at(columns, box.high[0]);
  if (!(first >= 0.0 && last < columns.n)) return false;
  for (auto c = static_cast<Index>(first); c <= static_cast<Index>(last); ++c)
    if (!(box.high[1] <= heights[c])) return false;
  return true;
}

}  // namespace

std::vector<Real> surface_heights(
    const Mesh<2>& mesh, const PointBlocks<2>& points, const Columns& columns, Ground ground)
{
  std::vector<Real> heights(columns.n, -std::numeric_limits<Real>::infinity());
  const auto enter = [&](const PointBlock<2>& block, Index) {
    if (!is_ground(ground, block)) return;
    for (Index lane = 0; lane < block.n; ++lane) {
      const Real place = column_at(columns, block.row(Rows::x)[lane]);
      if (!(place >= 0.0 && place < columns.n)) continue;
      Real& height = heights[static_cast<Index>(place)];
      height = std::max(height, block.row(Rows::x + 1)[lane]);
    }
  };
  const auto& cells = points.occupied();
  std::for_each(cells.rbegin(), cells.rend(), [&](Index cell) {
    if (!lies_below(box_of(mesh, cell), columns, heights)) for_each_block(points, cell, enter);
  });
  return heights;
}

std::array<Real, 2> extent_in_x(const Mesh<2>& mesh, const PointBlocks<2>& points, Ground ground)
{
  std::array<Real, 2> extent{std::numeric_limits<Real>::infinity(), -std::numeric_limits<Real>::infinity()};
  const auto enter = [&](const PointBlock<2>& block, Index) {
    if (!is_ground(ground, block)) return;
    for (Index lane = 0; lane < block.n; ++lane) {
      const Real x = block.row(Rows::x)[lane];
      extent = {std::min(extent[0], x), std::max(extent[1], x)};
    }
  };
  for (const Index cell : points.occupied()) {
    const CellBox box = box_of(mesh, cell);
    if (box.low[0] < extent[0] || box.high[0] > extent[1]) for_each_block(points, cell, enter);
  }
  return extent[0] <= extent[1] ? extent : std::array{std::nan(""), std::nan("")};
}

Real lowest(const PointBlocks<2>& points, Ground ground)
{
  Real y = std::numeric_limits<Real>::infinity();
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) {
    if (is_ground(ground, block)) y = std::min(y, block.row(Rows::x + 1)[lane]);
  });
  return y;
}

}  // namespace terp
