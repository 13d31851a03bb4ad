#include "points/move.hpp"

#include "mesh/locate.hpp"

namespace terp {

int move_to_new_cell(const Mesh<2>& mesh, PointBlocks<2>& points, Index b, Index lane, std::span<Real> values)
{
  using Rows = PointRows<2>;
  const PointBlock<2>& block = points.block(b);
  Vec<2> x{block.row(Rows::x)[lane], block.row(Rows::x + 1)[lane]};
  Location to = locate(mesh, x, block.cell);
  if (!to.inside) {
    to.local = clamp_to_cell(to.local);
    x = place_in_cell(mesh, to.cell, to.local);
  }
  for (int d = 0; d < 2; ++d) {
    block.row(Rows::x + d)[lane] = x[d];
    block.row(Rows::xi + d)[lane] = to.local[d];
  }
  if (to.cell != block.cell) {
    const Index material = block.material;
    points.take(b, lane, values);
    points.add(to.cell, material, values);
  }
  return to.inside ? 0 : 1;
}

}  // namespace terp
