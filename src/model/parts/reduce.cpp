// No law is named here: each change goes through the table of the law, parameter by parameter, and `change_parameters`
// makes it in the number and in a field alike. What stands in no table is changed beside it: contact planes, the
// stiffness of pore water, viscous damping and the end of the run.

#include "model/parts/reduce.hpp"

#include "math/errors.hpp"
#include "model/soils/point_parameters.hpp"
#include "soil/laws/material.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>

namespace terp {
namespace {

constexpr Real degree = std::numbers::pi / 180.0;

/// A parameter that was left out and has the value, or the field, of another strength: a residual strength of soil that
/// does not soften.
bool is_another(const MaterialType& law, const MaterialCase& material, std::size_t k)
{
  const auto other = std::ranges::find(law.parameters, law.parameters[k].fallback_of, &ParameterInfo::name);
  return other != law.parameters.end() &&
         material.parameters[k] == material.parameters[static_cast<std::size_t>(other - law.parameters.begin())];
}

bool is_used(const Case& c, const MaterialCase& material)
{
  return std::ranges::any_of(
      c.bodies, [&](const BodyCase& body) { return !body.points_file.empty() || body.material == material.called(); });
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
      const auto field = std::ranges::find(material.fields, k, &ParameterField::parameter);
      const bool varies = field != material.fields.end(),
                 follows = varies && !p.fallback_of.empty() && field->text == p.fallback_of;
      if (is_strength(p.reduction) &&
          (varies ? !follows : std::isfinite(material.parameters[k]) && !is_another(*law, material, k)))
        strengths.push_back({fmt::format("material.{}.{}", material.name, p.name), std::string(p.unit),
            varies ? std::numeric_limits<Real>::quiet_NaN() : material.parameters[k]});
    }
  }
  for (const SideCondition& side : c.sides) {
    if (side.adhesion > 0.0) strengths.push_back({fmt::format("boundary.{}.adhesion", side.side), "Pa", side.adhesion});
    if (side.friction > 0.0) strengths.push_back({fmt::format("boundary.{}.friction", side.side), "-", side.friction});
  }
  return strengths;
}

Case reduce_strength(Case c, Real factor)
{
  for (MaterialCase& material : c.materials) {
    if (const MaterialType* law = find_material(material.model))
      change_parameters(material,
          [law, factor](std::size_t k, Real value) { return reduced(law->parameters[k].reduction, value, factor); });
  }
  for (SideCondition& side : c.sides) {
    side.adhesion /= factor;
    side.friction /= factor;
  }
  return c;
}

Case leave_out_rate(Case c)
{
  for (MaterialCase& material : c.materials)
    if (const MaterialType* law = find_material(material.model))
      change_parameters(material,
          [law](std::size_t k, Real value) { return law->parameters[k].reduction == Reduction::zero ? 0.0 : value; });
  return c;
}

namespace {

/// The number of a parameter of a law; none: the law does not have it.
std::optional<std::size_t> number_of(const MaterialType& law, std::string_view name)
{
  const auto found = std::ranges::find(law.parameters, name, &ParameterInfo::name);
  if (found == law.parameters.end()) return std::nullopt;
  return static_cast<std::size_t>(found - law.parameters.begin());
}

bool is_field(const MaterialCase& material, std::size_t k)
{
  return std::ranges::find(material.fields, k, &ParameterField::parameter) != material.fields.end();
}

/// The second parameter becomes the first one, as a number or as a field.
void copy_parameter(MaterialCase& material, std::size_t from, std::size_t to)
{
  material.parameters[to] = material.parameters[from];
  std::erase_if(material.fields, [to](const ParameterField& f) { return f.parameter == to; });
  const auto found = std::ranges::find(material.fields, from, &ParameterField::parameter);
  if (found == material.fields.end()) return;
  ParameterField copy = *found;
  copy.parameter = to;
  material.fields.insert(std::ranges::lower_bound(material.fields, to, {}, &ParameterField::parameter), copy);
}

void reduce_as_davis(MaterialCase& material, std::array<std::size_t, 3> numbers)
{
  for (const std::size_t k : numbers)
    if (is_field(material, k))
      throw InputError(Problem{fmt::format("material.{}", material.name),
          "the reduced pair of Davis needs numbers for cohesion and angles",
          "One of them varies from place to place. Give the reduced strength in the case itself (docs/strength.md).",
          "material", true});
  Real &c = material.parameters[numbers[0]], &phi = material.parameters[numbers[1]],
       &psi = material.parameters[numbers[2]];
  const Real sin_phi = std::sin(phi * degree), sin_psi = std::sin(psi * degree), cos_psi = std::cos(psi * degree);
  const Real d = 1.0 - sin_psi * sin_phi;
  c *= cos_psi * std::cos(phi * degree) / d;
  phi = psi = std::atan(cos_psi * sin_phi / d) / degree;
}

}  // namespace

bool is_sand(const MaterialCase& material)
{
  const MaterialType* law = find_material(material.model);
  const auto cohesion = law == nullptr ? std::nullopt : number_of(*law, "cohesion");
  return cohesion && !is_field(material, *cohesion) && material.parameters[*cohesion] == 0.0;
}

