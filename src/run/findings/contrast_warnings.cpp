// Soils beside each other, and undrained strengths beside the stress that their soil bears. What a soil is follows from
// a word in its name; a name with two such words, as "sand with clay", says nothing.

#include "run/findings/contrast_warnings.hpp"

#include "model/soils/overburden.hpp"
#include "model/soils/point_parameters.hpp"
#include "model/water/water_pressure.hpp"
#include "run/findings/soil_size.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <string_view>

namespace terp {
namespace {

constexpr Real light = 1.2;      // density over that of water: peat
constexpr Real falls_to = 0.7;   // of the strength at the top of a layer
constexpr Real not_even = 0.15;  // S_u over sigma'_v; clay that never bore more has 0.2 to 0.35

struct SoilWord {
  std::string_view kind, english, dutch;
};
constexpr SoilWord soil_words[] = {{"peat", "peat", "veen"}, {"clay", "clay", "klei"}, {"sand", "sand", "zand"}};

/// A quantity of which soil of one kind has less than `factor` times what soil of another kind has.
struct Contrast {
  std::string_view less, more, key, what, unit;
  Real factor;
  Real (*value)(const SoilMaterial&, const MaterialCase&);
};

Real density(const SoilMaterial& soil, const MaterialCase&) { return soil.density; }
Real stiffness(const SoilMaterial& soil, const MaterialCase&) { return soil.law->shear_modulus(); }
Real permeability(const SoilMaterial&, const MaterialCase& values) { return values.permeability.horizontal; }

constexpr Contrast contrasts[] = {
    {"peat", "sand", "density", "is heavier than", "kg/m^3", 1.0, density},
    {"peat", "clay", "density", "is heavier than", "kg/m^3", 1.1, density},
    {"peat", "sand", "shear_modulus", "is stiffer than", "Pa", 2.0, stiffness},
    {"peat", "sand", "permeability", "leads water better than", "m/s", 10.0, permeability},
    {"clay", "sand", "permeability", "leads water better than", "m/s", 10.0, permeability},
};

/// Empty: the name says none, or two.
std::string_view kind_of(const std::string& name)
{
  std::string_view kind;
  std::string word;
  for (const char c : name + '.') {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      continue;
    }
    for (const SoilWord& soil : soil_words)
      if (word == soil.english || word == soil.dutch) {
        if (!kind.empty() && kind != soil.kind) return {};
        kind = soil.kind;
      }
    word.clear();
  }
  return kind;
}

void find_swapped_soils(const Model& model, std::vector<Problem>& warnings)
{
  const auto& cases = model.description.materials;
  for (const Contrast& contrast : contrasts)
    for (std::size_t a = 0; a < cases.size(); ++a)
      for (std::size_t b = 0; b < cases.size(); ++b) {
        const SoilMaterial &less = model.materials[a], &more = model.materials[b];
        if (kind_of(less.name) != contrast.less || kind_of(more.name) != contrast.more) continue;
        if (!is_used(model, less.name) || !is_used(model, more.name)) continue;
        const std::string key = parameter_key(cases[a], contrast.key);
        if (std::ranges::find(warnings, key, &Problem::key) != warnings.end()) continue;  // beside another soil
        const Real low = contrast.value(less, cases[a]), high = contrast.value(more, cases[b]);
        if (!(low > contrast.factor * high) || !(high > 0.0)) continue;
        warnings.push_back({key, fmt::format("`{}` {} `{}`", less.name, contrast.what, more.name),
            fmt::format("Got {:.4g} {} beside {:.4g} {}. Are the two swapped, or is a name another soil's?", low,
                contrast.unit, high, contrast.unit),
            "material", false, {parameter_key(cases[b], contrast.key)}});
      }
}

/// The strength of the highest and the lowest point of a material, and of that which has least of what it bears.
struct Borne {
  Real top = -INFINITY, bottom = INFINITY;              // [m]
  Real strength_top = 0.0, strength_bottom = 0.0;       // [Pa]
  Real least = INFINITY, stress = 0.0, strength = 0.0;  // S_u over sigma'_v [-], both there [Pa]
};

/// Number of the first undrained strength of a law; none: it has friction, or no strength.
std::optional<std::size_t> undrained_strength(const MaterialType& law)
{
  const auto has = [&](Reduction reduction) {
    return std::ranges::find(law.parameters, reduction, &ParameterInfo::reduction);
  };
  const auto at = has(Reduction::divide);
  if (has(Reduction::divide_tangent) != law.parameters.end() || at == law.parameters.end()) return std::nullopt;
  return static_cast<std::size_t>(at - law.parameters.begin());
}

void find_odd_strengths(const Model& model, const State& state, std::vector<Problem>& warnings)
{
  const Real g = -model.gravity[1];
  const auto& cases = model.description.materials;
  const WaterCase& water = model.description.water;
  std::vector<const ParameterField*> drawn(cases.size(), nullptr);  // by a formula or by pairs, not by stress or places
  std::vector<bool> is_peat(cases.size(), false);
  bool any = false;
  for (std::size_t m = 0; m < cases.size(); ++m) {
    const auto k = undrained_strength(*model.materials[m].type);
    if (!k || !(g > 0.0)) continue;
    const auto field = std::ranges::find(cases[m].fields, *k, &ParameterField::parameter);
    if (field == cases[m].fields.end())
      is_peat[m] = model.with.water && model.materials[m].density * g < light * water.unit_weight;
    else if (!field->follows && !field->needs.stress && field->needs.scales.empty() && field->needs.covers.empty())
      drawn[m] = &*field;
    any = any || is_peat[m] || drawn[m] != nullptr;
  }
  if (!any) return;
  const Overburden overburden(model);
  if (!overburden.is_known()) return;
  std::vector<Borne> borne(cases.size());
  Real largest = 0.0;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto m = static_cast<std::size_t>(block.material);
    const Vec<2> x{block.row(Rows::x)[lane], block.row(Rows::x + 1)[lane]};
    const Real stress = overburden.effective(x, situation_of(overburden.water(), 0));
    largest = std::max(largest, stress);
    if (drawn[m] == nullptr) return;
    Borne& soil = borne[m];
    const Real strength = drawn[m]->value_at({x, &overburden});
    if (x[1] > soil.top) soil.top = x[1], soil.strength_top = strength;
    if (x[1] < soil.bottom) soil.bottom = x[1], soil.strength_bottom = strength;
    if (strength < soil.least * stress) soil.least = strength / stress, soil.stress = stress, soil.strength = strength;
  });
  for (std::size_t m = 0; m < cases.size(); ++m) {
    const auto k = undrained_strength(*model.materials[m].type);
    if (!k || !is_used(model, cases[m].name)) continue;
    const std::string key = parameter_key(cases[m], model.materials[m].type->parameters[*k].name);
    const Borne& soil = borne[m];
    if (is_peat[m] && cases[m].parameters[*k] > largest)
      warnings.push_back({key,
          fmt::format("`{}` is as light as peat, and stronger than all that lies on it", cases[m].name),
          fmt::format("Got {:.3g} kPa; the largest sigma'_v in this section is {:.3g} kPa, and soil that bore no more "
                      "has 0.2 to 0.5 times\nas much. Is it another soil's strength, or its weight that of another?",
              1e-3 * cases[m].parameters[*k], 1e-3 * largest),
          std::string(cases[m].model), false, {parameter_key(cases[m], "density")}});
    if (drawn[m] != nullptr && soil.strength_bottom < falls_to * soil.strength_top && soil.least < not_even)
      warnings.push_back({key, fmt::format("the strength of `{}` falls with depth", cases[m].name),
          fmt::format(
              "It is {:.3g} kPa at y = {:.4g} m and {:.3g} kPa at {:.4g} m. Where it has {:.3g} kPa, sigma'_v is "
              "{:.3g} kPa: soil that\nnever bore more has 0.2 to 0.35 times as much. y is upwards: strength that "
              "grows by 1.5 kPa/m is \"10e3 - 1.5e3*y\".",
              1e-3 * soil.strength_top, soil.top, 1e-3 * soil.strength_bottom, soil.bottom, 1e-3 * soil.strength,
              1e-3 * soil.stress),
          "field", false, {parameter_key(cases[m], "density")}});
  }
}

}  // namespace

void find_odd_contrasts(const Model& model, const State& state, std::vector<Problem>& warnings)
{
  find_swapped_soils(model, warnings);
  find_odd_strengths(model, state, warnings);
}

}  // namespace terp
