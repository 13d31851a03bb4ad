// In which stage a verdict came true: a slide in daily water is no flood of the river.
#include "run/report/flood_summary.hpp"
#include "run/report/summary.hpp"
#include "support/test.hpp"

namespace flood_summary_test {

TEST(StageAt, IsTheStageInWhichATimeLiesWithItsEnd)
{
  const std::vector<StageSummary> stages{
      {"daily", {.start = 0.0, .end = 2.0}}, {"flood", {.start = 2.0, .end = StageSummary::none}}};
  EXPECT_EQ(stage_at(stages, 0.0), "daily");
  EXPECT_EQ(stage_at(stages, 2.0), "daily");
  EXPECT_EQ(stage_at(stages, 2.1), "flood");  // that runs
  EXPECT_EQ(stage_at(stages, {}), "");
  EXPECT_EQ(stage_at({}, 1.0), "");
  EXPECT_EQ(stage_at({stages[1]}, 2.0), "");  // at the end of another run that this one began with
  EXPECT_EQ(stage_at({stages[0]}, 2.1), "");
}

FloodSummary dike_that_failed_in(const char* damaged, const char* below)
{
  FloodSummary flood;
  flood.verdict = *below != 0 ? FloodVerdict::floods : FloodVerdict::damaged;
  flood.water_level = 4.5, flood.residual_height = 3.5, flood.freeboard = -1.0, flood.width_at_level = 0.0;
  flood.stage_damaged = damaged, flood.stage_below = below, flood.stage = "flood";
  return flood;
}

TEST(FloodClause, SaysInWhichStageTheGroundCameDown)
{
  EXPECT_THAT(
      flood_clause(dike_that_failed_in("daily", "daily")), EndsWith("; it began in the stage `daily`, before `flood`"));
  EXPECT_THAT(
      flood_clause(dike_that_failed_in("daily", "")), EndsWith("; it began in the stage `daily`, before `flood`"));
  EXPECT_THAT(flood_clause(dike_that_failed_in("flood", "flood")), EndsWith("4.50 m; it began in the stage `flood`"));
  EXPECT_THAT(flood_clause(dike_that_failed_in("", "flood")), EndsWith("4.50 m; it began in the stage `flood`"));
  EXPECT_THAT(flood_clause(dike_that_failed_in("daily", "flood")),
      EndsWith("; the damage began in the stage `daily`, the flood in `flood`"));
  EXPECT_THAT(flood_clause(dike_that_failed_in("", "")), EndsWith("the water at 4.50 m"));
  FloodSummary gone = dike_that_failed_in("flood", "flood");
  gone.residual_height = FloodSummary::none;
  EXPECT_THAT(flood_clause(gone), EndsWith(": no ground remains; it began in the stage `flood`"));
}

}  // namespace flood_summary_test
