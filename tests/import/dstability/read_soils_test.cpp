#include "archives.hpp"

namespace read_soils_test {

StixSoil soil_of(const StixProject& project, const std::string& name)
{
  const auto found = std::ranges::find(project.soils, name, &StixSoil::name);
  EXPECT_NE(found, project.soils.end()) << name;
  return found == project.soils.end() ? StixSoil{} : *found;
}

TEST(ReadSoils, TakesFlatAndNestedParametersAlike)
{
  const StixSoil flat = soil_of(read_stix(sample_path("tutorial-2022.01-v1")), "Clay, shallow");
  const StixSoil nested = soil_of(read_stix(sample_path("tutorial-2026.01")), "Clay, shallow");
  for (const StixSoil& soil : {flat, nested}) {
    EXPECT_EQ(soil.ratio.value, 0.23);
    EXPECT_EQ(soil.ratio.mean, 0.30);
    EXPECT_EQ(soil.ratio.deviation, 0.05);
    EXPECT_TRUE(soil.ratio.is_probabilistic);
    EXPECT_EQ(soil.exponent.deviation, 0.025);
    EXPECT_EQ(soil.below, StixStrengthModel::shansep);
    EXPECT_EQ(soil.weight_below, 14.8e3);
    EXPECT_EQ(soil.code, "H_Rk_k_shallow");
    EXPECT_THAT(soil.colour, MatchesRegex("#[0-9A-F]{8}"));
  }
}

TEST(ReadSoils, KnowsTheModelsByTheirNames)
{
  const StixProject project = read_stix(sample_path("tutorial-2026.01"));
  EXPECT_EQ(soil_of(project, "Sand").above, StixStrengthModel::advanced);
  EXPECT_EQ(soil_of(project, "Sand with clay").above, StixStrengthModel::classic);
  EXPECT_EQ(soil_of(project, "Sand with clay").classic.friction.value, 33.0);
  const StixSoil old = soil_of(read_stix(sample_path("example-2020.03-v1")), "Embankment old");
  EXPECT_EQ(old.above, StixStrengthModel::advanced);  // CPhi
  EXPECT_EQ(old.advanced.cohesion.value, 7e3);
  EXPECT_EQ(old.below, StixStrengthModel::su_table);
  EXPECT_THAT(old.su_table.rows, SizeIs(4));
}

TEST(ReadSoils, SortsTheRowsOfATable)
{
  const StixProject project = read_changed("soils.json", "\"SuTablePoints\":[]",
      "\"SuTablePoints\":[{\"EffectiveStress\":30,\"Su\":9},{\"EffectiveStress\":10,\"Su\":5}]");
  EXPECT_THAT(project.soils[0].su_table.rows, ElementsAre(Vec<2>{10e3, 5e3}, Vec<2>{30e3, 9e3}));
}

TEST(ReadSoils, RefusesAnIdTwice)
{
  const std::string second = compact_sample(berm)[2].second;
  ASSERT_EQ(compact_sample(berm)[2].first, "soils.json");
  const auto soils = nlohmann::ordered_json::parse(second)["Soils"];
  const std::string a = soils[0]["Id"], b = soils[1]["Id"];
  EXPECT_THAT(refusal_after("soils.json", "{\"Id\":\"" + b + "\"", "{\"Id\":\"" + a + "\""),
      HasSubstr("soils.json, Soils[1].Id: is there twice\n  Got " + a + ", which another soil has."));
}

}  // namespace read_soils_test
