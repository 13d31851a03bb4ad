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
#include <functional>
#include <string_view>

namespace terp {
namespace {

constexpr Real light = 1.2;      // density over that of water: peat
constexpr Real falls_to = 0.7;   // of the strength at the top of a layer
constexpr Real coarser = 10.0;   // times the permeability of another soil
constexpr Real far_more = 8.0;   // of a number of one soil beside those of all others: a point that slipped
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

struct Coarser {
  std::string_view key, what, unit, units;
  Real (*value)(const SoilMaterial&, const MaterialCase&);
};
constexpr Coarser coarser_soil[] = {
    {"permeability", "leads water better than", "m/s", "Permeabilities are in m/s; those in m/d are written \"1 m/d\".",
        permeability},
    {"shear_modulus", "is far stiffer than", "Pa", "Stiffness is in Pa: 2 MPa is 2.0e6.", stiffness},
};

/// Fine soil has less friction, more cohesion, a lower permeability and less stiffness than coarse soil: soil with the
/// first two and far more of one of the others has that of another, or in another unit.
void find_odd_fine_soil(const Coarser& quantity, const Model& model, std::vector<Problem>& warnings)
{
  const auto& cases = model.description.materials;
  for (std::size_t a = 0; a < cases.size(); ++a)
    for (std::size_t b = 0; b < cases.size(); ++b) {
      const SoilMaterial &fine = model.materials[a], &coarse = model.materials[b];
      const auto more = [&](std::string_view name, std::size_t m, std::size_t than) {
        return parameter_of(cases[m], *model.materials[m].type, name) >
               parameter_of(cases[than], *model.materials[than].type, name);
      };
      const Real of_fine = quantity.value(fine, cases[a]), of_coarse = quantity.value(coarse, cases[b]);
      const std::string key = parameter_key(cases[a], quantity.key);
      if (!is_used(model, fine.name) || !is_used(model, coarse.name) || !(of_fine > coarser * of_coarse)) continue;
      if (!more("cohesion", a, b) || !more("friction_angle", b, a) || !(of_coarse > 0.0)) continue;
      if (std::ranges::find(warnings, key, &Problem::key) != warnings.end()) continue;  // by its name
      warnings.push_back({key, fmt::format("`{}` {} `{}`, which is coarser", fine.name, quantity.what, coarse.name),
          fmt::format("Got {:.3g} {} beside {:.3g} {}, though it has less friction and more cohesion. {}", of_fine,
              quantity.unit, of_coarse, quantity.unit, quantity.units),
          "material", false, {parameter_key(cases[b], quantity.key)}});
      return;
    }
}

/// Peak over residual undrained strength, where both are numbers; NaN: unknown.
Real loss_of(const SoilMaterial& soil, const MaterialCase& values)
{
  const auto& parameters = soil.type->parameters;
  for (std::size_t k = 0; k < values.ratios.size(); ++k)
    if (parameters[k].ratio.divides && values.ratios[k].is_given()) return values.ratios[k].value;
  if (const Real share = parameter_of(values, *soil.type, "residual_share"); share > 0.0) return 1.0 / share;
  return parameter_of(values, *soil.type, "su_peak") / parameter_of(values, *soil.type, "su_residual");
}

/// Clay of one history has its least strength in extension, not in direct shear.
void find_swapped_directions(const Model& model, std::vector<Problem>& warnings)
{
  const auto& cases = model.description.materials;
  for (std::size_t m = 0; m < cases.size(); ++m) {
    const auto of = [&](std::string_view name) { return parameter_of(cases[m], *model.materials[m].type, name); };
    const Real active = of("su_active"), direct = of("su_direct"), passive = of("su_passive");
    if (!is_used(model, cases[m].name) || !(active > direct && passive > direct)) continue;
    const auto key_of = [&](const char* name) { return fmt::format("material.\"{}\".{}", cases[m].name, name); };
    const std::string key = key_of("su_direct");
    if (std::ranges::find(warnings, key, &Problem::key) != warnings.end()) continue;  // of another unit
    warnings.push_back(
        {key_of("su_passive"), fmt::format("`{}` is stronger in extension than in direct shear", cases[m].name),
            fmt::format(
                "S_P / S_A = {:.3g}, S_D / S_A = {:.3g}. Are the two swapped? S_D of clay lies between S_A and S_P.",
                passive / active, direct / active),
            std::string(cases[m].model), false, {key}});
  }
}

/// The void ratio and the density of soil whose pores are full of water give the density of its grains.
void find_odd_grains(const Model& model, std::vector<Problem>& warnings)
{
  constexpr Real heaviest = 3.5, of_water = 1000.0;  // over water; quartz 2.65, [kg/m^3]
  const auto& cases = model.description.materials;
  for (std::size_t m = 0; m < cases.size(); ++m) {
    const SoilMaterial& soil = model.materials[m];
    const Real e = parameter_of(cases[m], *soil.type, "void_ratio"), grains = soil.density / of_water * (1.0 + e) - e;
    if (!is_used(model, soil.name) || !(e > 0.0) || !(grains > heaviest)) continue;
    warnings.push_back({parameter_key(cases[m], "void_ratio"),
        fmt::format("the void ratio and the density of `{}` do not fit together", soil.name),
        fmt::format("With a void ratio of {:g} wet soil of {:.4g} kg/m^3 has grains of {:.3g} kg/m^3; quartz has 2650.",
            e, soil.density, of_water * grains),
        std::string(cases[m].model), false, {parameter_key(cases[m], "density")}});
  }
}

/// A stage that changes a strength by a factor of ten, as a slipped decimal point does: a trigger says that it is
/// meant.
void find_lost_strength(const Model& model, std::vector<Problem>& warnings)
{
  const Case& whole = model.whole();
  const std::vector<MaterialCase>* before = &whole.materials;
  for (std::size_t k = 0; k < whole.stages.size(); ++k) {
    const StageCase& stage = whole.stages[k];
    if (!stage.changed) continue;
    for (std::size_t m = 0; m < before->size() && !stage.trigger; ++m) {
      const MaterialCase &old = (*before)[m], &now = stage.changed->materials[m];
      const MaterialType* law = now.type();
      for (std::size_t p = 0; law != nullptr && now.model == old.model && p < law->parameters.size(); ++p) {
        const Real was = old.parameters[p], is = now.parameters[p];
        if (!is_strength(law->parameters[p].reduction) || !law->parameters[p].fallback_of.empty()) continue;
        if (!(is > 0.0) || !std::isfinite(was / is) || std::max(was / is, is / was) < far_more) continue;
        warnings.push_back({fmt::format("stage[{}].set", k),
            fmt::format(
                "`{}` of `{}` becomes {:.3g} in the stage `{}`", law->parameters[p].name, now.name, is, stage.name),
            fmt::format(
                "Before it is {:.4g}, {:.3g} times as much. Did a decimal point slip? A stage that shall make the "
                "section fail says so:\ntrigger = true.",
                was, was / is),
            "stage.set", false, {"stage"}});
      }
    }
    before = &stage.changed->materials;
  }
}

void find_odd_loss(const Model& model, std::vector<Problem>& warnings)
{
  const auto& cases = model.description.materials;
  std::vector<std::pair<Real, std::size_t>> losses;
  for (std::size_t m = 0; m < cases.size(); ++m)
    if (const Real loss = loss_of(model.materials[m], cases[m]); loss > 1.0 && is_used(model, cases[m].name))
      losses.emplace_back(loss, m);
  std::ranges::sort(losses, std::greater{});
  if (losses.size() < 2 || losses[0].first < far_more * losses[1].first) return;
  const MaterialCase& odd = cases[losses[0].second];
  warnings.push_back({fmt::format("material.\"{}\"", odd.name),
      fmt::format("`{}` loses far more of its strength than all other soil", odd.name),
      fmt::format("Its peak is {:.3g} times its residual strength, of other soil at most {:.3g} times (`{}`). Did a "
                  "decimal point slip?\nIf it is quick clay, leave it.",
          losses[0].first, losses[1].first, cases[losses[1].second].name),
      std::string(odd.model)});
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
  for (const Coarser& quantity : coarser_soil) find_odd_fine_soil(quantity, model, warnings);
  find_odd_loss(model, warnings);
  find_swapped_directions(model, warnings);
  find_odd_grains(model, warnings);
  find_lost_strength(model, warnings);
  find_odd_strengths(model, state, warnings);
}

}  // namespace terp
