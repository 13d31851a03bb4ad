// A file is a graph: members name each other by ids. So all members are read first, into tables by id (StixParts), and
// scenarios last, which take copies of what their ids name. Until notes.finish() throws all faults together, or at the
// tenth, a part with a fault is there, with values that say nothing.

#include "import/dstability/read_stix.hpp"

#include "import/dstability/foreign_file.hpp"

#include "math/utf8.hpp"
#include "import/dstability/section.hpp"
#include "import/dstability/stix_parts.hpp"
#include "io/files/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace terp {
namespace {

struct StixSource {
  StixNotes notes;
  std::vector<StixMember> members;
  StixParts parts;
  StixProject project;

  JsonCursor cursor(const StixMember& member) { return {member.content, member.name, notes}; }
};

using ReadMember = void (*)(JsonCursor&, StixParts&);
struct PartKind {
  std::string_view kind;
  ReadMember read;
};

constexpr std::array part_kinds{PartKind{"geometries", read_geometry}, PartKind{"soillayers", read_soil_layers},
    PartKind{"waternets", read_waternet}, PartKind{"watermeshes", read_water_mesh},
    PartKind{"waternetcreatorsettings", read_waternet_creator}, PartKind{"states", read_states},
    PartKind{"statecorrelations", read_state_correlations}, PartKind{"loads", read_loads},
    PartKind{"reinforcements", read_reinforcements}, PartKind{"decorations", read_decorations},
    PartKind{"calculationsettings", read_settings}, PartKind{"soilvisualizations", read_colours}};

/// All slip planes that were tried: most of the bytes of a file.
const std::vector<std::string> all_planes{"SlipPlaneResults"};

/// Known, and without meaning here.
constexpr std::array passed_over{std::string_view("nailpropertiesforsoils"), std::string_view("soilcorrelations")};
/// Read by name in `read_project`.
constexpr std::array read_by_name{std::string_view("projectinfo"), std::string_view("soils"),
    std::string_view("scenarios"), std::string_view("stages"), std::string_view("results")};

std::string kind_of(const std::string& name)
{
  const std::size_t slash = name.find('/');
  return slash != std::string::npos ? name.substr(0, slash) : name.substr(0, name.rfind(".json"));
}

bool is_read(const std::string& kind)
{
  return std::ranges::find(part_kinds, kind, &PartKind::kind) != part_kinds.end() ||
         std::ranges::find(read_by_name, kind) != read_by_name.end();
}

void unpack(StixSource& source, ZipMembers& zip)
{
  for (std::size_t k = 0; k < zip.names().size(); ++k) {
    const std::string& name = zip.names()[k];
    const std::string kind = kind_of(name);
    if (name == "checksum" || std::ranges::find(passed_over, kind) != passed_over.end()) continue;
    if (!name.ends_with(".json") || !is_read(kind))
      source.notes.remark_on_format(name, "This member is not known to Terp and was not read.");
    else {
      const std::string text = zip.text(k), sound = as_utf8(text);
      if (sound != text)
        source.notes.remark_on_format(name, "Some letters are not UTF-8. They were read as the sign U+FFFD.");
      source.members.push_back({name, kind, read_json(sound, source.project.path + ", " + name, all_planes)});
    }
  }
}

/// What has a version is of one that Terp knows, or is reported.
void check_versions(StixSource& source)
{
  for (const StixMember& member : source.members) {
    JsonCursor file = source.cursor(member);
    if (member.content.kind != JsonKind::object) {
      source.notes.fault(member.name, "is no object", fmt::format("Got {}.", words_of(member.content.kind)));
      continue;
    }
    const std::string version = file.has("ContentVersion") ? file.text("ContentVersion") : "";
    if (!version.empty() && version != "1" && version != "2")
      source.notes.remark_on_format(
          member.name, fmt::format("ContentVersion is \"{}\"; Terp knows 1 and 2. It was read as 2.", version));
    if (member.kind == "projectinfo") {
      source.project.content_version = version;
      source.project.application =
          file.text(file.has("ApplicationModified") ? "ApplicationModified" : "ApplicationCreated");
    }
  }
}

/// "bishop/bishopresult_1" of results/bishop/bishopresult_1.json.
std::string result_name(const StixMember& member)
{
  const std::size_t start = std::min(member.name.find('/') + 1, member.name.size()), end = member.name.rfind(".json");
  return member.name.substr(start, end - start);
}

void read_members(StixSource& source)
{
  for (const StixMember& member : source.members) {
    JsonCursor file = source.cursor(member);
    const auto part = std::ranges::find(part_kinds, member.kind, &PartKind::kind);
    if (part != part_kinds.end()) part->read(file, source.parts);
    if (member.kind == "soils") read_soils(file, source.project.soils);
    if (member.kind == "results") read_result(file, result_name(member), source.parts);
  }
  for (StixSoil& soil : source.project.soils)
    if (const auto found = source.parts.colours.find(soil.id); found != source.parts.colours.end())
      soil.colour = found->second;
}

/// What is wrong if an id is empty, or names nothing: both; the latter; nothing, and it is reported.
enum class Need { must_be_named, must_exist, may_be_missing };

/// The part that an id names; null without one.
template <class T>
const T* part_of(JsonCursor& from, const char* key, const StixById<T>& things, Need need = Need::must_exist)
{
  const std::string id = need == Need::must_be_named ? from.id(key) : from.text(key);
  if (id.empty()) return nullptr;
  const T* const thing = things.find(id);
  if (thing == nullptr && need == Need::may_be_missing)
    from.remark(filled<reported_texts::leads_nowhere>(key, id));
  else if (thing == nullptr)
    from.fault(key, "names what is not in the file",
        fmt::format("Got the id {}. The file is not complete: save it anew in D-Stability.", id));
  return thing;
}

void set_soils(
    JsonCursor& from, const std::map<std::string, std::string>& soils, const StixProject& project, StixStage& stage)
{
  for (const auto& [layer, soil] : soils) {
    const auto found = std::ranges::find(stage.layers, layer, &StixLayer::id);
    if (found == stage.layers.end() || soil.empty()) continue;
    const auto of_project = std::ranges::find(project.soils, soil, &StixSoil::id);
    if (of_project == project.soils.end())
      from.fault("SoilLayersId", "leads to a soil that is not in soils.json",
          fmt::format("The layer `{}` has the soil with the id {}.", found->label, soil));
    else
      found->soil = static_cast<std::size_t>(of_project - project.soils.begin());
  }
}

void set_water(JsonCursor& from, const StixParts& parts, StixStage& stage)
{
  const auto* const lines = part_of(from, "WaternetId", parts.waternets);
  if (lines != nullptr) stage.water = *lines;
  const std::string kind = from.text("WaterDefinitionType");
  const Need need = kind == "WaterMesh" ? Need::must_exist : Need::may_be_missing;
  const auto* const mesh = part_of(from, "WaterMeshId", parts.water_meshes, need);
  if (kind == "WaterMesh") {
    if (mesh == nullptr || mesh->mesh.empty())
      from.fault("WaterMeshId", "has no water mesh", "WaterDefinitionType is WaterMesh.");
    else
      stage.water = *mesh;
  }
  if ((stage.water.is_mesh || stage.water.phreatic) && !(stage.water.unit_weight > 0.0))
    from.fault(stage.water.is_mesh ? "WaterMeshId" : "WaternetId", "leads to water without weight",
        "UnitWeightWater must be more than zero.");
  if (!kind.empty() && kind != "WaterLines" && kind != "WaterMesh")
    from.fault(
        "WaterDefinitionType", "is none that Terp knows", fmt::format("Got \"{}\"; WaterLines or WaterMesh.", kind));
}

StixStage read_stage(JsonCursor& from, const StixParts& parts, const StixProject& project)
{
  StixStage stage;
  stage.id = from.id("Id"), stage.label = from.text("Label");
  if (const auto* layers = part_of(from, "GeometryId", parts.geometries, Need::must_be_named)) stage.layers = *layers;
  if (const auto* soils = part_of(from, "SoilLayersId", parts.soil_layers, Need::must_be_named))
    set_soils(from, *soils, project, stage);
  set_water(from, parts, stage);
  const auto take = [&]<class Part>(const char* key, const StixById<Part>& things) {
    if (const Part* part = part_of(from, key, things)) static_cast<Part&>(stage) = *part;
  };
  take("StateId", parts.states);
  take("DecorationsId", parts.decorations);
  take("LoadsId", parts.loads);
  take("ReinforcementsId", parts.reinforcements);
  if (const auto* at = part_of(from, "WaternetCreatorSettingsId", parts.embankments, Need::may_be_missing))
    stage.embankment = *at;
  part_of(from, "StateCorrelationsId", parts.state_correlations, Need::may_be_missing);
  from.pass_over({"Notes"});
  return stage;
}

/// A result that no calculation names is not shown, but reported.
void remark_on_results(StixSource& source)
{
  std::set<std::string> named;
  for (const StixScenario& scenario : source.project.scenarios)
    for (const StixCalculation& calculation : scenario.calculations)
      if (calculation.result) named.insert(calculation.result->name);
  for (const StixMember& member : source.members)
    if (member.kind == "results" && !named.contains(result_name(member)))
      source.notes.remark(member.name, filled<reported_texts::result_of_none>());
}

/// Settings and result that a calculation names, or, of data model 1, a stage.
StixCalculation read_calculation(JsonCursor& from, const StixParts& parts, std::size_t stage)
{
  StixCalculation calculation;
  if (const auto* settings = part_of(from, "CalculationSettingsId", parts.settings, Need::may_be_missing))
    calculation = *settings;
  const std::string method = from.text("AnalysisType");  // of a stage of data model 1 that another program wrote
  if (calculation.method.empty()) calculation.method = method;
  calculation.id = from.text("Id");
  calculation.label = from.text("Label");
  calculation.stage = stage;
  if (const auto* result = part_of(from, "ResultId", parts.results, Need::may_be_missing)) calculation.result = *result;
  return calculation;
}

StixScenario read_scenario(JsonCursor& file, const StixParts& parts, const StixProject& project)
{
  StixScenario scenario{.id = file.id("Id"), .label = file.text("Label")};
  for (JsonCursor& entry : file.list("Stages")) {
    scenario.stages.push_back(read_stage(entry, parts, project));
    entry.tell_unknown();
  }
  for (JsonCursor& entry : file.list("Calculations")) {
    scenario.calculations.push_back(
        read_calculation(entry, parts, scenario.stages.empty() ? 0 : scenario.stages.size() - 1));
    entry.pass_over({"Notes"});
    entry.tell_unknown();
  }
  if (scenario.stages.empty()) file.fault("Stages", "has no stage", "A scenario has one at least.");
  file.pass_over({"ContentVersion", "Notes"});
  file.tell_unknown();
  return scenario;
}

/// Data model 1: the stages of the file are one sequence, which stands in `members`.
StixScenario read_stages(StixSource& source, const std::vector<const StixMember*>& members)
{
  StixScenario scenario;
  for (const StixMember* const member : members) {
    JsonCursor file = source.cursor(*member);
    const std::size_t number = scenario.stages.size();
    scenario.stages.push_back(read_stage(file, source.parts, source.project));
    scenario.calculations.push_back(read_calculation(file, source.parts, number));
    file.pass_over({"ContentVersion"});
    file.tell_unknown();
  }
  return scenario;
}

/// Scenarios, or stages of data model 1, in the order of their ids. D-Stability numbers all that it writes anew. The
/// names of members say less: other programs sort them as texts, _10 before _2, and write them in that order.
std::vector<const StixMember*> members_of(StixSource& source, std::string_view kind)
{
  std::vector<const StixMember*> members;
  for (const StixMember& member : source.members)
    if (member.kind == kind) members.push_back(&member);
  std::ranges::stable_sort(members, {}, [](const StixMember* member) {
    const JsonNode* const id = member->content.find("Id");
    const std::string digits = id == nullptr ? "" : id->text;
    return std::pair(digits.size(), digits);  // whole numbers without leading zeros
  });
  return members;
}

void look_for_missing_keys(StixSource& source)
{
  std::vector<const StixMember*> members = members_of(source, "scenarios");
  std::ranges::copy(members_of(source, "stages"), std::back_inserter(members));
  for (const StixMember& member : source.members)
    if (member.kind != "scenarios" && member.kind != "stages") members.push_back(&member);
  tell_missing_keys(members, source.notes);
}

/// Scenarios, their stages and their calculations have ids that nothing else has.
void check_ids(StixSource& source)
{
  std::map<std::string, std::string> known;  // id -> what has it
  const auto add = [&](const std::string& id, const std::string& what) {
    if (id.empty()) return;
    const auto [entry, is_new] = known.try_emplace(id, what);
    if (!is_new)
      source.notes.fault(what, fmt::format("has the id {}, which {} has", id, entry->second),
          "Ids link the parts of the file. Save it anew in D-Stability.");
  };
  for (std::size_t s = 0; s < source.project.scenarios.size(); ++s) {
    const StixScenario& scenario = source.project.scenarios[s];
    const std::string name = fmt::format("scenario {}", s + 1);
    add(scenario.id, name);
    for (std::size_t k = 0; k < scenario.stages.size(); ++k)
      add(scenario.stages[k].id, fmt::format("{}, stage {}", name, k + 1));
    if (scenario.id.empty()) continue;  // of data model 1 a calculation is a part of its stage
    for (std::size_t k = 0; k < scenario.calculations.size(); ++k)
      add(scenario.calculations[k].id, fmt::format("{}, calculation {}", name, k + 1));
  }
}

void read_scenarios(StixSource& source)
{
  for (const StixMember* const member : members_of(source, "scenarios")) {
    JsonCursor file = source.cursor(*member);
    source.project.scenarios.push_back(read_scenario(file, source.parts, source.project));
  }
  const auto stages = members_of(source, "stages");
  if (!stages.empty()) source.project.scenarios.push_back(read_stages(source, stages));
  check_ids(source);
  if (source.project.scenarios.empty())
    source.notes.fault("scenarios/", "is missing, and so is stages/", "The file has no stage that could be read.");
  const auto has_layers = [](const StixStage& stage) { return !stage.layers.empty(); };
  if (std::ranges::none_of(
          source.project.scenarios, [&](const StixScenario& s) { return std::ranges::any_of(s.stages, has_layers); }))
    source.notes.fault("geometries/", "has no soil layer in any stage",
        "There is nothing to read. Draw the section in D-Stability and save it.");
}

// ---- what is kept for the reader of the results, not for the run ----

Sentence list_of(const std::vector<StixDrawnLine>& lines)
{
  Sentence list;
  for (const StixDrawnLine& line : lines) {
    const std::string name = '`' + line.label + '`';
    const Sentence one = std::isnan(line.start[0]) ? Sentence{name, name}
                                                   : filled<reported_texts::drawn_line>(line.label, line.start[0]);
    const char* const between = list.empty() ? "" : ", ";
    list.en += between + one.en;
    list.nl += between + one.nl;
  }
  return list;
}

void remark_on_stage(StixNotes& notes, const std::string& where, const StixStage& stage)
{
  const auto tell = [&](const Sentence& what) { notes.remark(where, what); };
  if (!stage.forbidden_lines.empty()) tell(filled<reported_texts::forbidden_lines>(list_of(stage.forbidden_lines)));
  if (!stage.geotextiles.empty()) tell(filled<reported_texts::geotextiles>(list_of(stage.geotextiles)));
  if (!stage.nails.empty()) tell(filled<reported_texts::nails>(list_of(stage.nails)));
  if (stage.line_loads > 0) tell(filled<reported_texts::line_loads>(stage.line_loads));
  if (stage.trees > 0) tell(filled<reported_texts::trees>(stage.trees));
  if (stage.has_earthquake) tell(filled<reported_texts::earthquake>());
  for (const StixLayerLoad& load : stage.layer_loads)
    if (std::ranges::any_of(load.consolidation, [](const auto& d) { return d.second < 100.0; }))
      tell(filled<reported_texts::layer_load>(load.layer));
  for (const StixLayer& layer : stage.layers)
    if (!layer.soil) tell(filled<reported_texts::layer_without_soil>(layer.label, layer.id));
  for (const StixStatePoint& point : stage.state_points)
    if (std::ranges::find(stage.layers, point.layer, &StixLayer::id) == stage.layers.end())
      tell(filled<reported_texts::state_of_no_layer>(point.label, point.layer));
  for (const std::string& layer : layers_with_two_states(stage)) tell(filled<reported_texts::two_states>(layer));
  if (stage.layers.empty()) tell(filled<reported_texts::no_layers>());
}

void remark_on_stages(StixSource& source)
{
  for (std::size_t s = 0; s < source.project.scenarios.size(); ++s) {
    const StixScenario& scenario = source.project.scenarios[s];
    for (std::size_t k = 0; k < scenario.stages.size(); ++k)
      remark_on_stage(source.notes, fmt::format("scenario {}, stage {}", s + 1, k + 1), scenario.stages[k]);
  }
}

}  // namespace

StixProject read_stix_bytes(std::string bytes, const std::string& path, ZipLimits limits)
{
  StixSource source{.notes = StixNotes(path), .members = {}, .parts = {}, .project = {}};
  source.project.path = path;
  ZipMembers zip(path, std::move(bytes), limits);
  unpack(source, zip);
  check_versions(source);
  if (std::ranges::none_of(source.members, [](const StixMember& m) { return m.kind == "soils"; }))
    source.notes.fault("soils.json", "is missing",
        std::ranges::any_of(zip.names(), [](const std::string& name) { return name.ends_with("/soils.json"); })
            ? "All members lie in a folder. Zip the files in it, not the folder itself."
            : "This is no file of D-Stability, or one of another program.");
  read_members(source);
  read_scenarios(source);
  remark_on_stages(source);
  look_for_missing_keys(source);
  remark_on_results(source);
  source.project.remarks = source.notes.finish();
  return std::move(source.project);
}

StixProject read_stix(const std::string& path)
{
  const std::string bytes = read_file(path);
  if (kind_of_section(path, bytes) != SectionFile::dstability)
    throw InputError({path, "is no file of D-Stability", "Read it by itself: terp import.", ""});
  return read_stix_bytes(bytes, path);
}

}  // namespace terp
