#include "mpm/features/footings.hpp"

#include "mpm/features/feature.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/step_state.hpp"

namespace terp {
namespace {

void fit_footings(const StepModel& model, const StepState&, Workspace& work)
{
  if (!model.with.footings) return work.with.footings.clear();
  FootingsScratch& footings = work.with.footings.made();
  footings.placed.reserve(model.with.footings->all.size());
  footings.chunk_impulses.reserve(work.node_sums.capacity());
  footings.chunk_impulses.resize(work.node_sums.size());
}

}  // namespace

std::span<const Footing> footings_of(const StepModel& model)
{
  if (!model.with.footings) return {};
  return model.with.footings->all;
}

void place_footings(const StepModel& model, const StepState& state, Workspace& work)
{
  FootingsScratch& footings = *work.with.footings;
  footings.placed.clear();
  for (FootingImpulses& impulses : footings.chunk_impulses) impulses = {};
  if (work.settles()) return;
  for (const Footing& footing : model.with.footings->all)
    footings.placed.push_back(place_footing(footing, state.time, model.dt, outline_slack(*model.mesh)));
}

void add_up_impulses(FootingsScratch& footings)
{
  footings.impulses = {};
  for (const FootingImpulses& of_chunk : footings.chunk_impulses)
    for (std::size_t k = 0; k < footings.placed.size(); ++k)
      for (int d = 0; d < 2; ++d) footings.impulses[k][d] += of_chunk[k][d];
}

TERP_FEATURE_DEFINITION(footings, .fit = &fit_footings)

}  // namespace terp
