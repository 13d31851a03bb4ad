// The table is what all files of a data model have had so far, 2020 to 2026. A key that only some versions have (Notes,
// WaterMeshId, SigmaTauTable, MinimumEffectiveStress) is not in it.

#include "import/dstability/stix_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

namespace terp {
namespace {

constexpr int first_model = 1, second_model = 2, both_models = 3;  // bits

struct ExpectedKeys {
  std::string_view place;  ///< kind of the member and path in it: "states, StatePoints[].Stress"; *: how it ends. In
                           ///< both models a stage is at "stages"
  int models;
  std::string_view keys;  ///< with a space between them; a|b: one of both
  SentenceForm assumed;   ///< what is taken where one is missing; in English alone where nothing is in doubt
  bool decides = true;    ///< stresses, strengths or ground may be others; else names, colours, stored results
};

constexpr bool in_words_only = false;
constexpr SentenceForm no_such_part{"the stage counts as one without them", "de fase telt als een zonder deze"};
constexpr SentenceForm no_design{"its design value and its mean count as not given, or as the plain value",
    "de rekenwaarde en het gemiddelde tellen als niet gegeven, of als de gewone waarde"};
constexpr SentenceForm number_empty{"it counts as empty: a case that needs it is refused",
    "hij telt als leeg: invoer die hem nodig heeft, wordt geweigerd"};
constexpr SentenceForm no_dilatancy{"the soil does not dilate", "de grond dilateert niet"};
constexpr SentenceForm no_preload{"the soil counts as normally consolidated, or what StateType names is asked for",
    "de grond telt als normaal geconsolideerd, of wat StateType noemt wordt gevraagd"};
constexpr SentenceForm crest_from_ground{"crest and river's side follow from the ground and the water",
    "kruin en rivierzijde volgen uit het maaiveld en het water"};

constexpr std::array table{ExpectedKeys{"projectinfo", both_models, "ContentVersion",
                               {"none: the data model follows from the members", ""}, in_words_only},
    ExpectedKeys{"projectinfo", second_model, "ApplicationModified ApplicationCreated",
        {"the program that wrote the file is not known, or the one that made it", ""}, in_words_only},
    ExpectedKeys{"*StochasticParameter", both_models, "IsProbabilistic Mean StandardDeviation", no_design},
    ExpectedKeys{"geometries", both_models, "Layers",
        {"the stage counts as one without soil", "de fase telt als een zonder grond"}},
    ExpectedKeys{"geometries, Layers[]", both_models, "Label", {"the layer is called by its soil", ""}, in_words_only},
    ExpectedKeys{"soillayers", both_models, "SoilLayers",
        {"no layer has a soil, and the stage cannot be computed",
            "geen laag heeft grond, en de fase kan niet worden berekend"}},
    ExpectedKeys{"soillayers, SoilLayers[]", both_models, "SoilId",
        {"the layer has no soil, and the stage cannot be computed",
            "de laag heeft geen grond, en de fase kan niet worden berekend"}},
    ExpectedKeys{"soils", both_models, "Soils", {"there are none", "er zijn er geen"}},
    ExpectedKeys{"soils, Soils[]", both_models, "Code Name", {"the soil has none", ""}, in_words_only},
    ExpectedKeys{"soils, Soils[]", both_models, "VolumetricWeightAbovePhreaticLevel VolumetricWeightBelowPhreaticLevel",
        number_empty},
    ExpectedKeys{"soils, Soils[]", both_models,
        "ShearStrengthModelTypeAbovePhreaticLevel ShearStrengthModelTypeBelowPhreaticLevel",
        {"the soil has no strength there, and a case that needs it is refused",
            "de grond heeft daar geen sterkte, en invoer die haar nodig heeft, wordt geweigerd"}},
    ExpectedKeys{"soils, Soils[]", both_models, "IsProbabilistic", {"nothing: it was not needed", ""}, in_words_only},
    ExpectedKeys{"soils, Soils[]", first_model, "Cohesion FrictionAngle ShearStrengthRatio StrengthIncreaseExponent",
        number_empty},
    ExpectedKeys{"soils, Soils[]", first_model, "Dilatancy", no_dilatancy},
    ExpectedKeys{"soils, Soils[]", first_model,
        "CohesionStochasticParameter FrictionAngleStochasticParameter DilatancyStochasticParameter "
        "ShearStrengthRatioStochasticParameter StrengthIncreaseExponentStochasticParameter",
        no_design},
    ExpectedKeys{"soils, Soils[]", second_model,
        "MohrCoulombAdvancedShearStrengthModel MohrCoulombClassicShearStrengthModel SuShearStrengthModel SuTable",
        {"its numbers count as empty: a case that needs them is refused",
            "de getallen ervan tellen als leeg: invoer die ze nodig heeft, wordt geweigerd"}},
    ExpectedKeys{
        "soils, Soils[].MohrCoulombAdvancedShearStrengthModel", second_model, "Cohesion FrictionAngle", number_empty},
    ExpectedKeys{"soils, Soils[].MohrCoulombAdvancedShearStrengthModel", second_model, "Dilatancy", no_dilatancy},
    ExpectedKeys{"soils, Soils[].MohrCoulombAdvancedShearStrengthModel", second_model,
        "CohesionStochasticParameter FrictionAngleStochasticParameter DilatancyStochasticParameter", no_design},
    ExpectedKeys{
        "soils, Soils[].MohrCoulombClassicShearStrengthModel", second_model, "Cohesion FrictionAngle", number_empty},
    ExpectedKeys{"soils, Soils[].MohrCoulombClassicShearStrengthModel", second_model,
        "CohesionStochasticParameter FrictionAngleStochasticParameter", no_design},
    ExpectedKeys{"soils, Soils[].SuShearStrengthModel", second_model, "ShearStrengthRatio StrengthIncreaseExponent",
        number_empty},
    ExpectedKeys{"soils, Soils[].SuShearStrengthModel", second_model,
        "ShearStrengthRatioStochasticParameter StrengthIncreaseExponentStochasticParameter", no_design},
    ExpectedKeys{"soils, Soils[].SuTable", both_models, "SuTablePoints",
        {"the table has no rows: a case that needs it is refused",
            "de tabel heeft geen rijen: invoer die haar nodig heeft, wordt geweigerd"}},
    ExpectedKeys{
        "soils, Soils[].SuTable", both_models, "IsSuTableProbabilistic SuTableVariationCoefficient", no_design},
    ExpectedKeys{
        "soilvisualizations", both_models, "SoilVisualizations", {"soils have colours of Terp", ""}, in_words_only},
    ExpectedKeys{"soilvisualizations, SoilVisualizations[]", both_models, "Color SoilId",
        {"the soil has a colour of Terp", ""}, in_words_only},
    ExpectedKeys{"decorations", both_models, "Excavations", no_such_part},
    ExpectedKeys{"decorations", first_model, "Berms", {"nothing: added layers are in the geometry", ""}, in_words_only},
    ExpectedKeys{
        "decorations", second_model, "Elevations", {"nothing: added layers are in the geometry", ""}, in_words_only},
    ExpectedKeys{"decorations, Excavations[]", both_models, "Points",
        {"the excavation takes nothing away", "de ontgraving neemt niets weg"}},
    ExpectedKeys{"waternets", both_models, "PhreaticLineId", {"the stage has no water", "de fase heeft geen water"}},
    ExpectedKeys{"waternets", both_models, "HeadLines ReferenceLines", no_such_part},
    ExpectedKeys{
        "waternets, HeadLines[]", both_models, "Points", {"the line has no places", "de lijn heeft geen punten"}},
    ExpectedKeys{"waternets, HeadLines[]", both_models, "Label", {"the line has no name", ""}, in_words_only},
    ExpectedKeys{
        "waternets, ReferenceLines[]", both_models, "Points", {"the line was left out", "de lijn is weggelaten"}},
    ExpectedKeys{"waternets, ReferenceLines[]", both_models, "TopHeadLineId BottomHeadLineId",
        {"the head of the line's other side; without both the line was left out",
            "de stijghoogte van de andere zijde van de lijn; zonder beide is de lijn weggelaten"}},
    ExpectedKeys{"waternets, ReferenceLines[]", both_models, "Label", {"the line has no name", ""}, in_words_only},
    ExpectedKeys{
        "watermeshes", second_model, "Elements", {"the mesh has no triangles", "het net heeft geen driehoeken"}},
    ExpectedKeys{"watermeshes", second_model, "UnitWeightWater",
        {"the unit weight of the stage's lines, or 9.81 kN/m3",
            "het volumegewicht van de lijnen van de fase, of 9,81 kN/m3"}},
    ExpectedKeys{"waternetcreatorsettings", both_models, "EmbankmentCharacteristics", crest_from_ground},
    ExpectedKeys{"waternetcreatorsettings, EmbankmentCharacteristics", both_models,
        "EmbankmentToeWaterSide EmbankmentTopWaterSide EmbankmentTopLandSide ShoulderBaseLandSide "
        "EmbankmentToeLandSide",
        {"this point of the embankment counts as not given", "dit punt van de dijk telt als niet gegeven"}},
    ExpectedKeys{"states", both_models, "StatePoints StateLines", no_such_part},
    ExpectedKeys{"states, StatePoints[]", both_models, "LayerId", {"the point was left out", "het punt is weggelaten"}},
    ExpectedKeys{"states, StatePoints[]", both_models, "Stress",
        {"the soil counts as normally consolidated", "de grond telt als normaal geconsolideerd"}},
    ExpectedKeys{"states, StatePoints[]", both_models, "Id Label", {"the point has none", ""}, in_words_only},
    ExpectedKeys{"states, StatePoints[].Stress", both_models, "StateType Pop", no_preload},
    ExpectedKeys{"states, StatePoints[].Stress", both_models, "PopStochasticParameter", no_design},
    ExpectedKeys{"states, StatePoints[].Stress", both_models, "Ocr YieldStress",
        {"nothing, unless StateType names it", ""}, in_words_only},
    ExpectedKeys{
        "states, StateLines[]", both_models, "Points Values", {"the line was left out", "de lijn is weggelaten"}},
    ExpectedKeys{"states, StateLines[].Values[]", both_models, "Above Below",
        {"the soil on that side counts as normally consolidated",
            "de grond aan die zijde telt als normaal geconsolideerd"}},
    ExpectedKeys{"states, StateLines[].Values[]", both_models, "Id Label", {"the place has none", ""}, in_words_only},
    ExpectedKeys{"states, StateLines[].Values[].Above", both_models, "StateType Pop", no_preload},
    ExpectedKeys{"states, StateLines[].Values[].Below", both_models, "StateType Pop", no_preload},
    ExpectedKeys{"states, StateLines[].Values[].Above", both_models, "PopStochasticParameter", no_design},
    ExpectedKeys{"states, StateLines[].Values[].Below", both_models, "PopStochasticParameter", no_design},
    ExpectedKeys{
        "statecorrelations", both_models, "StateCorrelations", {"nothing: it was not needed", ""}, in_words_only},
    ExpectedKeys{"loads", both_models, "UniformLoads LineLoads Trees LayerLoads", no_such_part},
    ExpectedKeys{"loads", both_models, "Earthquake", {"there is none", "er is er geen"}},
    ExpectedKeys{"loads, Earthquake", both_models, "IsEnabled", {"it is switched off", "zij staat uit"}},
    ExpectedKeys{"loads, UniformLoads[]", both_models, "Spread",
        {"0 degrees: the load does not spread", "0 graden: de belasting spreidt niet"}},
    ExpectedKeys{"loads, UniformLoads[]", both_models, "Consolidations",
        {"all soil is consolidated under the load", "alle grond is geconsolideerd onder de belasting"}},
    ExpectedKeys{"loads, UniformLoads[]", both_models, "Label", {"the load has no name", ""}, in_words_only},
    ExpectedKeys{"loads, LayerLoads[]", both_models, "Consolidations",
        {"all soil is consolidated under the layer", "alle grond is geconsolideerd onder de laag"}},
    ExpectedKeys{"reinforcements", both_models, "ForbiddenLines Geotextiles Nails", no_such_part},
    ExpectedKeys{"calculationsettings", both_models, "AnalysisType CalculationType",
        {"method or kind of the calculation are not known", ""}, in_words_only},
    ExpectedKeys{"calculationsettings", both_models, "ModelFactorMean",
        {"nothing: factors are compared without it", ""}, in_words_only},
    ExpectedKeys{"scenarios", second_model, "Calculations", {"the scenario has none", ""}, in_words_only},
    ExpectedKeys{"scenarios", second_model, "Label", {"the scenario has no name", ""}, in_words_only},
    ExpectedKeys{"scenarios, Calculations[]", second_model, "CalculationSettingsId ResultId Label Id",
        {"the calculation has none", ""}, in_words_only},
    ExpectedKeys{"stages", both_models, "Label", {"the stage has no name", ""}, in_words_only},
    ExpectedKeys{"stages", both_models, "StateId", {"the stage has no states", "de fase heeft geen toestanden"}},
    ExpectedKeys{
        "stages", both_models, "DecorationsId", {"the stage has no excavations", "de fase heeft geen ontgravingen"}},
    ExpectedKeys{"stages", both_models, "LoadsId", {"the stage has no loads", "de fase heeft geen belastingen"}},
    ExpectedKeys{"stages", both_models, "ReinforcementsId",
        {"the stage has no walls, geotextiles, nails", "de fase heeft geen wanden, geotextielen, nagels"}},
    ExpectedKeys{
        "stages", both_models, "WaternetId", {"the stage has no lines of water", "de fase heeft geen waterlijnen"}},
    ExpectedKeys{"stages", both_models, "WaternetCreatorSettingsId", crest_from_ground},
    ExpectedKeys{"stages", both_models, "StateCorrelationsId", {"nothing: it was not needed", ""}, in_words_only},
    ExpectedKeys{"stages", first_model, "CalculationSettingsId ResultId", {"the stage's calculation has none", ""},
        in_words_only},
    ExpectedKeys{"results", both_models, "FactorOfSafety|ReliabilityIndex", {"the result has none", ""}, in_words_only},
    ExpectedKeys{"results", both_models, "Points|ReliabilityIndex", {"the slip plane is not drawn", ""}, in_words_only},
    ExpectedKeys{"results", both_models, "Slices|ReliabilityIndex", {"nothing is compared with it", ""}, in_words_only},
    ExpectedKeys{"results, Points[]", both_models, "X Z", {"the place was left out", ""}, in_words_only},
    ExpectedKeys{"results, Slices[]", both_models, "TotalStress TotalPorePressure YieldStress SuOutput",
        {"the slices are not compared in it", ""}, in_words_only},
    ExpectedKeys{"results, Slices[]", both_models, "BottomLeft BottomRight",
        {"the slice has no foot and was left out", ""}, in_words_only}};

static_assert(std::ranges::none_of(table, [](const ExpectedKeys& row) { return row.decides && *row.assumed.nl == 0; }));

/// Members by kind that are in all files, and what their absence means; without soils and stages a file is refused.
constexpr std::array<std::pair<std::string_view, std::string_view>, 2> whole_members{
    {{"projectinfo", "the program that wrote the file is not known"},
        {"soilvisualizations", "soils have colours of Terp"}}};

using StagesOf = std::vector<std::pair<std::size_t, std::size_t>>;  ///< numbers of scenario and stage, from 0

struct Missing {
  const ExpectedKeys* row = nullptr;
  std::string first = {};  ///< where it was missed first
  std::size_t n = 0;
  StagesOf stages = {};
};

std::vector<std::string_view> words_of_list(std::string_view list, char between)
{
  std::vector<std::string_view> words;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(between), list.size());
    words.push_back(list.substr(0, end));
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return words;
}

bool is_at(const ExpectedKeys& row, const std::string& place)
{
  return row.place.starts_with('*') ? place.ends_with(row.place.substr(1)) : row.place == place;
}

bool has_one_of(const JsonNode& object, std::string_view keys)
{
  return std::ranges::any_of(
      words_of_list(keys, '|'), [&](std::string_view key) { return object.find(key) != nullptr; });
}

class MissingKeys {
 public:
  explicit MissingKeys(int model) : model_(model) {}

