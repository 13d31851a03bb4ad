#include "cli/commands.hpp"
#include "run/report/summary.hpp"
#include "support/simulations.hpp"

namespace run_warnings_test {

std::string warnings_on(const Summary& summary)
{
  const Simulation s(column("mpm_gp"));
  testing::internal::CaptureStderr();
  warn_of(summary, s.model, "runs/a");
  return testing::internal::GetCapturedStderr();
}

TEST(RunWarnings, ASpeedAndItsLimitAreNeverPrintedAlike)
{
  Summary summary;
  summary.stages = {{"high", {.start = 0.0, .end = 1.0, .at_rest = false, .fastest = 1.0004e-3}}};
  EXPECT_THAT(warnings_on(summary), HasSubstr("its fastest node moved with 0.0010004 m/s, limit 0.001 m/s"));
}

TEST(RunWarnings, NameTheStageAtWhoseEndSoilStillMoved)
{
  Summary summary;
  summary.stages = {{"high", {.start = 0.0, .end = 1.0, .at_rest = false, .fastest = std::nan("")}},
      {"after", {.start = 1.0, .end = 2.0, .at_rest = true, .fastest = 1e-5}}};
  FloodSummary& flood = summary.flood.emplace();
  flood.verdict = FloodVerdict::moving, flood.still_moves = true;
  flood.stage = "after", flood.stage_moving = "high";
  flood.fastest_soil = "clay", flood.fastest_node = 0.28, flood.fastest_x = 2.0, flood.fastest_y = 1.0;
  EXPECT_EQ(warnings_on(summary),
      "warning: runs/a: at the end of the stage `high` `clay` moves with 0.28 m/s at x = 2.0, y = 1.0 m, so nothing is "
      "decided: end that stage at rest, or later; see docs/stages.md#at-rest\n");
}

}  // namespace run_warnings_test
