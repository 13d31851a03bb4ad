// Soils that slip in the cells that they share.
#include "mpm/features/cut_cells.hpp"
#include "mpm/features/slip.hpp"
#include "mpm/step/now.hpp"

namespace terp {
namespace {

std::span<BlockSlip> slips(const GroupNow& now) { return now.step.work.with.slip->blocks; }

void set_context_of_slip(StepNow& now) { now.context.work_row = now.model.with.slip->row; }
void keep(LayerNow& now) { keep_mean_stress<Quad4>(slips(now.at), now.layer, now.gauss); }
void find(GroupNow& now) { find_slips(now.step.context, now.group, slips(now)); }

void take_kinks(GroupNow& now)
{
  now.strained = &without_kinks(now.group, slips(now), now.du, now.room, now.stress.slip_work);
}

void lose(GroupNow& now) { now.stress.slip_work += lost_by_slipping(now.group, slips(now)); }
void slip_layer(LayerNow& now) { now.strain = &with_slips<Quad4>(slips(now.at), now.layer, *now.strain, now.own); }
void slip_block(BlockNow& now) { now.strain = &with_slip<Quad4>(slips(now.at), now.number, *now.strain, now.own); }

void lose_as_law_runs(BlockNow& now)
{
  now.sums().slip_work += lost_while_slipping(now.block, slips(now.at)[now.number]);
}

using P = ScorePlace;
constexpr Kernel slip_score[] = {
    {P::context, "slip", &set_context_of_slip},
    {P::keep, "slip", &keep},
    {P::border, "slip", &find},
    {P::kinks, "slip", &take_kinks},
    {P::border_loss, "slip", &lose},
    {P::layer_border, "slip", &slip_layer},
    {P::border_strain, "slip", &slip_block, cells_first | layers_first},
    {P::block_loss, "slip", &lose_as_law_runs},
};

}  // namespace

TERP_FEATURE_KERNELS(slip, slot_is_full<&ScratchSlots::slip>)

}  // namespace terp
