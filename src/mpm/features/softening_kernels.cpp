// Softening that spreads over a length.
#include "mpm/features/softening_passes.hpp"

namespace terp {
namespace {

void mark(GroupNow& now)
{
  const CellGroup<Quad4>& group = now.group;
  std::vector<std::uint8_t>& marks = now.step.work.with.softening->cell_softens;
  for (int c = 0; c < group.n(); ++c)
    marks[group.number * pack_width + c] = softens(now.step.model, group.points, group.cells[c]);
}

void find_reach(StepNow& now) { find_reach_of_softening(now.model, now.state, now.work); }

void spread(StepNow& now)
{
  if (!now.work.with.softening->reach.cells.empty()) spread_softening(now.model, now.state, now.work);
}

using P = ScorePlace;
constexpr Kernel softening_score[] = {
    {P::mark, "softening", &mark},
    {P::reach, "softening", &find_reach},
    {P::spread, "softening", &spread},
};

}  // namespace

TERP_FEATURE_KERNELS(softening, slot_is_full<&ScratchSlots::softening>)

}  // namespace terp
