// The slope of the pressure within the cells.
#include "mpm/features/balance_passes.hpp"
#include "mpm/features/pressure_balance.hpp"

namespace terp {
namespace {

void clear(GroupNow& now)
{
  for (CellBalance& of_cell : now.here(std::span(now.step.work.with.balance->cells))) of_cell = {};
  for (auto& force : now.here(std::span(now.step.work.outer[outer_balance].corners))) force = {};
}

void add_slope(LayerNow& now)
{
  GroupNow& at = now.at;
  Workspace& work = at.step.work;
  add_balance(at.step.context, at.group, at.geometry, now.layer, now.gauss, at.within,
      at.here(std::span(work.with.balance->cells)), at.here(std::span(work.outer[outer_balance].corners)));
}

void sweep(StepNow& now) { balance_pressure(now); }

void add_forces(Nodes& nodes)
{
  const StepNow& now = nodes.step;
  add_outer_forces(nodes, now.work.outer[outer_balance], [&](Index i, Vec<2>& force) {
    const Vec<2> slope = sum_balance(now.model, now.state, now.work, i);
    for (int d = 0; d < 2; ++d) force[d] += slope[d];
  });
}

using P = ScorePlace;
constexpr Kernel balance_score[] = {
    {P::surface, "surface", &find_surface},
    {P::gradient, "balance", &clear},
    {P::slope, "balance", &add_slope},
    {P::cell_force, "balance", &sweep},
    {P::outer_force, "balance", &add_forces},
};

}  // namespace

TERP_FEATURE_KERNELS(balance, slot_is_full<&ScratchSlots::balance>)

}  // namespace terp
