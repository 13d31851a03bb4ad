#include "stability/stiffen.hpp"

#include "materials/material.hpp"

#include <cmath>

namespace terp {

Case stiffen(Case c, Real s)
{
  for (MaterialCase& material : c.materials) {
    const MaterialType* law = find_material(material.model);
    for (std::size_t k = 0; law != nullptr && k < law->parameters.size(); ++k) {
      if (law->parameters[k].strain_scale == StrainScale::multiply) material.parameters[k] *= s;
      if (law->parameters[k].strain_scale == StrainScale::multiply_root) material.parameters[k] *= std::sqrt(s);
    }
  }
  c.forces.viscous_damping *= std::sqrt(s);
  c.time.end /= std::sqrt(s);
  return c;
}

}  // namespace terp
