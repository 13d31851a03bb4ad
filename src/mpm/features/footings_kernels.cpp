// What rigid footings do to nodes.
#include "mpm/features/footings.hpp"
#include "mpm/step/now.hpp"

namespace terp {
namespace {

void place(StepNow& now) { place_footings(now.model, now.state, now.work); }

/// f(k, number of the footing) for the nodes inside.
template <class F>
void for_each_inside(const Nodes& nodes, F&& f)
{
  const StepNow& now = nodes.step;
  for (int k = 0; k < nodes.n; ++k)
    if (const int number = footing_at(now.work, now.model.mesh->nodes[nodes.number[k]]); number >= 0) f(k, number);
}

void free_part(Nodes& nodes)
{
  for_each_inside(nodes, [&](int k, int number) {
    const PlacedFooting& footing = nodes.step.work.with.footings->placed[number];
    nodes.force[k] = footing.free_part(nodes.force[k]);
    nodes.v[k] = footing.free_part(nodes.v[k]);
  });
}

void push(Nodes& nodes)
{
  FootingsScratch& footings = *nodes.step.work.with.footings;
  for_each_inside(nodes, [&](int k, int number) {
    push_by_footing(
        footings.placed[number], nodes.mass[k], nodes.v_star[k], footings.chunk_impulses[nodes.chunk][number]);
  });
}

void hold(Nodes& nodes)
{
  for_each_inside(
      nodes, [&](int k, int number) { nodes.step.work.with.footings->placed[number].hold(nodes.v_star[k]); });
}

void finish(StepNow& now) { add_up_impulses(*now.work.with.footings); }

using P = ScorePlace;
constexpr Kernel footings_score[] = {
    {P::outside, "footings", &place},
    {P::free, "footings", &free_part},
    {P::constrain, "footings", &push},
    {P::clamp, "footings", &hold},
    {P::finish, "footings", &finish},
};

}  // namespace

TERP_FEATURE_KERNELS(footings, slot_is_full<&ScratchSlots::footings>)

}  // namespace terp
