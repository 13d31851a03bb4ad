#include "mpm/features/relaxation.hpp"

#include "mpm/features/feature.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/step_state.hpp"
#include "mpm/step/workspace.hpp"

namespace terp {
namespace {

void fit_relaxation(const StepModel& model, const StepState& state, Workspace& work)
{
  if (!(model.method.relaxation_time > 0.0)) return work.with.relaxation.clear();
  RelaxationScratch& relaxation = work.with.relaxation.made();
  fit_array(state.points.occupied().size(), relaxation.fits);
  relaxation.fitted.resize(model.mesh->nodes.size());
}

}  // namespace

TERP_FEATURE_DEFINITION(relaxation, .fit = &fit_relaxation)

}  // namespace terp
