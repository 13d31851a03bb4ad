// soils.json: of data model 1 the parameters of all models stand flat in the soil, of 2 each in an object of its own.

#include "import/dstability/stix_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace terp {
namespace {

constexpr std::array<std::pair<std::string_view, StixStrengthModel>, 7> models{{{"None", StixStrengthModel::none},
    {"CPhi", StixStrengthModel::advanced}, {"MohrCoulombAdvanced", StixStrengthModel::advanced},
    {"MohrCoulombClassic", StixStrengthModel::classic}, {"Su", StixStrengthModel::shansep},
    {"SuTable", StixStrengthModel::su_table}, {"SigmaTauTable", StixStrengthModel::sigma_tau_table}}};

StixStrengthModel model_of(const std::string& word)
{
  const auto found = std::ranges::find(models, word, [](const auto& m) { return m.first; });
  return found == models.end() ? StixStrengthModel::unknown : found->second;
}

StixFriction read_friction(JsonCursor& from)
{
  from.pass_over({"CohesionAndFrictionAngleCorrelated"});
  return {read_parameter(from, "Cohesion", pa_per_kpa), read_parameter(from, "FrictionAngle", 1.0),
      read_parameter(from, "Dilatancy", 1.0)};
}

/// A table of strength over stress, rows by stress.
StixTable read_table(JsonCursor table, const char* rows, const char* strength, const std::string& name)
{
  StixTable read;
  for (JsonCursor& row : table.list(rows)) {
    read.rows.push_back({row.required("EffectiveStress", pa_per_kpa), row.required(strength, pa_per_kpa)});
    row.tell_unknown();
  }
  std::ranges::stable_sort(read.rows, {}, [](const Vec<2>& r) { return r[0]; });
  read.is_probabilistic = table.flag(("Is" + name + "Probabilistic").c_str());
  read.variation = table.number((name + "VariationCoefficient").c_str());
  table.pass_over({"StrengthIncreaseExponent", "StrengthIncreaseExponentStochasticParameter"});
  table.tell_unknown();
  return read;
}

/// The object of a model, if the file has one (data model 2); else the soil itself (1).
template <class Read>
void read_model(JsonCursor& soil, const char* key, const Read& read)
{
  if (!soil.has(key)) {
    soil.pass_over({key});
    return read(soil);
  }
  JsonCursor model = soil.object(key);
  read(model);
  model.tell_unknown();
}

StixSoil read_soil(JsonCursor& from)
{
  StixSoil soil{.id = from.id("Id"), .code = from.text("Code"), .name = from.text("Name")};
  soil.weight_above = pa_per_kpa * from.number("VolumetricWeightAbovePhreaticLevel");
  soil.weight_below = pa_per_kpa * from.number("VolumetricWeightBelowPhreaticLevel");
  soil.above_word = from.text("ShearStrengthModelTypeAbovePhreaticLevel");
  soil.below_word = from.text("ShearStrengthModelTypeBelowPhreaticLevel");
  soil.above = model_of(soil.above_word);
  soil.below = model_of(soil.below_word);
  read_model(from, "MohrCoulombAdvancedShearStrengthModel", [&](JsonCursor& m) { soil.advanced = read_friction(m); });
  if (from.has("MohrCoulombClassicShearStrengthModel"))
    read_model(from, "MohrCoulombClassicShearStrengthModel", [&](JsonCursor& m) { soil.classic = read_friction(m); });
  read_model(from, "SuShearStrengthModel", [&](JsonCursor& m) {
    soil.ratio = read_parameter(m, "ShearStrengthRatio", 1.0);
    soil.exponent = read_parameter(m, "StrengthIncreaseExponent", 1.0);
    m.pass_over({"ShearStrengthRatioAndShearStrengthExponentCorrelated"});
  });
  soil.su_table = read_table(from.object("SuTable"), "SuTablePoints", "Su", "SuTable");
  soil.sigma_tau_table =
      read_table(from.object("SigmaTauTable"), "SigmaTauTablePoints", "ShearStrength", "SigmaTauTable");
  from.pass_over({"IsProbabilistic", "Notes", "MohrCoulombClassicShearStrengthModel"});
  from.tell_unknown();
  for (const auto* word : {&soil.above_word, &soil.below_word})
    if (model_of(*word) == StixStrengthModel::unknown)
      from.remark(filled<reported_texts::unknown_model>(*word, soil.name));
  return soil;
}

}  // namespace

StixParameter read_parameter(JsonCursor& from, const std::string& key, Real unit)
{
  StixParameter parameter{.value = unit * from.number(key.c_str())};
  JsonCursor twin = from.object((key + "StochasticParameter").c_str());
  parameter.is_probabilistic = twin.flag("IsProbabilistic");
  parameter.mean = unit * twin.number("Mean");
  parameter.deviation = unit * twin.number("StandardDeviation");
  twin.tell_unknown();
  return parameter;
}

void read_soils(JsonCursor& file, std::vector<StixSoil>& soils)
{
  std::set<std::string> ids;
  for (JsonCursor& entry : file.list("Soils")) {
    soils.push_back(read_soil(entry));
    if (const std::string& id = soils.back().id; !id.empty() && !ids.insert(id).second)
      entry.fault("Id", "is there twice", fmt::format("Got {}, which another soil has.", id));
  }
  file.pass_over({"ContentVersion"});
  file.tell_unknown();
}

}  // namespace terp
