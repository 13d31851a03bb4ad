// A value is set once, at t = 0, and goes where its point goes. The time step must be known before there are points, so
// that their places are seeded once more for it, if any stiffness or viscosity could vary.

#include "simulation/point_parameters.hpp"

#include "base/errors.hpp"
#include "mesh/mesh_error.hpp"
#include "simulation/setup_points.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace terp {
namespace {

std::string key_of(const MaterialCase& material, std::string_view parameter)
{
  return fmt::format("material.{}.{}", material.name, parameter);
}

/// The values of those that vary, as a law takes them from a point.
std::vector<Real> varying_values(const SoilMaterial& material, const std::vector<Real>& parameters)
{
  std::vector<Real> values;
  for (const int k : material.law->varying()) values.push_back(parameters[static_cast<std::size_t>(k)]);
  return values;
}

}  // namespace

std::vector<int> varying_parameters(const MaterialCase& material, const MaterialType& type)
{
  std::vector<int> varying;
  for (const ParameterField& field : material.fields) {
    const ParameterInfo& parameter = type.parameters[field.parameter];
    if (!parameter.may_vary)
      throw InputError(Problem{key_of(material, parameter.name), "this parameter is the same for all points",
          fmt::format(
              "The law {} does not let {} vary from point to point. Give one number.", type.name, parameter.name),
          "material"});
    varying.push_back(static_cast<int>(field.parameter));
  }
  TERP_ASSERT(std::ranges::is_sorted(varying));
  return varying;
}

std::vector<Real> parameters_at(const MaterialCase& material, const MaterialType& type, Vec<2> x)
{
  std::vector<Real> values = material.parameters;
  for (const ParameterField& field : material.fields) {
    const ParameterInfo& parameter = type.parameters[field.parameter];
    const Real value = values[field.parameter] = field.value_at(x);
    if (!parameter.range.contains(value))
      throw InputError(Problem{key_of(material, parameter.name), "the value is outside of its range at some point",
          fmt::format("It is {} {} at {} m.", value, parameter.unit, place_text(x)), "material"});
  }
  if (material.fields.empty()) return values;
  for (const ParameterProblem& problem : type.check(values))
    throw InputError(Problem{key_of(material, problem.parameter), problem.what,
        fmt::format("At the point at {} m: {}", place_text(x), problem.detail), "material"});
  return values;
}

void set_point_parameters(const Model& model, std::span<const Real> places, State& state)
{
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const SoilMaterial& material = model.materials[block.material];
    if (!material.varies()) return;
    const auto id = static_cast<std::size_t>(block.row(PointRows<2>::id)[lane]);
    const std::vector<Real> values = parameters_at(
        model.description.materials[block.material], *material.type, {places[2 * id], places[2 * id + 1]});
    const LawRows rows = material.view(block, lane);
    std::size_t k = 0;
    for (const Real value : varying_values(material, values)) *rows.parameters(k++) = value;
  });
}

std::vector<Stiffness> list_stiffness(const Model& model, std::span<const Index> used)
{
  std::vector<Stiffness> list;
  bool any_varies = false;
  for (const Index number : used) {
    const SoilMaterial& material = model.materials[number];
    any_varies |= material.varies();
    if (!material.varies()) list.push_back({number, material.law->moduli(), material.law->viscosity()});
  }
  if (!any_varies) return list;
  for (const auto& batch : make_points(model))
    for (const NewPoint& point : batch) {
      const SoilMaterial& material = model.materials[point.material];
      if (!material.varies()) continue;
      std::vector<Real> values =
          varying_values(material, parameters_at(model.description.materials[point.material], *material.type, point.x));
      const LawRows at{.state = {}, .parameters = {.data = values.data()}};
      list.push_back({point.material, material.law->moduli(at), material.law->viscosity(at)});
    }
  return list;
}

}  // namespace terp
