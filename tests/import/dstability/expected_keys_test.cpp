#include "archives.hpp"
#include "import/dstability/import_doubts.hpp"

namespace expected_keys_test {

StixProject without(const std::string& sample, const std::string& member, const std::string& key)
{
  Members members = members_of_sample(sample);
  for (auto& [name, text] : members) {
    if (name != member) continue;
    auto json = nlohmann::ordered_json::parse(text);
    const auto drop = [&](const auto& self, auto& node) -> void {
      if (node.is_object()) node.erase(key);
      if (node.is_structured())
        for (auto& child : node) self(self, child);
    };
    drop(drop, json);
    text = json.dump();
  }
  return read_stix_bytes(zip_of(members), "dike.stix");
}

TEST(ExpectedKeys, AreAllThereInTheSamples)
{
  for (const char* sample : {"all-result-kinds-stale", "berm-fragility-2023", "example-2020.03-v1", "tutorial-2020-v1",
           "tutorial-2022.01-v1", "tutorial-2023", "tutorial-2026.01"})
    EXPECT_THAT(remarks_of(read_stix(sample_path(sample))), testing::Not(Contains(HasSubstr("is missing")))) << sample;
}

TEST(ExpectedKeys, ThatAreMissingAreToldWithTheirStageAndWhatWasTaken)
{
  EXPECT_THAT(remarks_of(without(berm, "loads/loads.json", "Spread")),
      Contains(
          "loads/loads.json, UniformLoads[].Spread: This key is missing in scenario 1, stage 1, though files of this "
          "kind have it. Taken was: 0 degrees: the load does not spread."));
  EXPECT_THAT(remarks_of(without("tutorial-2023", "states/states_2.json", "StateLines")),
      Contains(AllOf(StartsWith("states/states_2.json, StateLines: This key is missing in scenario 2, stage 2"),
          EndsWith("Taken was: the stage counts as one without them."))));
  EXPECT_THAT(remarks_of(without("example-2020.03-v1", "stages/stage_1.json", "LoadsId")),
      Contains(HasSubstr("LoadsId: This key is missing in scenario 1, stage 2, though")));
  EXPECT_THAT(remarks_of(without(berm, "soils.json", "StandardDeviation")),
      Contains(HasSubstr("CohesionStochasticParameter.StandardDeviation: This key is missing (96 times), though")));
}

TEST(ExpectedKeys, MakeADoubtOfTheStagesThatTheyDecide)
{
  const StixProject project = without("tutorial-2023", "states/states_2.json", "StateLines");
  EXPECT_THAT(in_english(doubts_of_reading(project, 1, 1)), Contains(HasSubstr("StateLines: This key is missing")));
  EXPECT_THAT(in_english(doubts_of_reading(project, 1, 0)), testing::Not(Contains(HasSubstr("is missing"))))
      << "a later stage";
  EXPECT_THAT(in_english(doubts_of_reading(project, 0, 0)), testing::Not(Contains(HasSubstr("is missing"))))
      << "another scenario";
  const StixProject labels = without("tutorial-2023", "geometries/geometry_2.json", "Label");
  EXPECT_THAT(remarks_of(labels), Contains(HasSubstr("Layers[].Label: This key is missing")));
  EXPECT_THAT(in_english(doubts_of_reading(labels, 1, 1)), testing::Not(Contains(HasSubstr("is missing"))))
      << "only a name";
}

TEST(ExpectedKeys, AreThoseOfTheDataModel)
{
  EXPECT_THAT(remarks_of(without("example-2020.03-v1", "soils.json", "Dilatancy")),
      Contains(HasSubstr("Soils[].Dilatancy: This key is missing (")));
  EXPECT_THAT(remarks_of(without("example-2020.03-v1", "decorations/decorations.json", "Berms")),
      Contains(HasSubstr("decorations.json, Berms: This key is missing")));
  EXPECT_THAT(remarks_of(without(berm, "decorations/decorations.json", "Elevations")),
      Contains(HasSubstr("decorations.json, Elevations: This key is missing")));
}

TEST(ExpectedKeys, AMemberThatIsMissingIsTold)
{
  Members members = members_of_sample(berm);
  std::erase_if(members, [](const auto& m) { return m.first == "soilvisualizations.json"; });
  EXPECT_THAT(remarks_of(read_stix_bytes(zip_of(members), "dike.stix")),
      Contains("soilvisualizations.json: This member is missing. Taken was: soils have colours of Terp."));
}

}  // namespace expected_keys_test
