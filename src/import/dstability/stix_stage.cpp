// Members that are not touched keep their bytes. A stage is copied with all members that its keys name: every `Id` in
// them gets a new number, and every key that ends in Id or Ids and names one of them follows.

#include "import/dstability/stix_stage.hpp"

#include "math/errors.hpp"
#include "math/number_from.hpp"
#include "import/dstability/zip_members.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace terp {
namespace {

using Json = nlohmann::ordered_json;

struct JsonMember {
  std::string name;
  Json content;
};

/// Calls f(key, value) for all members of objects in a text, at any depth.
template <class F>
void for_each_key(Json& json, const F& f)
{
  if (json.is_object())
    for (auto& [key, value] : json.items()) f(key, value);
  if (json.is_structured())
    for (Json& value : json) for_each_key(value, f);
}

Json points_json(const std::vector<Vec<2>>& places)
{
  Json points = Json::array();
  for (const Vec<2>& x : places) points.push_back({{"X", x[0]}, {"Z", x[1]}});
  return points;
}

class StageWriter {
 public:
  StageWriter(std::string bytes, const std::string& path) : path_(path)
  {
    ZipMembers zip(path, std::move(bytes));
    for (std::size_t k = 0; k < zip.names().size(); ++k) {
      const std::string& name = zip.names()[k];
      if (name == "checksum") continue;  // of what D-Stability wrote itself
      kept_.emplace_back(name, zip.text(k));
      if (!name.ends_with(".json")) continue;
      Json content = Json::parse(kept_.back().second, nullptr, false);
      if (content.is_discarded()) fail(name, "is no JSON text");
      for_each_key(content, [this](const std::string& key, const Json& value) {
        if (key == "Id" && value.is_string())
          next_ = std::max(next_, number_from<std::int64_t>(value.get<std::string>()).value_or(0) + 1);
      });
      if (content.is_object() && content.contains("Id")) members_.push_back({name, std::move(content)});
    }
  }

  std::string write(const AddedStage& added)
  {
    if (std::vector<JsonMember*> scenarios = of_kind("scenarios/"); !scenarios.empty())
      add_scenario(*scenarios.at(added.scenario), added);
    else
      add_last_stage(of_kind("stages/"), added);
    for (JsonMember& member : added_) kept_.emplace_back(member.name, member.content.dump());
    return zip_of(kept_);
  }

 private:
  [[noreturn]] void fail(const std::string& where, const std::string& what) const
  {
    throw InputError({path_ + ", " + where, what, "Save the file anew in D-Stability.", ""});
  }

  std::string new_id() { return std::to_string(next_++); }

  /// In the order of their ids, as the reader has them.
  std::vector<JsonMember*> of_kind(const std::string& folder)
  {
    std::vector<JsonMember*> found;
    for (JsonMember& member : members_)
      if (member.name.starts_with(folder)) found.push_back(&member);
    std::ranges::stable_sort(found, {}, [](const JsonMember* member) {
      const std::string id = member->content["Id"].get<std::string>();
      return std::pair(id.size(), id);
    });
    return found;
  }

  const JsonMember* member_of(const Json& id) const
  {
    const auto found = std::ranges::find_if(members_, [&](const JsonMember& m) { return m.content["Id"] == id; });
    return found == members_.end() ? nullptr : &*found;
  }

  /// "loads/loads_12.json", with the first number that is free.
  std::string free_name(const std::string& name) const
  {
    std::string stem = name.substr(0, name.size() - std::string_view(".json").size());
    if (const std::size_t line = stem.rfind('_'); line != std::string::npos && number_from<int>(stem.substr(line + 1)))
      stem.resize(line);
    const auto is_taken = [&](const std::string& wanted) {
      return std::ranges::any_of(kept_, [&](const auto& member) { return member.first == wanted; }) ||
             std::ranges::any_of(added_, [&](const JsonMember& member) { return member.name == wanted; });
    };
    for (int k = 1;; ++k)
      if (std::string wanted = fmt::format("{}_{}.json", stem, k); !is_taken(wanted)) return wanted;
  }

  /// A copy of an entry with all members that it names, with ids of their own. The numbers of the copies in added_ are
  /// appended to `copies`.
  Json copied(Json entry, std::map<std::string, std::size_t>* copies = nullptr)
  {
    if (entry.contains("ResultId")) entry["ResultId"] = nullptr;
    std::vector<std::pair<std::string, JsonMember>> parts;
    for (const auto& [key, value] : entry.items())
      if (key != "Id" && key.ends_with("Id"))
        if (const JsonMember* member = member_of(value)) parts.emplace_back(key, *member);
    std::map<std::string, std::string> ids;
    const auto number = [&](const std::string& key, const Json& value) {
      if (key == "Id" && value.is_string()) ids.try_emplace(value.get<std::string>(), new_id());
    };
    const auto follow = [&](Json& value) {
      if (!value.is_string()) return;
      if (const auto found = ids.find(value.get<std::string>()); found != ids.end()) value = found->second;
    };
    const auto rename = [&](const std::string& key, Json& value) {
      if (key.ends_with("Id")) follow(value);
      if (key.ends_with("Ids") && value.is_array()) std::ranges::for_each(value, follow);
    };
    for_each_key(entry, number);
    for (auto& [key, part] : parts) for_each_key(part.content, number);
    for_each_key(entry, rename);
    for (auto& [key, part] : parts) {
      for_each_key(part.content, rename);
      if (copies != nullptr) (*copies)[key] = added_.size();
      added_.push_back({free_name(part.name), std::move(part.content)});
    }
    return entry;
  }

