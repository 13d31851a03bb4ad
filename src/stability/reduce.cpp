#include "stability/reduce.hpp"

#include "materials/material.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace terp {
namespace {

constexpr Real degree = std::numbers::pi / 180.0;

Real reduced(Reduction reduction, Real value, Real factor)
{
  switch (reduction) {
    case Reduction::none: return value;
    case Reduction::divide: return value / factor;
    case Reduction::divide_tangent: return std::atan(std::tan(value * degree) / factor) / degree;
  }
  return value;
}

bool is_used(const Case& c, const MaterialCase& material)
{
  return std::ranges::any_of(
      c.bodies, [&](const BodyCase& body) { return !body.points_file.empty() || body.material == material.name; });
}

}  // namespace

std::vector<Strength> strengths_of(const Case& c)
{
  std::vector<Strength> strengths;
  for (const MaterialCase& material : c.materials) {
    const MaterialType* law = find_material(material.model);
    if (law == nullptr || !is_used(c, material)) continue;
    for (std::size_t k = 0; k < law->parameters.size(); ++k) {
      const ParameterInfo& p = law->parameters[k];
      if (p.reduction != Reduction::none && std::isfinite(material.parameters[k]))
        strengths.push_back(
            {fmt::format("material.{}.{}", material.name, p.name), std::string(p.unit), material.parameters[k]});
    }
  }
  for (const SideCase& side : c.sides) {
    if (side.adhesion > 0.0) strengths.push_back({fmt::format("boundary.{}.adhesion", side.side), "Pa", side.adhesion});
    if (side.friction > 0.0) strengths.push_back({fmt::format("boundary.{}.friction", side.side), "-", side.friction});
  }
  return strengths;
}

Case reduce_strength(Case c, Real factor)
{
  for (MaterialCase& material : c.materials) {
    const MaterialType* law = find_material(material.model);
    for (std::size_t k = 0; law != nullptr && k < law->parameters.size(); ++k)
      material.parameters[k] = reduced(law->parameters[k].reduction, material.parameters[k], factor);
  }
  for (SideCase& side : c.sides) {
    side.adhesion /= factor;
    side.friction /= factor;
  }
  return c;
}

std::vector<std::string> check_reduced(const Case& c)
{
  std::vector<std::string> problems;
  for (const MaterialCase& material : c.materials)
    if (const MaterialType* law = find_material(material.model))
      for (const ParameterProblem& p : law->check(material.parameters))
        problems.push_back(fmt::format("material.{}: {}: {}", material.name, p.what, p.detail));
  return problems;
}

}  // namespace terp
