#include "mpm/features/excess.hpp"

#include "mpm/features/feature.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/step_state.hpp"
#include "mpm/step/workspace.hpp"

#include <algorithm>

namespace terp {
namespace {

void fit_excess(const StepModel& model, const StepState& state, Workspace& work)
{
  if (!has_excess_pressure(model)) return work.with.excess.clear();
  fit_array(static_cast<std::size_t>(state.points.n_blocks()), work.with.excess.made().pressure);
  work.outer[outer_water].acts = true;
  fit_outer(model, state, work.outer[outer_water]);
}

}  // namespace

bool has_excess_pressure(const StepModel& model)
{
  return std::ranges::any_of(model.materials, [](const SoilMaterial& m) { return m.excess_row >= 0; });
}

Real excess_kept(const StepModel& model, const StepState& state)
{
  const Real before = 1.0 - model.ramp.share_at(state.time);
  return before > 0.0 ? (1.0 - model.ramp.share_at(model.time_of(state.step + 1))) / before : 0.0;
}

TERP_FEATURE_DEFINITION(excess, .fit = &fit_excess)

}  // namespace terp
