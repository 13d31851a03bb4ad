#include "mpm/features/balance.hpp"

#include "mpm/features/feature.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/step_state.hpp"
#include "mpm/step/workspace.hpp"

namespace terp {
namespace {

/// Forces of the cells are needed only where more than weight and acceleration has a part in the slope.
void fit_balance(const StepModel& model, const StepState& state, Workspace& work)
{
  const bool balanced = model.method.pressure == Pressure::balanced;
  if (!balanced || !looks_at(*model.scheme, "pressure")) return work.with.balance.clear();
  BalanceScratch& balance = work.with.balance.made();
  fit_array(state.points.occupied().size(), balance.cells);
  balance.nodes.resize(model.mesh->nodes.size());
  OuterForces& outer = work.outer[outer_balance];
  outer.acts = true;
  fit_outer_nodes(model, outer);
  if (model.with.water || model.with.bodies) fit_outer(model, state, outer);
}

}  // namespace

TERP_FEATURE_DEFINITION(balance, .fit = &fit_balance)

}  // namespace terp
