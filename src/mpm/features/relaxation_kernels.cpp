// Velocities that the nodes do not see fade.
#include "mpm/features/relaxation_passes.hpp"

namespace terp {
namespace {

void fade(StepNow& now)
{
  if (!now.work.settles() && (now.state.step + 1) % noise_interval(now.model) == 0)
    relax_velocities(now.model, now.state, now.work);
}

using P = ScorePlace;
constexpr Kernel relaxation_score[] = {
    {P::fade, "relaxation", &fade},
};

}  // namespace

TERP_FEATURE_KERNELS(relaxation, slot_is_full<&ScratchSlots::relaxation>)

}  // namespace terp
