#include "mpm/features/slip.hpp"

#include "mpm/features/feature.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/step_state.hpp"
#include "mpm/step/workspace.hpp"

namespace terp {
namespace {

void fit_slip(const StepModel& model, const StepState& state, Workspace& work)
{
  if (!model.with.slip) return work.with.slip.clear();
  fit_array(static_cast<std::size_t>(state.points.n_blocks()), work.with.slip.made().blocks);
}

}  // namespace

TERP_FEATURE_DEFINITION(slip, .fit = &fit_slip)

}  // namespace terp
