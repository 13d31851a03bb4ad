// What the step does in one occupied cell: views, corner values, and the motion of points.
#pragma once

#include "simulation/state.hpp"
#include "simulation/workspace.hpp"

namespace terp {

inline CellView view_cell(const Model& model, State& state, Workspace& work, Index slot)
{
  const Index cell = state.points.occupied()[slot];
  return {cell, model.mesh.geometry(cell), state.points, work.gauss, work.pressure, work.corners[slot]};
}

/// Values of the cell's corners; part: &NodeValues::v or &NodeValues::dv; times `factor`.
inline CornerVectors corner_values(const Mesh<2>& mesh, std::span<const NodeValues> node, Index cell, Vec<2> NodeValues::*part, Real factor)
{
  CornerVectors values;
  for (int i = 0; i < 4; ++i) {
    const Vec<2>& at = node[mesh.cells[cell][i]].*part;
    for (int d = 0; d < 2; ++d) values[d][i] = at[d] * factor;
  }
  return values;
}

/// x_p += sum N_i du_i; new local coordinates; lanes that left the half-open cell go to `leavers`, with those whose place the cell's map
/// does not reach. A place that is not a number stays: the guards speak of it.
inline void advance_points(const CellView& view, Vec<2> centre, const CornerVectors& du, const PointBlock<2>& block, Index b,
                           std::vector<PointPlace>& leavers)
{
  using Rows = PointRows<2>;
  for (Index p = 0; p < block.n; p += pack_width) {
    const Mask in_use = lane_numbers() < Pack(static_cast<Real>(block.n - p));
    const std::array<Pack, 2> xi{Pack::load(block.row(Rows::xi) + p), Pack::load(block.row(Rows::xi + 1) + p)};
    const auto step = interpolate(du, shape_functions(xi[0], xi[1]));
    std::array<Pack, 2> x;
    for (int d = 0; d < 2; ++d) {
      const Pack old = Pack::load(block.row(Rows::x + d) + p);
      x[d] = select(in_use, old + step[d], old);
      x[d].store(block.row(Rows::x + d) + p);
    }
    const auto local = local_coordinates(view.geometry, x[0] - Pack(centre[0]), x[1] - Pack(centre[1]));
    Mask inside = in_use;
    for (int d = 0; d < 2; ++d) {
      select(in_use, local[d], xi[d]).store(block.row(Rows::xi + d) + p);
      inside = inside & (local[d] >= Pack(-1.0)) & (local[d] < Pack(1.0));
    }
    const Mask known = (x[0] - x[0]) + (x[1] - x[1]) >= Pack(0.0);
    for (unsigned bits = to_bits((!inside) & in_use & known); bits != 0; bits &= bits - 1)
      leavers.push_back({b, p + static_cast<Index>(std::countr_zero(bits))});
  }
}

}  // namespace terp
