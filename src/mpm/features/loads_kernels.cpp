// Loads on the points, and forces.body.
#include "mpm/features/loads_passes.hpp"

namespace terp {
namespace {

void set_pressures(StepNow& now) { set_load_pressures(now.model, now.state, now.work); }

using P = ScorePlace;
constexpr Kernel loads_score[] = {
    {P::outside, "loads", &set_pressures},
    {P::load, "forces on points", &map_loads_of_group},
    {P::outer_force, "forces on points", &add_loads},
};

}  // namespace

TERP_FEATURE_KERNELS(loads, slot_is_full<&ScratchSlots::loads>)

}  // namespace terp
