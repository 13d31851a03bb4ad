#include "archives.hpp"
#include "import/dstability/section.hpp"
#include "support/catalogue.hpp"

namespace read_stix_test {

TEST(ReadStix, GivesWhatAFileOfDataModel2Holds)
{
  const StixProject project = read_stix(sample_path(berm));
  ASSERT_THAT(project.scenarios, SizeIs(1));
  const StixScenario& scenario = project.scenarios[0];
  ASSERT_THAT(scenario.stages, SizeIs(1));
  const StixStage& stage = scenario.stages[0];
  ASSERT_THAT(stage.layers, SizeIs(2));
  EXPECT_EQ(project.soils[*stage.layers[1].soil].name, "Clay with silt");
  EXPECT_EQ(project.soils[*stage.layers[1].soil].ratio.value, 0.22);
  EXPECT_EQ(project.soils[*stage.layers[1].soil].ratio.deviation, 0.03);
  EXPECT_EQ(project.soils[*stage.layers[0].soil].weight_above, 19300.0);
  EXPECT_EQ(stage.water.unit_weight, 9810.0);
  EXPECT_EQ(stage.loads[0].magnitude, 10000.0);
  EXPECT_THAT(stage.state_points, SizeIs(2));
  EXPECT_EQ(scenario.calculations[0].kind, StixCalculationKind::deterministic);
  EXPECT_NEAR(scenario.calculations[0].result->factor_of_safety, 0.8401, 5e-5);
  EXPECT_EQ(scenario.calculations[0].result->name, "bishopbruteforce/bishopbruteforceresult");
  EXPECT_THAT(remarks_of(project), IsEmpty());
}

TEST(ReadStix, GivesTheStagesOfDataModel1AsOneScenario)
{
  const StixProject project = read_stix(sample_path("tutorial-2022.01-v1"));
  ASSERT_THAT(project.scenarios, SizeIs(1));
  ASSERT_THAT(project.scenarios[0].stages, SizeIs(8));
  EXPECT_EQ(project.scenarios[0].stages[5].label, "Improvement");
  EXPECT_THAT(project.scenarios[0].stages[5].excavations, SizeIs(1));
  EXPECT_THAT(project.scenarios[0].stages[5].added_layers, SizeIs(2));
  const StixCalculation& design = project.scenarios[0].calculations[3];
  EXPECT_EQ(design.stage, 3U);
  EXPECT_EQ(design.kind, StixCalculationKind::design);
  EXPECT_NEAR(design.result->factor_of_safety, 1.0150, 5e-5);
  EXPECT_NEAR(design.result->slices[30].su, 30402.284, 1e-3);  // SuOutput, as there is no SuInput
}

TEST(ReadStix, SaysWhatIsOddAsTheCatalogueHasIt)
{
  const std::string path = source_path("tests/import/dstability/stix.wrong");
  for (const WrongRow& row : read_catalogue(path)) {
    std::string all;
    const std::string refused = refusal<InputError>([&] {
      for (const std::string& remark : remarks_of(read_changed(row.name, row.before, row.after)))
        all += (all.empty() ? "" : "\n") + remark;
    });
    expect_row(path, row, refused + all);
  }
}

TEST(ReadStix, OrdersStagesByTheirIdsAndNotByTheNamesOfMembers)
{
  Members members = members_of_sample("example-2020.03-v1");
  for (auto& [name, text] : members) {
    if (name == "stages/stage.json") name = "stages/stage_2.json";
    if (name == "stages/stage_1.json") name = "stages\\stage_10.json";
  }
  const StixProject project = read_stix_bytes(zip_of(members), "x.stix");
  EXPECT_EQ(project.scenarios[0].stages[0].label, "Stage 1");
  EXPECT_EQ(project.scenarios[0].stages[1].label, "Stage 2");
}

TEST(ReadStix, TellsOfMembersThatItDoesNotKnow)
{
  Members members = compact_sample(berm);
  members.emplace_back("frost/frost.json", "{}");
  EXPECT_THAT(remarks_of(read_stix_bytes(zip_of(members), "x.stix")),
      ElementsAre("frost/frost.json: This member is not known to Terp and was not read."));
}

TEST(ReadStix, TakesAByteOrderMarkAndEmptyNumbers)
{
  Members members = compact_sample(berm);
  for (auto& [name, text] : members)
    if (name == "soils.json") text = "\xEF\xBB\xBF" + text;
  members = changed(members, "soils.json", "\"Dilatancy\":0.0", "\"Dilatancy\":\"-\"");
  EXPECT_TRUE(std::isnan(read_stix_bytes(zip_of(members), "x.stix").soils[0].advanced.dilatancy.value));
}

TEST(ReadStix, RefusesAnIdThatIsThereTwice)
{
  Members members = compact_sample(berm);
  for (const auto& [name, text] : Members(members))
    if (name == "states/states.json") members.emplace_back("states/states_1.json", text);
  EXPECT_THAT(refusal_of(members), AllOf(HasSubstr("states/states_1.json, Id: is there twice"),
                                       HasSubstr("which is also the id of states/states.json.")));
}

TEST(ReadStix, RefusesAFileWithoutSoilLayersOrOfAnotherProgram)
{
  EXPECT_THAT(refusal<InputError>([] { read_stix(sample_path("empty-2023")); }),
      HasSubstr("has no soil layer in any stage\n  There is nothing to read."));
  EXPECT_THAT(refusal_of({{"document.xml", "<a/>"}}),
      HasSubstr("soils.json: is missing\n  This is no file of D-Stability, or one of another program."));
}

TEST(ReadStix, CollectsTenFaultsAtMost)
{
  Members members = compact_sample(berm);
  for (auto& [name, text] : members)
    for (std::size_t at = 0; name == "soils.json" && (at = text.find("\"Name\":", at)) != std::string::npos; at += 8)
      text.replace(at, 7, "\"Name\":7,\"Title\":");
  try {
    read_stix_bytes(zip_of(members), "x.stix");
    ADD_FAILURE() << "was read";
  } catch (const InputError& error) {
    ASSERT_EQ(error.problems().size(), 10U);  // of 12 soils
    EXPECT_EQ(error.problems()[1].key, "x.stix, soils.json, Soils[1].Name");
    EXPECT_EQ(error.problems()[1].what, "is not a text");
  }
}

TEST(ReadStix, ReadsEverySampleButTheEmptyOne)
{
  for (const auto& entry : std::filesystem::directory_iterator(source_path("tests/import/dstability/samples"))) {
    if (entry.path().extension() != ".stix" || entry.path().stem() == "empty-2023") continue;
    EXPECT_EQ(refusal([&] { read_stix(entry.path().string()); }), "") << entry.path();
  }
}

TEST(ReadStix, TellsOfALayerWithTwoStatePoints)
{
  const StixProject project =
      read_changed("states/states.json", "\"Id\":\"25\",\"LayerId\":\"17\"", "\"Id\":\"25\",\"LayerId\":\"16\"");
  EXPECT_THAT(refusal<InputError>([&] { StixSection(project, 0, 0, StixBasis::deterministic); }),
      HasSubstr("the layer with the id 16 has two state points\n  Which one holds cannot be known."));
}

TEST(ReadStix, SaysThatTheFolderWasZippedAsAWhole)
{
  Members members = compact_sample(berm);
  for (auto& [name, text] : members) name = "berm/" + name;
  EXPECT_THAT(
      refusal_of(members), HasSubstr("soils.json: is missing\n  All members lie in a folder. Zip the files in it"));
}

}  // namespace read_stix_test
