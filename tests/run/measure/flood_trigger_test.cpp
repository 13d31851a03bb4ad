#include "run/measure/flood_dike.hpp"
#include "support/stages.hpp"

namespace flood_trigger_test {

/// The dike with a stage that changes nothing, one of weaker soil, and one with a higher river.
Case triggered_dike()
{
  Case c = dike();
  c.at_strength = 1.25;
  c.flood.river = RiverSide::left;
  c.water.situations = {{.name = "raised", .phreatic_line = {{0.0, 4.5}, {40.0, 1.0}}}};
  for (const char* name : {"as_it_is", "weaker", "higher"}) {
    StageCase stage;
    stage.name = name, stage.duration = 1.0;
    auto changed = std::make_shared<Case>(c);
    changed->stages.clear();
    changed->at_strength = c.stages.empty() ? 1.0 : 1.25;
    stage.changed = changed;
    c.stages.push_back(stage);
  }
  c.stages[2].trigger = true, c.stages[2].water = "raised";
  return c;
}

/// Its verdict in a stage. The first one has taken 2 s, damage and flood are of these times.
FloodSummary verdict_in_stage(std::size_t number, Case c)
{
  c.at_strength = c.stages[number].changed->at_strength;
  Drawn s;
  s.become([](Vec<2> p) { return p; }).become([](Vec<2> p) { return Vec<2>{p[0], 0.7 * p[1]}; });  // from 2.5 s on
  s.model.description.stages = c.stages, s.model.description.water = c.water;
  s.model.description.at_strength = c.at_strength, s.model.flood_level.river = Facing::left;
  s.state.stage = static_cast<int>(number);
  s.state.stages_done.assign(number, {.start = 0.0, .end = 1.0, .at_rest = true});
  return s.flood();
}

TEST(Flood, AVerdictUnderATriggerSaysSoAndWhatItWasBefore)
{
  const Case c = triggered_dike();
  EXPECT_FALSE(verdict_in_stage(0, c).trigger);
  const FloodSummary weaker = verdict_in_stage(1, c);
  ASSERT_TRUE(weaker.trigger);
  EXPECT_EQ(weaker.trigger->stage, "weaker");
  EXPECT_EQ(weaker.trigger->at_strength, 1.25);
  EXPECT_EQ(weaker.trigger->before, FloodVerdict::stands);
  EXPECT_FALSE(weaker.trigger->river);
  EXPECT_THAT(flood_clause(weaker),
      testing::StartsWith("after strengths were divided by 1.25 (before that: stands): floods, from 2.50 s on:"));
  EXPECT_THAT(flood_clause(verdict_in_stage(2, c)),
      testing::StartsWith("after strengths were divided by 1.25 and the river brought to 4.50 m (before that: "));
}

TEST(Flood, DamageBeforeTheTriggerIsOfTheSectionAsItIs)
{
  Case c = triggered_dike();
  c.stages[1].trigger = true;  // strengths are divided in the first stage, too
  auto first = std::make_shared<Case>(*c.stages[0].changed);
  first->at_strength = 1.25;
  c.stages[0].changed = first;
  EXPECT_FALSE(verdict_in_stage(1, c).trigger->before);
  EXPECT_EQ(verdict_in_stage(1, c).trigger->stage, "as_it_is");
  EXPECT_THAT(flood_clause(verdict_in_stage(1, c)), testing::StartsWith("after strengths were divided by 1.25: "));
}

/// The dike with a river of 2 m, which a trigger brings to 4.8 m.
Case dike_with_raised_river()
{
  Case c = dike();
  c.flood.water_level = 4.8, c.flood.river = RiverSide::left;
  c.water.start.phreatic_line = {{0.0, 2.0}, {12.0, 2.0}, {30.0, 0.5}};
  c.water.situations = {{.name = "raised", .phreatic_line = {{0.0, 4.8}, {17.0, 4.8}, {30.0, 0.5}}}};
  StageCase raised = stage("raised", 1.0);
  raised.water = "raised", raised.trigger = true;
  return staged(c, {{stage("as_it_is", 1.0), {}}, {raised, {}}});
}

/// The crest comes down to a share of its height over the land, then the trigger begins.
FloodSummary after_settling_to(Real share, bool at_rest = true)
{
  Drawn s(dike_with_raised_river());
  s.become([=](Vec<2> p) { return Vec<2>{p[0], p[1] > 1.0 ? 1.0 + share * (p[1] - 1.0) : p[1]}; });
  EXPECT_EQ(s.flood().first_time_below.has_value(), share < 0.2);
  EXPECT_FALSE(s.flood().trigger);
  s.state.stages_done = {{.start = 0.0, .end = s.state.time, .at_rest = at_rest}};
  s.state.stage = 1;
  for (int k = 0; k < 22; ++k) s.state.time += 0.1, s.look();
  return s.flood();
}

TEST(Flood, BeforeATriggerTheGroundIsJudgedAgainstItsOwnRiver)
{
  const FloodSummary settled = after_settling_to(0.9);  // the crest of 4.6 m is above the river, below the raised one
  EXPECT_EQ(settled.verdict, FloodVerdict::floods);
  EXPECT_NEAR(*settled.first_time_below, 2.5, 1e-9);
  EXPECT_EQ(settled.trigger->before, FloodVerdict::damaged);
  EXPECT_EQ(settled.trigger->river, 4.8);
  EXPECT_EQ(settled.criterion,
      "it floods where no ground between river and land stands at 4.8 m or higher (before the trigger: 2 m)");
  EXPECT_EQ(after_settling_to(1.0).verdict, FloodVerdict::stands);
  EXPECT_EQ(after_settling_to(0.1).trigger->before, FloodVerdict::floods);
  EXPECT_EQ(after_settling_to(0.1).stage_below, "as_it_is");
  EXPECT_EQ(settled.stage_damaged, "as_it_is");
}

TEST(Flood, BeforeATriggerThereIsNoVerdictOnSoilThatHadNotComeToRest)
{
  const FloodSummary moved = after_settling_to(0.9, false);
  EXPECT_FALSE(moved.trigger->before);
  EXPECT_THAT(flood_clause(moved), testing::StartsWith("after the river was brought to 4.80 m: floods"));
  EXPECT_EQ(after_settling_to(0.1, false).trigger->before, FloodVerdict::floods);  // that is for good
}

TEST(Flood, AStageThatHoldsTheSoilIsNoTrigger)
{
  Case c = triggered_dike();
  auto held = std::make_shared<Case>(*c.stages[0].changed);
  held->at_strength = 0.5;
  c.stages[0].changed = held;
  EXPECT_FALSE(verdict_in_stage(0, c).trigger);
  EXPECT_EQ(verdict_in_stage(1, c).trigger->stage, "weaker");
  c.stages.resize(1);  // it never is as strong as it is
  EXPECT_EQ(verdict_in_stage(0, c).trigger->at_strength, 0.5);
}

TEST(Flood, OfDividedStrengthsWithoutStagesIsUnderATrigger)
{
  Drawn s;
  EXPECT_FALSE(s.flood().trigger);
  s.model.description.at_strength = 1.5;
  EXPECT_EQ(s.flood().trigger->at_strength, 1.5);
  EXPECT_EQ(trigger_words({.stage = "traffic"}), "after the stage `traffic`");
  EXPECT_EQ(trigger_words({.stage = "w", .river = 3.0}), "after the river was brought to 3.00 m");
}

}  // namespace flood_trigger_test
