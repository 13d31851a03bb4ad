// The score: one explicit step as a short list of named, timed passes. Equation numbers are the paper's.

#include "mpm/step/kernels.hpp"

#include "mpm/points/move.hpp"
#include "mpm/schemes/patch_group.hpp"
#include "mpm/features/balance_passes.hpp"
#include "mpm/step/cell_passes.hpp"
#include "mpm/step/node_passes.hpp"
#include "mpm/step/outer_passes.hpp"
#include "mpm/step/point_noise.hpp"
#include "mpm/step/softening_passes.hpp"

namespace terp {
namespace {

template <class F>
void timed(Workspace& work, Pass pass, F&& f)
{
  const auto start = std::chrono::steady_clock::now();
  f();
  work.seconds[pass] += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Calls f(group, sums of the chunk, points_leaving of the thread) for the occupied cells in groups of eight
/// neighbours.
template <class F>
void for_each_group(const StepModel& model, StepState& state, Workspace& work, F&& f)
{
  static_assert(cells_per_chunk % pack_width == 0);
  work.threads.for_each_range(static_cast<Index>(state.points.occupied().size()), cells_per_chunk,
      [&](Index begin, Index end, Index chunk, int thread) {
        CellSums& sums = work.cell_sums[chunk];
        std::vector<PointPlace>& points_leaving = work.points_leaving[thread];
        sums.thread = thread;
        sums.first_leaving = points_leaving.size();
        for (Index slot = begin; slot < end; slot += pack_width)
          f(view_group(model, state, work, slot, std::min(slot + pack_width, end)), sums, points_leaving);
        sums.end_of_leaving = points_leaving.size();
      });
}

template <class F>
void for_each_node(Workspace& work, F&& f)
{
  work.threads.for_each_range(
      static_cast<Index>(work.active_nodes.size()), nodes_per_chunk, [&](Index begin, Index end, Index chunk, int) {
        for (Index k = begin; k < end; ++k) f(work.active_nodes[k], work.node_sums[chunk]);
      });
}

/// Part of its excess pressure that soil keeps which has become drained: it falls to zero over the ramp of the stage.
Real excess_kept(const StepModel& model, const StepState& state)
{
  const Real before = 1.0 - model.ramp.share_at(state.time);
  return before > 0.0 ? (1.0 - model.ramp.share_at(model.time_of(state.step + 1))) / before : 0.0;
}

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
    for (std::size_t k = 0; k < work.footings.size(); ++k)
      for (int d = 0; d < 2; ++d) total.footing[k][d] += sums.footing[k][d];
  }
  work.footing_impulse = total.footing;
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
  work.fastest_node = std::sqrt(total.fastest);
  work.search.stiffness = total.stiffness;
  work.search.inertia = total.inertia;
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

/// The mean force of damping is zero again at nodes without soil, where soil that comes back begins anew.
void forget_mean_force(std::span<const Index> active_nodes, std::span<Vec<2>> mean_force)
{
  std::size_t k = 0;
  for (Index i = 0; i < std::ssize(mean_force); ++i) {
    if (k < active_nodes.size() && active_nodes[k] == i)
      ++k;
    else
      mean_force[i] = {0.0, 0.0};
  }
}

void move_leavers(const StepModel& model, StepState& state, Workspace& work)
{
  for (const CellSums& sums : work.cell_sums)
    for (std::size_t k = sums.end_of_leaving;
         k-- > sums.first_leaving;) {  // from the last lane of a block to the first: see take()
      const PointPlace place = work.points_leaving[sums.thread][k];
      const Index material = state.points.block(place.block).material;
      const Moved moved = move_to_new_cell(*model.mesh, model.open_sides, state.points, place, work.point_leaving);
      if (moved == Moved::put_back) enter_put_back(work.point_leaving, state);
      if (moved == Moved::left) enter_left(model, material, work.point_leaving, state);
    }
  const bool one_block =
      model.materials.size() == 1 && state.points.n_bodies() == 1;  // in each cell: it is new with it
  if (!one_block && std::ranges::any_of(
                        work.cell_sums, [](const CellSums& sums) { return sums.end_of_leaving > sums.first_leaving; }))
    work.patches->partners.clear();
  if (!state.points.update_occupied()) return;
  work.fit(model, state);
  if (!state.mean_force.empty()) forget_mean_force(work.active_nodes, state.mean_force);
}

/// The strength of the next step follows what softened in this one, spread over the length of each material. Only
/// where that can reach.
void spread_softening(const StepModel& model, StepState& state, Workspace& work)
{
  NodeSpread& spread = *work.softening;
  const SofteningReach& reach = work.softening_reach;
  const auto for_each_cell = [&](auto&& f) {
    const std::vector<Index>& cells = state.points.occupied();
    work.threads.for_each_range(
        static_cast<Index>(cells.size()), cells_per_chunk, [&](Index begin, Index end, Index, int) {
          for (Index slot = begin; slot < end; ++slot)
            if (reach.has_cell[cells[slot]] != 0) f(slot, cells[slot]);
        });
  };
  const auto for_each_node_group = [&](auto&& f) {
    work.threads.for_each_range(
        model.diffusion->n_groups(), nodes_per_chunk / pack_width, [&](Index begin, Index end, Index, int) {
          for (Index g = begin; g < end; ++g)
            if (reach.has_any_of_group(g)) f(g);
        });
  };
  for_each_cell(
      [&](Index slot, Index cell) { collect_softening(model, state.points, cell, work.softening_corners[slot]); });
  for (NodeNumbers* numbers : {&spread.value, &spread.next, &spread.filling}) numbers->clear();
  for_each_node_group([&](Index g) { gather_group(model, state, work, g, spread); });
  for_each_node_group([&](Index g) { set_rates(*model.diffusion, g, spread); });
  for (int n = 0; n < model.diffusion->n_substeps; ++n) {
    for_each_node_group([&](Index g) { spread_nodes(*model.diffusion, g, spread); });
    std::swap(spread.value, spread.next);
  }
  for_each_cell([&](Index, Index cell) { soften_points(model, state.points, cell, spread.value); });
}

/// What points move against each other unseen by the nodes fades.
void relax_velocities(const StepModel& model, StepState& state, Workspace& work)
{
  const std::vector<Index>& cells = state.points.occupied();
  const Real time = static_cast<Real>(noise_interval(model)) * model.dt;
  const Real share = 1.0 - std::exp(-time / model.method.relaxation_time);
  const auto for_each_cell = [&](auto&& f) {
    work.threads.for_each_range(
        static_cast<Index>(cells.size()), cells_per_chunk, [&](Index begin, Index end, Index chunk, int) {
          for (Index slot = begin; slot < end; ++slot) f(slot, cells[slot], chunk);
        });
  };
  const auto take_means = [&] {
    for_each_node(work, [&](Index i, NodeSums&) { work.fitted[i] = mean_of_fits(model, state, work, i); });
  };
  const auto corners_of = [&](Index cell) {
    std::array<Vec<2>, Quad4::n_corners> at;
    for (int i = 0; i < Quad4::n_corners; ++i) at[i] = work.fitted[model.mesh->cells[cell][i]];
    return at;
  };
  for_each_cell([&](Index slot, Index cell, Index) { sum_corner_fit(state.points, cell, work.fits[slot]); });
  take_means();
  for_each_cell([&](Index slot, Index cell, Index) { solve_corner_fit(corners_of(cell), work.fits[slot]); });
  take_means();
  for (CellSums& sums : work.cell_sums) sums.relaxation = 0.0;
  for_each_cell([&](Index, Index cell, Index chunk) {
    work.cell_sums[chunk].relaxation += relax_points(state.points, cell, corners_of(cell), share);
  });
  for (const CellSums& sums : work.cell_sums) state.work.relaxation += sums.relaxation;
}

/// Points to corners and to Gauss points, Eqs. (1) to (4).
void gather_points(const StepModel& model, const SchemeContext& context, StepState& state, Workspace& work)
{
  const SchemeFunctions& scheme = model.scheme->functions(model.method.shares);
  if (scheme.integrate != nullptr && work.patches->partners.empty()) {
    work.patches->start_blocks(state.points.n_blocks());
    for_each_group(model, state, work, [&](const auto& group, CellSums&, auto&) { set_partners(group); });
  }
  for_each_group(model, state, work, [&](const CellGroup<Quad4>& group, CellSums&, auto&) {
    for (int c = 0; c < group.n(); ++c) map_mass_and_momentum(group, c);
    scheme.gather(context, group);
    for (int c = 0; work.outer[outer_load].acts && c < group.n(); ++c) map_loads(model, state, group, c, work);
  });
  if (scheme.integrate == nullptr) return;
  work.patches->mark_small_partners();
  for_each_group(model, state, work, [&](const auto& group, CellSums&, auto&) { fold_patches(group); });
  for_each_group(model, state, work, [&](const auto& group, CellSums&, auto&) { scheme.integrate(context, group); });
}

/// The acceleration of each cell in this step, for the slope of its pressure: Jacobi sweeps, of which each takes a
/// tenth of the error (decision 0068).
void balance_pressure(const StepModel& model, const StepState& state, Workspace& work)
{
  constexpr int n_sweeps = 3;
  const auto for_each_slot = [&](auto&& f) {
    work.threads.for_each_range(
        static_cast<Index>(work.balance.size()), cells_per_chunk, [&](Index begin, Index end, Index, int) {
          for (Index slot = begin; slot < end; ++slot) f(slot);
        });
  };
  for_each_node(work, [&](Index i, NodeSums&) { start_balance(model, state, i, work); });
  for (int sweep = 0; sweep < n_sweeps; ++sweep) {
    for_each_node(work, [&](Index i, NodeSums&) { accelerate_for_balance(model, state, i, work); });
    for_each_slot([&](Index slot) { set_cell_acceleration(model, state, slot, work); });
  }
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
      if (model.spreads_softening())
        work.cell_softens[group.number * pack_width + c] = softens(model, group.points, group.cells[c]);
      advance_points(group.cell(c), model.mesh->centres[group.cells[c]], du[c], points_leaving);
    }
  });
}