  void add_scenario(const JsonMember& from, const AddedStage& added)
  {
    Json scenario = from.content;
    scenario["Id"] = new_id();
    scenario["Label"] = added.label;
    Json stages = Json::array(), calculations = Json::array();
    for (std::size_t k = 0; k <= added.after; ++k) stages.push_back(copied(from.content["Stages"].at(k)));
    stages.push_back(changed_stage(from.content["Stages"].at(added.after), added));
    if (const Json& old = from.content["Calculations"]; !old.empty()) calculations.push_back(copied(old.at(0)));
    scenario["Stages"] = std::move(stages);
    scenario["Calculations"] = std::move(calculations);
    added_.push_back({free_name(from.name), std::move(scenario)});
  }

  void add_last_stage(const std::vector<JsonMember*>& stages, const AddedStage& added)
  {
    if (added.after + 1 != stages.size())
      throw InputError({path_, fmt::format("has stages after stage {}", added.after + 1),
          "Files of before 2023 have one sequence of stages. Leave --stage out, so that the new one follows the last.",
          ""});
    const std::string name = stages.back()->name;
    Json stage = changed_stage(stages.back()->content, added);
    stage["Id"] = new_id();  // the largest, so that it is the last
    added_.push_back({free_name(name), std::move(stage)});
  }

  Json changed_stage(const Json& from, const AddedStage& added)
  {
    std::map<std::string, std::size_t> copies;
    Json stage = copied(from, &copies);
    stage["Label"] = added.label;
    const auto part = [&](const char* key) -> Json& {
      const auto found = copies.find(key);
      if (found == copies.end()) fail(fmt::format("stage {}", added.after + 1), fmt::format("has no {}", key));
      return added_[found->second].content;
    };
    std::vector<std::string> ids;
    Json layers = Json::array(), soils = Json::array();
    for (const StageLayer& layer : added.layers) {
      ids.push_back(new_id());
      layers.push_back(
          {{"Id", ids.back()}, {"Label", layer.label}, {"Notes", nullptr}, {"Points", points_json(layer.outline)}});
      soils.push_back({{"LayerId", ids.back()}, {"SoilId", layer.soil_id}});
    }
    part("GeometryId")["Layers"] = std::move(layers);
    part("SoilLayersId")["SoilLayers"] = std::move(soils);
    for (const char* key : {"DecorationsId", "StateId", "StateCorrelationsId", "ReinforcementsId"})
      if (copies.contains(key))
        for (auto& [name, value] : part(key).items())
          if (value.is_array()) value = Json::array();
    set_loads(part("LoadsId"), ids);
    if (copies.contains("WaternetCreatorSettingsId"))
      for (auto& [name, value] : part("WaternetCreatorSettingsId").items())
        if (name.ends_with("LayerId")) value = nullptr;
    if (added.water) {
      set_water(part("WaternetId"), *added.water);
      if (stage.contains("WaterDefinitionType")) stage["WaterDefinitionType"] = "WaterLines";
    }
    return stage;
  }

  /// No loads; as D-Stability has it, all layers as consolidated loads on all others.
  static void set_loads(Json& loads, const std::vector<std::string>& ids)
  {
    const auto consolidated = [&](const std::string& but) {
      Json list = Json::array();
      for (const std::string& id : ids)
        if (id != but) list.push_back({{"LayerId", id}, {"Degree", 100.0}});
      return list;
    };
    for (auto& [name, value] : loads.items())
      if (value.is_array()) value = Json::array();
    if (loads.contains("LayerLoads"))
      for (const std::string& id : ids)
        loads["LayerLoads"].push_back({{"LayerId", id}, {"Consolidations", consolidated(id)}});
    if (loads.contains("Earthquake") && loads["Earthquake"].is_object()) {
      loads["Earthquake"]["IsEnabled"] = false;
      loads["Earthquake"]["Consolidations"] = consolidated("");
    }
  }

  void set_water(Json& net, const WaterOfLines& water)
  {
    std::map<std::string, std::string> ids;  // of head lines, by their names
    Json heads = Json::array(), references = Json::array();
    const auto add_head = [&](const std::string& name, const std::string& label, const std::vector<Vec<2>>& places) {
      const std::string id = ids[name] = new_id();
      heads.push_back({{"Id", id}, {"Label", label}, {"Notes", nullptr}, {"Points", points_json(places)}});
    };
    add_head(std::string(phreatic_head), "Phreatic line", water.situation.phreatic_line);
    for (const HeadLine& line : water.situation.head_lines) add_head(line.name, line.name, line.places);
    for (const ReferenceLine& line : water.situation.reference_lines)
      references.push_back({{"Id", new_id()}, {"Label", ""}, {"Notes", nullptr}, {"Points", points_json(line.places)},
          {"TopHeadLineId", ids.at(line.head)}, {"BottomHeadLineId", ids.at(line.head_bottom)}});
    net["UnitWeightWater"] = water.unit_weight / 1e3;
    net["PhreaticLineId"] = ids.at(std::string(phreatic_head));
    net["HeadLines"] = std::move(heads);
    net["ReferenceLines"] = std::move(references);
  }

  std::string path_;
  std::vector<std::pair<std::string, std::string>> kept_;  ///< name, bytes
  std::vector<JsonMember> members_, added_;                ///< with an id, of the file; new
  std::int64_t next_ = 1;
};

}  // namespace

std::string with_added_stage(std::string bytes, const std::string& path, const AddedStage& added)
{
  return StageWriter(std::move(bytes), path).write(added);
}

}  // namespace terp
