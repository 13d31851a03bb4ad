#include "mpm/features/bodies.hpp"

#include "mpm/features/feature.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/step_state.hpp"
#include "mpm/step/workspace.hpp"

#include <cmath>

namespace terp {
namespace {

void fit_bodies(const StepModel& model, const StepState& state, Workspace& work)
{
  if (!model.with.bodies) return work.with.bodies.clear();
  work.with.bodies.made();
  fit_outer(model, state, work.outer[outer_load]);
}

}  // namespace

int held_row_of(const StepModel& model) { return model.with.bodies ? model.with.bodies->held_row : -1; }

std::int64_t step_of_removal(const StepModel& model, const StepState& state)
{
  return state.stage_start + std::llround(model.ramp.duration / model.dt);
}

void set_held_shares(const StepModel& model, const StepState& state, Workspace& work)
{
  HeldShares& held = work.with.bodies->held;
  held = {};
  if (work.settles()) return;
  const BodiesModel& bodies = *model.with.bodies;
  const Real let_go = model.ramp.share_at(state.time + 0.5 * model.dt);
  if (bodies.places) held.placed = 1.0 - let_go;
  if (bodies.removes && state.step < step_of_removal(model, state)) held.removed = let_go;
  work.outer[outer_load].acts |= held.act();
}

TERP_FEATURE_DEFINITION(bodies, .fit = &fit_bodies)

}  // namespace terp
