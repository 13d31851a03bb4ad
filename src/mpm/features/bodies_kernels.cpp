// The weight of bodies that come or go.
#include "mpm/features/loads_passes.hpp"

namespace terp {
namespace {

void set_shares(StepNow& now) { set_held_shares(now.model, now.state, now.work); }

void set_context_of_bodies(StepNow& now)
{
  now.context.held = now.work.with.bodies->held;
  now.context.held_row = held_row_of(now.model);
}

using P = ScorePlace;
constexpr Kernel bodies_score[] = {
    {P::outside, "bodies", &set_shares},
    {P::context, "bodies", &set_context_of_bodies},
    {P::load, "forces on points", &map_loads_of_group},
    {P::outer_force, "forces on points", &add_loads},
};

}  // namespace

TERP_FEATURE_KERNELS(bodies, slot_is_full<&ScratchSlots::bodies>)

}  // namespace terp
