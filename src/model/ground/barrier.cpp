// A hollow under an overhang leads nowhere, so the barrier is the largest height of the surface. Between the middles of
// columns the surface is a straight line; at the end of the ground it falls at the edge of the column.

#include "model/ground/barrier.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace terp {
namespace {

constexpr Real none = -std::numeric_limits<Real>::infinity();
constexpr Real carries = 1.0 / 3.0;  // part of a cell that ground must fill to connect its neighbours with the base

struct CellContent {
  Real volume = 0.0, sheared = 0.0;  ///< [m^2]
  Real top = none;                   ///< upper edge of the highest point, a square of its volume [m]
  Real from_below = 0.0;             ///< of the volume: what points below reach into it, less what its own reach below
};

CellContent content_of(const PointBlocks<2>& points, Index cell, const GroundQuestion& question)
{
  CellContent content;
  for_each_block(points, cell, [&](const PointBlock<2>& block, Index) {
    if (!is_ground(question.ground, block)) return;
    const int strain = question.strain.empty() ? -1 : question.strain[static_cast<std::size_t>(block.material)];
    for (Index lane = 0; lane < block.n; ++lane) {
      const Real volume = block.row(Rows::volume)[lane];
      content.volume += volume;
      content.top = std::max(content.top, block.row(Rows::x + 1)[lane] + 0.5 * std::sqrt(volume));
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

/// The upright cell at the lower or upper end of an upright one along x (d = 0) or y; `outside`: there is none.
Index upright_neighbour(const Mesh<2>& mesh, Index cell, std::size_t d, bool upper)
{
  const auto x = mesh.corners(cell);
  for (std::size_t side = 0; side < x.size(); ++side) {
    const Vec<2>&a = x[side], &b = x[(side + 1) % x.size()];
    if (a[d] != b[d] || (a[d] > mesh.centres[static_cast<std::size_t>(cell)][d]) != upper) continue;
    const Index next = mesh.neighbours[static_cast<std::size_t>(cell)][side];
    return next != outside && is_upright(mesh.corners(next)) ? next : outside;
  }
  return outside;
}

/// Ground of the cells where a point is as large as its volume, a part of its cell of the same shape: what reaches over
/// a side counts beyond it. Without that, ground that sinks would keep its height until a row of points leaves a cell.
class GroundFill {
 public:
  GroundFill(const Mesh<2>& mesh, const PointBlocks<2>& points, const GroundQuestion& question,
      const std::vector<std::uint8_t>& connected)
      : mesh_(mesh),
        points_(points),
        question_(question),
        connected_(connected),
        of_cell_(static_cast<std::size_t>(mesh.n_cells()))
  {
  }

  void enter(Index cell, const CellContent& content)
  {
    if (!is_upright(mesh_.corners(cell))) {
      add(cell, content.volume, content.sheared);
      of_cell_[static_cast<std::size_t>(cell)].top = content.top;
      return;
    }
    for_each_block(points_, cell, [&](const PointBlock<2>& block, Index) {
      if (is_ground(question_.ground, block))
        for (Index lane = 0; lane < block.n; ++lane) spread(cell, block, lane);
    });
  }

  /// Seeded points are not always squares. So what reaches up out of a cell that is not full fills it first, and what
  /// reaches down into a cell that is full stays above.
  void settle()
  {
    std::vector<std::pair<Index, Real>> moved;  // into a cell out of the one below [m^2]
    for (const Index cell : cells_) {
      const Real reaches = of_cell_[static_cast<std::size_t>(cell)].from_below;
      const Index below = reaches != 0.0 ? upright_neighbour(mesh_, cell, 1, false) : outside;
      if (below == outside) continue;
      const Real lacks = area_of(mesh_.corners(below)) - of_cell_[static_cast<std::size_t>(below)].volume;
      const Real up = reaches > 0.0 ? -std::clamp(lacks, 0.0, reaches) : std::clamp(-lacks, 0.0, -reaches);
      if (up != 0.0) moved.emplace_back(cell, up);
    }
    for (const auto& [cell, volume] : moved) {
      CellContent& upper = of_cell_[static_cast<std::size_t>(cell)];
      CellContent& lower = of_cell_[static_cast<std::size_t>(upright_neighbour(mesh_, cell, 1, false))];
      const CellContent& source = volume > 0.0 ? lower : upper;
      const Real sheared = source.volume > 0.0 ? volume * source.sheared / source.volume : 0.0;
      upper.volume += volume, lower.volume -= volume;
      upper.sheared += sheared, lower.sheared -= sheared;
    }
  }

  const std::vector<Index>& cells() const { return cells_; }
  const CellContent& of(Index cell) const { return of_cell_[static_cast<std::size_t>(cell)]; }

 private:
  bool holds_ground(Index cell) const
  {
    const Index slot = points_.slot_of_cell()[cell];
    return slot >= 0 && connected_[static_cast<std::size_t>(slot)] != 0;
  }

  void add(Index cell, Real volume, Real sheared)
  {
    CellContent& content = of_cell_[static_cast<std::size_t>(cell)];
    if (!(content.volume > 0.0)) cells_.push_back(cell);
    content.volume += volume;
    content.sheared += sheared;
  }

  void spread(Index cell, const PointBlock<2>& block, Index lane)
  {
    const auto x = mesh_.corners(cell);
    const Real volume = block.row(Rows::volume)[lane];
    const int strain = question_.strain.empty() ? -1 : question_.strain[static_cast<std::size_t>(block.material)];
    const Real sheared = strain >= 0 && block.row(strain)[lane] >= question_.intact_below ? 1.0 : 0.0;
    const std::array<std::array<Real, 3>, 2> part = parts(x, block, lane, std::sqrt(volume / area_of(x)));
    for (std::size_t row = 0; row < 3; ++row) {
      if (!(part[1][row] > 0.0)) continue;
      const Index next = row == 1 ? outside : upright_neighbour(mesh_, cell, 1, row == 2);
      const Index in_row = next == outside ? cell : next;
      const Real reaches = next == outside ? 0.0 : volume * part[1][row];
      if (reaches > 0.0 && row == 2) of_cell_[static_cast<std::size_t>(next)].from_below += reaches;
      if (reaches > 0.0 && row == 0) of_cell_[static_cast<std::size_t>(cell)].from_below -= reaches;
      for (std::size_t column = 0; column < 3; ++column) {
        if (!(part[0][column] > 0.0)) continue;
        const Index beside = column == 1 ? outside : upright_neighbour(mesh_, in_row, 0, column == 2);
        if (beside != outside && !holds_ground(beside)) continue;  // less than the part of a column: no ground there
        const Real share = volume * part[1][row] * part[0][column];
        add(beside != outside ? beside : in_row, share, sheared * share);
      }
    }
  }

  /// Along x and y: the part of a point that lies below its cell, in it and beyond. size: of the point over the cell's.
  static std::array<std::array<Real, 3>, 2> parts(
      const std::array<Vec<2>, 4>& x, const PointBlock<2>& block, Index lane, Real size)
  {
    std::array<std::array<Real, 3>, 2> part;
    for (std::size_t d = 0; d < 2; ++d) {
      const auto [low, high] = std::minmax({x[0][d], x[1][d], x[2][d], x[3][d]});
      const Real place = (block.row(Rows::x + static_cast<int>(d))[lane] - low) / (high - low);
      const Real below = std::clamp(0.5 - place / size, 0.0, 1.0);
      const Real beyond = std::clamp(0.5 - (1.0 - place) / size, 0.0, 1.0 - below);
      part[d] = {below > least ? below : 0.0, 0.0, beyond > least ? beyond : 0.0};
      part[d][1] = 1.0 - part[d][0] - part[d][2];
    }
    return part;
  }

  static constexpr Real least = 1e-9;  ///< part of a point: less is round-off

  const Mesh<2>& mesh_;
  const PointBlocks<2>& points_;
  const GroundQuestion& question_;
  const std::vector<std::uint8_t>& connected_;
  std::vector<CellContent> of_cell_;
  std::vector<Index> cells_;  ///< those with ground
};

void enter_cell(const std::array<Vec<2>, 4>& corners, const CellContent& content, StandingGround& ground)
{
  const Real top = is_upright(corners) ? -none : content.top;  // of a cell cut askew the share says little
  const auto [left, right] = std::minmax({corners[0][0], corners[1][0], corners[2][0], corners[3][0]});
  const Columns& columns = ground.columns;
  const Real full = std::min(1.0, content.volume / area_of(corners));
  if (!(full > 1e-9)) return;  // round-off
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
  GroundFill fill(mesh, points, question, connected);
  for (std::size_t slot = 0; slot < cells.size(); ++slot)
    if (connected[slot] != 0) fill.enter(cells[slot], contents[slot]);
  fill.settle();
  for (const Index cell : fill.cells()) enter_cell(mesh.corners(cell), fill.of(cell), ground);
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

/// A place x whose ground lies d/slope below the level forbids the left ends from x - width - d to x + d; the ground
/// between two places forbids what lies between their ends, too.
std::optional<Real> place_of_profile(const StandingGround& ground, ColumnRange range, Real width, Real slope)
{
  const Columns& columns = ground.columns;
  const auto middle = [&](Index k) { return columns.left + (k + 0.5) * columns.width; };
  const auto lacking = [&](Index k) { return slope * (ground.level - ground.heights[k]); };  // infinite: no ground
  std::vector<Stretch> forbidden;
  const auto forbid = [&](Real x, Real d) { forbidden.push_back({x - width - d, x + d}); };
  for (Index k = range.first; k < range.last; ++k) {
    const Real here = lacking(k);
    if (here > 0.0) forbid(middle(k), here);
    if (k + 1 == range.last) break;
    const Real next = lacking(k + 1);
    if (here > 0.0 && next > 0.0) {
      const Stretch other{middle(k + 1) - width - next, middle(k + 1) + next};
      forbidden.back() = {std::min(forbidden.back().from, other.from), std::max(forbidden.back().to, other.to)};
    } else if (here > 0.0 || next > 0.0) {
      const Real x = std::isinf(here) || std::isinf(next)
                         ? middle(k) + 0.5 * columns.width
                         : middle(k) + columns.width * here / (here - next);  // where the ground is at the level
      const Real at = here > 0.0 ? middle(k) : middle(k + 1), d = std::max(here, next);
      forbidden.push_back({std::min(x - width, at - width - d), std::max(x, at + d)});
    }
  }
  std::ranges::sort(forbidden, {}, &Stretch::from);
  Real left = middle(range.first) - 0.5 * columns.width;
  const Real last = middle(range.last - 1) + 0.5 * columns.width - width;
  for (const Stretch& stretch : forbidden)
    if (stretch.from < left) left = std::max(left, stretch.to);
  return left <= last ? std::optional(left) : std::nullopt;
}

}  // namespace terp
