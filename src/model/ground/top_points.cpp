// On a lattice of points the highest of each column remain, whatever the ratio of the distances between them (from 1 :
// 2 to 2 : 1) and the angle between rows and columns. Slopes up to 1.5 : 1 hide no point of theirs.

#include "model/ground/top_points.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real beside = 0.4, far = 1.5;  // of its size
constexpr Real steep = 1.5;              // slope of the cone

bool hides(const TopPoint& above, const TopPoint& below)
{
  const Real dx = std::abs(above.x[0] - below.x[0]), dy = above.x[1] - below.x[1];
  if (!(dy > 0.0)) return false;
  return dx < beside * above.size || (dx < far * above.size && dy > steep * dx);
}

std::vector<TopPoint> collect(const PointBlocks<2>& points, Real left, Real right, int held_row)
{
  std::vector<TopPoint> found;
  for (const Index cell : points.occupied())
    for_each_block(points, cell, [&](const PointBlock<2>& block, Index b) {
      for (Index lane = 0; lane < block.n; ++lane)
        if (const Real x = block.row(Rows::x)[lane];
            x >= left && x <= right && (held_row < 0 || block.row(held_row)[lane] >= 0.0))
          found.push_back({{b, lane}, {x, block.row(Rows::x + 1)[lane]}, std::sqrt(block.row(Rows::volume)[lane])});
    });
  return found;
}

}  // namespace

std::vector<TopPoint> find_top_points(const PointBlocks<2>& points, Real left, Real right, int held_row)
{
  std::vector<TopPoint> all = collect(points, left, right, held_row);
  // From the highest down: what is hidden by a hidden point is hidden by one above that, or near enough.
  std::ranges::sort(
      all, [](const TopPoint& a, const TopPoint& b) { return a.x[1] != b.x[1] ? a.x[1] > b.x[1] : a.x[0] < b.x[0]; });
  Real largest = 0.0;
  for (const TopPoint& p : all) largest = std::max(largest, p.size);
  std::vector<TopPoint> tops;  // sorted by x
  const auto by_x = [](const TopPoint& a, Real x) { return a.x[0] < x; };
  for (const TopPoint& p : all) {
    const auto first = std::lower_bound(tops.begin(), tops.end(), p.x[0] - far * largest, by_x);
    const auto end = std::lower_bound(first, tops.end(), p.x[0] + far * largest, by_x);
    if (std::none_of(first, end, [&](const TopPoint& above) { return hides(above, p); }))
      tops.insert(std::lower_bound(tops.begin(), tops.end(), p.x[0], by_x), p);
  }
  return tops;
}

}  // namespace terp
