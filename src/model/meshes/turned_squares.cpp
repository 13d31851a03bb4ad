// Of two squares that touch at a corner alone one is taken out: the outline is followed from corner to corner, and at
// such a corner two lines would begin.

#include "model/meshes/turned_squares.hpp"

#include "mpm/mesh/box_grid.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace terp {
namespace {

using Spot = std::array<Index, 2>;  // of a corner in the grid; of a square that of its first corner

/// By crossings of the ray from x to the right.
bool is_well_inside(const std::vector<Vec<2>>& polygon, Vec<2> x, Real clearance)
{
  bool inside = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec<2>&a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if (distance_to_line(a, b, x) < clearance) return false;
    const bool crosses = (a[1] > x[1]) != (b[1] > x[1]);
    if (crosses && x[0] < a[0] + (x[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
  }
  return inside;
}

class Grid {
 public:
  Grid(const std::vector<Vec<2>>& polygon, Real side, Real turn) : box_(box_around(polygon)), side_(side)
  {
    const Real angle = turn * std::numbers::pi / 180.0;
    along_ = {std::cos(angle), std::sin(angle)};
  }

  Vec<2> place(Spot s) const
  {
    const auto i = static_cast<Real>(s[0]), j = static_cast<Real>(s[1]);
    return {0.5 * (box_.low[0] + box_.high[0]) + side_ * (i * along_[0] - j * along_[1]),
        0.5 * (box_.low[1] + box_.high[1]) + side_ * (i * along_[1] + j * along_[0])};
  }

  /// A line that enters a square passes a corner within half a side.
  std::set<Spot> squares_in(const std::vector<Vec<2>>& polygon, Real clearance) const
  {
    const Real radius = 0.5 * std::hypot(box_.high[0] - box_.low[0], box_.high[1] - box_.low[1]);
    const Index n = static_cast<Index>(radius / side_) + 2;
    std::set<Spot> inside, squares;
    for (Index i = -n; i <= n; ++i)
      for (Index j = -n; j <= n; ++j)
        if (is_well_inside(polygon, place({i, j}), clearance)) inside.insert({i, j});
    for (const auto& [i, j] : inside)
      if (inside.contains({i + 1, j}) && inside.contains({i + 1, j + 1}) && inside.contains({i, j + 1}))
        squares.insert({i, j});
    return squares;
  }

 private:
  BoundingBox box_;
  Real side_;
  Vec<2> along_;
};

/// Removes one of two squares that touch at a corner alone, until none do.
void part_at_corners(std::set<Spot>& squares)
{
  for (bool removed = true; removed;) {
    removed = false;
    for (auto at = squares.begin(); at != squares.end();) {
      const auto [i, j] = *at;
      const auto touches = [&, i = i, j = j](Index d) {
        return squares.contains({i + d, j + 1}) && !squares.contains({i + d, j}) && !squares.contains({i, j + 1});
      };
      const bool alone = touches(1) || touches(-1);
      at = alone ? squares.erase(at) : std::next(at);
      removed |= alone;
    }
  }
}

class Numbering {
 public:
  Numbering(const Grid& grid, TurnedSquares& result) : grid_(grid), result_(result) {}

  Index line(Spot a, Spot b)
  {
    if (const auto back = lines_.find({b, a}); back != lines_.end()) return -(back->second + 1);
    const auto [found, is_new] = lines_.emplace(std::pair(a, b), static_cast<Index>(result_.lines.size()));
    if (is_new) result_.lines.push_back({place(a), place(b)});
    return found->second + 1;
  }

 private:
  Index place(Spot s)
  {
    const auto [found, is_new] = places_.emplace(s, static_cast<Index>(result_.places.size()));
    if (is_new) result_.places.push_back(grid_.place(s));
    return found->second;
  }

  const Grid& grid_;
  TurnedSquares& result_;
  std::map<Spot, Index> places_;
  std::map<std::pair<Spot, Spot>, Index> lines_;
};

std::vector<std::vector<Index>> loops_of(std::map<Spot, std::pair<Index, Spot>> next)
{
  std::vector<std::vector<Index>> loops;
  while (!next.empty()) {
    loops.emplace_back();
    for (auto at = next.begin(); at != next.end();) {
      const auto [line, end] = at->second;
      loops.back().push_back(line);
      next.erase(at);
      at = next.find(end);
    }
  }
  return loops;
}

}  // namespace

TurnedSquares turned_squares(const std::vector<Vec<2>>& polygon, Real side, Real turn, Real clearance)
{
  const Grid grid(polygon, side, turn);
  std::set<Spot> squares = grid.squares_in(polygon, clearance);
  part_at_corners(squares);
  TurnedSquares result;
  Numbering numbering(grid, result);
  std::map<Spot, std::pair<Index, Spot>> free;
  for (const auto& [i, j] : squares) {
    const std::array<Spot, 4> corner{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}},
        beside{{{i, j - 1}, {i + 1, j}, {i, j + 1}, {i - 1, j}}};
    std::array<Index, 4> lines;
    for (int k = 0; k < 4; ++k) {
      const Spot end = corner[(k + 1) % 4];
      lines[k] = numbering.line(corner[k], end);
      if (!squares.contains(beside[k])) free[corner[k]] = {lines[k], end};
    }
    result.squares.push_back(lines);
  }
  result.outline = loops_of(std::move(free));
  return result;
}

}  // namespace terp
