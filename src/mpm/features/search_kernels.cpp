// The search for equilibrium: forces that are held, and damping that follows the slowest motion.
#include "mpm/features/search.hpp"
#include "mpm/step/now.hpp"

namespace terp {
namespace {

void set_damping(StepNow& now)
{
  now.work.damping.local = now.work.with.search->damping_local;
  now.work.damping.viscous += now.work.with.search->viscous;
}

void hold_search(Nodes& nodes)
{
  for (int k = 0; k < nodes.n; ++k) hold_back(*nodes.step.work.with.search, nodes.number[k], nodes.out_of_balance[k]);
}

void follow_search(Nodes& nodes)
{
  SearchScratch& search = *nodes.step.work.with.search;
  for (int k = 0; k < nodes.n; ++k)
    follow_motion(search, nodes.number[k], nodes.force[k], nodes.v[k], nodes.mass[k] * nodes.step.model.dt, nodes.sums);
}

void finish_search(StepNow& now)
{
  SearchScratch& search = *now.work.with.search;
  search.stiffness = search.inertia = 0.0;
  for (const NodeSums& sums : now.work.node_sums) search.stiffness += sums.stiffness, search.inertia += sums.inertia;
}

using P = ScorePlace;
constexpr Kernel search_score[] = {
    {P::outside, "search", &set_damping},
    {P::hold, "search", &hold_search},
    {P::follow, "search", &follow_search},
    {P::finish, "search", &finish_search},
};

}  // namespace

TERP_FEATURE_KERNELS(search, slot_is_full<&ScratchSlots::search>)

}  // namespace terp
