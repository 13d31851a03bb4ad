// What every step does in a group of cells: kernels of the core (core_kernels.cpp), and the view of a group.
#pragma once

#include "mpm/points/rows_of_packs.hpp"
#include "mpm/step/now.hpp"

namespace terp {

/// Least memory of the points from which blocks are fetched ahead [bytes]: where they stay in the last cache it costs 5
/// to 10 % of a step, beyond it saves up to a quarter.
inline constexpr std::int64_t prefetch_from = 16 << 20;

/// The occupied cells `first` to `end` - 1, first a multiple of pack_width, as a group.
inline CellGroup<Quad4> view_group(const StepModel& model, StepState& state, Workspace& work, Index first, Index end)
{
  const std::span<const Index> occupied = state.points.occupied();
  const std::span<CornerSums<Quad4>> corners = work.corners;
  const Index n = end - first, n_groups = Threads::n_chunks(static_cast<Index>(occupied.size()), pack_width);
  const bool in_cache = state.points.n_points() * state.points.n_rows() * std::int64_t{sizeof(Real)} < prefetch_from;
  const Index next_cell = static_cast<std::size_t>(end) < occupied.size() ? occupied[end] : -1;
  return {occupied.subspan(first, n), *model.mesh, state.points, corners.subspan(first, n), work.pressure, work.gauss,
      work.gauss_rows, work.n_gauss_rows, first / pack_width, n_groups, next_cell, !in_cache};
}

/// Values of the cell's corners; part: &NodeValues::v or &NodeValues::dv; times `factor`.
inline CornerVectors<Quad4> corner_values(
    const Mesh<2>& mesh, std::span<const NodeValues> node, Index cell, Vec<2> NodeValues::*part, Real factor)
{
  CornerVectors<Quad4> values;
  for (int i = 0; i < Quad4::n_corners; ++i) {
    const Vec<2>& at = node[mesh.cells[cell][i]].*part;
    for (int d = 0; d < Quad4::dim; ++d) values[d][i] = at[d] * factor;
  }
  return values;
}

/// v_i dt of the corners of each cell of a group.
inline void move_corners(GroupNow& now)
{
  const CellGroup<Quad4>& group = now.group;
  for (int c = 0; c < pack_width; ++c)
    now.du[c] = c < group.n() ? corner_values(*now.step.model.mesh, now.step.work.node, group.cells[c], &NodeValues::v,
                                    now.step.model.dt)
                              : CornerVectors<Quad4>{};
  now.strained = &now.du;
}

/// m_i and (m v)_i of the points of the cells; clears the forces.
inline void map_masses(GroupNow& now)
{
  const CellGroup<Quad4>& group = now.group;
  for (int c = 0; c < group.n(); ++c) {
    prefetch_next(group, c, Rows::xi, Rows::strain);
    CornerSums<Quad4>& corners = group.corners[c] = {};
    for_each_block(group.points, group.cells[c],
        [&](const PointBlock<2>& block, Index) { map_mass_and_momentum(block, corners); });
  }
}

/// v_p of a cell from the accelerated nodes, and the momentum of the points with it. Returns the kinetic energy that
/// PIC adds [J per m].
inline Real accelerate_and_map(const StepModel& model, std::span<const NodeValues> node, const CellView<Quad4>& view)
{
  const CornerVectors<Quad4> dv = corner_values(*model.mesh, node, view.cell, &NodeValues::dv, 1.0);
  const CornerVectors<Quad4> v_star = corner_values(*model.mesh, node, view.cell, &NodeValues::v, 1.0);
  view.corners.momentum = {};
  Real gained = 0.0;
  for_each_block(view.points, view.cell, [&](PointBlock<2> block, Index) {
    gained += accelerate_points<Quad4>(dv, v_star, model.materials[block.material].flip, block);
    map_momentum(block, view.corners);
  });
  return gained;
}

/// x_p += sum N_i du_i; new local coordinates; lanes that left the half-open cell go to `points_leaving`, with those
/// whose place the cell's map does not reach. A place that is not a number stays: the guards report it.
template <class Element>
inline void advance_points(const CellGeometry<Element>& cell, const Vec<Element::dim>& centre,
    const CornerVectors<Element>& du, const PointBlock<Element::dim>& block, Index b,
    std::vector<PointPlace>& points_leaving)
{
  constexpr int dim = Element::dim;
  using Rows = PointRows<dim>;
  for (Index p = 0; p < block.n; p += pack_width) {
    const Mask in_use = lane_numbers() < Pack(static_cast<Real>(block.n - p));
    const auto xi = load_rows<dim>(block, Rows::xi, p);
    const auto step = interpolate(du, Element::shape_functions(xi));
    PerDirection<Element, Pack> offset;
    Mask known = in_use;
    for (int d = 0; d < dim; ++d) {
      const Pack old = Pack::load(block.row(Rows::x + d) + p);
      const Pack x = select(in_use, old + step[d], old);
      x.store(block.row(Rows::x + d) + p);
      offset[d] = x - Pack(centre[d]);
      known = known & (x - x >= Pack(0.0));
    }
    const auto local = Element::local_coordinates(cell.map, offset);
    Mask inside = in_use;
    for (int d = 0; d < dim; ++d) {
      select(in_use, local[d], xi[d]).store(block.row(Rows::xi + d) + p);
      inside = inside & (local[d] >= Pack(-1.0)) & (local[d] < Pack(1.0));
    }
    for (unsigned bits = to_bits((!inside) & known); bits != 0; bits &= bits - 1)
      points_leaving.push_back({b, p + static_cast<Index>(std::countr_zero(bits))});
  }
}

inline void advance_points(
    const CellView<Quad4>& view, Vec<2> centre, const CornerVectors<Quad4>& du, std::vector<PointPlace>& points_leaving)
{
  for_each_block(view.points, view.cell, [&](const PointBlock<2>& block, Index b) {
    advance_points(view.geometry, centre, du, block, b, points_leaving);
  });
}

inline void advance_group(GroupNow& now)
{
  for (int c = 0; c < now.group.n(); ++c)
    advance_points(now.group.cell(c), now.group.mesh.centres[now.group.cells[c]], now.du[c], now.points_leaving);
}

}  // namespace terp
