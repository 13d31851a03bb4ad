// Damping that looks at the running mean of the force. The search has its own.
#include "mpm/features/mean_force.hpp"
#include "mpm/step/now.hpp"

namespace terp {
namespace {

void follow(Nodes& nodes)
{
  if (nodes.step.work.settles()) return;
  for (int k = 0; k < nodes.n; ++k) {
    Vec<2>& mean = nodes.step.state.with.mean_force->force[nodes.number[k]];
    follow_force(nodes.step.work.damping, nodes.force[k], nodes.step.model.dt, mean);
    nodes.force[k] = mean;
  }
}

void forget(StepNow& now)
{
  if (now.work.cells_changed) forget_mean_force(now.work.active_nodes, *now.state.with.mean_force);
}

bool present(const StepModel& model, const Workspace&) { return model.damping.averaging_time > 0.0; }

using P = ScorePlace;
constexpr Kernel mean_force_score[] = {
    {P::follow, "mean force", &follow},
    {P::occupied, "mean force", &forget},
};

}  // namespace

TERP_FEATURE_KERNELS(mean_force, present)

}  // namespace terp
