// The table of the kernels of the core. Part of the kernels.

#include "mpm/step/core_kernels.hpp"

#include "mpm/step/cell_passes.hpp"
#include "mpm/step/chunk_sums.hpp"
#include "mpm/step/gauss_passes.hpp"
#include "mpm/step/node_passes.hpp"

namespace terp {
namespace {

void start_step(StepNow& now)
{
  const StepModel& model = now.model;
  start_sums(now.work);
  now.work.gravity = model.gravity_at(now.state.time + 0.5 * model.dt);  // of the middle of the step
  now.work.damping = model.damping;
  now.work.outer[outer_load].acts = false;
}

void set_context(StepNow& now)
{
  now.context.dt = now.model.dt;
  now.context.mesh = now.model.mesh.get();
  now.context.gravity = now.work.gravity;
  now.context.time = now.state.time;
  now.context.step = now.state.step;
  now.context.at_strength = now.model.at_strength(now.model.time_of(now.state.step + 1));
}

void accelerate_group(GroupNow& now)
{
  for (int c = 0; c < now.group.n(); ++c)
    now.sums.relaxation += accelerate_and_map(now.step.model, now.step.work.node, now.group.cell(c));
}

void look_on(StepNow& now)
{
  if (now.work.watcher != nullptr) now.work.watcher->step(now.model, now.work);
}

void update_occupied(StepNow& now)
{
  now.work.cells_changed = now.state.points.update_occupied();
  if (now.work.cells_changed) now.work.fit(now.model, now.state);
}

void end_step(StepNow& now)
{
  ++now.state.step;
  now.state.time = now.model.time_of(now.state.step);
}

void end_forces(StepNow& now) { now.work.finite = std::ranges::all_of(now.work.node_sums, &NodeSums::finite); }

using P = ScorePlace;
constexpr Kernel kernels_of_all[] = {
    {P::start, "sums", &start_step},
    {P::context, "step", &set_context},
    {P::mass, "points", &map_masses},
    {P::geometry, "cells", &set_geometry},
    {P::means, "Gauss points", &take_means},
    {P::force, "Gauss points", &add_force},
    {P::gather, "cells", &gather_nodes},
    {P::free, "all", &free_nodes},
    {P::trial, "damping", &accelerate_nodes},
    {P::book, "nodes", &book_nodes},
    {P::book_force, "nodes", &book_forces},
    {P::accelerate, "points", &accelerate_group},
    {P::remap, "cells", &remap_velocities},
    {P::works, "forces", &book_works},
    {P::move_corners, "nodes", &move_corners},
    {P::strain_geometry, "cells", &set_strain_geometry},
    {P::strain, "in packs", &set_strain, in_patches},
    {P::strain, "in packs, by cell", &set_strain_of_cells, cells_first | layers_first},
    {P::advance, "nodes", &move_corners, in_patches},  // in a walk of its own
    {P::advance, "points", &advance_group},
    {P::finish, "works", &finish_sums},
    {P::watch, "watcher", &look_on},
    {P::occupied, "cells", &update_occupied},
    {P::end, "time", &end_step},
    {P::end_of_forces, "nodes", &end_forces},
};

}  // namespace

std::span<const Kernel> core_kernels() { return kernels_of_all; }

}  // namespace terp
