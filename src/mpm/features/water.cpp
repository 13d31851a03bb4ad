#include "mpm/features/water.hpp"

#include "mpm/features/feature.hpp"
#include "mpm/features/loads.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/step_state.hpp"
#include "mpm/step/workspace.hpp"

#include <algorithm>

namespace terp {
namespace {

void fit_water(const StepModel& model, const StepState& state, Workspace& work)
{
  if (!model.with.water) return work.with.water.clear();
  work.with.water.made().loads.reserve(load_pressures(work).size());
  work.outer[outer_water].acts = true;
  fit_outer(model, state, work.outer[outer_water]);
}

}  // namespace

void set_water(const StepModel& model, const StepState& state, Workspace& work)
{
  WaterScratch& water = *work.with.water;
  const Real share = model.ramp.share_at(state.time + 0.5 * model.dt);
  const bool holds_bodies = model.with.bodies != nullptr;
  const WaterMoment moment =
      model.with.water->moment_at(model.stage.water, state.time, share, -work.gravity[1], holds_bodies);
  const std::span<const Real> loads = load_pressures(work);
  if (moment == water.moment && std::ranges::equal(loads, water.loads)) return;
  model.with.water->set(moment, loads, share, water.pore);
  water.moment = moment;
  water.loads.assign(loads.begin(), loads.end());
}

std::span<const Real> node_pressures(const Workspace& work)
{
  if (!work.with.water) return {};
  return work.with.water->pore.pressure;
}

void forget_water(Workspace& work)
{
  if (work.with.water) work.with.water->moment.time = std::numeric_limits<Real>::quiet_NaN();
}

TERP_FEATURE_DEFINITION(water, .fit = &fit_water)

}  // namespace terp
