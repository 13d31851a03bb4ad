#include "mpm/features/mean_force.hpp"

#include "mpm/features/feature.hpp"
#include "mpm/step/state_arrays.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/step_state.hpp"

namespace terp {
namespace {

void save_mean_force(const StepState& state, ArrayWriter& arrays)
{
  if (!state.with.mean_force) return;
  std::vector<Real> values;
  for (const Vec<2>& force : state.with.mean_force->force) values.insert(values.end(), force.begin(), force.end());
  arrays.copy("mean_force", std::move(values));
}

void load_mean_force(const StepModel& model, const ArrayReader& arrays, StepState& state)
{
  if (!(model.damping.averaging_time > 0.0)) return;
  std::vector<Vec<2>> force(model.mesh->nodes.size());
  const std::vector<Real>& values = arrays.reals("mean_force", 2 * force.size());
  for (std::size_t i = 0; i < force.size(); ++i) force[i] = {values[2 * i], values[2 * i + 1]};
  state.with.mean_force.set({std::move(force)});
}

}  // namespace

void forget_mean_force(std::span<const Index> active_nodes, MeanForceState& mean)
{
  std::size_t k = 0;
  for (Index i = 0; i < std::ssize(mean.force); ++i) {
    if (k < active_nodes.size() && active_nodes[k] == i)
      ++k;
    else
      mean.force[i] = {0.0, 0.0};
  }
}

TERP_FEATURE_DEFINITION(mean_force, .save = &save_mean_force, .load = &load_mean_force)

}  // namespace terp
