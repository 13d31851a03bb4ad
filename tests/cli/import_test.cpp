#include "support/process.hpp"

#include <nlohmann/json.hpp>

namespace import_test {

const std::string samples = source_path("tests/import/dstability/samples/");

TEST(Import, ListsWhatAFileHolds)
{
  const Finished f = succeeded(test::terp({"import", samples + "tutorial-2023.stix"}));
  EXPECT_THAT(
      f.out, AllOf(StartsWith(samples + "tutorial-2023.stix: D-Stability 2023.00+ca71a792f, content version 2\n"),
                 HasSubstr("scenario 3  \"Improvement\""), HasSubstr("1 excavation; 2 added layers; 1 uniform load"),
                 ContainsRegex("\"Design Values\" +Bishop +Design +F = 1\\.0099 +fits +bishop/bishopresult_1"),
                 ContainsRegex("\"Probabilistic\" +Bishop +Probabilistic +beta = 2\\.134 +no slices"),
                 HasSubstr("soils in use: 6 of 10"), HasSubstr("S 0.230 (0.300; 0.0500)")));
  EXPECT_EQ(f.err, "");
}

TEST(Import, TellsTheSameToAProgram)
{
  const Finished f = test::terp({"import", samples + "all-result-kinds-stale.stix", "--json"});
  const auto json = nlohmann::json::parse(f.out);
  EXPECT_EQ(json["scenarios"][0]["stages"].size(), 9);
  EXPECT_EQ(json["scenarios"][0]["calculations"][0]["result"]["verdict"], "stale");
  EXPECT_EQ(json["soils"].size(), 10);
  EXPECT_EQ(json["remarks"].size(), 6);
}

TEST(Import, WritesASliceTableOverAnEarlierOneAndOverNothingElse)
{
  const ScratchFolder scratch;
  const std::string csv = scratch.path() + "/slices.csv", file = scratch.path() + "/berm.stix";
  std::filesystem::copy_file(samples + "berm-fragility-2023.stix", file);
  for (int k = 0; k < 2; ++k) {
    EXPECT_THAT(succeeded(test::terp({"import", file, "--slices", csv})).out,
        AllOf(HasSubstr("bishopbruteforce/bishopbruteforceresult"), EndsWith("1 results in " + csv + "\n")));
  }
  const std::string table = text_of(csv);
  EXPECT_EQ(std::ranges::count(table, '\n'), 32);
  EXPECT_EQ(error_with(2, test::terp({"import", file, "--slices", file})),
      "error: " + file +
          " is there already, and it is no table of slices\n"
          "  Choose another name: --slices slices.csv\n");
}

TEST(Import, RefusesABadFileWithStatus2)
{
  EXPECT_EQ(error_with(2, test::terp({"import", samples + "empty-2023.stix"})),
      "error: " + samples +
          "empty-2023.stix, geometries/: has no soil layer in any stage\n"
          "  There is nothing to read. Draw the section in D-Stability and save it.\n");
  EXPECT_EQ(test::terp({"import", samples + "none.stix"}).status, 1);
  EXPECT_EQ(test::terp({"import", samples + "SOURCES.md"}).status, 2);
}

}  // namespace import_test
