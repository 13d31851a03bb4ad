// Rows of a material are entered in a fixed order, state variables and then varying parameters, since its views find
// both by that order. Of a law with a scratch variable, the first one is where the softening of a step stands. It is
// neither shown nor saved, since it lives for one step only.

#include "mpm/points/soil_material.hpp"

#include <algorithm>

namespace terp {

RowInfo row_of_parameter(const ParameterInfo& parameter)
{
  return {.name = "parameter_" + std::string(parameter.name),
      .unit = std::string(parameter.unit),
      .meaning = std::string(parameter.meaning),
      .owner = "law",
      .averaging = Averaging::keep,
      .shown = true};
}

RowInfo row_of_excess_pressure()
{
  return {.name = "excess_pressure",
      .unit = "Pa",
      .meaning = "excess pore pressure, that which strain gave to the pore water beyond pore_pressure",
      .owner = "water",
      .shown = true};
}

void add_rows(Index number, SoilMaterial& material, RowTable& table)
{
  const auto add = [&](RowInfo info) {
    info.of = {number};
    material.rows.push_back(table.add(std::move(info)));
  };
  for (const StateInfo& state : material.type->state)
    add({.name = std::string(state.name),
        .unit = std::string(state.unit),
        .meaning = std::string(state.meaning),
        .owner = "law",
        .averaging = state.averaging,
        .initial = state.initial,
        .shown = state.shown && !state.scratch,
        .saved = !state.scratch});
  if (const auto scratch = std::ranges::find(material.type->state, true, &StateInfo::scratch);
      scratch != material.type->state.end())
    material.increment_row = material.rows[static_cast<std::size_t>(scratch - material.type->state.begin())];
  for (const int k : material.law->varying()) add(row_of_parameter(material.type->parameters[k]));
}

void add_excess_row(Index number, SoilMaterial& material, RowTable& table)
{
  RowInfo row = row_of_excess_pressure();
  row.of = {number};
  material.excess_row = table.add(std::move(row));
}

Real strength_at(const SoilMaterial& material, const PointBlock<2>& block, Index lane, Real strain)
{
  if (const int k = find_role(material.type->state, Role::strength); k >= 0) return material.type->state[k].initial;
  std::vector<Real> state;
  for (const StateInfo& info : material.type->state)
    state.push_back(info.role == driver_of_strength(material) ? strain : info.initial);
  return material.law->derived(find_role(material.type->derived, Role::strength),
      {.state = {.data = state.data()}, .parameters = material.view(block, lane).parameters});
}

}  // namespace terp
