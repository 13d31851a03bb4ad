// A section is a picture in two dimensions: water that comes from one side goes over the highest ground that hangs
// together with the base, wherever that lies, and a hollow under an overhang leads nowhere. So the barrier is the
// largest height of the surface. Between the middles of columns the surface is a straight line; at the end of the
// ground it falls at the edge of the column.

#include "events/barrier.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace terp {
namespace {

constexpr Real none = -std::numeric_limits<Real>::infinity();
constexpr Real carries = 1.0 / 3.0;  // part of a cell that ground must fill to connect its neighbours with the base

/// What a cell holds of ground.
struct CellContent {
  Real volume = 0.0, sheared = 0.0;  ///< [m^2]
  Real top = none;                   ///< upper edge of the highest point, a square of its volume [m]
};

CellContent content_of(const PointBlocks<2>& points, Index cell, const GroundQuestion& question)
{
  CellContent content;
  for_each_block(points, cell, [&](const PointBlock<2>& block, Index) {
    if (!is_ground(question.ground, block)) return;
    const int strain = question.strain.empty() ? -1 : question.strain[static_cast<std::size_t>(block.material)];
    for (Index lane = 0; lane < block.n; ++lane) {
      const Real volume = block.row(PointRows<2>::volume)[lane];
      content.volume += volume;
      content.top = std::max(content.top, block.row(PointRows<2>::x + 1)[lane] + 0.5 * std::sqrt(volume));
      if (strain >= 0 && block.row(strain)[lane] >= question.intact_below) content.sheared += volume;
    }
  });
  return content;
}

bool is_at_boundary(const Mesh<2>& mesh, Index cell)
{
  return std::ranges::find(mesh.neighbours[static_cast<std::size_t>(cell)], outside) !=
         mesh.neighbours[static_cast<std::size_t>(cell)].end();
}

Real area_of(const std::array<Vec<2>, 4>& x)
{
  return 0.5 * ((x[2][0] - x[0][0]) * (x[3][1] - x[1][1]) - (x[3][0] - x[1][0]) * (x[2][1] - x[0][1]));
}

/// Which of the occupied cells rest on the boundary of the mesh, or on others that do. A thread of points through cells
/// that are nearly empty connects nothing.
std::vector<std::uint8_t> find_connected(
    const Mesh<2>& mesh, const PointBlocks<2>& points, const std::vector<CellContent>& contents)
{
  const auto& cells = points.occupied();
  std::vector<std::uint8_t> connected(cells.size(), 0);
  std::vector<Index> open;
  const auto enter = [&](Index slot) {
    if (slot < 0 || connected[slot] != 0 || !(contents[slot].volume > 0.0)) return;
    connected[slot] = 1;
    if (contents[slot].volume >= carries * area_of(mesh.corners(cells[slot]))) open.push_back(slot);
  };
  for (Index slot = 0; slot < static_cast<Index>(cells.size()); ++slot)
    if (is_at_boundary(mesh, cells[slot])) enter(slot);
  while (!open.empty()) {
    const Index cell = cells[open.back()];
    open.pop_back();
    for (const Index next : mesh.neighbours[static_cast<std::size_t>(cell)])
      if (next != outside) enter(points.slot_of_cell()[next]);
  }
  return connected;
}

/// The stretch of the vertical line at x that lies in a cell [m]; empty if first >= second.
std::array<Real, 2> stretch_at(const std::array<Vec<2>, 4>& corners, Real x)
{
  std::array<Real, 2> stretch{-none, none};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec<2>&a = corners[k], &b = corners[(k + 1) % corners.size()];
    if ((a[0] < x && b[0] < x) || (a[0] > x && b[0] > x)) continue;
    const Real part = a[0] == b[0] ? 0.0 : (x - a[0]) / (b[0] - a[0]);
    for (const Real y : {a[1] + part * (b[1] - a[1]), a[0] == b[0] ? b[1] : a[1] + part * (b[1] - a[1])})
      stretch = {std::min(stretch[0], y), std::max(stretch[1], y)};
  }
  return stretch;
}

/// Sides along x and y: what a cell holds then fills it up to its share of the height.
bool is_upright(const std::array<Vec<2>, 4>& corners)
{
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec<2>&a = corners[k], &b = corners[(k + 1) % corners.size()];
    if (a[0] != b[0] && a[1] != b[1]) return false;
  }
  return true;
}

