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

}  // namespace stability_test
