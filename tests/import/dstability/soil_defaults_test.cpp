#include "import/dstability/soil_defaults.hpp"
#include "model/bodies/csv_rows.hpp"
#include "support/test.hpp"

namespace soil_defaults_test {

TEST(SoilDefaults, FindTheKindInTheName)
{
  const auto kinds = read_soil_defaults("table", soil_defaults_table());
  EXPECT_EQ(kind_of_soil(kinds, "Peat, shallow").kind, "peat");
  EXPECT_EQ(kind_of_soil(kinds, "Hollandveen").kind, "peat");
  EXPECT_EQ(kind_of_soil(kinds, "Organic clay").kind, "organic clay");
  EXPECT_EQ(kind_of_soil(kinds, "Dijksmateriaal (klei)").kind, "embankment");
  EXPECT_EQ(kind_of_soil(kinds, "Sand with clay").kind, "clay");
  EXPECT_EQ(kind_of_soil(kinds, "ZAND").kind, "sand");
  EXPECT_EQ(kind_of_soil(kinds, "unnamed").kind, "other");
  EXPECT_EQ(kind_of_soil(kinds, "ZAND").ratio, 0.0);
}

TEST(SoilDefaults, FindTheKindInTheCodesOfTheTrade)
{
  const auto kinds = read_soil_defaults("table", soil_defaults_table());
  const auto kind_of = [&](const char* name, const char* code = "") { return kind_of_soil(kinds, name, code).kind; };
  EXPECT_EQ(kind_of("H_Vhv_v"), "peat");
  EXPECT_EQ(kind_of("H_Mp_ko"), "organic clay");
  EXPECT_EQ(kind_of("H_Rk_ko S,phi=0"), "organic clay");
  EXPECT_EQ(kind_of("H_Aa_ht"), "embankment");
  EXPECT_EQ(kind_of("H_Rk_k_shallow"), "clay");
  EXPECT_EQ(kind_of("H_Rk_k&s"), "silt");
  EXPECT_EQ(kind_of("P_Wdz_zg"), "sand");
  EXPECT_EQ(kind_of("P_Rg_zm"), "sand");
  EXPECT_EQ(kind_of("Z[H]d"), "sand");
  EXPECT_EQ(kind_of("V1"), "peat");
  EXPECT_EQ(kind_of("Layer 3", "P_Rg_zm"), "sand");  // the code where the name tells nothing
  EXPECT_EQ(kind_of("H_Mp_ko", "P_Rg_zm"), "organic clay");
  EXPECT_EQ(kind_of("Zandig", "H_Vhv_v"), "peat");  // a pattern of the code before a word of the name
  EXPECT_EQ(kind_of("Vlonder"), "other");
}

TEST(SoilDefaults, AreReadFromATableOfTheUser)
{
  std::string text = soil_defaults_table();
  text.insert(text.find("peat,peat veen"), "mud,mud slib,,12,20,0.3,0.48,0.3,0.7,20,0,0.3,0.9,1,1,0.1,0.3,0.1,0.3\n");
  EXPECT_EQ(kind_of_soil(read_soil_defaults("mine.csv", text), "Slib").stiffness_ratio, 20.0);
}

TEST(SoilDefaults, RefuseWhatNoSoilHas)
{
  std::string text = soil_defaults_table();
  text.replace(text.find("10.8,50"), 7, "108,50 ");
  const std::string said = refusal<CsvError>([&] { read_soil_defaults("mine.csv", text); });
  EXPECT_THAT(said, HasSubstr("mine.csv:8: weight is 108; allowed is 9 to 30"));
  EXPECT_THAT(said, HasSubstr("terp import --soil-defaults-table prints the table that holds without it"));
  EXPECT_THAT(refusal<CsvError>([&] { read_soil_defaults("mine.csv", text.substr(0, text.find("peat,peat"))); }),
      HasSubstr("no rows below the names of the columns"));
}

}  // namespace soil_defaults_test
