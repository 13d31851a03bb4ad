#include "mpm/features/softening.hpp"

#include "mpm/features/feature.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/step_state.hpp"
#include "mpm/step/workspace.hpp"

namespace terp {
namespace {

SofteningScratch make_scratch(const NodeDiffusion& diffusion, const Mesh<2>& mesh)
{
  SofteningScratch softening{.spread = NodeSpread(diffusion)};
  softening.reach.has_cell.resize(mesh.cells.size());
  softening.reach.has_node.resize(pack_width * static_cast<std::size_t>(diffusion.n_groups()));
  softening.reach.cells.reserve(mesh.cells.size());
  return softening;
}

void fit_softening(const StepModel& model, const StepState& state, Workspace& work)
{
  if (!model.with.softening) return work.with.softening.clear();
  Slot<SofteningScratch>& slot = work.with.softening;
  if (!slot) slot.set(make_scratch(model.with.softening->diffusion, *model.mesh));
  fit_array(state.points.occupied().size(), slot->corners);
  fit_array(state.points.occupied().size(), slot->cell_softens);
}

}  // namespace

TERP_FEATURE_DEFINITION(softening, .fit = &fit_softening)

}  // namespace terp
