#include "mpm/features/loads.hpp"

#include "mpm/features/feature.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/step_state.hpp"
#include "mpm/step/workspace.hpp"

namespace terp {
namespace {

void fit_loads(const StepModel& model, const StepState& state, Workspace& work)
{
  if (!model.with.loads) return work.with.loads.clear();
  work.with.loads.made().pressure.resize(model.with.loads->all.size());
  fit_outer(model, state, work.outer[outer_load]);
}

}  // namespace

std::span<const Load> loads_of(const StepModel& model)
{
  if (!model.with.loads) return {};
  return model.with.loads->all;
}

Real pressure_of(const StepModel& model, const Load& load, Real time)
{
  return load.pressure_at(time, model.ramp.share_at(time));
}

std::span<const Real> load_pressures(const Workspace& work)
{
  if (!work.with.loads) return {};
  return work.with.loads->pressure;
}

void set_load_pressures(const StepModel& model, const StepState& state, Workspace& work)
{
  const Real time = state.time + 0.5 * model.dt;
  const LoadsModel& loads = *model.with.loads;
  std::vector<Real>& pressure = work.with.loads->pressure;
  bool acts = false;
  for (std::size_t k = 0; k < loads.all.size(); ++k) {
    const bool waits = work.settles() && !loads.all[k].is_permanent();
    pressure[k] = waits ? 0.0 : pressure_of(model, loads.all[k], time);
    acts |= pressure[k] != 0.0;
  }
  work.outer[outer_load].acts |= acts || loads.body_force;
}

TERP_FEATURE_DEFINITION(loads, .fit = &fit_loads)

}  // namespace terp
