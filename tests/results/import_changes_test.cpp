// What was changed in an imported case, in sentences.
#include "results/import_changes.hpp"

#include "support/paths.hpp"
#include "support/test.hpp"

#include <fstream>

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
  EXPECT_THAT(in_english(changes_since_import(now, folder.path())),
      ElementsAre(StartsWith("What changed since the import is not known: ")));
  std::ofstream(folder.path() + "/imported.toml") << imported;
  EXPECT_THAT(changes_since_import(now, folder.path()), SizeIs(1));
}

}  // namespace import_changes_test
