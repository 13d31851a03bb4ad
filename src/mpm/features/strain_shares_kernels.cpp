// The way back from Gauss points to points as the transpose of the way there.
#include "mpm/features/strain_shares.hpp"
#include "mpm/step/now.hpp"

namespace terp {
namespace {

std::vector<PerGauss<Quad4>>& ratios(const GroupNow& now) { return now.step.work.with.strain_shares->ratios; }

void keep_strain_shares(LayerNow& now) { keep_ratios<Quad4>(ratios(now.at), now.layer, now.gauss); }

void hand_back_layer(LayerNow& now)
{
  now.strain = &handed_back(ratios_of<Quad4>(ratios(now.at), now.layer), *now.strain, now.own);
  now.booked_room = weights_taken(now.gauss);
  now.booked = &now.booked_room;
}

void weigh_later(LayerNow& now) { now.weighed = true; }

void weigh(LayerNow& now) { now.left.weigh(ShareRatio<Quad4, Pack>(ratios_of<Quad4>(ratios(now.at), now.layer))); }

void hand_back(BlockNow& now) { now.strain = &handed_back(ratios(now.at)[now.number], *now.strain, now.own); }

using P = ScorePlace;
constexpr Kernel strain_shares_score[] = {
    {P::keep, "strain shares", &keep_strain_shares},
    {P::layer_strain, "strain shares", &hand_back_layer, layers_first},
    {P::layer_strain, "strain shares", &weigh_later, patched_layers},
    {P::left_rows, "strain shares", &weigh},
    {P::own_strain, "strain shares", &hand_back, cells_first | layers_first},
};

}  // namespace

TERP_FEATURE_KERNELS(strain_shares, slot_is_full<&ScratchSlots::strain_shares>)

}  // namespace terp
