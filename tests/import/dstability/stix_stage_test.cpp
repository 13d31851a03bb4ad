#include "import/dstability/stix_stage.hpp"

#include "import/dstability/section.hpp"
#include "archives.hpp"

#include <set>

namespace stix_stage_test {

using Json = nlohmann::ordered_json;

/// After the last stage of the first scenario: a box, on it 1 mm of another soil, on it a body that overhangs a gap.
AddedStage stage_of(const StixProject& project)
{
  const std::string heavy = project.soils.front().id, light = project.soils.back().id;
  AddedStage added{0, project.scenarios[0].stages.size() - 1, "after", {}, {}};
  added.layers = {{"base", heavy, {{0.0, -4.0}, {20.0, -4.0}, {20.0, 0.0}, {0.0, 0.0}}},
      {"thin", light, {{0.0, 0.0}, {20.0, 0.0}, {20.0, 0.001}, {0.0, 0.001}}},
      {"top", heavy, {{0.0, 0.001}, {8.0, 0.001}, {8.0, 1.0}, {12.0, 1.0}, {12.0, 3.0}, {0.0, 3.0}}}};
  WaterSituation water;
  water.phreatic_line = {{0.0, -1.0}, {20.0, -1.0}};
  water.head_lines = {{"sand", {{0.0, 0.5}, {20.0, 0.5}}}};
  water.reference_lines = {{{{0.0, -3.0}, {20.0, -3.0}}, "sand", "sand"}};
  added.water = WaterOfLines{water, 9.81e3};
  return added;
}

struct Written {
  StixProject before, after;
  Members old_members, new_members;
};

Written write_after(const std::string& sample)
{
  Written w;
  const std::string bytes = read_file(sample_path(sample));
  w.before = read_stix_bytes(bytes, sample);
  const std::string made = with_added_stage(bytes, sample, stage_of(w.before));
  w.after = read_stix_bytes(made, sample);
  w.old_members = members_of_sample(sample);
  ZipMembers zip(sample, made);
  for (std::size_t k = 0; k < zip.names().size(); ++k) w.new_members.emplace_back(zip.names()[k], zip.text(k));
  return w;
}

const StixScenario& scenario_of(const Written& w) { return w.after.scenarios.back(); }

TEST(StixStage, IsReadBackWithTheStressesOfItsLayers)
{
  for (const char* sample : {"tutorial-2026.01", "tutorial-2023", "tutorial-2020-v1", "berm-fragility-2023"}) {
    const Written w = write_after(sample);
    const StixScenario& scenario = scenario_of(w);
    const StixStage& stage = scenario.stages.back();
    EXPECT_EQ(stage.label, "after");
    ASSERT_EQ(stage.layers.size(), 3u);
    const StixSoil &heavy = w.after.soils.front(), &light = w.after.soils.back();
    const StixStageColumn thick(w.after, stage, 4.0), overhung(w.after, stage, 10.0), low(w.after, stage, 16.0);
    EXPECT_NEAR(thick.ground(), 3.0, 1e-9);
    EXPECT_NEAR(overhung.ground(), 3.0, 1e-9);
    EXPECT_NEAR(low.ground(), 0.001, 1e-9);
    const Real base = heavy.weight_above + 0.5 * heavy.weight_below;  // down to z = -1.5 m, water at -1 m
    EXPECT_NEAR(low.total_stress(-1.5), base + 0.001 * light.weight_above, 1e-3);
    EXPECT_NEAR(thick.total_stress(-1.5), base + 0.001 * light.weight_above + 2.999 * heavy.weight_above, 1e-3);
    EXPECT_NEAR(overhung.total_stress(-1.5), base + 0.001 * light.weight_above + 2.0 * heavy.weight_above, 1e-3);
    EXPECT_NEAR(thick.pore_pressure(-3.5), 9.81e3 * 4.0, 1e-3) << "the head of the sand";
    EXPECT_NO_THROW(
        StixSection(w.after, w.after.scenarios.size() - 1, scenario.stages.size() - 1, StixBasis::deterministic));
  }
}

TEST(StixStage, LeavesEveryOtherMemberAsItIs)
{
  for (const char* sample : {"tutorial-2026.01", "tutorial-2020-v1"}) {
    const Written w = write_after(sample);
    const std::map<std::string, std::string> now(w.new_members.begin(), w.new_members.end());
    for (const auto& [name, text] : w.old_members) {
      if (name == "checksum") continue;
      ASSERT_TRUE(now.contains(name)) << name;
      EXPECT_EQ(now.at(name), text) << name;
    }
    EXPECT_FALSE(now.contains("checksum"));
  }
}

void collect_ids(const Json& json, std::vector<std::string>& ids)
{
  if (json.is_object() && json.contains("Id") && json["Id"].is_string()) ids.push_back(json["Id"]);
  if (json.is_structured())
    for (const Json& value : json) collect_ids(value, ids);
}

TEST(StixStage, ItsMembersHaveTheKeysAndVersionsOfTheirKindAndIdsOfTheirOwn)
{
  for (const char* sample : {"tutorial-2026.01", "tutorial-2020-v1", "berm-fragility-2023"}) {
    const Written w = write_after(sample);
    std::map<std::string, std::set<std::vector<std::string>>> kinds;  // keys of the members of a folder
    const auto keys_of = [](const Json& json) {
      std::vector<std::string> keys;
      for (const auto& [key, value] : json.items()) keys.push_back(key);
      return keys;
    };
    const auto folder_of = [](const std::string& name) { return name.substr(0, name.find('/')); };
    std::set<std::string> names;
    for (const auto& [name, text] : w.old_members) {
      names.insert(name);
      if (name.ends_with(".json")) kinds[folder_of(name)].insert(keys_of(Json::parse(text)));
    }
    std::size_t n_new = 0;
    std::vector<std::string> ids;
    for (const auto& [name, text] : w.new_members) {
      if (!name.ends_with(".json")) continue;
      const Json json = Json::parse(text);
      collect_ids(json, ids);
      if (names.contains(name)) continue;
      ++n_new;
      EXPECT_TRUE(kinds[folder_of(name)].contains(keys_of(json))) << name;
      EXPECT_EQ(json["ContentVersion"], w.before.content_version) << name;
    }
    EXPECT_GE(n_new, 9u);
    const std::set<std::string> unique(ids.begin(), ids.end());
    EXPECT_EQ(unique.size(), ids.size());
  }
}

TEST(StixStage, TheScenariosOfTheFileKeepTheirStagesAndCalculations)
{
  const Written w = write_after("tutorial-2026.01");
  ASSERT_EQ(w.after.scenarios.size(), w.before.scenarios.size() + 1);
  for (std::size_t s = 0; s < w.before.scenarios.size(); ++s) {
    EXPECT_EQ(w.after.scenarios[s].stages.size(), w.before.scenarios[s].stages.size());
    EXPECT_EQ(w.after.scenarios[s].calculations.size(), w.before.scenarios[s].calculations.size());
  }
  EXPECT_EQ(scenario_of(w).stages.size(), w.before.scenarios[0].stages.size() + 1);
  ASSERT_EQ(scenario_of(w).calculations.size(), 1u);
  EXPECT_FALSE(scenario_of(w).calculations[0].result.has_value());
  const Written of_one_sequence = write_after("tutorial-2020-v1");
  EXPECT_EQ(scenario_of(of_one_sequence).stages.size(), of_one_sequence.before.scenarios[0].stages.size() + 1);
}

TEST(StixStage, FollowsTheLastOfOneSequence)
{
  const std::string bytes = read_file(sample_path("tutorial-2020-v1"));
  AddedStage early = stage_of(read_stix_bytes(bytes, "a.stix"));
  early.after = 0;
  EXPECT_THAT(
      refusal<InputError>([&] { with_added_stage(bytes, "a.stix", early); }), HasSubstr("has stages after stage 1"));
}

}  // namespace stix_stage_test
