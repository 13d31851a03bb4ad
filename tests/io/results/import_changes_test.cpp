#include "io/results/import_changes.hpp"

#include "support/paths.hpp"

namespace import_changes_test {

const std::string imported = R"(title = "Dike"
scheme = "mpm_gp"
[mesh]
cell = 0.5
[[body]]
name = "Clay, below water"
material = "clay"
polygon = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]
[[body]]
name = "Sand"
material = "sand"
polygon = [[0.0, -1.0], [2.0, -1.0], [2.0, 0.0]]
[material.clay]
color = "#000000"
density = "14.8 kN/m3"
su_peak = { shansep = { S = 0.23, m = 0.9, pop = "10 kPa", water = "high" } }
[material.sand]
density = "20 kN/m3"
friction_angle = 26.5
[water]
phreatic_line = [[0.0, 8.0], [10.0, 6.0]]
[[water.situation]]
name = "high"
phreatic_line = [[0.0, 12.0], [10.0, 6.0]]
[[load]]
name = "traffic"
pressure = "13 kPa"
[flood]
water_level = 12.0
[reference]
imported = "imported.toml"
)";

std::vector<Sentence> changes(std::initializer_list<std::pair<std::string, std::string>> edits)
{
  std::string now = imported;
  for (const auto& [from, to] : edits) {
    EXPECT_THAT(now, HasSubstr(from));
    now.replace(now.find(from), from.size(), to);
  }
  return import_changes(parse_toml(imported), parse_toml(now));
}

TEST(ImportChanges, AreNoneWhereNothingButTheSpellingChanged)
{
  EXPECT_THAT(changes({}), IsEmpty());
  EXPECT_THAT(
      changes({{"title = \"Dike\"", "title = \"My dike\""}, {"#000000", "#ff0000"}, {"14.8 kN/m3", "14.80 kN/m^3"},
          {"\"10 kPa\"", "1e4"}, {"[[0.0, 8.0], ", "[[0.0, 8.0], [5.0, 7.0], "}}),
      IsEmpty());
}

TEST(ImportChanges, NameSoilValueAndWhatItWasInBothLanguages)
{
  const auto all = changes({{"14.8 kN/m3", "15.5 kN/m3"}, {"S = 0.23", "S = 0.2"}, {"= 26.5", "= 30"}});
  EXPECT_THAT(in_english(all), ElementsAre("clay: weight was 14.8 kN/m3 in the import, is 15.5 kN/m3 here.",
                                   "clay: S was 0.23 in the import, is 0.2 here.",
                                   "sand: friction angle was 26.5 deg in the import, is 30 deg here."));
  EXPECT_EQ(all[0].nl, "clay: gewicht was bij het inlezen 14,8 kN/m3, is hier 15,5 kN/m3.");
  EXPECT_EQ(all[1].nl, "clay: S was bij het inlezen 0,23, is hier 0,2.");
}

TEST(ImportChanges, HaveTheSameUnitOnBothSides)
{
  const auto words = [](const std::string& from, const std::string& to) {
    const auto all = changes({{from, to}});
    return all.size() == 1 ? all[0] : Sentence{};
  };
  const Sentence plain = words("\"14.8 kN/m3\"", "1500.0");
  EXPECT_EQ(plain.en, "clay: weight was 14.8 kN/m3 in the import, is 14.715 kN/m3 here.");
  EXPECT_EQ(plain.nl, "clay: gewicht was bij het inlezen 14,8 kN/m3, is hier 14,715 kN/m3.");
  EXPECT_EQ(
      words("\"13 kPa\"", "\"0.012 MPa\"").en, "Load `traffic`: pressure was 13 kPa in the import, is 12 kPa here.");
  EXPECT_EQ(words("= 12.0", "= \"1150 cm\"").en, "Flood: river level was 1200 cm in the import, is 1150 cm here.");
  EXPECT_EQ(words("= 12.0", "= \"high\"").en, "Flood: river level was 12 m in the import, is high here.");
}

TEST(ImportChanges, OfKeysAtTheTopOfTheCaseNameTheKeyAlone)
{
  const auto all = changes({{"\"mpm_gp\"", "\"mpm_mixed\""}, {"[mesh]", "at_strength = 1.1\n[mesh]"}});
  EXPECT_THAT(in_english(all), ElementsAre("`scheme` was mpm_gp in the import, is mpm_mixed here.",
                                   "`at_strength` was not given by the import, is 1.1 here."));
  const auto gone = changes({{"scheme = \"mpm_gp\"\n", ""}});
  EXPECT_THAT(in_english(gone), ElementsAre("`scheme` was mpm_gp in the import, is not given here."));
}