void enter_cell(const std::array<Vec<2>, 4>& corners, const CellContent& content, StandingGround& ground)
{
  const Real top = is_upright(corners) ? -none : content.top;  // of a cell cut askew the share says little
  const auto [left, right] = std::ranges::minmax({corners[0][0], corners[1][0], corners[2][0], corners[3][0]});
  const Columns& columns = ground.columns;
  const Real full = std::min(1.0, content.volume / area_of(corners));
  const auto first = static_cast<Index>(std::max(0.0, std::ceil((left - columns.left) / columns.width - 0.5)));
  for (Index k = first; k < columns.n; ++k) {
    const Real x = columns.left + (k + 0.5) * columns.width;
    if (x > right) break;
    const auto [low, high] = stretch_at(corners, x);
    if (!(low < high)) continue;
    ground.heights[k] = std::max(ground.heights[k], std::min(low + full * (high - low), top));
    if (low <= ground.level && ground.level < high) ground.sheared[k] = content.sheared / content.volume;
  }
}

/// A stretch of x with ground at the level [m].
struct Stretch {
  Real from, to;
  Real length() const { return to - from; }
};

/// The part of the stretch between the middles of two columns, at distance `width`, in which a surface of these heights
/// reaches the level: from its start, or to its end [m].
Real reach(Real high, Real low, Real level, Real width)
{
  if (low >= level) return width;
  return low == none ? 0.5 * width : width * (high - level) / (high - low);
}

std::vector<Stretch> stretches_at_level(const StandingGround& ground, ColumnRange range)
{
  const Columns& columns = ground.columns;
  const auto middle = [&](Index k) { return columns.left + (k + 0.5) * columns.width; };
  const auto reaches = [&](Index k) { return ground.heights[k] >= ground.level; };
  std::vector<Stretch> stretches;
  for (Index k = range.first; k < range.last; ++k) {
    if (!reaches(k)) continue;
    Index end = k;
    while (end + 1 < range.last && reaches(end + 1)) ++end;
    Stretch stretch{middle(k) - 0.5 * columns.width, middle(end) + 0.5 * columns.width};
    if (k > range.first)
      stretch.from = middle(k) - reach(ground.heights[k], ground.heights[k - 1], ground.level, columns.width);
    if (end + 1 < range.last)
      stretch.to = middle(end) + reach(ground.heights[end], ground.heights[end + 1], ground.level, columns.width);
    stretches.push_back(stretch);
    k = end;
  }
  return stretches;
}

}  // namespace

StandingGround look_at_ground(const Mesh<2>& mesh, const PointBlocks<2>& points, const GroundQuestion& question)
{
  const auto& cells = points.occupied();
  std::vector<CellContent> contents;
  for (const Index cell : cells) contents.push_back(content_of(points, cell, question));
  const std::vector<std::uint8_t> connected = find_connected(mesh, points, contents);
  const auto n = static_cast<std::size_t>(question.columns.n);
  StandingGround ground{question.columns, question.level, std::vector<Real>(n, none), std::vector<Real>(n, 0.0)};
  for (std::size_t slot = 0; slot < cells.size(); ++slot)
    if (connected[slot] != 0) enter_cell(mesh.corners(cells[slot]), contents[slot], ground);
  return ground;
}

ColumnRange columns_of_barrier(const StandingGround& ground, std::optional<Facing> river)
{
  const Index n = ground.columns.n;
  const auto reaches = [&](Index k) { return ground.heights[k] >= ground.level; };
  const auto is_empty = [&](Index k) { return ground.heights[k] == none; };
  Index left = 0, right = n;  // the high land at both ends of the soil, which may end before the mesh
  while (left < n && is_empty(left)) ++left;
  while (river != Facing::left && left < n && reaches(left)) ++left;
  while (right > 0 && is_empty(right - 1)) --right;
  while (river != Facing::right && right > 0 && reaches(right - 1)) --right;
  for (Index k = left; k < right; ++k)
    if (reaches(k)) return {left, right};
  return {0, n};
}

Barrier find_barrier(const StandingGround& ground, ColumnRange range)
{
  Barrier barrier{.height = none};
  for (Index k = range.first; k < range.last; ++k) barrier.height = std::max(barrier.height, ground.heights[k]);
  const auto stretches = stretches_at_level(ground, range);
  if (stretches.empty()) return barrier;
  const Stretch& widest = *std::ranges::max_element(stretches, {}, &Stretch::length);
  barrier.width = widest.length();
  for (Index k = range.first; k < range.last; ++k) {
    const Real left = ground.columns.left + k * ground.columns.width;
    const Real inside = std::min(left + ground.columns.width, widest.to) - std::max(left, widest.from);
    if (inside > 0.0) barrier.intact_width += inside * (1.0 - ground.sheared[k]);
  }
  return barrier;
}

}  // namespace terp
