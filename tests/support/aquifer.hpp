// A cover of clay on sand whose water lifts it.
#pragma once

#include "support/cases.hpp"

namespace terp::test {

inline MaterialCase sand(Real friction, Real cohesion = 0.0)
{
  MaterialCase material{"sand", "mohr_coulomb", 2000.0, {}};
  material.parameters = find_material("mohr_coulomb")->complete(std::vector<Real>{1e7, 0.3, cohesion, friction});
  return material;
}

/// Clay of 3 m, 16 kN/m3, on 5 m of sand of 20 kN/m3, 40 m wide. Gravity and water of 10 in their units. The water on
/// the ground is at z = 8 m, that of the sand rises to `left` on the left half and to `right` on the other.
inline Case cover(Real left, Real right, MaterialCase soil = sand(30.0))
{
  MaterialCase weak = clay();
  weak.density = 1600.0;
  Case c = free_box("mpm_gp", {0.0, 5.0}, {40.0, 8.0}, weak);
  c.mesh.size = {40.0, 10.0};
  c.mesh.cell = {1.0, 1.0};
  c.forces.gravity = {0.0, -10.0};
  c.bodies.push_back(body("sand", {0.0, 0.0}, {40.0, 5.0}));
  c.materials.push_back(std::move(soil));
  c.water.unit_weight = 10e3;
  c.water.start.phreatic_line = {Vec<2>{0.0, 8.0}};
  c.water.start.head_lines = {{"aquifer", {{0.0, left}, {20.0, left}, {20.0, right}, {40.0, right}}}};
  c.water.start.reference_lines = {{.places = {Vec<2>{0.0, 5.0}}, .head = "aquifer", .head_bottom = "aquifer"}};
  return c;
}

}  // namespace terp::test
