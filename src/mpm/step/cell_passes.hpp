// What the step does in an occupied cell or a group of them: views, corner values, and the motion of points.
#pragma once

#include "mpm/points/rows_of_packs.hpp"
#include "mpm/schemes/cell_group.hpp"
#include "mpm/step/step_state.hpp"
#include "mpm/step/workspace.hpp"
#include "mpm/kernels/map_load.hpp"

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
  const auto here = [&](auto& all) {
    const std::span of_all(all);
    return of_all.empty() ? of_all : of_all.subspan(first, n);
  };
  return {occupied.subspan(first, n), *model.mesh, state.points, corners.subspan(first, n), work.pressure, work.gauss,
      work.gauss_rows, work.n_gauss_rows, first / pack_width, n_groups, next_cell, !in_cache, work.patches.get(),
      here(work.outer[outer_water].corners), work.excess, work.volume_gradients, here(work.balance),
      here(work.outer[outer_balance].corners), work.ratios, work.slips};
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

/// v_i dt of the corners of each cell of a group [m]; zero beyond the last.
inline GroupVectors<Quad4> displacements(
    const StepModel& model, std::span<const NodeValues> node, const CellGroup<Quad4>& group)
{
  GroupVectors<Quad4> du{};
  for (int c = 0; c < group.n(); ++c)
    du[c] = corner_values(*model.mesh, node, group.cells[c], &NodeValues::v, model.dt);
  return du;
}

inline void enter(const StressSums& of, CellSums& sums)
{
  sums.plastic += of.plastic_work;
  sums.slip += of.slip_work;
  sums.taken += sum(of.taken);
  sums.reset += sum(of.reset);
}

/// m_i and (m v)_i of the points of cell c; clears the forces.
inline void map_mass_and_momentum(const CellGroup<Quad4>& group, int c)
{
  prefetch_next(group, c, Rows::xi, Rows::strain);
  const CellView<Quad4> view = group.cell(c);
  view.corners = {};
  if (!group.water_force.empty()) group.water_force[c] = {};
  for_each_block(
      view.points, view.cell, [&](const PointBlock<2>& block, Index) { map_mass_and_momentum(block, view.corners); });
}

/// grad p at the centre of a cell [Pa/m]; 0 without water.
inline Vec<2> pressure_gradient(const StepModel& model, Index cell, std::span<const Real> pressure)
{
  Vec<2> gradient{0.0, 0.0};
  if (pressure.empty()) return gradient;
  for (int i = 0; i < Quad4::n_corners; ++i)
    for (int d = 0; d < 2; ++d)
      gradient[d] += pressure[model.mesh->cells[cell][i]] * model.mesh->geometry(cell).centre_gradient[i][d];
  return gradient;
}

/// f_i += m_p N_i(x_p) b(x_p, x_p0, t), of the block's points.
inline void map_body_force(const BodyForce& body, const PointBlock<2>& block, std::span<const Real> x_initial,
    Real time, CornerVectors<Quad4>& force)
{
  for (Index p = 0; p < block.n; ++p) {
    const std::size_t id = static_cast<std::size_t>(block.row(Rows::id)[p]);
    const Vec<2> b =
        body({block.row(Rows::x)[p], block.row(Rows::x + 1)[p]}, {x_initial[2 * id], x_initial[2 * id + 1]}, time);
    const auto N = Quad4::shape_functions<Real>({block.row(Rows::xi)[p], block.row(Rows::xi + 1)[p]});
    for (int d = 0; d < 2; ++d)
      for (int i = 0; i < Quad4::n_corners; ++i) force[d][i] += block.row(Rows::mass)[p] * N[i] * b[d];
  }
}

/// Forces of the loads at the corners of cell c, of what holds the weight of bodies that come or go, and of
/// forces.body.
inline void map_loads(
    const StepModel& model, const StepState& state, const CellGroup<Quad4>& group, int c, Workspace& work)
{
  const Index cell = group.cells[c];
  CornerVectors<Quad4>& force = work.outer[outer_load].corners[group.number * pack_width + c];
  force = {};
  for_each_block(group.points, cell, [&](const PointBlock<2>& block, Index) {
    for (std::size_t k = 0; k < model.loads.size(); ++k)
      if (work.load_pressure[k] != 0.0)
        map_load(block, model.loads[k].row, work.load_pressure[k], model.mesh->geometry(cell),
            model.mesh->centres[cell], force);
    if (work.held.act())
      map_held_weight<Quad4>(
          block, model.held_row, work.held, work.gravity, pressure_gradient(model, cell, work.pore.pressure), force);
    if (model.body_force) map_body_force(model.body_force, block, state.x_initial, state.time + 0.5 * model.dt, force);
  });
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

}  // namespace terp
