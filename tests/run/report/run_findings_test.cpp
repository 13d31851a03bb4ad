#include "run/report/run_findings.hpp"
#include "run/report/summary.hpp"
#include "support/simulations.hpp"

namespace run_findings_test {

std::vector<RunFinding> findings_of(const Summary& summary)
{
  const Simulation s(column("mpm_gp"));
  return findings_against(s.model, summary);
}

TEST(RunFindings, ASpeedAndItsLimitAreNeverPrintedAlike)
{
  Summary summary;
  summary.stages = {{"high", {.start = 0.0, .end = 1.0, .at_rest = false, .fastest = 1.0004e-3}}};
  const std::vector<RunFinding> findings = findings_of(summary);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_THAT(findings[0].en, HasSubstr("its fastest node moved with 0.0010004 m/s, limit 0.001 m/s"));
}

TEST(RunFindings, NameTheStageAtWhoseEndSoilStillMoved)
{
  Summary summary;
  summary.stages = {{"high", {.start = 0.0, .end = 1.0, .at_rest = false, .fastest = std::nan("")}},
      {"after", {.start = 1.0, .end = 2.0, .at_rest = true, .fastest = 1e-5}}};
  FloodSummary& flood = summary.flood.emplace();
  flood.verdict = FloodVerdict::moving, flood.still_moves = true;
  flood.stage = "after", flood.stage_moving = "high";
  flood.fastest_soil = "clay", flood.fastest_node = 0.28, flood.fastest_x = 2.0, flood.fastest_y = 1.0;
  const std::vector<RunFinding> findings = findings_of(summary);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].en,
      "At the end of the stage `high` `clay` moves with 0.28 m/s at x = 2.0, y = 1.0 m, so nothing is decided: end "
      "that "
      "stage at rest, or later.");
  EXPECT_EQ(findings[0].nl,
      "Aan het einde van fase `high` beweegt `clay` met 0,28 m/s bij x = 2,0, y = 1,0 m, zodat niets beslist is: "
      "eindig "
      "die fase in rust, of later.");
  flood.first_time_below = 0.5;  // what floods has flooded
  EXPECT_TRUE(findings_of(summary).empty());
}

TEST(RunFindings, AreNoneBelowTheirLimits)
{
  const auto ids = [](const Summary& summary) {
    std::vector<std::string> all;
    for (const RunFinding& finding : findings_of(summary)) all.push_back(finding.id);
    return all;
  };
  Summary s;
  s.unexplained_energy = 0.019;
  s.numbers = {{"water_from_nowhere", 0.019}, {"damping_over_promised", 8.0}, {"damping_fraction", 0.04},
      {"softening_length_over_cell_reached", 1.0}, {"softening_length_over_cell", 1.0},
      {"lowest_library_strength", 0.0}};
  EXPECT_THAT(ids(s), ElementsAre());
  s.unexplained_energy = 0.021;
  s.numbers = {{"water_from_nowhere", 0.021}, {"damping_over_promised", 8.0}, {"damping_fraction", 0.06},
      {"softening_length_over_cell_reached", 1.0}, {"softening_length_over_cell", 3.0},
      {"lowest_library_strength", -1.0}};
  s.reached_sides = {{"right", 2.0, false}, {"left", 3.0, true}};
  s.clamped_points = 1, s.points_left = 2;
  s.flood.emplace().margin = 0.05;
  EXPECT_THAT(ids(s), ElementsAre("margin", "energy", "water", "damping", "softening_length", "strength", "side",
                          "side", "clamped", "left"));
}

}  // namespace run_findings_test
