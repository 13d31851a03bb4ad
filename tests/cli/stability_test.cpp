#include "support/process.hpp"
#include <nlohmann/json.hpp>

namespace stability_test {

const std::string cut = source_path("cases/verification/vertical_cut/case.toml");

TEST(Stability, LeavesItsResultsTheMechanismAndAPicture)
{
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/cut";
  EXPECT_THAT(succeeded(test::terp({"stability", cut, "--cells", "0.5,1", "--from", "1.05", "--to", "1.25",
                            "--tolerance", "0.1", "--with-tension", "-o", folder, "-j", "1"}))
                  .out,
      AllOf(HasSubstr("factor of safety at most "), HasSubstr("the slope on the right of the highest ground"),
          HasSubstr("its soil moves to the right"), HasSubstr(" on cells of 1 m, "),
          HasSubstr(" on cells of 0.5 m.\n  What moves is ")));
  const auto json = nlohmann::json::parse(text_of(folder + "/stability.json"));
  EXPECT_EQ(json.at("mechanism").at("slope"), "right");
  EXPECT_NEAR(json.at("mechanism").at("exit").at(0), 5.0, 1.0) << "the toe of the cut";
  EXPECT_LT(json.at("mechanism").at("entry").at(0), 4.0);
  EXPECT_EQ(json.at("mesh").at("sizes").size(), 2u);
  EXPECT_TRUE(json.at("is_upper_bound")) << "below five cells over the depth nothing is extrapolated";
  EXPECT_EQ(json.at("factor_of_safety"), json.at("failed_at"));
  for (const char* file : {"/stability.txt", "/mechanism.svg", "/mechanism/results.vtkhdf.series",
           "/mechanism/mesh.vtkhdf", "/mechanism/frames/points_00000.vtkhdf", "/cells_1/stability.json"})
    EXPECT_TRUE(std::filesystem::exists(folder + file)) << file;
}

TEST(Stability, OfSoilThatCracksIsLessAndNamesTheFactorWithTension)
{
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/cut";
  const std::vector<std::string> search = {"stability", cut, "--set", "mesh.cell=1", "--from", "0.7", "--to", "0.9",
      "--tolerance", "0.1", "-o", folder, "-j", "1"};
  EXPECT_THAT(succeeded(test::terp(search)).out,
      HasSubstr("soil cracks: no tension where its law sets no limit. With tension (--with-tension) 1.1"));
  const auto json = nlohmann::json::parse(text_of(folder + "/stability.json"));
  EXPECT_LT(json.at("failed_at"), 1.0);
  EXPECT_GT(json.at("soil").at("with_tension").at("factor"), 1.05);
  EXPECT_TRUE(json.at("soil").at("cracks"));

  EXPECT_EQ(error_with(1, test::terp(search)), "error: the folder " + folder +
                                                   " holds the result of an earlier search\n  Use --force to replace "
                                                   "it, or -o DIR to write to another folder.\n");
}

TEST(Stability, LooksOnlyAtSoilAsDeepAsAsked)
{
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/cut";
  EXPECT_THAT(error_with(2, test::terp({"stability", cut, "--least-depth", "50", "-o", folder, "-j", "1"})),
      AllOf(HasSubstr("no soil lies 50 m below the ground, as --least-depth asks"), HasSubstr("The deepest lies ")));
}

TEST(Stability, NamesTheRunInItsWarnings)
{
  const ScratchFolder scratch;
  const std::string folder = scratch.path() + "/cut";
  const Finished f = test::terp({"stability", source_path("cases/verification/strip_footing/case.toml"), "--from",
      "0.9", "--to", "1", "--tolerance", "0.2", "--set", "time.end=0.01", "-q", "-o", folder, "-j", "1"});
  EXPECT_THAT(f.err, HasSubstr("warning: " + folder + ": terp stability leaves footings out"));
}

TEST(Stability, SaysOfTheSectionWhatCheckSays)  // and stops before the search
{
  const ScratchFolder scratch;
  const Finished f = test::terp({"stability", cut, "--set", "body[0].points_per_cell=[2, 2]", "--set",
      "material.clay.su_peak=\"10 MPa\"", "--set", "material.clay.tension_cutoff=0", "--with-tension", "--least-depth",
      "50", "-o", scratch.path() + "/cut", "-j", "1"});
  EXPECT_THAT(f.err, AllOf(HasSubstr("su_peak"), HasSubstr("warning: "),
                         HasSubstr("--with-tension has no effect on `clay`: the case limits the tension")));
  EXPECT_THAT(f.err, HasSubstr("no soil lies 50 m below the ground"));
}

TEST(Stability, TakesDifferentSizesOfCells)
{
  EXPECT_EQ(error_with(2, test::terp({"stability", cut, "--cells", "1,1"})),
      "error: --cells: the size 1 m is given twice\n  Give each size once.\n");
}

}  // namespace stability_test
