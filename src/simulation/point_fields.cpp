// All values are checked before the first is written: a refusal leaves the state as it was. In a run that has started,
// the energy that the new values bring is booked as energy of the start, and the followers are told. Else the balance
// would show it as a numerical error, and a strain set lower as one that fell.

#include "simulation/point_fields.hpp"

#include "base/errors.hpp"
#include "simulation/frame.hpp"
#include "simulation/ledger.hpp"
#include "simulation/point_parameters.hpp"
#include "simulation/run.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace terp {
namespace {

using Rows = PointRows<2>;

/// The rows that can be set: those that results show.
std::vector<std::string> names_to_set(const Model& model)
{
  std::vector<std::string> names;
  for (const RowInfo& row : model.rows.entries())
    if (row.shown) names.push_back(row.name);
  return names;
}

[[noreturn]] void refuse(const std::string& name, const std::string& what, const std::string& detail)
{
  throw InputError(Problem{name, what, detail, ""});
}

/// Where a field lies in the rows of a material's points.
struct FieldPlace {
  int first_row = -1;  ///< -1: points of the material have no such variable
  int n_rows = 1, n_components = 1;
};

/// By material. Of a vector the third component is 0.
std::vector<FieldPlace> places_of(const Model& model, const std::string& name)
{
  std::vector<FieldPlace> places;
  for (const RowInfo& row : model.rows.entries())
    for (Index m = 0; row.shown && row.name == name && m < std::ssize(model.materials); ++m)
      places.push_back({row.is_of(m) ? row.first : -1, row.n, row.n == 2 ? 3 : row.n});
  if (places.empty())
    refuse(name, "there is no field of this name that can be set",
        fmt::format("These can be set: {}.", fmt::join(names_to_set(model), ", ")));
  return places;
}

template <class F>
void for_each_value(State& state, const std::vector<FieldPlace>& places, const std::vector<Real>& values, F&& f)
{
  for_each_point(state.points, [&](PointBlock<2> block, Index lane) {
    const FieldPlace& place = places[static_cast<std::size_t>(block.material)];
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    f(block, lane, place, values.data() + id * static_cast<std::size_t>(place.n_components));
  });
}

void check_value(const Model& model, const State& state, const std::string& name, const PointBlock<2>& block,
    Index lane, const FieldPlace& place, const Real* value)
{
  const auto id = static_cast<std::int64_t>(block.row(Rows::id)[lane]);
  const SoilMaterial& material = model.materials[block.material];
  if (place.first_row < 0) {
    if (!std::isnan(*value))
      refuse(name, fmt::format("material point {} cannot take the value {}", id, *value),
          fmt::format("Its material `{}` ({}) has no `{}`: give NaN there, as the field itself does.", material.name,
              material.type->name, name));
    return;
  }
  for (int k = 0; k < place.n_components; ++k)
    if (!std::isfinite(value[k]))
      refuse(name, fmt::format("the value of material point {} is not a finite number", id),
          fmt::format("Component {} is {}.", k, value[k]));
  for (int k = place.n_rows; k < place.n_components; ++k)
    if (value[k] != 0.0)
      refuse(name, fmt::format("the value of material point {} points out of the plane", id),
          fmt::format("Component {} is {}, in plane strain it is 0.", k, value[k]));
  if (place.first_row == Rows::volume && !(*value > 0.0))
    refuse(
        name, fmt::format("the volume of material point {} is not positive", id), fmt::format("Got {} m^2.", *value));
  if (place.first_row == row_of(material, Role::plastic_strain) && *value < 0.0)
    refuse(
        name, fmt::format("the plastic strain of material point {} is below zero", id), fmt::format("Got {}.", *value));
  const std::span<const int> of_law = std::span(material.rows).subspan(static_cast<std::size_t>(material.n_state()));
  if (std::ranges::find(of_law, place.first_row) != of_law.end())
    check_point_parameter(model, state, block, lane, place.first_row, *value);
}

}  // namespace

PointField get_point_field(const Model& model, const State& state, const std::string& name)
{
  std::vector<std::string> names;
  if (auto field = make_field(model, state, name, names)) return std::move(*field);
  refuse(name, "there is no field of this name", fmt::format("Fields of this run: {}.", fmt::join(names, ", ")));
}

void set_point_field(const Model& model, const std::string& name, const std::vector<Real>& values, State& state)
{
  const std::vector<FieldPlace> places = places_of(model, name);
  const std::int64_t n = state.n_ids() * places.front().n_components;
  if (std::ssize(values) != n)
    refuse(name, fmt::format("{} values were given, {} are needed", values.size(), n),
        fmt::format("Its shape is [{}, {}], sorted by id.", state.n_ids(), places.front().n_components));
  for_each_value(
      state, places, values, [&](const PointBlock<2>& block, Index lane, const FieldPlace& place, const Real* value) {
        check_value(model, state, name, block, lane, place, value);
      });
  const Real before = kinetic_and_elastic_energy(model, state);
  for_each_value(
      state, places, values, [](const PointBlock<2>& block, Index lane, const FieldPlace& place, const Real* value) {
        for (int k = 0; k < place.n_rows && place.first_row >= 0; ++k) block.row(place.first_row + k)[lane] = value[k];
      });
  if (!has_started(state)) return;
  state.start_energy += kinetic_and_elastic_energy(model, state) - before;
  for (const ActiveFollower& active : state.followers) active.follower->points_were_set(model, state);
}

}  // namespace terp
