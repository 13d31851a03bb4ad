#include "simulation/initial.hpp"

#include "simulation/nodal_water.hpp"
#include "simulation/overburden.hpp"
#include "water/water_pressure.hpp"

#include <cmath>

namespace terp {
void set_initial_stress(const Model& model, State& state)
{
  using Rows = PointRows<2>;
  const Case& c = model.description;
  const bool first_guess = c.initial.stress == InitialStress::equilibrium && model.water;
  if (c.initial.stress != InitialStress::k0 && !first_guess) return;
  const Overburden overburden(model, -model.gravity_at(0.0)[1]);
  if (first_guess && !overburden.is_known()) return;
  const WaterWay way = water_way(model, 0.0, model.ramp.share_at(0.0));
  const WaterSituation& water = situation_of(c.water, way.share > 0.0 ? way.to : way.from);
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const Vec<2> x{block.row(Rows::x)[lane], block.row(Rows::x + 1)[lane]};
    const MaterialCase& material = c.materials[block.material];
    const Real k0 = std::isnan(material.k0) ? c.initial.k0 : material.k0;
    const Real vertical = -overburden.effective(x, water),
               stored = material.stores_effective() ? 0.0 : overburden.pore_pressure(x, water);
    block.row(Rows::sigma)[lane] = k0 * vertical - stored;
    block.row(Rows::sigma + 1)[lane] = vertical - stored;
    block.row(Rows::sigma + 2)[lane] = k0 * vertical - stored;
  });
}

}  // namespace terp
