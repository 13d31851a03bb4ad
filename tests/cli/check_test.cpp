#include "cli/coarse_column.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace check_test {

/// The number before `unit` in the line of `terp check` that begins with `word`.
double number_in(const std::string& out, const std::string& word, const std::string& unit)
{
  const std::size_t line = out.find("  " + word + " "), end = out.find(" " + unit, line);
  const std::size_t begin = out.rfind(' ', end - 1) + 1;
  return std::stod(out.substr(begin, end - begin));
}

TEST(Check, SaysHowMuchDiskTheRunNeedsToAFactorOfTwo)
{
  for (const std::string field : {"output.fields.every=0.01", "output.fields.every=0.2"}) {
    const ScratchFolder scratch;
    const std::string folder = scratch.path() + "/run";
    const std::vector<std::string> more{
        "--set", field, "--set", "output.checkpoint.every=0.05", "--set", "mesh.cell=0.2"};
    const Finished check = succeeded(test::terp(column_command("check", more)));
    EXPECT_THAT(check.out, ContainsRegex("  output         [0-9]+ frames of [0-9.]+ MB, 4 checkpoints of [0-9.]+ "
                                         "MB, [0-9]+ rows\n  disk           [0-9.]+ MB at the end, with 2 "
                                         "checkpoints\n"));
    succeeded(run_column(folder, more));
    double bytes = 0.0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.is_regular_file()) bytes += static_cast<double>(entry.file_size());
    const double ratio = number_in(check.out, "disk", "MB") * 1e6 / bytes;
    EXPECT_GT(ratio, 0.5) << check.out;
    EXPECT_LT(ratio, 2.0) << check.out;
  }
}

TEST(Check, GivesItsNumbersToAProgram)
{
  const std::vector<std::string> coarse{"--set", "mesh.cell=0.2"};
  const Finished text = succeeded(test::terp(column_command("check", coarse)));
  std::vector<std::string> words = column_command("check", coarse);
  words.push_back("--json");
  const auto json = nlohmann::json::parse(succeeded(test::terp(words)).out);
  EXPECT_THAT(text.out, HasSubstr(fmt::format("  points         {}\n", json["points"].get<long>())));
  EXPECT_THAT(text.out, HasSubstr(fmt::format("  steps          {} to t = ", json["steps"].get<long>())));
  EXPECT_EQ(json["bodies"].size(), 1u);
  EXPECT_GT(json["expected_s"].get<double>(), 0.0);
  EXPECT_NEAR(json["cell_size"].get<double>(), 0.2, 1e-12);
}

TEST(Check, AVariantOfAMeshFromAPolygonHasOtherCells)
{
  const auto told = [](const std::string& variant) {
    return test::terp({"check", source_path("cases/column_collapse/model_2_unstructured.toml"), "--set",
        "mesh.cell=0.5", "--set", "mesh.variant=" + variant, "-j", "1"});
  };
  const auto mesh_line = [](const std::string& out) {
    const std::size_t begin = out.find("  mesh  ");
    return out.substr(begin, out.find('\n', begin) - begin);
  };
  const Finished best = told("0"), other = told("1");
  ASSERT_EQ(best.status + other.status, 0) << best.err << other.err;
  EXPECT_NE(mesh_line(best.out), mesh_line(other.out));
}

}  // namespace check_test