  /// stages: that the member is of.
  void look_at(const StixMember& member, const StagesOf& stages)
  {
    member_ = &member;
    stages_ = &stages;
    visit(member.content, member.kind, "");
  }

  void look_at_stage(const StixMember& member, const JsonNode& stage, const StagesOf& number)
  {
    member_ = &member;
    stages_ = &number;
    visit(stage, "stages", "Stages[]");
  }

  void tell(StixNotes& notes) const
  {
    for (const auto& [key, missing] : missing_) {
      const Sentence assumed{missing.row->assumed.en, missing.row->assumed.nl};
      const Sentence times = missing.n > 1 ? filled<reported_texts::times>(missing.n) : Sentence{};
      const Sentence what = filled<reported_texts::missing_key>(times, in_words(missing.stages), assumed);
      notes.remark({missing.first, what.en, !missing.row->decides, missing.stages, what.nl});
    }
  }

 private:
  void visit(const JsonNode& node, const std::string& place, const std::string& path)
  {
    if (node.kind == JsonKind::list) {
      for (const auto& [none, entry] : node.members) visit(entry, place + "[]", path + "[]");
      return;
    }
    if (node.kind != JsonKind::object) return;
    bool goes_on = false;
    for (const ExpectedKeys& row : table) {
      goes_on = goes_on || row.place.starts_with(place);
      if (!is_at(row, place) || (row.models & model_) == 0) continue;
      for (const std::string_view keys : words_of_list(row.keys, ' '))
        if (!has_one_of(node, keys)) miss(row, keys, path);
    }
    if (!goes_on) return;
    for (const auto& [key, value] : node.members) {
      if (place == "scenarios" && key == "Stages") continue;  // each by itself: look_at_stage
      visit(value, place + (path.empty() ? ", " : ".") + key, path + (path.empty() ? "" : ".") + key);
    }
  }

