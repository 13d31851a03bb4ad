// In which stage a verdict came true: a slide in daily water is no flood of the river.
#include "simulation/verdict_words.hpp"
#include "support/test.hpp"

namespace {

/// A dike that came down at a time; the stage `daily` ended at 2 s, `flood` runs.
Summary dike_that_failed_at(Real time)
{
  Summary summary;
  FloodSummary& flood = summary.flood.emplace();
  flood.verdict = FloodVerdict::floods;
  flood.water_level = 4.5, flood.residual_height = 3.5, flood.freeboard = -1.0, flood.width_at_level = 0.0;
  flood.first_time_damaged = 0.5 * time, flood.first_time_below = time;
  summary.stages = {{"daily", {.start = 0.0, .end = 2.0}}, {"flood", {.start = 2.0, .end = StageSummary::none}}};
  return summary;
}

TEST(VerdictWords, SayInWhichStageTheGroundCameDown)
{
  EXPECT_THAT(verdict_clause(dike_that_failed_at(2.0)),
      AllOf(StartsWith("floods, from 2.00 s on: "), EndsWith("; it began in the stage `daily`, before `flood`")));
  EXPECT_THAT(verdict_clause(dike_that_failed_at(2.1)), EndsWith("; it began in the stage `flood`"));
  Summary damaged = dike_that_failed_at(2.1);  // damaged from 1.05 s on
  damaged.flood->verdict = FloodVerdict::damaged, damaged.flood->first_time_below.reset();
  EXPECT_THAT(verdict_clause(damaged), EndsWith("; it began in the stage `daily`, before `flood`"));
}

TEST(VerdictWords, AreThoseOfTheVerdictAloneWithoutStagesOrDamage)
{
  Summary summary = dike_that_failed_at(1.0);
  summary.stages.clear();
  EXPECT_EQ(verdict_clause(summary), flood_clause(*summary.flood));
  summary = dike_that_failed_at(1.0);
  summary.stages = {{"", {.start = 0.0, .end = 2.0}}};  // of a run that ended at rest
  EXPECT_EQ(verdict_clause(summary), flood_clause(*summary.flood));
  summary = dike_that_failed_at(1.0);
  summary.flood->verdict = FloodVerdict::stands;
  summary.flood->first_time_below.reset(), summary.flood->first_time_damaged.reset();
  EXPECT_EQ(verdict_clause(summary), flood_clause(*summary.flood));
}

}  // namespace
