#include "mpm/points/move.hpp"

#include "mpm/mesh/locate.hpp"

#include <cmath>

namespace terp {
namespace {

/// True if a place beyond its cell lies beyond an open side of it.
bool beyond_open_side(std::uint8_t open, Vec<2> local)
{
  const auto is_open = [open](int side) { return (open >> side & 1) != 0; };
  for (int d = 0; d < Quad4::dim; ++d)
    if (std::abs(local[d]) > 1.0 && is_open(Quad4::side_at(d, local[d] > 0.0))) return true;
  return false;
}

}  // namespace

Moved move_to_new_cell(
    const Mesh<2>& mesh, const OpenSides& open, PointBlocks<2>& points, PointPlace at, std::span<Real> values)
{
  const PointBlock<2>& block = points.block(at.block);
  Vec<2> x{block.row(Rows::x)[at.lane], block.row(Rows::x + 1)[at.lane]};
  values[Rows::id] = block.row(Rows::id)[at.lane];
  Location to = locate(mesh, x, block.cell);
  if (!to.inside && beyond_open_side(open[to.cell], to.local)) {
    points.take(at.block, at.lane, values);
    return Moved::left;
  }
  if (!to.inside) {
    to.local = clamp_to_cell(to.local);
    x = place_in_cell(mesh, to.cell, to.local);
  }
  for (int d = 0; d < 2; ++d) {
    block.row(Rows::x + d)[at.lane] = x[d];
    block.row(Rows::xi + d)[at.lane] = to.local[d];
  }
  if (to.cell != block.cell) {
    const BlockKey key{to.cell, block.material, block.body};
    points.take(at.block, at.lane, values);
    points.add(key, values);
  }
  return to.inside ? Moved::inside : Moved::put_back;
}

}  // namespace terp
