// What a search for a factor of safety leaves: the JSON and the text.
#include "output/stability_json.hpp"
#include "output/files.hpp"
#include "support/test.hpp"
#include <nlohmann/json.hpp>

namespace {

StabilityResult result()
{
  StabilityResult r;
  r.strengths = {{"material.clay.su_peak", "Pa", 8000.0}};
  r.options.search.tolerance = 0.1;
  r.height = 4.0, r.displacement = 0.05, r.n_points = 900, r.rest_steps = 70;
  for (const auto& [factor, verdict] : {std::pair{1.0, TrialVerdict::stable}, {1.1, TrialVerdict::undecided}}) {
    Trial trial;
    trial.factor = factor, trial.verdict = verdict, trial.reason = "why", trial.steps = 12;
    trial.windows = {{0.5, 0.01, 1e-3}, {1.0, 0.02, 5e-5}};
    enter(std::move(trial), r.search);
  }
  return r;
}

TEST(StabilityJson, HoldsTheFactorItsBracketAndTheTrials)
{
  const auto json = nlohmann::json::parse(stability_json(result(), "mpm_gp", {"cut", "title = \"x\""}));
  EXPECT_DOUBLE_EQ(json["factor_of_safety"], 1.05);
  EXPECT_EQ(json["stable_at"], 1.0);
  EXPECT_EQ(json["not_stable_at"], 1.1);
  EXPECT_EQ(json["strengths"][0]["key"], "material.clay.su_peak");
  EXPECT_EQ(json["trials"][1]["verdict"], "undecided");
  EXPECT_EQ(json["trials"][0]["displacement"][1], 0.02);
  EXPECT_EQ(json["criterion"]["displacement_scale"], 0.05);
  EXPECT_EQ(json["case_name"], "cut");
}

TEST(StabilityJson, AFactorThatWasNotFoundIsNull)
{
  StabilityResult r = result();
  r.search.failed.reset();
  EXPECT_TRUE(nlohmann::json::parse(stability_json(r, "mpm_gp", {"cut", ""}))["factor_of_safety"].is_null());
  EXPECT_THAT(stability_text(r, "mpm_gp"), HasSubstr("factor of safety not found: the soil stands even at 1\n"));
}

TEST(StabilityText, SaysFactorCriterionAndTrials)
{
  const std::string text = stability_text(result(), "mpm_gp");
  EXPECT_THAT(text, HasSubstr("factor of safety 1.050 +- 0.050   (stands at 1.000, does not at 1.100)\n  by reduction "
                              "of 1 strength, mpm_gp, 900 points"));
  EXPECT_THAT(text, HasSubstr("    1.0000  stable     why\n    1.1000  undecided  why\n"));
  EXPECT_THAT(text, HasSubstr("At 1.1000 the soil still crept after 200 windows; that counts as not standing. Larger "
                              "--windows decide it.\n"));
}

TEST(StabilityText, SaysWhatTheBracketDoesNot)
{
  StabilityResult r = result();
  const std::string creep = "No trial failed, so nothing bounds the factor from above but creep",
                    mesh = "The width is that of the search alone";
  EXPECT_THAT(
      stability_text(r, "mpm_gp"), AllOf(HasSubstr(creep), HasSubstr(mesh), Not(HasSubstr("standard_mpm locks"))));
  EXPECT_THAT(stability_text(r, "standard_mpm"), HasSubstr("standard_mpm locks"));
  r.search.trials[1].verdict = TrialVerdict::failed;
  EXPECT_THAT(stability_text(r, "mpm_gp"), AllOf(Not(HasSubstr(creep)), HasSubstr(mesh)));
  r.stopped = true;
  EXPECT_THAT(
      stability_text(r, "mpm_gp"), HasSubstr("The search was stopped before the bracket was as narrow as asked for"));
}

TEST(StabilityJson, IsWrittenIntoAFolderThatIsMade)
{
  const std::string folder = testing::TempDir() + "stability_json_test/deep";
  write_stability(folder, result(), "mpm_gp", {"cut", ""});
  EXPECT_THAT(read_file(folder + "/stability.txt"), HasSubstr("factor of safety 1.050"));
  EXPECT_THAT(read_file(folder + "/stability.json"), HasSubstr("\"factor_of_safety\": 1.05"));
  std::filesystem::remove_all(testing::TempDir() + "stability_json_test");
}

}  // namespace
