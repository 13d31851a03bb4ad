#include "support/two_soils.hpp"

namespace terp::test {

Case two_soils(const std::string& scheme, Shares shares, Vec<2> place, Real degrees, Index points)
{
  Case c = free_box(scheme, {0.5, 0.5}, {4.5, 4.5}, elastic(soft, 0.3, 2000.0));
  c.mesh.size = {5.0, 5.0};
  c.materials.push_back(elastic(stiff, 0.2, 2000.0));
  c.materials[1].name = "hard rock";
  c.bodies.push_back(c.bodies[0]);
  c.bodies[1].material = "hard rock";
  const Real angle = degrees * std::numbers::pi / 180.0, cosine = std::cos(angle), sine = std::sin(angle);
  const auto at = [&](Real along, Real up) {
    return Vec<2>{place[0] + cosine * along - sine * up, place[1] + sine * along + cosine * up};
  };
  // Later bodies take the place of earlier ones.
  c.bodies[1].polygon = {at(-1.5, 0.0), at(1.5, 0.0), at(1.5, 1.2), at(-1.5, 1.2)};
  for (BodyCase& part : c.bodies) part.points_per_cell = {points, points};
  c.method.shares = shares;
  c.method.weights = Weights::summed;
  c.method.cut_cells = CutCells::slip;
  return c;
}

Case two_clays(const std::string& scheme, Shares shares, Vec<2> place, Real degrees)
{
  Case c = two_soils(scheme, shares, place, degrees);
  const auto never_yields = [](const MaterialCase& of, Real shear_modulus, Real poisson_ratio) {
    MaterialCase soil = clay({shear_modulus, poisson_ratio, 1e9, 1e9});
    soil.name = of.name;
    return soil;
  };
  c.materials = {never_yields(c.materials[0], soft, 0.3), never_yields(c.materials[1], stiff, 0.2)};
  return c;
}

}  // namespace terp::test
