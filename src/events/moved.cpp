#include "events/moved.hpp"

namespace terp {

Real moved_volume(const PointBlocks<2>& points, std::span<const Real> x_initial, Real distance)
{
  using Rows = PointRows<2>;
  Real volume = 0.0;
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) {
    const Real* first = &x_initial[2 * static_cast<std::size_t>(block.row(Rows::id)[lane])];
    const Real dx = block.row(Rows::x)[lane] - first[0], dy = block.row(Rows::x + 1)[lane] - first[1];
    if (dx * dx + dy * dy > distance * distance) volume += block.row(Rows::volume)[lane];
  });
  return volume;
}

}  // namespace terp
