#include "support/cases.hpp"

#include "soil/laws/material.hpp"

namespace terp::test {

MaterialCase clay(const Clay& p)
{
  const std::vector<Real> given{p.shear_modulus, p.poisson_ratio, p.su_peak, p.su_residual, p.eta};
  return {"clay", "tresca_softening", 1990.0, find_material("tresca_softening")->complete(given)};
}

MaterialCase elastic(Real shear_modulus, Real poisson_ratio, Real density)
{
  return {"rock", "linear_elastic", density, {shear_modulus, poisson_ratio}};
}

BodyCase body(const std::string& material, Vec<2> low, Vec<2> high)
{
  BodyCase b;
  b.material = material;
  b.polygon = {low, {high[0], low[1]}, high, {low[0], high[1]}};
  return b;
}

SideCondition side(const std::string& name, SideKind kind)
{
  SideCondition s;
  s.side = name;
  s.kind = kind;
  return s;
}

Case column(const std::string& scheme, Real cell)
{
  Case c;
  c.name = "column";
  c.scheme = scheme;
  c.method.shares = Shares::point;
  c.time.end = 4.0;
  c.mesh.size = {16.0, 3.0};
  c.mesh.cell = {cell, cell};
  c.bodies = {body("clay", {0.0, 0.0}, {8.0, 2.0})};
  c.materials = {clay()};
  c.forces.gravity = {0.0, -9.81};
  c.forces.local_damping = 0.1;
  c.sides = {
      side("left", SideKind::roller), side("right", SideKind::roller), side("bottom", SideKind::contact_bilateral)};
  c.sides[2].adhesion = 8.0e3;
  return c;
}

Case column_without_softening(const std::string& scheme, Real cell)
{
  Case c = column(scheme, cell);
  c.materials = {clay({.su_residual = 8.0e3})};
  c.sides[2] = side("bottom", SideKind::roller);
  return c;
}

Case free_box(const std::string& scheme, Vec<2> low, Vec<2> high, const MaterialCase& material)
{
  Case c;
  c.name = "box";
  c.scheme = scheme;
  c.time.end = 1.0;
  c.mesh.size = {4.0, 2.0};
  c.mesh.cell = {0.25, 0.25};
  c.bodies = {body(material.name, low, high)};
  c.materials = {material};
  return c;
}

Case confined_box(InitialStress stress)
{
  Case c = free_box("mpm_gp", {0.0, 0.0}, {4.0, 1.5}, elastic(2e6, 0.3, 2000.0));
  c.forces.gravity = {0.0, -9.81};
  c.forces.local_damping = 0.1;
  c.initial.stress = stress;
  for (const char* name : {"left", "right", "bottom"}) c.sides.push_back(side(name, SideKind::roller));
  return c;
}

Case clamped_cell(const std::string& scheme)
{
  Case c = free_box(scheme, {0.0, 0.0}, {1.0, 1.0});
  c.mesh.size = c.mesh.cell = {1.0, 1.0};
  c.bodies[0].points_per_cell = {2, 2};
  c.method.shares = Shares::point;
  for (const char* name : {"left", "right", "bottom", "top"}) c.sides.push_back(side(name, SideKind::fixed));
  return c;
}

}  // namespace terp::test
