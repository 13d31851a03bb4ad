// The pore pressure of the nodes.
#include "mpm/features/pore_force.hpp"

namespace terp {
namespace {

void set_pressures_water(StepNow& now) { set_water(now.model, now.state, now.work); }
void set_context_of_water(StepNow& now) { now.context.pore = &now.work.with.water->pore; }

void add_point_force_water(BlockNow& now)
{
  const CellGroup<Quad4>& group = now.at.group;
  add_pore_force_of_points(now.geometry(), now.block,
      pore_at_corners<Quad4>(*now.context().pore, group.mesh.cells[group.cells[now.c]], now.material.stores_effective),
      now.material.is_drained() ? now.material.density : 0.0, water_force(now.at)[now.c]);
}

using P = ScorePlace;
constexpr Kernel water_score[] = {
    {P::outside, "water", &set_pressures_water},
    {P::context, "water", &set_context_of_water},
    {P::clear, "pore pressure", &clear_water_force},
    {P::point_force, "water", &add_point_force_water},
    {P::pore_force, "pore pressure", &add_water_force},
    {P::outer_force, "pore pressure", &add_water_forces},
};

}  // namespace

TERP_FEATURE_KERNELS(water, slot_is_full<&ScratchSlots::water>)

}  // namespace terp
