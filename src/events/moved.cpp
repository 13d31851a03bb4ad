#include "events/moved.hpp"

#include <array>
#include <cmath>

namespace terp {
namespace {

using Rows = PointRows<2>;

/// Calls f(block, lane, dx) for the points that lie farther than `distance` from their first places; dx: to the right [m].
template <class F>
void for_each_moved(const PointBlocks<2>& points, std::span<const Real> x_initial, Real distance, F&& f)
{
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) {
    const Real* first = &x_initial[2 * static_cast<std::size_t>(block.row(Rows::id)[lane])];
    const Real dx = block.row(Rows::x)[lane] - first[0], dy = block.row(Rows::x + 1)[lane] - first[1];
    if (dx * dx + dy * dy > distance * distance) f(block, lane, dx);
  });
}

}  // namespace

Real moved_volume(const PointBlocks<2>& points, std::span<const Real> x_initial, Real distance)
{
  Real volume = 0.0;
  for_each_moved(points, x_initial, distance, [&](const PointBlock<2>& block, Index lane, Real) { volume += block.row(Rows::volume)[lane]; });
  return volume;
}

Real intact_share(const PointBlocks<2>& points, std::span<const Real> x_initial, Real distance, std::span<const int> strain_rows)
{
  Real all = 0.0, intact = 0.0;
  for_each_moved(points, x_initial, distance, [&](const PointBlock<2>& block, Index lane, Real) {
    const int row = strain_rows[static_cast<std::size_t>(block.material)];
    if (row < 0) return;
    const Real volume = block.row(Rows::volume)[lane];
    all += volume;
    if (block.row(Rows::state + row)[lane] < intact_strain) intact += volume;
  });
  return all > 0.0 ? intact / all : std::nan("");
}

std::array<Real, 2> reach(const PointBlocks<2>& points, std::span<const Real> x_initial, Real distance)
{
  std::array<Real, 2> x{std::nan(""), std::nan("")};
  for_each_moved(points, x_initial, distance, [&](const PointBlock<2>& block, Index lane, Real dx) {
    const Real place = block.row(Rows::x)[lane];
    if (dx < 0.0 && !(place >= x[0])) x[0] = place;
    if (dx > 0.0 && !(place <= x[1])) x[1] = place;
  });
  return x;
}

}  // namespace terp
