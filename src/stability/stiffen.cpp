#include "stability/stiffen.hpp"

#include "materials/material.hpp"

#include <cmath>

namespace terp {

Case stiffen(Case c, Real s)
{
  for (MaterialCase& material : c.materials)
    if (const MaterialType* law = find_material(material.model))
      change_parameters(material, [law, s](std::size_t k, Real value) {
        const Real exponent = law->parameters[k].strain_exponent;
        return exponent == 0.0 ? value
                               : value * (exponent == 1.0      ? s
                                             : exponent == 0.5 ? std::sqrt(s)
                                                               : std::pow(s, exponent));
      });
  c.forces.viscous_damping *= std::sqrt(s);
  c.time.end /= std::sqrt(s);
  return c;
}

}  // namespace terp
