// The slownesses are averaged by volume, not those of the softest soil: layers add up the times in which a wave crosses
// them, and a thin soft layer hardly lengthens the period of a section.

#include "run/rest/shear_wave.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terp {

Real time_to_cross(const Model& model, const StepState& state)
{
  Real low = std::numeric_limits<Real>::infinity(), high = -low, slowness = 0.0, volume = 0.0;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const SoilMaterial& material = model.materials[block.material];
    const Moduli m = material.type->stiffness_by_stress
                         ? material.law->moduli_at(material.view(block, lane), stress_at(block, lane))
                     : material.varies() ? material.law->moduli(material.view(block, lane))
                                         : material.law->moduli();
    const Real depth =
        block.row(Rows::x)[lane] * model.damping.down[0] + block.row(Rows::x + 1)[lane] * model.damping.down[1];
    low = std::min(low, depth), high = std::max(high, depth);
    const Real stiffness = m.shear > 0.0 ? m.shear : m.bulk, part = block.row(Rows::volume)[lane];
    slowness += part * std::sqrt(material.density / stiffness);
    volume += part;
  });
  return volume > 0.0 ? (high - low) * slowness / volume : 0.0;
}

}  // namespace terp
