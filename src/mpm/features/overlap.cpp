#include "mpm/features/overlap.hpp"

#include "math/errors.hpp"
#include "mpm/features/excess.hpp"
#include "mpm/features/feature.hpp"
#include "mpm/features/patch_rows.hpp"
#include "mpm/step/step_model.hpp"
#include "mpm/step/step_state.hpp"
#include "mpm/step/workspace.hpp"

#include <algorithm>

namespace terp {
namespace {

std::size_t n_packs(std::size_t n) { return (n + pack_width - 1) / pack_width; }

PatchValues make_patches(const StepModel& model, const StepState& state, Index n_gauss_rows)
{
  PatchValues patches;
  const std::size_t most = 2 * static_cast<std::size_t>(state.points.n_blocks());
  const int n_excess = has_excess_pressure(model) ? 1 : 0, n_work = model.with.slip ? 1 : 0;
  patches.cells = find_patch_partners(*model.mesh);
  patches.excess_place = patch_others + n_gauss_rows;
  patches.sum_width = patches.excess_place + n_excess;
  patches.gauss_width =
      (model.scheme->keeps_gauss_values ? HistoryRows::end + n_work : StrainRows::end) + n_gauss_rows + n_excess;
  TERP_ASSERT(std::max(patches.sum_width, patches.gauss_width) <= PatchView::most_rows);
  patches.partners.reserve(most);
  patches.taken.reserve(most);
  patches.folds.reserve(most);
  patches.sums.reserve(n_packs(most * Patch<Quad4>::n_slots * patches.sum_width));
  patches.gauss.reserve(n_packs(most * Quad4::n_gauss * patches.gauss_width));
  return patches;
}

void fit_overlap(const StepModel& model, const StepState& state, Workspace& work)
{
  if (!model.with.overlap) return work.with.overlap.clear();
  Slot<OverlapScratch>& slot = work.with.overlap;
  if (!slot) slot.set({make_patches(model, state, work.n_gauss_rows)});
  PatchValues& patches = slot->patches;
  const auto n = static_cast<std::size_t>(state.points.n_blocks());
  patches.partners.clear();
  patches.sums.resize(n_packs(n * Patch<Quad4>::n_slots * patches.sum_width));
  patches.gauss.resize(n_packs(n * Quad4::n_gauss * patches.gauss_width));
}

}  // namespace

TERP_FEATURE_DEFINITION(overlap, .fit = &fit_overlap)

}  // namespace terp
