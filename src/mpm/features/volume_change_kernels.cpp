// The volume change of a cell as that of its soil.
#include "mpm/features/volume_change.hpp"
#include "mpm/features/volume_gradient.hpp"

namespace terp {
namespace {

void set_gradient(GroupNow& now)
{
  set_volume_gradient(
      now.group, now.within, [&](const BlockLayer& layer) { return now.gauss_of(layer).volume; }, now.geometry,
      now.step.work.with.volume_change->gradients[now.group.number]);
}

void take_gradient(GroupNow& now)
{
  now.geometry.centre_gradient = now.step.work.with.volume_change->gradients[now.group.number];
}

using P = ScorePlace;
constexpr Kernel volume_change_score[] = {
    {P::surface, "surface", &find_surface},
    {P::gradient, "volume change", &set_gradient},
    {P::strain_geometry, "volume change", &take_gradient},
};

}  // namespace

TERP_FEATURE_KERNELS(volume_change, slot_is_full<&ScratchSlots::volume_change>)

}  // namespace terp
