// The words about a run.
#include "report/story.hpp"
#include "support/test.hpp"

namespace {

/// A run of 4 s that ends with a fifth of its largest kinetic energy.
RunResults sample_run()
{
  RunResults run;
  run.ledger = {{"time", "kinetic"}, {{0.0, 1.0, 4.0}, {0.0, 1000.0, 200.0}}};
  run.summary.finished = true;
  Summary& s = run.summary.values;
  s.facing = Facing::right, s.scheme = "mpm_gp", s.n_points = 500, s.n_steps = 100, s.front_x = 13.06, s.run_out = 5.07,
  s.crest_x = 4.1, s.crest_y = 1.96;
  s.moved_volume = 6.47, s.moved_fraction = 0.404, s.moved_distance = 0.1;
  return run;
}

Slide slide(Real begins, std::optional<Real> stops)
{
  return {.begins = begins, .stops = stops, .crest_from = 8.0, .crest_to = 6.0, .kinetic_peak = 1000.0};
}

TEST(Story, TellsEachSlideMotionAndCrest)
{
  RunResults run = sample_run();
  run.summary.values.slides = {{slide(0.18, 2.16), {}}, {slide(2.52, {}), {}}};
  EXPECT_THAT(tell_story(run), ElementsAre("The first slide begins at 0.18 s: the crest retreats from x = 8.00 m to "
                                           "6.00 m. At 2.16 s it has slowed to a tenth of its largest kinetic energy.",
                                   "The second slide begins at 2.52 s: the crest retreats from x = 8.00 m to 6.00 m. "
                                   "It still moves at 4.00 s, with 20 % of its largest kinetic energy.",
                                   "By 4.00 s, 6.47 m² of soil (40.4 % of the section) have moved by more than 0.1 m. "
                                   "The front has run out by 5.07 m, to x = 13.06 m.",
                                   "The first surface still stands up to x = 4.10 m, y = 1.96 m."));
}

TEST(Story, SaysWhenASlideIsOvertakenByTheNext)
{
  RunResults run = sample_run();
  run.summary.values.slides = {{slide(0.18, {}), {}}, {slide(2.52, 3.0), {}}};
  EXPECT_THAT(tell_story(run)[0],
      HasSubstr("It has not slowed to a tenth of its largest kinetic energy when the next one begins."));
  EXPECT_THAT(tell_story(run), Contains("At the end the soil still moves, with 20 % of its largest kinetic energy."));
}

TEST(Story, SaysThatSoilHolds)
{
  RunResults run = sample_run();
  run.summary.values.moved_fraction = 0.0;
  EXPECT_EQ(tell_story(run)[0], "The soil holds: there is no slide.");
  run.summary.values.moved_fraction = 0.3;
  EXPECT_EQ(tell_story(run)[0], "Soil moves, but the crest does not retreat as in a slide.");
}

TEST(Story, OfARunThatGoesOnWaitsForItsSummary)
{
  RunResults run = sample_run();
  run.ledger = {{"time", "step", "kinetic"}, {{0.0, 1.0}, {0.0, 200.0}, {0.0, 10.0}}};
  EXPECT_THAT(
      tell_story(run), ElementsAre("The run has come to 1.00 s. What happened is told when it ends or is stopped."));
  run.summary.values.n_steps = 200;
  EXPECT_GT(tell_story(run).size(), 1);
}

TEST(Story, JudgesRestByTheMotionOfTheNodes)
{
  RunResults run = sample_run();
  run.ledger = {{"time", "kinetic", "kinetic_nodal"}, {{0.0, 1.0, 4.0}, {0.0, 1000.0, 120.0}, {0.0, 1000.0, 1e-6}}};
  for (const auto& text : tell_story(run)) EXPECT_THAT(text, Not(HasSubstr("still moves")));
}

TEST(Story, SaysThatTheToeIsNotFreeAndHowFarSoilCame)
{
  RunResults run = sample_run();
  Summary& s = run.summary.values;
  s.free_toe = false;
  EXPECT_THAT(tell_story(run)[1], EndsWith("The soil fills the section to its side, so its toe is not free: "
                                           "what moved reaches x = 13.06 m, 5.07 m beyond the toe of "
                                           "the slope."));
  s.front_x = std::nan("");
  EXPECT_THAT(tell_story(run)[1], EndsWith("its toe is not free: no soil has come out of the slope."));
  s.facing.reset();
  EXPECT_THAT(tell_story(run)[1], EndsWith("The section has no slope: there is no front and no crest."));
}

TEST(Story, NamesTheSlopeThatSlidesToTheLeft)
{
  RunResults run = sample_run();
  Slide left = slide(0.18, 2.16);
  left.facing = Facing::left;
  run.summary.values.slides = {{left, {}}};
  EXPECT_THAT(
      tell_story(run)[0], StartsWith("The first slide begins at 0.18 s on the slope to the left: the crest retreats"));
}

TEST(Story, SaysHowMuchOfWhatMovedIsIntact)
{
  RunResults run = sample_run();
  run.summary.values.intact_fraction = 0.248;
  EXPECT_THAT(tell_story(run), Contains("Of the soil that moved, 24.8 % is intact: its plastic strain is below 0.01."));
}

TEST(Story, NamesSofteningAndAHistoryThatFell)
{
  RunResults run = sample_run();
  Summary& s = run.summary.values;
  s.scheme = "mpm_mixed", s.softened_fraction = {{4.0, 0.417}}, s.points_eps_eq_p_fell = 16, s.points_su_rose = 14;
  EXPECT_THAT(tell_story(run), Contains("41.7 % of the soil has lost more than half of its strength."));
  EXPECT_THAT(tell_story(run), Contains("At 16 of 500 points the plastic strain fell at some time and strength came "
                                        "back. The law of the soil does not allow it: "
                                        "MPM-Mixed averages the history of neighbouring points."));
}

TEST(Cautions, AreNoneForAGoodRunAndNameWhatIsNot)
{
  RunResults run = sample_run();
  EXPECT_THAT(find_cautions(run), IsEmpty());
  run.summary.finished = false;
  run.summary.values.energy_balance_error = 0.06;
  run.summary.values.clamped_points = 3;
  run.summary.values.points_left = 7;
  EXPECT_THAT(find_cautions(run),
      ElementsAre("The run has not reached its end: the last row of its ledger is at 4 s.",
          "The energy balance is off by 6 % of the energy exchanged.",
          "3 points had to be put back at a wall of the mesh.", "7 points left the mesh through open sides."));
}

TEST(Checks, OfAKilledRunAreNotPassedForWantOfNumbers)
{
  RunResults run = sample_run();
  run.summary.finished = false;
  run.summary.values.n_steps = 0;
  const auto checks = list_checks(run);
  ASSERT_EQ(checks.size(), 1);
  EXPECT_FALSE(checks[0].passed);
}

TEST(Checks, FailWhereTheNumbersSaySo)
{
  RunResults run = sample_run();
  for (const Check& check : list_checks(run)) EXPECT_TRUE(check.passed) << check.name;
  run.summary.values.points_su_rose = 1;
  EXPECT_FALSE(list_checks(run).back().passed);
  EXPECT_EQ(list_checks(run).back().value, "1");
}

TEST(Story, BeginsWithTheVerdictOnTheWater)
{
  RunResults run = sample_run();
  run.summary.values.slides = {{slide(0.18, 2.16), {}}};
  run.summary.values.residual_height = 3.4;
  run.summary.values.flood = {.verdict = FloodVerdict::floods,
      .water_level = 4.0,
      .water_level_origin = "that of the case",
      .river = Facing::left,
      .residual_height = 3.4,
      .freeboard = -0.6,
      .first_time_damaged = {},
      .first_time_below = 0.5,
      .criterion = "it floods where it is low"};
  const auto story = tell_story(run);
  EXPECT_EQ(story[0],
      "Verdict: Floods, from 0.50 s on: at the end the highest ground stands at 3.40 m, 0.60 m below the water at 4.00 "
      "m. "
      "The criterion: it floods where it is low. The water level is that of the case. Water that would flow over is "
      "not simulated.");
  EXPECT_THAT(story[1], StartsWith("The first slide begins at 0.18 s on the land's side: "));
  EXPECT_THAT(story, Contains("The highest ground that remains stands at 3.40 m."));
}

TEST(Story, TellsOfStagesAndOfTheWaterOfStrengths)
{
  RunResults run = sample_run();
  run.summary.values.stages = {{"daily", {.start = 0.0, .end = 4.25, .steps = 100, .at_rest = true, .fastest = 1e-4}},
      {"flood", {.start = 4.25, .end = 44.0, .steps = 900, .at_rest = false, .fastest = 0.0125}},
      {"after", {.start = 44.0, .end = 45.0, .steps = 9, .at_rest = false, .fastest = std::nan("")}}};
  run.summary.values.strength_water = {
      {"clay", "su_peak", "flood", "start"}, {"peat", "su_peak", "flood", "start"}, {"sand", "cohesion", "start", {}}};
  const auto story = tell_story(run);
  EXPECT_THAT(story, Contains("Stages: daily from 0.00 to 4.25 s, at rest; flood from 4.25 to 44.00 s, not at rest "
                              "(the fastest node: 0.013 m/s); after from 44.00 to 45.00 s."));
  EXPECT_THAT(story, Contains("Strength of clay, peat: su_peak follows from sigma'_v in the water of the situation "
                              "\"flood\", and from sigma'_p in the water at the start."));
  EXPECT_THAT(story, Contains("Strength of sand: cohesion follows from sigma'_v in the water at the start."));
}

}  // namespace
