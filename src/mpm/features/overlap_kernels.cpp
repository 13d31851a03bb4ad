// Shares that overlap: sums over patches, and what points find around them.
#include "mpm/step/walks.hpp"

namespace terp {
namespace {

void set_context_of_overlap(StepNow& now) { now.context.inverse_extent = now.model.with.overlap->inverse_extent; }

void find_partners(StepNow& now)
{
  PatchValues& patches = patches_of(now.work);
  if (!patches.partners.empty()) return;
  patches.start_blocks(now.state.points.n_blocks());
  for_each_group(now.model, now.state, now.work,
      [&](const CellGroup<Quad4>& group, CellSums&, auto&) { set_partners(group, patches); });
}

void mark_taken(StepNow& now) { patches_of(now.work).mark_small_partners(); }
void fold(GroupNow& now) { fold_patches(now.group, patches_of(now.step.work)); }
void leave(LayerNow& now) { now.left.leave(now.at.group, patches_of(now.at.step.work), now.layer); }

void look_around(BlockNow& now)
{
  const CellGroup<Quad4>& group = now.at.group;
  const int extent = now.context().inverse_extent;
  if (now.number == group.points.first_block(group.cells[now.c])) prefetch_extents(extent, group, now.c);
  prefetch_for_update(extent, now.block);
  PatchValues& patches = patches_of(now.at.step.work);
  now.size = patch_size(extent, group, group.cells[now.c]);
  now.patch.emplace(
      patches.partners[now.number], patches.taken_shares(now.number), now.number,
      [&](Index other) { return patches.gauss_of(other); }, patches.gauss_width);
}

/// Blocks were made or left.
void forget_partners(StepNow& now)
{
  const bool one_block =
      now.model.materials.size() == 1 && now.state.points.n_bodies() == 1;  // in each cell: it is new with it
  const auto any_leaves = [](const CellSums& sums) { return sums.end_of_leaving > sums.first_leaving; };
  if (!one_block && std::ranges::any_of(now.work.cell_sums, any_leaves)) patches_of(now.work).partners.clear();
}

using P = ScorePlace;
constexpr Kernel overlap_score[] = {
    {P::context, "overlap", &set_context_of_overlap},
    {P::partners, "overlap", &find_partners},
    {P::taken, "overlap", &mark_taken},
    {P::fold, "overlap", &fold},
    {P::leave, "overlap", &leave},
    {P::around, "overlap", &look_around},
    {P::leavers, "overlap", &forget_partners},
};

}  // namespace

TERP_FEATURE_KERNELS(overlap, slot_is_full<&ScratchSlots::overlap>)

}  // namespace terp
