#include "cli/same_results.hpp"
#include "os/process.hpp"
#include "support/older_run.hpp"
#include <csignal>
#include <regex>
#include <nlohmann/json.hpp>

namespace converge_test {

namespace fs = std::filesystem;

/// The column for 0.2 s on cells of 1, 0.5 and 0.25 m.
std::vector<std::string> converge_command(
    const std::string& folder, const std::vector<std::string>& more = {}, const std::string& cells = "0.5,1,0.25")
{
  return with({"converge", column_file, "--cells", cells, "--set", "time.end=0.2", "-j", "1", "-o", folder}, more);
}

nlohmann::json study_in(const std::string& folder)
{
  return nlohmann::json::parse(text_of(folder + "/convergence.json"));
}

struct Converge : testing::Test {
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/study";
};

TEST_F(Converge, TheExampleOfTheReadmeFitsItsMesh)
{
  const std::string readme = text_of(source_path("README.md"));
  std::smatch found;
  ASSERT_TRUE(std::regex_search(readme, found, std::regex("build/terp converge +(\\S+) --cells (\\S+)")));
  succeeded(test::terp({"converge", source_path(found[1]), "--cells", found[2], "--estimate"}));
}

TEST_F(Converge, SaysWhichInputsTheOutcomeTurnsOn)  // a column that stands with a little more strength
{
  const Finished f = succeeded(test::terp(converge_command(folder,
      {"--what-decides", "--set", "material.clay.su_peak=\"40 kPa\"", "--set", "material.clay.su_residual=\"40 kPa\"",
          "--set", "time.end=1"},
      "1,0.5")));
  EXPECT_THAT(f.out, AllOf(HasSubstr("  cells of 1 m "), HasSubstr("  cells of 0.5 m "), HasSubstr("  S_u x 0.85 "),
                         HasSubstr("  S_u x 1.15 "), HasSubstr("\nturns on: ")));
  const auto json = nlohmann::json::parse(text_of(folder + "/depends.json"));
  EXPECT_EQ(json.at("runs").size(), 6u);
  EXPECT_EQ(json.at("runs").at(2).at("input"), "S_u");
  EXPECT_EQ(json.at("runs").at(2).at("run"), "S_u x 0.85");
  EXPECT_THAT(text_of(folder + "/cell_1_S_u_x_0.85/case.toml"), HasSubstr("34 kPa"));
  EXPECT_EQ(json.at("turns_on").size() + json.at("does_not_turn_on").size(), 3u) << "cells, S_u, k0";
}

TEST_F(Converge, GoesOnWithARunThatWasInterrupted)
{
  const std::vector<std::string> often{"--set", "output.checkpoint.every=0.1", "--set", "time.end=0.6"};
  {
    Process process(converge_command(folder, often));
    wait_for_checkpoint(folder + "/cell_0.25");
    process.send(SIGINT);
    EXPECT_THAT(error_with(1, process.wait()),
        EndsWith("stopped; what is solved is kept in " + folder + ". Go on with the same command\n"));
  }
  EXPECT_FALSE(fs::exists(folder + "/convergence.json"));
  EXPECT_THAT(succeeded(test::terp(converge_command(folder, often))).out,
      AllOf(HasSubstr("[1/3] cells of 1 m  kept, solved before\n"), HasSubstr(" of which "),
          HasSubstr("[3/3] cells of 0.25 m  solved in ")));
  succeeded(test::terp(converge_command(scratch.path() + "/whole", often)));
  EXPECT_EQ(text_of(folder + "/cell_0.25/ledger.csv"), text_of(scratch.path() + "/whole/cell_0.25/ledger.csv"));
}

TEST_F(Converge, GoesOnWithOtherSizesWhereOneStopsItself)
{
  // Soil flies out of the mesh: on cells of 1 m at 0.214 s, on smaller ones later than the end.
  const Finished f = test::terp(converge_command(folder,
      {"--set", "body[0].velocity=[40.0, 0.0]", "--set", "boundary.right=\"free\"", "--set", "time.end=0.217"}));
  EXPECT_EQ(f.status, 3);
  EXPECT_THAT(f.err, HasSubstr("warning: [1/3] cells of 1 m  no result; the others go on\n  step "));
  EXPECT_THAT(
      f.out, AllOf(HasSubstr("[3/3] cells of 0.25 m  solved in "), HasSubstr("  No result on cells of 1 m: step "),
                 HasSubstr("Two sizes give no order"), ContainsRegex("front at the end \\[m\\] +- +1")));
  const auto runs = study_in(folder)["sequences"][0]["runs"];
  EXPECT_EQ(runs[0]["solved"], false);
  EXPECT_THAT(runs[0]["fault"], HasSubstr("points had to be put back at the walls"));
  EXPECT_EQ(runs[1]["solved"], true);
}

TEST_F(Converge, SolvesVariantsAtAllSizes)
{
  const Finished f = succeeded(test::terp(converge_command(
      folder, {"--variant", "scheme=mpm_mixed; body.*.points_per_cell=[3, 3]", "--json", "--report"}, "1,0.5")));
  const auto json = nlohmann::json::parse(f.out.substr(0, f.out.rfind("}\n") + 2));
  ASSERT_EQ(json["sequences"].size(), 2);
  EXPECT_EQ(
      json["sequences"][1]["changes"], (std::vector<std::string>{"scheme=mpm_mixed", "body.*.points_per_cell=[3, 3]"}));
  EXPECT_TRUE(fs::exists(folder + "/cell_0.5_scheme_mpm_mixed_body._.points_per_cell_3_3/summary.json"));
  EXPECT_TRUE(fs::exists(folder + "/report.html"));
}

TEST_F(Converge, TurnsTheCellsAndVariesTheirPointsAndSetsAllBesideEachOther)
{
  if (!run_process({"gmsh", "--version"}, 60.0).found) GTEST_SKIP() << "gmsh is not installed";
  // 5 points are those of the case, 0 degrees its direction.
  const Finished f = test::terp(converge_command(folder, {"--turn", "0,22.5", "--points", "4,5"}, "0.5,0.25"));
  ASSERT_EQ(f.status, 0) << f.err;
  EXPECT_THAT(
      f.out, AllOf(HasSubstr("\nall variants, cells of 0.25 m\n  [0] as given\n  [1] turned by 22.5 degrees\n"
                             "  [2] 4 x 4 points per cell\n"),
                 ContainsRegex(" +\\[0\\] +\\[1\\] +\\[2\\] +range +share\n"),
                 ContainsRegex("\nfront at the end \\[m\\] +8[.0-9]* +8[.0-9]* +8[.0-9]* +0[.0-9]* +[0-9.]+ %\n"),
                 HasSubstr("\nOn cells of 0.25 m, as given and with 2 variants: ")));
  const auto json = study_in(folder);
  EXPECT_EQ(json["sequences"].size(), 3u);
  EXPECT_EQ(json["variants"]["cell"], 0.25);
  EXPECT_EQ(json["variants"]["quantities"][0]["values"].size(), 3u);
  EXPECT_EQ(json["sequences"][1]["changes"].size(), 0u);
  EXPECT_NEAR(json["sequences"][1]["runs"][1]["size"], 0.25, 0.01);
  EXPECT_THAT(text_of(folder + "/cell_0.5_turned_by_22.5_degrees/case.toml"), HasSubstr(".msh\""));
  EXPECT_THAT(text_of(folder + "/cell_0.5_4_x_4_points_per_cell/case.toml"), HasSubstr("[4, 4]"));
  EXPECT_THAT(test::terp(converge_command(folder, {"--turn", "22.5", "--points", "4"}, "0.5,0.25")).out,
      HasSubstr("[3/6] cells of 0.5 m, turned by 22.5 degrees  kept, solved before\n"));
  EXPECT_THAT(text_of(folder + "/convergence.html"),
      AllOf(StartsWith("<!doctype html>"), HasSubstr("\"kind\":\"convergence\""), HasSubstr("\"variants\":{")));
}

TEST_F(Converge, WarnsOfPointsThatStayTheSameAtAllSizes)
{
  std::string points = "x,y,volume,material\n";
  for (const char* x : {"0.125", "0.375", "0.625", "0.875"})
    for (const char* y : {"0.125", "0.375", "0.625", "0.875"}) points += std::string(x) + "," + y + ",0.0625,clay\n";
  write_text(scratch.path() + "/points.csv", points);
  write_text(scratch.path() + "/case.toml",
      "time.end = 0.01\nmesh = {size = [2.0, 1.0], cell = 0.5}\nbody = [{points = \"points.csv\"}]\n"
      "[material.clay]\nmodel = \"linear_elastic\"\ndensity = 2000.0\nshear_modulus = 1e6\npoisson_ratio = 0.3\n"
      "[boundary]\nbottom = \"fixed\"\nleft = \"roller\"\n[forces]\ngravity = [0.0, -9.81]\n");
  EXPECT_THAT(
      succeeded(test::terp({"converge", scratch.path() + "/case.toml", "--cells", "0.5,0.25", "--estimate"})).err,
      HasSubstr("warning: the points of points.csv are the same at all sizes: smaller cells hold fewer of "
                "them, until cells are empty\n"));
}

TEST_F(Converge, RefusesVariantsWithOneFolderAndCasesThatCannotBeRead)
{
  EXPECT_EQ(error_with(2, test::terp(converge_command(
                              folder, {"--variant", "scheme=mpm_mixed", "--variant", "scheme = mpm_mixed"}, "1,0.5"))),
      "error: two variants would have one folder, " + folder +
          "/cell_1_scheme_mpm_mixed\n  Write one of them differently.\n");
  succeeded(test::terp(converge_command(folder, {"-q"}, "1,0.5")));
  for (const char* cell : {"/cell_1", "/cell_0.5"}) test::forget_checksums(folder + cell);
  std::string summary = text_of(folder + "/cell_1/summary.json");
  const std::string key = "\"terp_version\": \"";
  summary.insert(summary.find(key) + key.size(), "9.");
  write_text(folder + "/cell_1/summary.json", summary);
  const Finished older = test::terp(converge_command(folder, {"-q"}, "1,0.5"));
  EXPECT_THAT(older.err, AllOf(StartsWith("warning: " + folder + "/cell_1 was solved by terp 9."),
                             EndsWith("; --force solves it anew\n")));
  write_text(folder + "/cell_0.5/case.toml", "no case");
  EXPECT_THAT(test::terp(converge_command(folder, {}, "1,0.5")).err,
      HasSubstr("/cell_0.5: this folder holds a run of another case\n  its case cannot be read\n"));
}

TEST_F(Converge, RefusesAFolderThatHoldsSomethingElse)
{
  succeeded(run_column(scratch.path() + "/run", {"-q"}));
  EXPECT_EQ(error_with(1, test::terp(converge_command(scratch.path() + "/run"))),
      "error: " + scratch.path() +
          "/run: this is the folder of one run; the sizes get folders of their own\n"
          "  Choose another: -o DIR\n");
  fs::create_directories(scratch.path() + "/cell_1");
  write_text(scratch.path() + "/cell_1/notes.txt", "mine");
  EXPECT_EQ(
      test::terp(converge_command(scratch.path())).err, "error: " + scratch.path() +
                                                            "/cell_1: this folder is not empty, and holds no run\n"
                                                            "  Choose another: -o DIR\n");
}

}  // namespace converge_test
