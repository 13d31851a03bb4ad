// Forces of the loads, of forces.body and of the weight that is held, at the corners of a cell.
// Not for: their sizes in a step (loads.hpp, bodies.hpp).
#pragma once

#include "mpm/features/bodies.hpp"
#include "mpm/features/loads.hpp"
#include "mpm/features/water.hpp"
#include "mpm/kernels/map_held_weight.hpp"
#include "mpm/kernels/map_load.hpp"
#include "mpm/step/node_passes.hpp"

namespace terp {

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
  const std::span<const Load> loads = loads_of(model);
  const std::span<const Real> pressure = load_pressures(work);
  const HeldShares held = work.with.bodies ? work.with.bodies->held : HeldShares{};
  const bool has_body_force = model.with.loads && model.with.loads->body_force;
  for_each_block(group.points, cell, [&](const PointBlock<2>& block, Index) {
    for (std::size_t k = 0; k < loads.size(); ++k)
      if (pressure[k] != 0.0)
        map_load(block, loads[k].row, pressure[k], model.mesh->geometry(cell), model.mesh->centres[cell], force);
    if (held.act())
      map_held_weight<Quad4>(block, model.with.bodies->held_row, held, work.gravity,
          pressure_gradient(model, cell, node_pressures(work)), force);
    if (has_body_force)
      map_body_force(model.with.loads->body_force, block, state.x_initial, state.time + 0.5 * model.dt, force);
  });
}

inline void map_loads_of_group(GroupNow& now)
{
  StepNow& step = now.step;
  for (int c = 0; step.work.outer[outer_load].acts && c < now.group.n(); ++c)
    map_loads(step.model, step.state, now.group, c, step.work);
}

inline void add_loads(Nodes& nodes) { add_outer_forces(nodes, nodes.step.work.outer[outer_load]); }

}  // namespace terp
