// The force of a load from the points that carry it to the corners of their cell.
#pragma once

#include "mpm/points/rows_of_packs.hpp"
#include "mpm/mesh/cell_geometry.hpp"
#include "mpm/kernels/cell_sums.hpp"

namespace terp {

/// Where the load of eight points acts, in local coordinates of their cell: at the upper end of the vertical line
/// through the middle of the point, half the side of its square above it, but within the cell. In an affine cell that
/// place lies on the vertical line wherever it ends. Points at the surface of a filled cell load its upper side so.
template <class Element>
inline PerDirection<Element, Pack> top_of_points(
    const PointBlock<2>& block, Index p, const CellGeometry<Element>& cell, const Vec<2>& centre)
{
  const auto xi = load_rows<2>(block, Rows::xi, p);
  const Pack lift = Pack(0.5) * sqrt(Pack::load(block.row(Rows::volume) + p));
  const std::array<Pack, 2> offset{Pack::load(block.row(Rows::x) + p) - Pack(centre[0]),
      Pack::load(block.row(Rows::x + 1) + p) - Pack(centre[1]) + lift};
  const auto top = Element::local_coordinates(cell.map, offset);
  Pack part(1.0);  // of the way up that lies in the cell
  for (int d = 0; d < 2; ++d) {
    const Pack way = top[d] - xi[d];
    const Pack room = select(way > Pack(0.0), Pack(1.0) - xi[d], Pack(-1.0) - xi[d]);
    part = select(way * way > room * room, min(part, room / way), part);
  }
  const Mask known = (top[0] - top[0] >= Pack(0.0)) & (top[1] - top[1] >= Pack(0.0));
  return {
      select(known, fma(part, top[0] - xi[0], xi[0]), xi[0]), select(known, fma(part, top[1] - xi[1], xi[1]), xi[1])};
}

/// f_i += N_i(top of the point) (0, -pressure * width): N_i add up to one, so the sum of the forces is exact.
///
/// row       of the points: width that each carries [m]
/// pressure  [Pa]
template <class Element>
inline void map_load(const PointBlock<2>& block, int row, Real pressure, const CellGeometry<Element>& cell,
    const Vec<2>& centre, CornerVectors<Element>& force)
{
  for (Index p = 0; p < block.n; p += pack_width) {
    const Pack width = Pack::load(block.row(row) + p);
    const Mask carries = (lane_numbers() < Pack(static_cast<Real>(block.n - p))) & (width > Pack(0.0));
    if (to_bits(carries) == 0) continue;
    const auto N = Element::shape_functions(top_of_points(block, p, cell, centre));
    for (int i = 0; i < Element::n_corners; ++i)
      force[1][i] -= sum(select(carries, N[i] * (width * Pack(pressure)), Pack(0.0)));
  }
}

}  // namespace terp
