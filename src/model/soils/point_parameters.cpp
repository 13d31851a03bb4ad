// A value is set once, at t = 0, and goes where its point goes. The time step must be known before there are points, so
// fields are asked at the places of points to be (settle_fields).

#include "model/soils/point_parameters.hpp"

#include "math/errors.hpp"
#include "mpm/kernels/time_step.hpp"
#include "soil/laws/elastic_constants.hpp"
#include "model/meshes/mesh_error.hpp"
#include "model/bodies/setup_points.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace terp {
namespace {

std::vector<Real> varying_values(const SoilMaterial& material, const std::vector<Real>& parameters)
{
  std::vector<Real> values;
  for (const int k : material.law->varying()) values.push_back(parameters[static_cast<std::size_t>(k)]);
  return values;
}

/// Throws InputError if a parameter that varies is outside its range, or the law refuses them together. x: the place of
/// the point at t = 0, for the message.
void check_parameters(const MaterialCase& material, const MaterialType& type, const std::vector<Real>& values, Vec<2> x)
{
  for (std::size_t k = 0; k < values.size(); ++k) {
    const ParameterInfo& parameter = type.parameters[k];
    if (parameter.may_vary && !parameter.range.contains(values[k]))
      throw InputError(
          Problem{parameter_key(material, parameter.name), "the value is outside of its range at some point",
              fmt::format("It is {} {} at {} m.", values[k], parameter.unit, place_text(x)), "material"});
  }
  for (const ParameterProblem& problem : type.check(values))
    throw InputError(Problem{parameter_key(material, problem.parameter), problem.what,
        fmt::format("At the point at {} m: {}", place_text(x), problem.detail), "material"});
}

/// How much a parameter that varies changes when number `set` becomes `factor` times as large.
Real factor_of(const MaterialCase& material, std::size_t parameter, std::size_t set, Real factor)
{
  if (parameter == set) return factor;
  const auto field = std::ranges::find(material.fields, parameter, &ParameterField::parameter);
  return field != material.fields.end() && field->follows ? factor_of(material, *field->follows, set, factor) : 1.0;
}

/// The parameters of a point that vary, in the order of its law, once the one in `row` has a new value.
std::vector<Real> with_parameter(const Model& model, const PointBlock<2>& block, Index lane, int row, Real value)
{
  const SoilMaterial& material = model.materials[block.material];
  const std::span<const int> varying = material.law->varying();
  const std::span<const int> numbers = std::span(material.rows).subspan(static_cast<std::size_t>(material.n_state()));
  const auto place = static_cast<std::size_t>(std::ranges::find(numbers, row) - numbers.begin());
  const LawRows rows = material.view(block, lane);
  const Real before = *rows.parameters(place), factor = before == 0.0 ? 1.0 : value / before;
  std::vector<Real> own;
  for (std::size_t k = 0; k < varying.size(); ++k)
    own.push_back(k == place ? value
                             : *rows.parameters(k) * factor_of(model.description.materials[block.material],
                                                         static_cast<std::size_t>(varying[k]),
                                                         static_cast<std::size_t>(varying[place]), factor));
  return own;
}

/// With the stiffness of pore water that cannot leave.
Moduli undrained(const SoilMaterial& material, Moduli drained)
{
  return {drained.bulk + material.water_stiffness, drained.shear};
}

}  // namespace

std::string parameter_key(const MaterialCase& material, std::string_view parameter)
{
  const bool is_plain = material.called().find_first_of(".[") == std::string::npos;
  const std::string_view part = material.zone == Zone::below ? ".below" : material.zone == Zone::above ? ".above" : "";
  return fmt::format(
      fmt::runtime(is_plain ? "material.{}{}.{}" : "material.\"{}\"{}.{}"), material.called(), part, parameter);
}

Real parameter_of(const MaterialCase& material, const MaterialType& law, std::string_view name)
{
  const auto at = std::ranges::find(law.parameters, name, &ParameterInfo::name);
  const auto k = static_cast<std::size_t>(at - law.parameters.begin());
  const bool varies = std::ranges::find(material.fields, k, &ParameterField::parameter) != material.fields.end();
  return k < law.parameters.size() && k < material.parameters.size() && !varies
             ? material.parameters[k]
             : std::numeric_limits<Real>::quiet_NaN();
}

std::vector<int> varying_parameters(const MaterialCase& material, const MaterialType& type)
{
  std::vector<int> varying;
  for (const ParameterField& field : material.fields) {
    const ParameterInfo& parameter = type.parameters[field.parameter];
    if (!parameter.may_vary)
      throw InputError(Problem{parameter_key(material, parameter.name), "this parameter is the same for all points",
          fmt::format(
              "The law {} does not let {} vary from point to point. Give one number.", type.name, parameter.name),
          "material"});
    varying.push_back(static_cast<int>(field.parameter));
  }
  TERP_ASSERT(std::ranges::is_sorted(varying));
  return varying;
}

std::vector<Real> parameters_at(const MaterialCase& material, const MaterialType& type, const PlaceInSoil& at)
{
  std::vector<Real> values = material.parameters;
  for (const ParameterField& field : material.fields) values[field.parameter] = field.value_at(at);
  if (!material.fields.empty()) check_parameters(material, type, values, at);
  return values;
}

