#include "mpm/features/rest.hpp"
#include "mpm/step/workspace.hpp"
#include "run/measure/flood_dike.hpp"
#include "run/findings/flood_warnings.hpp"
#include "run/loop/other_run.hpp"

namespace flood_test {

/// What slid: all to the right of a line that falls from (x, 5 m) at 45 degrees, by so much to the right and down.
Vec<2> slide_right(Vec<2> p, Real x, Real along, Real down)
{
  return p[1] > 1.0 && p[0] > x + (5.0 - p[1]) ? Vec<2>{p[0] + along, std::max(1.05, p[1] - down)} : p;
}

TEST(Flood, ADikeThatStandsHoldsTheWater)
{
  const Drawn s;
  const FloodSummary flood = s.flood();
  EXPECT_EQ(flood.verdict, FloodVerdict::stands);
  EXPECT_NEAR(flood.residual_height, 5.0, 1e-9);
  EXPECT_NEAR(flood.freeboard, 1.0, 1e-9);
  EXPECT_NEAR(flood.width_at_level, 8.0, 0.1);  // 4 m and 2 m of each slope
  EXPECT_NEAR(flood.intact_width, flood.width_at_level, 1e-12);
  EXPECT_FALSE(flood.first_time_below || flood.first_time_damaged || flood.river);
  EXPECT_NEAR(s.rows[0]["residual_height"], 5.0, 1e-9);
  EXPECT_NEAR(s.rows[0]["width_at_level"], flood.width_at_level, 1e-12);
  EXPECT_EQ(flood.criterion, "it floods where no ground between river and land stands at 4 m or higher");
}

TEST(Flood, ADikeThatLostPartOfItsCrestIsDamaged)
{
  Drawn s;
  s.become([](Vec<2> p) { return slide_right(p, 20.0, 6.0, 2.0); });
  const FloodSummary flood = s.flood();
  EXPECT_EQ(flood.verdict, FloodVerdict::damaged);
  EXPECT_NEAR(flood.residual_height, 5.0, 1e-9);
  EXPECT_LT(flood.width_at_level, 6.0);
  EXPECT_NEAR(*flood.first_time_damaged, 0.1, 1e-9);
  EXPECT_FALSE(flood.first_time_below);
}

TEST(Flood, OfDamagedGroundJustAboveTheWaterTheVerdictIsNotSure)
{
  const auto flattened = [](Real water_level, Real smallest_freeboard = 0.0) {
    Case c = dike();
    c.flood.water_level = water_level, c.flood.smallest_freeboard = smallest_freeboard;
    Drawn s(c);
    s.become([](Vec<2> p) { return Vec<2>{p[0], p[1] > 1.0 ? 1.0 + 0.8 * (p[1] - 1.0) : p[1]}; });
    return s.flood();
  };
  const Real ground = flattened(3.0).residual_height;
  EXPECT_THAT(flattened(ground - 0.05).margin, Optional(DoubleNear(0.05, 1e-9)));  // a fortieth of 4 m is 0.1 m
  EXPECT_THAT(flattened(ground - 0.2, 0.15).margin, Optional(DoubleNear(0.05, 1e-9)));
  EXPECT_FALSE(flattened(ground - 0.2).margin);
  EXPECT_FALSE(flattened(ground + 0.05).margin) << "it is near a flood";
  Case c = dike();
  c.flood.water_level = 4.95;
  EXPECT_FALSE(Drawn(c).flood().margin) << "it stands";
}

TEST(Flood, ADikeThatCameDownBelowTheWaterFloodsFromThatTimeOn)
{
  Drawn s;
  s.become([](Vec<2> p) { return p; }).become([](Vec<2> p) { return Vec<2>{p[0], 0.7 * p[1]}; });
  const FloodSummary flood = s.flood();
  EXPECT_EQ(flood.verdict, FloodVerdict::floods);
  EXPECT_NEAR(*flood.first_time_below, 2.5, 1e-9);
  EXPECT_NEAR(flood.residual_height, 3.5, 0.05);
  EXPECT_EQ(flood_clause(flood).substr(0, 23), "floods, from 2.50 s on:");
  FloodSummary kept = flood;
  withhold_verdict(kept);
  EXPECT_EQ(kept.verdict, FloodVerdict::floods);
}

/// The dike with its crest at some height over the land.
auto with_height(Real height)
{
  return [=](Vec<2> p) { return Vec<2>{p[0], p[1] > 1.0 ? 1.0 + height / 4.0 * (p[1] - 1.0) : p[1]}; };
}

TEST(Flood, GroundThatWasBelowTheWaterForAMomentByLittleOrNotToTheEndIsNear)
{
  Drawn back;
  back.become(with_height(2.0)).become(with_height(4.0));
  const FloodSummary flood = back.flood();
  EXPECT_EQ(flood.verdict, FloodVerdict::near) << "it stands above it at the end";
  EXPECT_THAT(flood.below_for, Optional(DoubleNear(2.3, 1e-9)));
  EXPECT_THAT(flood.below_by, Optional(DoubleNear(1.0, 0.05)));
  EXPECT_THAT(
      flood_clause(flood), StartsWith("floods briefly or by little, uncertain, from 0.10 s on, below by 0.97 m "
                                      "at most, last for 2.30 s: at the end the highest ground stands at 5.00"));
  Case c = dike();
  c.flood.smallest_freeboard = 1.05;  // a fortieth of 4 m is 0.1 m
  const FloodSummary low = Drawn(c).become(with_height(4.0)).flood();
  EXPECT_EQ(low.verdict, FloodVerdict::near);
  EXPECT_THAT(low.below_by, Optional(DoubleNear(0.05, 1e-9)));
  Drawn brief;
  draw_points(brief, with_height(2.0));
  for (int k = 0; k < 20; ++k) brief.state.time += 0.1, brief.look();
  const Follower& follower = *std::ranges::find(brief.state.followers, "flood", [](const ActiveFollower& active) {
    return active.type->name;
  })->follower;
  EXPECT_EQ(brief.flood().verdict, FloodVerdict::near);
  EXPECT_TRUE(follower.waits(brief.state)) << "time alone decides";
  brief.state.time += 0.1, brief.look();
  EXPECT_EQ(brief.flood().verdict, FloodVerdict::floods);
  EXPECT_FALSE(follower.waits(brief.state));
}

/// The land slope of the dike as far as it lies less than so deep below its face moves by 2 m [m].
auto skin_that_moves(Real depth)
{
  return [=](Vec<2> p) {
    const bool is_skin = p[0] > 22.0 && p[0] < 30.0 && p[1] > std::max(1.0, 5.0 - 0.5 * (p[0] - 22.0) - depth);
    return is_skin ? Vec<2>{p[0] + 2.0, p[1]} : p;
  };
}

TEST(Flood, SoilThatMovesAboveTheLeastDepthRavels)
{
  Case c = dike();
  EXPECT_EQ(Drawn(c).become(skin_that_moves(0.6)).flood().verdict, FloodVerdict::damaged);
  EXPECT_FALSE(Drawn(c).become(skin_that_moves(0.6)).flood().ravelled_volume);
  c.flood.least_depth = 1.2;
  Drawn skin(c);
  skin.become(skin_that_moves(0.6));
  const Summary ravelled = summarise(skin.model, skin.state);
  EXPECT_EQ(ravelled.flood->verdict, FloodVerdict::stands);
  EXPECT_TRUE(ravelled.slides.empty());
  EXPECT_THAT(ravelled.flood->ravelled_volume, Optional(DoubleNear(8.0 * 0.6, 0.5)));
  EXPECT_THAT(ravelled.flood->ravelled_depth, Optional(DoubleNear(0.7, 0.2)));
  skin.state.time = 0.0;  // of its step
  Drawn resumed(c);
  resumed.restore(skin.save());
  EXPECT_EQ(resumed.flood().ravelled_volume, ravelled.flood->ravelled_volume);
  Drawn deep(c);
  const FloodSummary slid = deep.become(skin_that_moves(3.0)).flood();
  EXPECT_EQ(slid.verdict, FloodVerdict::damaged);
  EXPECT_THAT(slid.ravelled_depth, Optional(DoubleNear(1.2, 0.2)));
  c.flood.least_depth = 8.0;
  EXPECT_THAT(refusal<InputError>([&] { build_model(c, 1); }),
      HasSubstr(
          "flood.least_depth: the least depth is deeper than the section\n  Got 8 m; the mesh is 8 m high. No soil "
          "could slide. Give less, 0.5 to 2 m for a dike."));
}

TEST(Flood, OfARunThatHasNotEndedTheClauseSaysSo)
{
  FloodSummary flood = Drawn().flood();
  EXPECT_THAT(flood_clause(flood), StartsWith("stands: at the end the highest ground stands at 5.00 m, 1.00 m above"));
  withhold_verdict(flood);
  flood.first_time_damaged = 2.0;
  EXPECT_THAT(
      flood_clause(flood), StartsWith("no verdict before the end of the run, damaged from 2.00 s on: so far the "
                                      "highest ground stands at 5.00 m, "));
}

TEST(Flood, AStageThatResetsDisplacementBeginsNoNewVerdict)
{
  Drawn s;
  s.become([](Vec<2> x) { return Vec<2>{x[0], std::min(x[1], 0.6 * x[1] + 0.4)}; });
  const FloodSummary before = s.flood();
  ASSERT_TRUE(before.first_time_below);
  for (const ActiveFollower& active : s.state.followers) active.follower->count_displacement_anew(s.model, s.state);
  s.look();
  EXPECT_EQ(s.flood().first_time_below, before.first_time_below);
  EXPECT_EQ(s.flood().first_time_damaged, before.first_time_damaged);
}

TEST(Flood, ASlideBeforeDisplacementWasCountedAnewStillIsDamage)
{
  Drawn s;  // the land slope slides; the barrier keeps its height
  s.become([](Vec<2> p) { return slide_right(p, 20.0, 6.0, 2.0); });
  const Summary before = summarise(s.model, s.state);
  ASSERT_EQ(before.slides.size(), 1u);
  ASSERT_TRUE(before.flood->first_time_damaged);
  for (const ActiveFollower& active : s.state.followers) active.follower->count_displacement_anew(s.model, s.state);
  s.look();
  const Summary after = summarise(s.model, s.state);
  ASSERT_EQ(after.slides.size(), 1u);
  EXPECT_EQ(after.slides[0].slide.begins, before.slides[0].slide.begins);
  EXPECT_EQ(after.flood->first_time_damaged, before.flood->first_time_damaged);
  EXPECT_EQ(after.flood->verdict, FloodVerdict::damaged);
}

TEST(Flood, AllThatStandsBetweenRiverAndLandCounts)
{
  Drawn s;  // both slopes slide and leave a wall of 1.5 m with nearly the first height
  s.become([](Vec<2> p) {
    if (p[1] < 1.0 || std::abs(p[0] - 20.0) < 0.75) return p;
    return p[0] > 20.0 ? Vec<2>{p[0] + 5.0, 1.0 + 0.2 * (p[1] - 1.0)} : Vec<2>{p[0] - 5.0, 1.0 + 0.2 * (p[1] - 1.0)};
  });
  const Summary summary = summarise(s.model, s.state);
  EXPECT_NEAR(summary.flood->residual_height, 5.0, 1e-9);
  EXPECT_NEAR(*summary.residual_height, 5.0, 1e-9);
  EXPECT_EQ(summary.flood->verdict, FloodVerdict::damaged);
  EXPECT_EQ(summary.slides.size(), 2u);  // one down each slope
}

TEST(Flood, FreeboardAndWidthAreAskedFor)
{
  Case c = dike();
  const auto standing = [](const Case& of) { return Drawn(of).become([](Vec<2> p) { return p; }).flood(); };
  c.flood.smallest_freeboard = 1.2;
  EXPECT_EQ(standing(c).verdict, FloodVerdict::floods);
  c.flood.smallest_freeboard = 0.9;
  c.flood.smallest_width = 7.0;
  EXPECT_EQ(Drawn(c).flood().verdict, FloodVerdict::stands);
  EXPECT_EQ(Drawn(c).flood().criterion,
      "it floods where no ground between river and land stands at 4.9 m or higher, 0.9 m over the water at 4 m, or "
      "where "
      "the ground is less than 7 m wide at 4 m");
  c.flood.smallest_width = 9.0;
  EXPECT_EQ(standing(c).verdict, FloodVerdict::floods);
  EXPECT_NEAR(*Drawn(c).flood().first_time_below, 0.0, 1e-12);
}

TEST(Flood, SoilThatShearedIsNoIntactWidth)
{
  Case c = dike();
  c.flood.smallest_width = 7.0;
  Drawn s(c);
  const int strain = row_of(s.model.materials[0], Role::plastic_strain);
  edit_points(s.state, [&](const PointBlock<2>& block, Index lane) {
    if (std::abs(block.row(Rows::x)[lane] - 20.0) < 1.0) block.row(strain)[lane] = 0.5;
  });
  s.state.time += 1.0;
  s.look();
  EXPECT_NEAR(s.flood().width_at_level - s.flood().intact_width, 2.0, 1e-9);
  EXPECT_EQ(s.flood().verdict, FloodVerdict::damaged);  // 6 m intact of 7 m
  EXPECT_EQ(s.flood().first_time_damaged, 1.0);
}

/// With a body of water in front of the dike up to 4.5 m, and a load of 1 m on its crest.
Case dike_with_river_and_load()
{
  Case c = dike();
  BodyCase river = body("water", {0.0, 1.0}, {10.0, 4.5}), load = body("load", {19.0, 5.0}, {21.0, 6.0});
  river.polygon = {{0.0, 1.0}, {10.0, 1.0}, {17.0, 4.5}, {0.0, 4.5}};
  for (BodyCase* b : {&river, &load}) b->points_per_cell = {4, 4};
  c.bodies.push_back(river), c.bodies.push_back(load);
  const MaterialType* fluid = find_material("newtonian_fluid");
  std::vector<Real> parameters;
  for (const ParameterInfo& info : fluid->parameters) parameters.push_back(info.typical);
  c.materials.push_back({"water", "newtonian_fluid", 1000.0, fluid->complete(parameters)});
  c.materials.push_back(elastic(2.0e6, 0.3, 2000.0));
  c.materials.back().name = "load";
  c.materials.back().ground = false;
  return c;
}

TEST(Flood, WaterAndLoadsAreNoGround)
{
  const Drawn s(dike_with_river_and_load()), alone;
  const FloodSummary a = s.flood(), b = alone.flood();
  EXPECT_EQ(a.residual_height, b.residual_height);
  EXPECT_EQ(a.width_at_level, b.width_at_level);
  for (const char* name : {"front_x", "front_left_x", "crest_x", "crest_y", "crest_left_x", "crest_left_y"}) {
    const Real with = s.rows[0][name], without = alone.rows[0][name];
    EXPECT_TRUE(with == without || (std::isnan(with) && std::isnan(without))) << name << ' ' << with;
  }
  Case c = dike_with_river_and_load();
  c.materials.back().ground = true;
  EXPECT_NEAR(Drawn(c).flood().residual_height, 6.0, 1e-9);
}

TEST(Flood, OnlyGroundMoves)
{
  Drawn s(dike_with_river_and_load());
  s.become([](Vec<2> p) { return p[1] > 5.0 || (p[0] < 8.0 && p[1] > 1.0) ? Vec<2>{p[0] + 1.0, p[1]} : p; });
  EXPECT_EQ(s.rows.back()["moved_volume"], 0.0);
  EXPECT_EQ(summarise(s.model, s.state).moved_volume, 0.0);
  EXPECT_EQ(s.flood().verdict, FloodVerdict::stands);
}

TEST(Flood, TheRiverIsWhereTheGroundIsLow)
{
  Case c = dike();
  BodyCase land = body("clay", {22.0, 1.0}, {40.0, 5.0});
  c.bodies.push_back(land);
  EXPECT_EQ(Drawn(c).flood().river, Facing::left);
  c.flood.river = RiverSide::right;
  EXPECT_EQ(Drawn(c).flood().river, Facing::right);
}

TEST(Flood, WithoutAWaterLevelNothingIsJudged)
{
  Case c = dike();
  c.flood.water_level = std::nan("");
  const Drawn s(c);
  EXPECT_FALSE(summarise(s.model, s.state).flood);
  EXPECT_TRUE(std::isnan(s.rows[0]["residual_height"]));
  EXPECT_NEAR(*summarise(s.model, s.state).residual_height, 5.0, 1e-9);
}

/// The same dike with the river to the left, whose water may rise after the start.
Case dike_in_water()
{
  Case c = dike();
  c.flood.given = true;
  c.flood.water_level = std::nan("");
  c.water.start.phreatic_line = {{0.0, 2.0}, {12.0, 2.0}, {30.0, 1.5}};  // free water of 0.5 m at the right end
  WaterSituation high;
  high.name = "high";
  high.phreatic_line = {{0.0, 4.0}, {16.0, 4.0}, {30.0, 1.5}};
  c.water.situations = {high};
  return c;
}

FloodLevel level_of(const Case& c) { return build_model(c, 1).flood_level; }

TEST(Flood, TheLevelIsTheHighestFreeWaterAtTheRiver)
{
  Case c = dike_in_water();
  EXPECT_EQ(level_of(c).value, 2.0);  // no stage and no time leads to the other situation
  EXPECT_EQ(level_of(c).origin, "the highest free water at the left end of the section");
  c.water.situations[0].time = c.time.end / 2.0;
  const FloodLevel level = level_of(c);
  EXPECT_EQ(level.value, 4.0);
  EXPECT_EQ(level.origin, "the highest free water at the left end of the section, in the situation \"high\"");
  EXPECT_EQ(level.river, Facing::left);
  const FloodSummary flood = Drawn(c).flood();
  EXPECT_EQ(flood.water_level, 4.0);
  EXPECT_EQ(flood.water_level_origin, level.origin);
  EXPECT_EQ(flood.river, Facing::left);
  EXPECT_NEAR(flood.freeboard, 1.0, 1e-9);
}

// A run that is resumed with a later end, or begins with the end of another one, is judged against the same level.
TEST(Flood, TheLevelDoesNotDependOnTheEndOfTheRun)
{
  Case c = dike_in_water();
  c.water.situations[0].time = 2.0 * c.time.end;
  EXPECT_EQ(level_of(c).value, 4.0);
  c.water.situations[0].time = c.time.end;
  c.water.situations.push_back(c.water.situations[0]);
  c.water.situations[1] = {.name = "low", .time = 1.5 * c.time.end, .phreatic_line = {{0.0, 0.5}}};
  EXPECT_EQ(level_of(c).value, 4.0);  // water that falls again does not undo it
}

TEST(Flood, TheLevelOfAFormulaIsThatOfItsPressureAtTheGround)
{
  Case c = dike_in_water();
  WaterSituation& high = c.water.situations[0];
  high.time = c.time.end;
  high.phreatic_line.clear();
  high.formula = [](Vec<2> x, Real) { return x[0] < 16.0 ? 9810.0 * (4.0 - x[1]) : 0.0; };
  EXPECT_NEAR(level_of(c).value, 4.0, 1e-12);
  EXPECT_EQ(level_of(c).river, Facing::left);
  high.formula = [](Vec<2> x, Real) { return x[0] < 16.0 ? 4.0 - x[1] : 0.0; };
  high.formula_gives_head = true;
  high.formula = [](Vec<2>, Real) { return 4.0; };
  EXPECT_NEAR(level_of(c).value, 4.0, 1e-12);
}

TEST(Flood, ABermThatSlidIsDamageThoughTheCrestStands)
{
  const auto lower_slope_moves = [](Real by) {
    Drawn s;
    s.become([&](Vec<2> p) { return p[0] > 26.0 && p[1] > 1.0 ? Vec<2>{p[0] + by, p[1]} : p; });
    return s.flood();
  };
  EXPECT_EQ(lower_slope_moves(0.19).verdict, FloodVerdict::stands) << "less than a twentieth of the relief";
  const FloodSummary slid = lower_slope_moves(2.0);
  EXPECT_EQ(slid.verdict, FloodVerdict::damaged);
  EXPECT_NEAR(slid.residual_height, 5.0, 1e-9);
}

/// A run of the case that begins with the present state of another one.
FloodSummary after(const Drawn& other, const Case& c)
{
  Model before = build_model(other.model.description, 1), model = build_model(c, 1);
  before.followers = model.followers = all_followers();
  State state = restore(before, other.save());
  begin_from(before, "", model, state);
  Simulation s(std::move(model), std::move(state));
  keep_ledger(s.model, s.state, s.work);
  return *summarise(s.model, s.state).flood;
}

TEST(Flood, ARunThatBeginsWithAnotherOneKeepsItsVerdictIfItAsksForTheSame)
{
  Drawn fell;
  fell.become([](Vec<2> p) { return Vec<2>{p[0], 0.7 * p[1]}; }).become([](Vec<2> p) { return p; });
  fell.state.time = 0.0;  // of its step
  EXPECT_EQ(after(fell, dike()).verdict, FloodVerdict::near);
  Case lower = dike();
  lower.flood.water_level = 3.0;  // to which the ground never came down
  const FloodSummary other = after(fell, lower);
  EXPECT_EQ(other.verdict, FloodVerdict::stands);
  EXPECT_NEAR(other.freeboard, 2.0, 1e-9);
}

TEST(Flood, ARunThatBeginsWithAnotherOneComparesWithItsOwnGroundAtTheStart)
{
  Case dry = dike();
  dry.flood = {};  // the other run did not ask, so all of its ground counts
  BodyCase hill = dry.bodies[0];
  hill.polygon = {{34.0, 1.0}, {40.0, 1.0}, {40.0, 6.0}, {34.0, 6.0}};  // high land behind the dike
  dry.bodies.push_back(hill);
  Drawn fell(dry);
  fell.become([](Vec<2> p) { return p[0] < 33.0 ? Vec<2>{p[0], 0.7 * p[1]} : p; });
  fell.state.time = 0.0;
  Case asks = dry;
  asks.flood.water_level = 4.0;
  const FloodSummary flood = after(fell, asks);
  EXPECT_EQ(flood.verdict, FloodVerdict::near) << "so far";
  EXPECT_LT(flood.residual_height, 4.0);
}

TEST(Flood, TheRiverMayBeNamed)
{
  Case c = dike_in_water();
  c.flood.river = RiverSide::right;
  EXPECT_EQ(level_of(c).value, 1.5);
  EXPECT_EQ(level_of(c).origin, "the highest free water at the right end of the section");
  c.flood.water_level = 3.5;  // what is given counts
  EXPECT_EQ(level_of(c).value, 3.5);
  EXPECT_EQ(level_of(c).origin, "flood.water_level");
  c.flood.river = RiverSide::deduced;
  EXPECT_EQ(level_of(c).river, Facing::left);
}

TEST(Flood, SoilStillMovesThatWouldGoFarInAFreeFallThroughTheReliefThoughTheRunWasShort)
{
  const auto still_moves = [](Real speed, Real time) {
    Drawn s;
    s.work.with.rest.set({speed});
    s.state.time = time;
    s.look();
    return s.flood().still_moves;
  };
  EXPECT_TRUE(still_moves(0.3, 0.3));  // 0.09 m in the time of the run; 0.27 m in that of a fall of 4 m; limit 0.1 m
  EXPECT_FALSE(still_moves(0.1, 0.3));
  EXPECT_TRUE(still_moves(0.1, 1.1));
}

TEST(Flood, ARunThatResumesRemembers)
{
  Drawn s;
  s.become([](Vec<2> p) { return Vec<2>{p[0], 0.7 * p[1]}; });
  const auto times = array_of(s.state, "followers/flood/times");
  s.state.time = 0.0;  // of its step
  Drawn other;
  other.restore(s.save());
  EXPECT_EQ(array_of(other.state, "followers/flood/times"), times);
  EXPECT_EQ(flood_clause(other.flood()), flood_clause(s.flood()));
}

}  // namespace flood_test