  void miss(const ExpectedKeys& row, std::string_view keys, const std::string& path)
  {
    Missing& missing = missing_[fmt::format("{}/{}", row.place, keys)];
    missing.row = &row;
    if (missing.n++ == 0) missing.first = fmt::format("{}, {}{}{}", member_->name, path, path.empty() ? "" : ".", keys);
    for (const auto& stage : *stages_)
      if (std::ranges::find(missing.stages, stage) == missing.stages.end()) missing.stages.push_back(stage);
  }

  static Sentence in_words(const StagesOf& stages)
  {
    Sentence text;
    for (const auto& [scenario, stage] : stages) {
      const char* const between = text.empty() ? " in " : "; ";
      const Sentence one = filled<reported_texts::stage_number>(scenario + 1, stage + 1);
      text = {text.en + between + one.en, text.nl + between + one.nl};
    }
    return text;
  }

  int model_;
  const StixMember* member_ = nullptr;
  const StagesOf* stages_ = nullptr;
  std::map<std::string, Missing> missing_;  ///< by place and key
};

/// The stages by the ids of their parts.
class PartsOfStages {
 public:
  void add(const JsonNode& stage, std::size_t scenario, std::size_t number)
  {
    for (const auto& [key, value] : stage.members)
      if (key != "Id" && key.ends_with("Id") && !value.text.empty()) stages_[value.text].push_back({scenario, number});
  }
  const StagesOf& of(const JsonNode& member) const
  {
    static const StagesOf none;
    const JsonNode* const id = member.find("Id");
    const auto found = id == nullptr ? stages_.end() : stages_.find(id->text);
    return found == stages_.end() ? none : found->second;
  }

