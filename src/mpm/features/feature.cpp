#include "mpm/features/feature.hpp"

#include "mpm/step/step_model.hpp"
#include "mpm/step/step_state.hpp"

namespace terp {

#define TERP_FEATURE(slot, Name) extern const Feature feature_##slot;
#include "mpm/features/features.def"
#undef TERP_FEATURE

std::span<const Feature* const> all_features()
{
  static constexpr const Feature* features[] = {
#define TERP_FEATURE(slot, Name) &feature_##slot,
#include "mpm/features/features.def"
#undef TERP_FEATURE
  };
  return features;
}

void fit_outer_nodes(const StepModel& model, OuterForces& outer) { outer.node.resize(model.mesh->nodes.size()); }

void fit_outer(const StepModel& model, const StepState& state, OuterForces& outer)
{
  fit_outer_nodes(model, outer);
  fit_array(state.points.occupied().size(), outer.corners);
}

}  // namespace terp
