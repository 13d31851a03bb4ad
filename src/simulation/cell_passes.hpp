// What the step does in one occupied cell: views, corner values, and the motion of points.
#pragma once

#include "simulation/state.hpp"
#include "simulation/workspace.hpp"

namespace terp {

inline CellView view_cell(const Model& model, State& state, Workspace& work, Index slot)
{
  const Index cell = state.points.occupied()[slot];
  return {cell, model.mesh.geometry(cell), state.points, work.gauss, work.corners[slot]};
}

/// Values of the cell's corners; part: &NodeValues::v or &NodeValues::dv; times `factor`.
inline CornerVectors corner_values(const Mesh<2>& mesh, const std::vector<NodeValues>& node, Index cell, Vec<2> NodeValues::*part, Real factor)
{
  CornerVectors values;
  for (int i = 0; i < 4; ++i) {
    const Vec<2>& at = node[mesh.cells[cell][i]].*part;
    for (int d = 0; d < 2; ++d) values[d][i] = at[d] * factor;
  }
  return values;
}

/// Largest component of the corners' displacements [m].
inline Real largest(const CornerVectors& du)
{
  Real value = 0.0;
  for (const auto& direction : du)
    for (const Real u : direction) value = max(value, abs(u));
  return value;
}

/// x_p += sum N_i du_i; new local coordinates; lanes that left the half-open cell go to `leavers`.
inline void advance_points(const CellView& view, Vec<2> centre, const CornerVectors& du, const PointBlock<2>& block, Index b,
                           std::vector<PointPlace>& leavers)
{
  using Rows = PointRows<2>;
  const int newton_steps = newton_steps_for(view.geometry, largest(du));
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
    const auto local = local_coordinates_near(view.geometry, x[0] - Pack(centre[0]), x[1] - Pack(centre[1]), xi, newton_steps);
    Mask left = {};
    for (int d = 0; d < 2; ++d) {
      select(in_use, local[d], xi[d]).store(block.row(Rows::xi + d) + p);
      left = left | (local[d] < Pack(-1.0)) | (local[d] >= Pack(1.0));
    }
    for (unsigned bits = to_bits(left & in_use); bits != 0; bits &= bits - 1)
      leavers.push_back({b, p + static_cast<Index>(std::countr_zero(bits))});
  }
}

}  // namespace terp