TEST(ImportChanges, HaveAllTheirFormsInDutch)
{
  struct Row {
    std::string from, to, dutch;
  };
  for (const auto& [from, to, dutch] : {
           Row{"\"mpm_gp\"", "\"mpm_mixed\"", "`scheme` was bij het inlezen mpm_gp, is hier mpm_mixed."},
           Row{"scheme = \"mpm_gp\"", "", "`scheme` was bij het inlezen mpm_gp, is hier niet gegeven."},
           Row{"[mesh]", "at_strength = 1.1\n[mesh]", "`at_strength` gaf het inlezen niet, is hier 1,1."},
           Row{"friction_angle = 26.5", "",
               "sand: hoek van inwendige wrijving was bij het inlezen 26,5 deg, is hier "
               "niet gegeven."},
           Row{"[material.sand]", "[material.sand]\nk0 = 0.5", "sand: K0 gaf het inlezen niet, is hier 0,5."},
           Row{"[[load]]\nname = \"traffic\"\npressure = \"13 kPa\"", "",
               "Belasting `traffic` van het inlezen is hier niet."},
           Row{"[material.sand]", "[material.peat]\nk0 = 0.5\n[material.sand]", "peat is niet van het inlezen."},
           Row{"[[0.0, 12.0]", "[[0.0, 11.2]",
               "Water `high`: freatische lijn lag bij het inlezen op 12,00 m, ligt hier op 11,20 m, bij x = 0,00 m."},
           Row{"[[0.0, 8.0]", "[[0.0, 7.5]",
               "Water aan het begin: freatische lijn lag bij het inlezen op 8,00 m, ligt hier op 7,50 m, bij x = 0,00 "
               "m."},
           Row{"[2.0, 2.0], ", "[2.0, 2.5], ",
               "Laag `Clay, below water`: hoekpunten van de omtrek zijn sinds het inlezen tot 0,5 m verplaatst."},
           Row{"[2.0, 2.0], ", "[2.0, 2.0], [1.0, 3.0], ",
               "Laag `Clay, below water`: de omtrek had bij het inlezen 4 hoekpunten en 4,00 m2, heeft hier 5 en 5,00 "
               "m2."},
       }) {
    const auto all = changes({{from, to}});
    ASSERT_THAT(all, SizeIs(1)) << dutch;
    EXPECT_EQ(all[0].nl, dutch);
  }
}

TEST(ImportChanges, OfTheRiverAreItsLevelAndWhereItsLineMovedMost)
{
  const auto all = changes({{"water_level = 12.0", "water_level = 11.2"}, {"[[0.0, 12.0]", "[[0.0, 11.2]"}});
  EXPECT_THAT(in_english(all),
      ElementsAre("Water `high`: phreatic line was at 12.00 m in the import, is at 11.20 m here, at x = 0.00 m.",
          "Flood: river level was 12 m in the import, is 11.2 m here."));
  EXPECT_EQ(all[1].nl, "Overstroming: rivierstand was bij het inlezen 12 m, is hier 11,2 m.");
}

TEST(ImportChanges, OfOutlinesAreCornersAndAreas)
{
  EXPECT_THAT(in_english(changes({{"[2.0, 2.0], ", "[2.0, 2.0], [1.0, 3.0], "}})),
      ElementsAre("Layer `Clay, below water`: its outline had 4 corners and 4.00 m2 in the import, has 5 and 5.00 m2 "
                  "here."));
  EXPECT_THAT(in_english(changes({{"[2.0, 2.0], ", "[2.0, 2.5], "}})),
      ElementsAre("Layer `Clay, below water`: corners of its outline moved by up to 0.5 m since the import."));
}

TEST(ImportChanges, AreNoneOfAnOutlineInAnotherUnit)
{
  EXPECT_THAT(changes({{"[[0.0, -1.0], ", "[[0.0, \"-100 cm\"], "}}), IsEmpty());
}

TEST(ImportChanges, OfTablesOverDepthAreTheirNumbers)
{
  const std::string table = "[material.clay]\nsu_peak = { depth = [[0, 8e3]] }\n";
  EXPECT_THAT(in_english(import_changes(
                  parse_toml(table), parse_toml(std::string(table).replace(table.find("8e3"), 3, "9e3")))),
      ElementsAre("clay: `su_peak.depth` was [[0, 8000.0]] in the import, is [[0, 9000.0]] here."));
}

TEST(ImportChanges, OfWhatIsNewOrGoneToo)
{
  EXPECT_THAT(in_english(changes({{"friction_angle = 26.5", "cohesion = \"1 kPa\""}})),
      ElementsAre("sand: cohesion was not given by the import, is 1 kPa here.",
          "sand: friction angle was 26.5 deg in the import, is not given here."));
  EXPECT_THAT(in_english(changes({{"[[load]]\nname = \"traffic\"\npressure = \"13 kPa\"\n", ""},
                  {"[material.sand]", "[material.peat]\ndensity = 1100.0\nk0 = 0.5\n[material.sand]"}})),
      ElementsAre("peat is not of the import.", "Load `traffic` of the import is not here."));
}

TEST(ImportChanges, GoByNameWhereATableIsPutInFront)
{
  EXPECT_THAT(in_english(changes({{"[[body]]", "[[body]]\nname = \"Ditch\"\nmaterial = \"clay\"\n[[body]]"}})),
      ElementsAre("Layer `Ditch` is not of the import."));
}

TEST(ImportChanges, AreOfTheFileThatTheCaseNames)
{
  const ScratchFolder folder;
  const Node now = parse_toml(std::string(imported).replace(imported.find("= 26.5"), 6, "= 30.0"));
  EXPECT_THAT(changes_since_import(parse_toml("title = \"a\""), folder.path()), IsEmpty());
  const auto unknown = changes_since_import(now, folder.path());
  ASSERT_THAT(unknown, SizeIs(1));
  EXPECT_THAT(unknown[0].en, StartsWith("What changed since the import is not known: "));
  EXPECT_THAT(unknown[0].nl, StartsWith("Wat sinds het inlezen is veranderd, is niet bekend: "));
  std::ofstream(folder.path() + "/imported.toml") << imported;
  EXPECT_THAT(changes_since_import(now, folder.path()), SizeIs(1));
}

}  // namespace import_changes_test
