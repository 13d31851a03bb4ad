// The largest speed of the nodes.
#include "mpm/features/rest.hpp"
#include "mpm/step/node_passes.hpp"

namespace terp {
namespace {

void find_fastest(Nodes& nodes)
{
  for (int k = 0; k < nodes.n; ++k)
    if (nodes.mass[k] >= part_of_full_mass(nodes.step.model, nodes.number[k], part_that_rests)) {
      const Vec<2> v = nodes.v_star[k];
      nodes.sums.fastest = std::max(nodes.sums.fastest, v[0] * v[0] + v[1] * v[1]);
    }
}

void finish_rest(StepNow& now)
{
  Real fastest = 0.0;
  for (const NodeSums& sums : now.work.node_sums) fastest = std::max(fastest, sums.fastest);
  now.work.with.rest->fastest_node = std::sqrt(fastest);
}

using P = ScorePlace;
constexpr Kernel rest_score[] = {
    {P::works, "rest", &find_fastest},
    {P::finish, "rest", &finish_rest},
};

}  // namespace

TERP_FEATURE_KERNELS(rest, slot_is_full<&ScratchSlots::rest>)

}  // namespace terp
