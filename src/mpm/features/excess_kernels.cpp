// Excess pore pressure of undrained soil.
#include "mpm/features/pore_force.hpp"

namespace terp {
namespace {

void set_context_of_excess(StepNow& now)
{
  now.context.all_drains = now.work.settles();
  now.context.drained_keeps = excess_kept(now.model, now.state);
}

/// What soil stores is part of its internal force.
void add_point_force(BlockNow& now)
{
  if (now.material.excess_row < 0) return;
  CornerVectors<Quad4> force{};
  add_excess_force_of_points(now.geometry(), now.block, now.material.excess_row, force);
  const bool stored = stores_excess(now.context(), now.material);
  CornerVectors<Quad4>& sums = stored ? now.at.group.corners[now.c].internal_force : water_force(now.at)[now.c];
  for (int d = 0; d < 2; ++d)
    for (int i = 0; i < Quad4::n_corners; ++i) sums[d][i] += stored ? -force[d][i] : force[d][i];
}

/// The force of the excess pressure that soil of a layer stores, -u I as part of its stress.
void add_stored_force(LayerNow& now)
{
  if (now.material.excess_row < 0 || !stores_excess(now.at.step.context, now.material)) return;
  GaussValues<Quad4, Pack> water{.sigma = {}, .volume = now.gauss.volume, .weight = now.gauss.weight, .pressure = {}};
  const Pack excess = gather_excess(now);
  for (int k = 0; k < n_sym<2>; ++k) water.sigma[k].fill(k < 3 ? Pack(0.0) - excess : Pack(0.0));
  add_internal_force(now.at.group, now.at.geometry, now.layer, water, now.at.step.model.method.b_bar);
}

void leave_pressure(LayerNow& now)
{
  Workspace& work = now.at.step.work;
  now.left.set_pore(patches_of(work).gauss_width - 1, now.layer, work.with.excess->pressure);
}

/// Of the points, from the strain of their Gauss points.
void update_block(BlockNow& now)
{
  if (now.material.excess_row < 0) return;
  update_excess(now.context(), now.block, now.at.step.work.with.excess->pressure[now.number], *now.strain, now.sums());
}

/// By how much that of the points of a block lies above what is around them.
void find_shift(BlockNow& now)
{
  if (now.material.excess_row < 0) return;
  const int row = patches_of(now.at.step.work).gauss_width - 1;
  MeanAbove above;
  for (Index p = 0; p < now.block.n_padded(); p += pack_width)
    with_shares(now.block, p, now.size, [&](const auto& shares) {
      above.add(now.block, p, Pack::load(now.block.row(now.material.excess_row) + p),
          now.patch->at_points<1>(shares, row)[0]);
    });
  now.shift = above();
}

/// around(p): what the pressure of the points p ... p + 7 of the block is set to at the start of the step. own: theirs.
template <class Around>
void update_strip_of(StripNow& now, Around&& around)
{
  BlockNow& at = now.at;
  if (at.material.excess_row < 0) return;
  const ExcessStep step(at.context(), at.material);
  for (Index p = 0; p < now.n; p += pack_width) {
    Real* here = at.block.row(at.material.excess_row) + now.first + p;
    const Pack own = Pack::load(here), omega = Pack::load(at.block.row(Rows::volume) + now.first + p);
    step(own, around(now.first + p, own), trace(strain_of(now.strip, p)), omega, at.sums()).store(here);
  }
}

void update_strip_of_points(StripNow& now)
{
  update_strip_of(now, [](Index, Pack own) { return own; });
}

void update_strip_from_patch(StripNow& now)
{
  const int row = patches_of(now.at.at.step.work).gauss_width - 1;
  update_strip_of(now, [&](Index p, Pack) {
    Pack around;
    with_shares(
        now.at.block, p, now.at.size, [&](const auto& shares) { around = now.at.patch->at_points<1>(shares, row)[0]; });
    return around + now.at.shift;
  });
}

void update_block_from_patch(BlockNow& now)
{
  if (now.material.excess_row < 0) return;
  update_excess_from_patch(
      now.context(), now.block, now.size, *now.patch, patches_of(now.at.step.work).gauss_width - 1, now.sums());
}

using P = ScorePlace;
constexpr Kernel excess_score[] = {
    {P::context, "excess", &set_context_of_excess},
    {P::clear, "pore pressure", &clear_water_force},
    {P::point_force, "excess", &add_point_force},
    {P::pore_force, "pore pressure", &add_water_force},
    {P::pore_force, "excess, stored", &add_stored_force},
    {P::left_rows, "excess", &leave_pressure},
    {P::pore, "excess", &update_block, cells_first | layers_first},
    {P::pore, "excess", &find_shift, patched_cells},
    {P::pore, "excess", &update_block_from_patch, patched_layers},
    {P::strip, "excess", &update_strip_of_points, at_points},
    {P::strip, "excess", &update_strip_from_patch, patched_cells},
    {P::outer_force, "pore pressure", &add_water_forces},
};

}  // namespace

TERP_FEATURE_KERNELS(excess, slot_is_full<&ScratchSlots::excess>)

}  // namespace terp
