#include "mpm/features/volume_change.hpp"

#include "mpm/features/feature.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/step_state.hpp"
#include "mpm/step/workspace.hpp"

namespace terp {
namespace {

void fit_volume_change(const StepModel& model, const StepState& state, Workspace& work)
{
  const bool of_soil = model.method.volume_change == VolumeChange::soil;
  if (!of_soil || !looks_at(*model.scheme, "volume_change")) return work.with.volume_change.clear();
  const auto n_cells = static_cast<Index>(state.points.occupied().size());
  const auto n_groups = static_cast<std::size_t>(Threads::n_chunks(n_cells, pack_width));
  auto& gradients = work.with.volume_change.made().gradients;
  if (gradients.size() < n_groups) gradients.make_anew(2 * n_groups);
}

}  // namespace

TERP_FEATURE_DEFINITION(volume_change, .fit = &fit_volume_change)

}  // namespace terp