Real stable_step(const StageSoil& soil, const Stiffness& s)
{
  const Real altitude = soil.mesh->smallest_altitude, density = soil.materials[s.material].density;
  const Real wave = wave_speed(s.moduli.p_wave(), density);
  return stable_time_step(soil.description.time.courant, altitude, wave) *
         viscous_reduction(s.viscosity / density, altitude, wave);
}

void check_point_parameter(
    const Model& model, const StepState& state, const PointBlock<2>& block, Index lane, int row, Real value)
{
  const SoilMaterial& material = model.materials[block.material];
  const std::span<const int> varying = material.law->varying();
  const LawRows rows = material.view(block, lane);
  std::vector<Real> values = model.description.materials[block.material].parameters;
  std::vector<Real> own = with_parameter(model, block, lane, row, value);
  for (std::size_t k = 0; k < varying.size(); ++k) values[static_cast<std::size_t>(varying[k])] = own[k];
  const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
  const Vec<2> x{state.x_initial[2 * id], state.x_initial[2 * id + 1]};
  check_parameters(model.description.materials[block.material], *material.type, values, x);
  const LawRows at{.state = rows.state, .parameters = {.data = own.data()}};
  const Real stable =
      stable_step(model, {block.material, undrained(material, material.law->moduli(at)), material.law->viscosity(at)});
  if (stable < model.dt * (1.0 - 1e-12))  // round-off
    throw InputError(Problem{"material." + material.name, "a point is too stiff for the time step of the run",
        fmt::format(
            "The point at {} m needs dt = {:.4g} s at most; the run has {:.4g} s. Give the stiffest soil in the "
            "case.",
            place_text(x), stable, model.dt),
        "material"});
}

void set_point_parameter(const Model& model, const PointBlock<2>& block, Index lane, int row, Real value)
{
  const LawRows rows = model.materials[block.material].view(block, lane);
  std::size_t k = 0;
  for (const Real own : with_parameter(model, block, lane, row, value)) *rows.parameters(k++) = own;
}

void set_point_parameters(const Model& model, const Seeds& seeds, StepState& state, const std::vector<bool>& of_bodies)
{
  if (!model.ground()) return;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const SoilMaterial& material = model.materials[block.material];
    if (!material.varies()) return;
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    const Index body = seeds.bodies[id];
    if (!of_bodies.empty() && !of_bodies[static_cast<std::size_t>(body)]) return;
    const std::vector<Real> values = parameters_at(model.description.materials[block.material], *material.type,
        {{seeds.places[2 * id], seeds.places[2 * id + 1]},
            model.parts->grounds.of(model.description.bodies[static_cast<std::size_t>(body)])});
    const LawRows rows = material.view(block, lane);
    std::size_t k = 0;
    for (const Real value : varying_values(material, values)) *rows.parameters(k++) = value;
  });
}

std::vector<Stiffness> list_stiffness(const StageSoil& soil, std::span<const Index> used, const FieldsOfPoints& fields)
{
  std::vector<Stiffness> list;
  for (const Index number : used)
    if (const SoilMaterial& material = soil.materials[number]; !material.varies())
      list.push_back({number, undrained(material, material.law->moduli()), material.law->viscosity()});
  std::vector<Real> all, own;
  for (const FieldsOfPoints::Point& point : fields.points) {
    if (std::ranges::find(used, point.material) == used.end()) continue;
    const SoilMaterial& material = soil.materials[point.material];
    const MaterialCase& description = soil.description.materials[point.material];
    all = description.parameters;
    const auto first = fields.values.begin() + static_cast<std::ptrdiff_t>(point.first);
    own.assign(first, first + static_cast<std::ptrdiff_t>(description.fields.size()));
    for (std::size_t f = 0; f < description.fields.size(); ++f) all[description.fields[f].parameter] = own[f];
    check_parameters(description, *material.type, all, point.x);
    const LawRows at{.state = {}, .parameters = {.data = own.data()}};
    list.push_back({point.material, undrained(material, material.law->moduli(at)), material.law->viscosity(at)});
  }
  return list;
}

void set_water_stiffness(const Parts& parts, const FieldsOfPoints& fields, Soils& soils)
{
  for (const Index number : parts.used) {
    const MaterialCase& c = soils.description.materials[number];
    if (!c.has_excess_pressure()) continue;
    Real& stiffness = soils.materials[number].water_stiffness;
    if (!std::isnan(c.water_stiffness)) {
      stiffness = c.water_stiffness;
      continue;
    }
    Moduli stiffest{0.0, 0.0};
    for (const Stiffness& s : list_stiffness({parts, soils}, std::array{number}, fields)) {
      const Real nu = poisson_ratio_of(s.moduli);
      if (!(c.undrained_poisson_ratio > nu))
        throw InputError(Problem{parameter_key(c, "undrained_poisson_ratio"), less_compressible_than_soil,
            fmt::format("undrained_poisson_ratio = {:g}; it must be above the Poisson's ratio of the soil, {:.4g}{}.",
                c.undrained_poisson_ratio, nu, c.fields.empty() ? "" : " at some point"),
            "material.undrained_poisson_ratio", false, {parameter_key(c, "drainage")}});
      if (s.moduli.shear > stiffest.shear) stiffest = s.moduli;
    }
    stiffness = bulk_from_poisson(stiffest.shear, c.undrained_poisson_ratio) - stiffest.bulk;
  }
}

}  // namespace terp
