// A stage that ends while soil moves decides the verdict, whatever comes after it.
#include "mpm/features/rest.hpp"
#include "mpm/step/workspace.hpp"
#include "run/measure/flood_dike.hpp"

namespace flood_stages_test {

constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

/// The dike in stages, the water of the second one high, that of the third low.
struct Staged : Drawn {
  Staged()
  {
    for (const auto& [name, water] : {std::pair("daily", ""), {"high", "high"}, {"after", "start"}}) {
      StageCase stage;
      stage.name = name, stage.water = water;
      stage.changed = std::make_shared<Case>();
      model.description.stages.push_back(stage);
    }
    state.time = 1.0;
  }

  /// fastest: of the record; NaN: a stage of fixed duration.
  Staged& end_stage(std::size_t number, bool at_rest, Real speed, Real fastest)
  {
    model.stage = {};
    model.stage.name = model.description.stages[number].name, model.stage.number = number, model.stage.n_all = 3;
    if (!std::isnan(fastest)) model.stage.rest.speed = 0.001, model.stage.rest.steps = 10;
    state.stage = static_cast<std::int64_t>(number);
    state.stages_done.push_back({.start = state.time, .end = state.time + 1.0, .at_rest = at_rest, .fastest = fastest});
    state.time += 1.0;
    work.with.rest.set({speed});
    look();
    return *this;
  }
  Staged& rest(std::size_t number) { return end_stage(number, true, 1e-5, 1e-5); }
};

TEST(FloodInStages, AStageThatEndsWhileSoilMovesLeavesTheVerdictOpen)
{
  Staged s;
  s.rest(0).end_stage(1, false, 0.28, 0.28).rest(2);
  const FloodSummary flood = s.flood();
  EXPECT_EQ(flood.verdict, FloodVerdict::moving);
  EXPECT_EQ(flood.stage_moving, "high");
  EXPECT_EQ(flood.fastest_node, 0.28);
  EXPECT_THAT(flood_clause(flood), HasSubstr("; at the end of the stage `high` `clay` moves with 0.28 m/s at x = "));
}

TEST(FloodInStages, SoDoesOneOfFixedDuration)
{
  Staged s;
  s.rest(0).end_stage(1, false, 0.28, nan).rest(2);
  EXPECT_EQ(s.flood().verdict, FloodVerdict::moving);
  EXPECT_EQ(s.flood().stage_moving, "high");
  Staged slow;
  slow.rest(0).end_stage(1, false, 0.01, nan).rest(2);  // 0.03 m in as long again, limit 0.1 m
  EXPECT_EQ(slow.flood().verdict, FloodVerdict::stands);
}

TEST(FloodInStages, SoilBelowTheLimitOfRestIsNotFast)
{
  Staged s;
  s.rest(0).end_stage(1, false, 0.0009, 0.0009).rest(2);
  EXPECT_EQ(s.flood().verdict, FloodVerdict::stands);
}

TEST(FloodInStages, DamageIsKnownHoweverItMoved)
{
  Staged s;
  s.rest(0).end_stage(1, false, 0.28, 0.28);
  s.become([](Vec<2> p) { return Vec<2>{p[0], p[1] > 1.0 ? 1.0 + 0.8 * (p[1] - 1.0) : p[1]}; });
  s.rest(2);
  EXPECT_EQ(s.flood().verdict, FloodVerdict::damaged);
  EXPECT_FALSE(s.flood().still_moves);
}

TEST(FloodInStages, AStageThatGoesOnDecidesForTheOneBefore)
{
  Staged s;
  s.model.description.stages[2].water = "";
  s.rest(0).end_stage(1, false, 0.28, 0.28).rest(2);
  EXPECT_EQ(s.flood().verdict, FloodVerdict::stands);
  Staged held;
  auto strong = std::make_shared<Case>();
  strong->at_strength = 0.5;
  held.model.description.stages[0].changed = strong;
  held.end_stage(0, false, 0.28, 0.28).rest(1).rest(2);
  EXPECT_EQ(held.flood().verdict, FloodVerdict::stands);
}

/// The dike held in a first stage, and released over 4 s from now on.
struct Released : Drawn {
  Released()
  {
    for (const auto& [name, at] : {std::pair("rise", 0.5), {"release", 1.0}}) {
      StageCase stage;
      stage.name = name;
      auto changed = std::make_shared<Case>();
      changed->at_strength = at;
      stage.changed = changed;
      model.description.stages.push_back(stage);
    }
    model.description.stages[1].ramp = 4.0;
    model.stage.name = "rise", model.stage.n_all = 2;
  }
  Released& release()
  {
    state.stages_done.push_back({.start = 0.0, .end = state.time, .at_rest = true});
    model.first_time = state.time;
    model.stage.name = "release", model.stage.number = 1, state.stage = 1;
    for (const ActiveFollower& active : state.followers) active.follower->count_displacement_anew(model, state);
    edit_points(state, [&](const PointBlock<2>& block, Index lane) {
      const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
      for (int d = 0; d < 2; ++d) state.x_initial[2 * id + d] = block.row(Rows::x + d)[lane];
    });
    return *this;
  }
};

Vec<2> lower(Vec<2> p) { return {p[0], p[1] > 1.0 ? 1.0 + 0.9 * (p[1] - 1.0) : p[1]}; }

TEST(FloodInStages, SoilThatIsHeldIsNotDamagedByWhatItSettles)
{
  Released s;
  s.become(lower);
  EXPECT_FALSE(s.flood().first_time_damaged);
  s.release().look();
  EXPECT_FALSE(s.flood().first_time_damaged);
  Released loose;
  loose.release().become(lower);
  EXPECT_TRUE(loose.flood().first_time_damaged);
}

TEST(FloodInStages, SoilThatIsReleasedSaysAtWhichStrengthItFailed)
{
  Released s;
  s.become([](Vec<2> p) { return p; });
  s.release().become([](Vec<2> p) { return p; }).become([](Vec<2> p) { return Vec<2>{p[0], 0.7 * p[1]}; });
  const FloodSummary flood = s.flood();  // 2.5 of 4 s after the release began: 3/8 of the strength in excess is left
  EXPECT_EQ(flood.verdict, FloodVerdict::floods);
  EXPECT_THAT(flood.at_strength_below, Optional(DoubleNear(1.0 / 1.375, 1e-6)));
  EXPECT_THAT(flood.at_strength_damaged, Optional(DoubleNear(1.0 / 1.375, 1e-6)));
  EXPECT_THAT(flood_clause(flood),
      HasSubstr("; it began in the stage `release` at at_strength = 0.73, the flood at at_strength = 0.73"));
}

TEST(FloodInStages, ACheckpointRemembersTheStage)
{
  Staged s, other;
  s.rest(0).end_stage(1, false, 0.28, 0.28);
  s.state.time = 0.0, s.state.stage = 0;  // as the clock of the model stands
  other.restore(s.save());
  other.rest(2);
  EXPECT_EQ(other.flood().stage_moving, "high");
}

}  // namespace flood_stages_test