 private:
  std::map<std::string, StagesOf> stages_;
};

}  // namespace

void tell_missing_keys(const std::vector<const StixMember*>& members, StixNotes& notes)
{
  const auto is_of = [](std::string_view kind) { return [=](const StixMember* m) { return m->kind == kind; }; };
  MissingKeys missing(std::ranges::any_of(members, is_of("scenarios")) ? second_model : first_model);
  PartsOfStages parts;
  std::size_t scenarios = 0, stages = 0;
  for (const StixMember* const member : members) {
    if (member->kind == "stages") {
      parts.add(member->content, 0, stages);
      missing.look_at(*member, {{0, stages++}});
    }
    const JsonNode* const list = member->kind == "scenarios" ? member->content.find("Stages") : nullptr;
    for (std::size_t k = 0; list != nullptr && k < list->members.size(); ++k) {
      const JsonNode& stage = list->members[k].second;
      parts.add(stage, scenarios, k);
      missing.look_at_stage(*member, stage, {{scenarios, k}});
    }
    if (member->kind == "scenarios") ++scenarios;
  }
  for (const StixMember* const member : members)
    if (member->kind != "stages") missing.look_at(*member, parts.of(member->content));
  missing.tell(notes);
  for (const auto& [kind, assumed] : whole_members)
    if (std::ranges::none_of(members, is_of(kind)))
      notes.remark_on_format(
          fmt::format("{}.json", kind), fmt::format("This member is missing. Taken was: {}.", assumed));
}

}  // namespace terp
