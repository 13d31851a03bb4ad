#include "mpm/points/moved.hpp"

#include "mpm/points/moved_search.hpp"

#include <algorithm>
#include <cmath>

namespace terp {

Real farthest_way(
    const PointBlock<2>& block, Index lane, std::span<const Real> x_initial, std::span<const Real> moved_before)
{
  const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
  const Real dx = block.row(Rows::x)[lane] - x_initial[2 * id],
             dy = block.row(Rows::x + 1)[lane] - x_initial[2 * id + 1];
  return std::max(std::sqrt(dx * dx + dy * dy), moved_before.empty() ? 0.0 : moved_before[id]);
}

MovedSoil join(const MovedSoil& a, const MovedSoil& b)
{
  return {.volume = a.volume + b.volume,
      .reach_left = std::fmin(a.reach_left, b.reach_left),
      .reach_right = std::fmax(a.reach_right, b.reach_right)};
}

MovedSoil find_moved(const PointBlocks<2>& points, std::span<const Real> x_initial, Real distance, Ground ground)
{
  MovedSearch search(x_initial, distance);
  for_each_block(points, [&](const PointBlock<2>& block) {
    for (Index p = 0; p < block.n && is_ground(ground, block); p += pack_width) search.enter(block, p);
  });
  return search.found();
}

Real intact_share(
    const PointBlocks<2>& points, std::span<const Real> x_initial, Real distance, std::span<const int> strain_rows)
{
  Real all = 0.0, intact = 0.0;
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) {
    const int row = strain_rows[static_cast<std::size_t>(block.material)];
    const Real* first = &x_initial[2 * static_cast<std::size_t>(block.row(Rows::id)[lane])];
    const Real dx = block.row(Rows::x)[lane] - first[0], dy = block.row(Rows::x + 1)[lane] - first[1];
    if (row < 0 || !(dx * dx + dy * dy > distance * distance)) return;
    const Real volume = block.row(Rows::volume)[lane];
    all += volume;
    if (block.row(row)[lane] < intact_strain) intact += volume;
  });
  return all > 0.0 ? intact / all : std::nan("");
}

}  // namespace terp