Real largest_tension(const MaterialType& law, std::span<const Real> parameters)
{
  const auto value = [&](std::string_view name) {
    const auto k = number_of(law, name);
    return k ? parameters[*k] : 0.0;
  };
  Real most = 0.0;
  for (const char* ending : {"", "_residual"}) {
    const Real c = value(std::string("cohesion") + ending), phi = value(std::string("friction_angle") + ending);
    most = std::max(most, phi > 0.0 ? c / std::tan(phi * degree) : 2.0 * c);
  }
  for (const char* strength : {"su_peak", "su_active", "su_direct", "su_passive"})
    most = std::max(most, 2.0 * value(strength));
  return most;
}

Problem idle_cutoff(const MaterialCase& material, Real cutoff, Real most)
{
  const bool has_friction = number_of(*find_material(material.model), "cohesion").has_value();
  return {parameter_key(material, tension_cutoff),
      fmt::format("`tension_cutoff` has no effect: it lies above {}",
          has_friction ? "c cot(phi)" : "twice the undrained strength"),
      fmt::format(
          "It is {:g} Pa, and {} {:g} Pa. `terp stability` takes it as not given: the soil cracks.\nGive less; 0 is "
          "soil that cracks.",
          cutoff, has_friction ? "the strength ends at" : "soil that is not pulled in all directions carries at most",
          most),
      material.model, false, {fmt::format("material.{}", material.name)}};
}

namespace {

/// Number of the limit of tension of soil that could crack and could have tension.
std::optional<std::size_t> cutoff_of(const MaterialCase& material)
{
  const MaterialType* law = find_material(material.model);
  const auto k = law == nullptr ? std::nullopt : number_of(*law, tension_cutoff);
  return k && law->parameters[*k].reduction == Reduction::divide && !is_sand(material) ? k : std::nullopt;
}

/// Of soil that varies: whether a limit is given, which may act at some places; else whether the limit acts.
bool has_limit(const MaterialCase& material, std::size_t cutoff)
{
  if (!material.fields.empty()) return is_field(material, cutoff) || std::isfinite(material.parameters[cutoff]);
  return material.parameters[cutoff] <= largest_tension(*find_material(material.model), material.parameters);
}

/// No tension at the places where the limit would not act.
void crack_where_no_limit_acts(MaterialCase& material, std::size_t cutoff)
{
  ParameterField field{.parameter = cutoff, .value_at = {}, .text = "tension_cutoff where it acts"};
  field.value_at = [given = material, law = find_material(material.model), cutoff](const PlaceInSoil& at) {
    std::vector<Real> values = given.parameters;
    for (const ParameterField& f : given.fields) values[f.parameter] = f.value_at(at);
    return values[cutoff] > largest_tension(*law, values) ? 0.0 : values[cutoff];
  };
  std::erase_if(material.fields, [cutoff](const ParameterField& f) { return f.parameter == cutoff; });
  material.fields.insert(std::ranges::lower_bound(material.fields, cutoff, {}, &ParameterField::parameter), field);
}

}  // namespace

Case leave_out_tension(Case c)
{
  for (MaterialCase& material : c.materials)
    if (const auto k = cutoff_of(material)) {
      if (!has_limit(material, *k))
        material.parameters[*k] = 0.0;
      else if (!material.fields.empty())
        crack_where_no_limit_acts(material, *k);
    }
  return c;
}

std::vector<std::string> soils_that_limit_tension(const Case& c)
{
  std::vector<std::string> names;
  for (const MaterialCase& material : c.materials)
    if (const auto k = cutoff_of(material); k && has_limit(material, *k)) names.push_back(material.name);
  return names;
}

Case with_flow(Case c, FlowRule rule)
{
  if (rule == FlowRule::as_given) return c;
  for (MaterialCase& material : c.materials)
    if (const MaterialType* law = find_material(material.model))
      for (const char* ending : {"", "_residual"}) {
        const auto cohesion = number_of(*law, std::string("cohesion") + ending),
                   phi = number_of(*law, std::string("friction_angle") + ending),
                   psi = number_of(*law, std::string("dilatancy_angle") + ending);
        if (!cohesion || !phi || !psi) continue;
        if (rule == FlowRule::davis)
          reduce_as_davis(material, {*cohesion, *phi, *psi});
        else
          copy_parameter(material, *phi, *psi);
      }
  return c;
}

const MaterialCase* find_not_judged(const Case& c)
{
  const auto found = std::ranges::find_if(c.materials, [&](const MaterialCase& material) {
    const MaterialType* law = find_material(material.model);
    return law != nullptr && !law->not_judged.empty() && is_used(c, material);
  });
  return found == c.materials.end() ? nullptr : &*found;
}

std::vector<std::string> check_reduced(const Case& c)
{
  std::vector<std::string> problems;
  for (const MaterialCase& material : c.materials)
    if (const MaterialType* law = material.type(); law != nullptr && material.fields.empty())  // else at each point
      for (const ParameterProblem& p : law->check(material.parameters))
        problems.push_back(fmt::format("material.{}: {}: {}", material.name, p.what, p.detail));
  return problems;
}

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
  for (MaterialCase& material : c.materials) material.water_stiffness *= s;
  c.forces.viscous_damping *= std::sqrt(s);
  c.time.end /= std::sqrt(s);
  return c;
}

}  // namespace terp