SchemeContext context_of(const StepModel& model, const StepState& state, const Workspace& work)
{
  return {.method = model.method,
      .materials = model.materials,
      .dt = model.dt,
      .inverse_extent = model.inverse_extent,
      .slip_row = model.slip_row,
      .pore = model.water ? &work.pore : nullptr,
      .all_drains = work.settling,
      .excess_kept = excess_kept(model, state),
      .mesh = model.mesh.get(),
      .gravity = work.gravity,
      .held = work.held,
      .held_row = model.held_row,
      .time = state.time,
      .step = state.step};
}

/// What acts from outside in this step, and what the schemes see of it.
SchemeContext begin_step(const StepModel& model, StepState& state, Workspace& work)
{
  start_sums(work);
  work.gravity = model.gravity_at(state.time + 0.5 * model.dt);  // of the middle of the step
  place_footings(model, state, work);
  if (model.has_loads()) set_load_pressures(model, state, work);
  if (model.water) set_water(model, state, work);
  return context_of(model, state, work);
}

}  // namespace

void step_compiled(const StepModel& model, StepState& state, Workspace& work)
{
  const SchemeContext context = begin_step(model, state, work);
  timed(work, points_to_cells, [&] { gather_points(model, context, state, work); });
  if (!work.balance.empty()) timed(work, cell_acceleration, [&] { balance_pressure(model, state, work); });
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
  if (model.spreads_softening())
    timed(work, softening, [&] { softens_now = find_reach_of_softening(model, state, work); });
  timed(work, move, [&] { move_leavers(model, state, work); });
  if (model.method.relaxation_time > 0.0 && !work.settling && (state.step + 1) % noise_interval(model) == 0)
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
