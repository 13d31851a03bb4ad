#include "support/process.hpp"

namespace import_folder_test {

const std::string tutorial = source_path("tests/import/dstability/samples/tutorial-2023.stix");

std::string write_drawing(const ScratchFolder& scratch, const std::string& more = "")
{
  const std::string path = scratch.path() + "/section.dxf";
  const auto outline = [](const std::string& layer, const std::string& places) {
    return "0\nLWPOLYLINE\n5\n2B\n8\n" + layer + "\n90\n4\n70\n1\n" + places;
  };
  std::ofstream(path) << "0\nSECTION\n2\nENTITIES\n"
                      << outline("zand", "10\n0\n20\n0\n10\n40\n20\n0\n10\n40\n20\n3\n10\n0\n20\n3\n")
                      << outline("klei", "10\n0\n20\n3\n10\n40\n20\n3\n10\n25\n20\n6\n10\n15\n20\n6\n") << more
                      << "0\nENDSEC\n0\nEOF\n";
  return path;
}

struct ImportFolder : testing::Test {
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/section";
};

TEST_F(ImportFolder, WritesAStageThatTerpChecks)
{
  EXPECT_THAT(
      succeeded(test::terp({"import", tutorial, "--scenario", "2", "--between", "-30,60", "--cell", "1", "-o", folder}))
          .out,
      HasSubstr("Next: terp check " + folder + "/case.toml"));
  EXPECT_THAT(text_of(folder + "/report.md"), HasSubstr("Only the part from x = -30 to 60 m and above z = -9 m was"));
  EXPECT_THAT(succeeded(test::terp({"check", folder + "/case.toml"})).out, HasSubstr("su_peak"));
  EXPECT_EQ(error_with(2, test::terp({"import", tutorial, "--scenario", "2", "-o", folder})),
      "error: " + folder + "/case.toml is there already\n  Choose another folder: -o FOLDER. --force replaces it.\n");
}

TEST_F(ImportFolder, SetsTheRiverToAnotherLevel)
{
  EXPECT_THAT(
      succeeded(test::terp({"import", tutorial, "--scenario", "2", "--cell", "2", "--river", "10.5", "-o", folder}))
          .err,
      HasSubstr("warning: The river stands at 10.50 m instead of the 12.00 m of the file (--river)."));
  EXPECT_THAT(
      succeeded(test::terp({"check", folder + "/case.toml"})).out, HasSubstr("stage high_water_river_at_10_50_m"));
  EXPECT_THAT(error_with(2, test::terp({"import", tutorial, "--river", "10.5"})),
      HasSubstr("error: --river has no effect without -o"));
}

TEST_F(ImportFolder, AsksWhichScenarioAndRefusesOthers)
{
  const auto said = [](const std::vector<std::string>& more) {
    return error_with(2, test::terp(with({"import", tutorial, "-o", "/tmp/none"}, more)));
  };
  EXPECT_THAT(said({}), HasSubstr("has 3 scenarios\n  Choose one: --scenario 1 to 3. terp import "));
  EXPECT_THAT(said({"--scenario", "7"}), HasSubstr("has no scenario 7\n  It has 3.\n"));
  EXPECT_THAT(said({"--scenario", "2", "--stage", "3"}), HasSubstr("scenario 2 of " + tutorial + " has no stage 3"));
  EXPECT_THAT(said({"--scenario", "2", "--between", "60,-30"}), HasSubstr("--between goes from 60 m to -30 m"));
  EXPECT_THAT(said({"--scenario", "2", "--base", "13"}), HasSubstr(": there is no soil in this part of the section"));
  EXPECT_THAT(said({"--scenario", "2", "--base", "13"}), Not(HasSubstr(": : ")));
  EXPECT_THAT(said({"--scenario", "2", "--base", "nan"}), HasSubstr("--base"));
  EXPECT_THAT(said({"--scenario", "2", "--soil-defaults", tutorial}), HasSubstr("error: "));
}

TEST_F(ImportFolder, ListsTheRegionsOfADrawing)
{
  const Finished f = succeeded(test::terp({"import", write_drawing(scratch)}));
  EXPECT_THAT(f.out, ContainsRegex("zand +120\\.000 +4   0\\.00 to 40\\.00, 0\\.00 to 3\\.00"));
  EXPECT_THAT(f.out, ContainsRegex("all +195\\.000"));
  EXPECT_THAT(f.out, HasSubstr("The drawing has no unit ($INSUNITS): one unit was taken as 1 m."));
}

TEST_F(ImportFolder, WritesADrawingAsACaseToFillIn)
{
  succeeded(test::terp({"import", write_drawing(scratch), "-o", folder}));
  succeeded(test::terp({"check", folder + "/case.toml"}));
}

TEST_F(ImportFolder, RefusesADrawingByEntityAndUnit)
{
  const std::string path = write_drawing(scratch, "0\nARC\n5\n3C\n8\nklei\n");
  EXPECT_THAT(error_with(2, test::terp({"import", path})),
      HasSubstr("error: " + path + ": ARC with handle 3C: is not read\n  It is on layer klei."));
  EXPECT_THAT(test::terp({"import", path, "--unit", "mile"}).err,
      HasSubstr("there is no unit `mile` of drawings\n  Units: m, dm, cm, mm, ft, in.\n"));
  EXPECT_THAT(test::terp({"import"}).err, HasSubstr("`terp import` needs a file\n  Give a .stix or a .dxf"));
}

TEST_F(ImportFolder, RefusesOptionsThatWouldHaveNoEffect)
{
  const std::string drawing = write_drawing(scratch);
  const auto said = [](const std::vector<std::string>& arguments) {
    return error_with(2, test::terp(with({"import"}, arguments)));
  };
  EXPECT_EQ(said({tutorial, "--unit", "mm"}),
      "error: --unit is of drawings\n  " + tutorial + " is a D-Stability file. Leave the option out.\n");
  EXPECT_EQ(said({drawing, "--stage", "2", "-o", folder}),
      "error: --stage is of D-Stability files\n  " + drawing + " is a drawing. Leave the option out.\n");
  EXPECT_EQ(said({drawing, "--cell", "1"}),
      "error: --cell has no effect without -o\n  Give a folder for the case, -o FOLDER, or leave it out.\n");
  for (const char* option : {"--scenario", "--stage", "--base"})
    EXPECT_THAT(said({tutorial, option, "1"}), HasSubstr(std::string(option) + " has no effect without -o"));
  const std::vector<std::string> to_folder{tutorial, "--scenario", "2", "-o", folder};
  for (const std::vector<std::string>& list :
      {std::vector<std::string>{"--json"}, {"--slices", scratch.path() + "/s.csv"}}) {
    EXPECT_EQ(said(with(to_folder, list)),
        "error: " + list[0] + " is not written with -o\n  Make the list and the case one after the other.\n");
  }
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST_F(ImportFolder, HoldsTheSoilAsAskedAlsoWhereTheTriggerIsLookedFor)
{
  const Finished f =
      succeeded(test::terp({"import", source_path("tests/import/dstability/samples/example-2020.03-v1.stix"), "--cell",
          "8", "--held", "--trigger", "strength", "-o", folder}));
  EXPECT_THAT(text_of(folder + "/case.toml"), AllOf(HasSubstr("at_strength = 0.5"), HasSubstr("\"weaker_soil\"")));
  EXPECT_THAT(f.err, HasSubstr("warning: The soil is held until it is at rest"));
}

TEST_F(ImportFolder, RefusesCellsThatAreTooMany)
{
  EXPECT_THAT(error_with(2, test::terp({"import", tutorial, "--scenario", "2", "--cell", "0.002", "-o", "/tmp/none"})),
      HasSubstr("cells of 0.002 m are too small for this section\n  The soil would have 6.9e+08 of them"));
}

TEST_F(ImportFolder, PrintsTheTableOfDefaults)
{
  EXPECT_THAT(test::terp({"import", "--soil-defaults-table"}).out, HasSubstr("\npeat,peat veen,10.8,50,"));
}

}  // namespace import_folder_test
