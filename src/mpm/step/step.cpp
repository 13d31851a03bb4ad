// The score: one explicit step as a short list of named, timed passes. Equation numbers are the paper's.

#include "mpm/step/kernels.hpp"

#include "mpm/features/balance_passes.hpp"
#include "mpm/features/loads_passes.hpp"
#include "mpm/features/relaxation_passes.hpp"
#include "mpm/features/softening_passes.hpp"
#include "mpm/schemes/patch_group.hpp"
#include "mpm/step/node_passes.hpp"
#include "mpm/step/stored_energy.hpp"

namespace terp {
namespace {

void start_sums(Workspace& work)
{
  for (NodeSums& sums : work.node_sums) sums = {};
  for (CellSums& sums : work.cell_sums) sums = {};
  for (auto& list : work.points_leaving) list.clear();
}

/// In order of chunk.
void finish_sums(StepState& state, Workspace& work)
{
  NodeSums total;
  for (const NodeSums& sums : work.node_sums) {
    total.gravity += sums.gravity;
    total.damping += sums.damping;
    total.boundary += sums.boundary;
    total.clamps += sums.clamps;
    for (int kind = 0; kind < n_outer_kinds; ++kind) total.outer[kind] += sums.outer[kind];
    total.internal += sums.internal;
    total.stiffness += sums.stiffness;
    total.inertia += sums.inertia;
    total.unbalanced += sums.unbalanced;
    total.weight += sums.weight;
    total.kinetic += sums.kinetic;
    total.fastest = std::max(total.fastest, sums.fastest);
    total.finite &= sums.finite;
  }
  state.work.gravity += total.gravity;
  state.work.damping += total.damping;
  state.work.boundary += total.boundary;
  state.work.clamps += total.clamps;
  state.work.internal += total.internal;
  Real outer = 0.0;
  for (int kind = 0; kind < n_outer_kinds; ++kind) {
    state.work.outer[kind] += total.outer[kind];
    outer += total.outer[kind];
  }
  state.work.last_step = total.gravity + total.damping + total.boundary + total.clamps + outer + total.internal;
  for (const CellSums& sums : work.cell_sums) {
    state.work.plastic += sums.plastic;
    state.work.slip += sums.slip;
    state.work.taken += sums.taken;
    state.work.reset += sums.reset;
    state.work.relaxation += sums.relaxation;
  }
  state.work.from_outside = std::max(state.work.from_outside, state.work.size_of_outside());
  state.work.exchanged = energy_exchanged(state.work);
  work.finite = total.finite;
  work.kinetic_nodal = total.kinetic;
  if (work.with.rest) work.with.rest->fastest_node = std::sqrt(total.fastest);
  if (work.with.search) work.with.search->stiffness = total.stiffness, work.with.search->inertia = total.inertia;
  if (work.with.footings) add_up_impulses(*work.with.footings);
  work.unbalanced_ratio = total.weight > 0.0 ? total.unbalanced / total.weight : 0.0;
}

/// Enters a point that crossed an open side in the list of those that left.
void enter_left(const StepModel& model, Index number, std::span<Real> values, StepState& state)
{
  state.left.push_back({.time = model.time_of(state.step + 1),
      .id = static_cast<std::int64_t>(values[Rows::id]),
      .x = {values[Rows::x], values[Rows::x + 1]},
      .v = {values[Rows::v], values[Rows::v + 1]},
      .mass = values[Rows::mass],
      .elastic = elastic_energy(model.materials[number], values),
      .volume = values[Rows::volume]});
}

/// Counts a point that had to be put back at a wall, once.
void enter_put_back(std::span<const Real> values, StepState& state)
{
  auto before = state.put_back[static_cast<std::size_t>(values[Rows::id])];
  if (!before) ++state.clamped;
  before = true;
}

void move_leavers(const StepModel& model, StepState& state, Workspace& work)
{
  const OpenSides& open = model.with.sides->open;
  for (const CellSums& sums : work.cell_sums)
    for (std::size_t k = sums.end_of_leaving;
         k-- > sums.first_leaving;) {  // from the last lane of a block to the first: see take()
      const PointPlace place = work.points_leaving[sums.thread][k];
      const Index material = state.points.block(place.block).material;
      const Moved moved = move_to_new_cell(*model.mesh, open, state.points, place, work.point_leaving);
      if (moved == Moved::put_back) enter_put_back(work.point_leaving, state);
      if (moved == Moved::left) enter_left(model, material, work.point_leaving, state);
    }
  const bool one_block =
      model.materials.size() == 1 && state.points.n_bodies() == 1;  // in each cell: it is new with it
  const auto any_leaves = [](const CellSums& sums) { return sums.end_of_leaving > sums.first_leaving; };
  if (work.with.overlap && !one_block && std::ranges::any_of(work.cell_sums, any_leaves))
    work.with.overlap->patches.partners.clear();
  if (!state.points.update_occupied()) return;
  work.fit(model, state);
  if (state.with.mean_force) forget_mean_force(work.active_nodes, *state.with.mean_force);
}

/// Points to corners and to Gauss points, Eqs. (1) to (4).
void gather_points(const StepModel& model, const SchemeContext& context, StepState& state, Workspace& work)
{
  const SchemeFunctions& scheme = model.scheme->functions(model.method.shares);
  if (scheme.integrate != nullptr && work.with.overlap->patches.partners.empty()) {
    work.with.overlap->patches.start_blocks(state.points.n_blocks());
    for_each_group(model, state, work, [&](const auto& group, CellSums&, auto&) { set_partners(group); });
  }
  for_each_group(model, state, work, [&](const CellGroup<Quad4>& group, CellSums&, auto&) {
    for (int c = 0; c < group.n(); ++c) map_mass_and_momentum(group, c);
    scheme.gather(context, group);
    for (int c = 0; work.outer[outer_load].acts && c < group.n(); ++c) map_loads(model, state, group, c, work);
  });
  if (scheme.integrate == nullptr) return;
  work.with.overlap->patches.mark_small_partners();
  for_each_group(model, state, work, [&](const auto& group, CellSums&, auto&) { fold_patches(group); });
  for_each_group(model, state, work, [&](const auto& group, CellSums&, auto&) { scheme.integrate(context, group); });
}

/// Steps 2 to 4, or Sec. 2.2. after: what follows in each group, with the displacements of its corners.
template <class After>
void update_stress(
    const StepModel& model, const SchemeContext& context, StepState& state, Workspace& work, After&& after)
{
  const SchemeFunctions& scheme = model.scheme->functions(model.method.shares);
  if (scheme.strain != nullptr)
    for_each_group(model, state, work, [&](const CellGroup<Quad4>& group, CellSums& sums, auto&) {
      StressSums stress_sums;
      scheme.strain(context, group, displacements(model, work.node, group), stress_sums);
      enter(stress_sums, sums);
    });
  for_each_group(model, state, work, [&](const CellGroup<Quad4>& group, CellSums& sums, auto& points_leaving) {
    const auto du = displacements(model, work.node, group);
    StressSums stress_sums;
    scheme.update_stress(context, group, du, stress_sums);
    enter(stress_sums, sums);
    after(group, du, points_leaving);
  });
}

/// Then the points go on.
void update_stress_and_places(const StepModel& model, const SchemeContext& context, StepState& state, Workspace& work)
{
  update_stress(model, context, state, work, [&](const CellGroup<Quad4>& group, const auto& du, auto& points_leaving) {
    for (int c = 0; c < group.n(); ++c) {
      if (model.with.softening)
        work.with.softening->cell_softens[group.number * pack_width + c] = softens(model, group.points, group.cells[c]);
      advance_points(group.cell(c), model.mesh->centres[group.cells[c]], du[c], points_leaving);
    }
  });
}

/// What acts from outside in the step.
void start_outer(const StepModel& model, const StepState& state, Workspace& work)
{
  work.outer[outer_load].acts = false;
  if (model.with.footings) place_footings(model, state, work);
  if (model.with.loads) set_load_pressures(model, state, work);
  if (model.with.bodies) set_held_shares(model, state, work);
  if (model.with.water) set_water(model, state, work);
}

SchemeContext context_of(const StepModel& model, const StepState& state, const Workspace& work)
{
  return {.method = model.method,
      .materials = model.materials,
      .dt = model.dt,
      .inverse_extent = model.with.overlap ? model.with.overlap->inverse_extent : -1,
      .slip_row = model.with.slip ? model.with.slip->row : -1,
      .pore = model.with.water ? &work.with.water->pore : nullptr,
      .all_drains = work.settles(),
      .excess_kept = excess_kept(model, state),
      .mesh = model.mesh.get(),
      .gravity = work.gravity,
      .held = model.with.bodies ? work.with.bodies->held : HeldShares{},
      .held_row = held_row_of(model),
      .time = state.time,
      .step = state.step};
}

/// What acts from outside in this step, and what the schemes see of it.
SchemeContext begin_step(const StepModel& model, StepState& state, Workspace& work)
{
  start_sums(work);
  work.gravity = model.gravity_at(state.time + 0.5 * model.dt);  // of the middle of the step
  start_outer(model, state, work);
  return context_of(model, state, work);
}

}  // namespace

void step_compiled(const StepModel& model, StepState& state, Workspace& work)
{
  const SchemeContext context = begin_step(model, state, work);
  timed(work, points_to_cells, [&] { gather_points(model, context, state, work); });
  if (work.with.balance) timed(work, cell_acceleration, [&] { balance_pressure(model, state, work); });
  timed(work, nodes, [&] {
    for_each_node(work, [&](Index i, NodeSums& sums) {
      accelerate_node(model, state, sum_cells(model, state, work, i), i, work, sums);
    });
  });
  timed(work, cells_to_points, [&] {
    for_each_group(model, state, work, [&](const CellGroup<Quad4>& group, CellSums& sums, auto&) {
      for (int c = 0; c < group.n(); ++c) sums.relaxation += accelerate_and_map(model, work.node, group.cell(c));
    });
  });
  timed(work, velocities, [&] {
    for_each_node(
        work, [&](Index i, NodeSums& sums) { remap_velocity(model, sum_cells(model, state, work, i), i, work, sums); });
  });
  timed(work, stress, [&] { update_stress_and_places(model, context, state, work); });
  finish_sums(state, work);  // before points move and the chunks change
  if (work.watcher != nullptr) work.watcher->step(model, work);
  bool softens_now = false;
  if (model.with.softening) timed(work, softening, [&] { softens_now = find_reach_of_softening(model, state, work); });
  timed(work, move, [&] { move_leavers(model, state, work); });
  if (work.with.relaxation && !work.settles() && (state.step + 1) % noise_interval(model) == 0)
    timed(work, relaxation, [&] { relax_velocities(model, state, work); });
  if (softens_now) timed(work, softening, [&] { spread_softening(model, state, work); });

  ++state.step;
  state.time = model.time_of(state.step);
}

void find_forces_compiled(const StepModel& model, StepState& state, Workspace& work)
{
  const SchemeContext context = begin_step(model, state, work);
  timed(work, points_to_cells, [&] { gather_points(model, context, state, work); });
  timed(work, nodes, [&] {
    for_each_node(work,
        [&](Index i, NodeSums& sums) { find_force(model, state, sum_cells(model, state, work, i), i, work, sums); });
  });
  work.finite = std::ranges::all_of(work.node_sums, &NodeSums::finite);
}

void strain_compiled(const StepModel& model, StepState& state, Workspace& work)
{
  start_sums(work);
  timed(work, stress, [&] {
    update_stress(model, context_of(model, state, work), state, work, [](const auto&, const auto&, auto&) {});
  });
}

}  // namespace terp
