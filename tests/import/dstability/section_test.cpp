// Stresses and strengths of small sections, by hand: clay of 15 / 16 kN/m3 to -6 m, water at -1 m.
#include "math/errors.hpp"
#include "sections.hpp"

namespace section_test {

const Vec<2> in_clay{10.0, -4.0};  // sigma = 15 + 3 * 16 = 63 kPa, u = 30 kPa

TEST(StixSection, WeighsSoilAboveAndBelowThePhreaticLine)
{
  const StixPlace clay = place_in(project_of({clay_on_sand()}), in_clay);
  EXPECT_DOUBLE_EQ(clay.total_stress, 63e3);
  EXPECT_DOUBLE_EQ(clay.pore_pressure, 30e3);
  EXPECT_DOUBLE_EQ(clay.effective_stress, 33e3);
  EXPECT_TRUE(clay.below_water);
  EXPECT_EQ(clay.model, StixStrengthModel::shansep);
  EXPECT_DOUBLE_EQ(clay.su, 0.25 * 33e3);  // no state: normally consolidated
  const StixPlace sand = place_in(project_of({clay_on_sand()}), {10.0, -8.0});
  EXPECT_DOUBLE_EQ(sand.total_stress, 95e3 + 40e3);
  EXPECT_NEAR(sand.cohesion, 2e3 * std::cos(std::numbers::pi / 6.0), 1e-9);
  EXPECT_TRUE(std::isnan(sand.su));
}

TEST(StixSection, IsDrainedAboveThePhreaticLine)
{
  const StixPlace crust = place_in(project_of({clay_on_sand()}), {10.0, -0.5});
  EXPECT_EQ(crust.model, StixStrengthModel::classic);
  EXPECT_EQ(crust.friction, 25.0);  // classic: no reduction
  EXPECT_EQ(crust.cohesion, 5e3);
  EXPECT_TRUE(std::isnan(crust.su));
  EXPECT_DOUBLE_EQ(crust.total_stress, 7.5e3);
}

TEST(StixSection, CarriesFreeWater)
{
  StixStage stage = clay_on_sand();
  stage.water.head_lines[0].line = {{0.0, 2.0}};
  const StixPlace clay = place_in(project_of({stage}), in_clay);
  EXPECT_DOUBLE_EQ(clay.total_stress, 20e3 + 64e3);
  EXPECT_DOUBLE_EQ(clay.pore_pressure, 60e3);
}

TEST(StixSection, CapsThePorePressureAtTheTotalStress)
{
  StixStage stage = clay_on_sand();
  stage.water.head_lines.push_back({"a", "", {{0.0, 9.0}}});
  stage.water.reference_lines = {{"top of sand", {{0.0, -6.0}}, 1, 1}};  // u = 150 kPa there, total stress 95 kPa
  const StixPlace clay = place_in(project_of({stage}), {10.0, -5.9});
  EXPECT_EQ(clay.pore_pressure, clay.total_stress);
  EXPECT_EQ(clay.effective_stress, 0.0);
  EXPECT_EQ(clay.su, 0.0);
}

TEST(StixSection, SpreadsALoadWithDepth)
{
  StixStage stage = clay_on_sand();
  stage.loads = {{.label = "road", .start = 8.0, .end = 11.0, .magnitude = 14e3, .spread = 45.0}};
  const StixProject project = project_of({stage});
  EXPECT_DOUBLE_EQ(place_in(project, in_clay).load_stress, 14e3 * 3.0 / 11.0);  // 3 m, 4 m to each side
  EXPECT_NEAR(place_in(project, {4.1, -4.0}).load_stress, 14e3 * 3.0 / 11.0, 1e-9);
  EXPECT_EQ(place_in(project, {3.9, -4.0}).load_stress, 0.0);
  EXPECT_DOUBLE_EQ(place_in(project, in_clay).pore_pressure, 30e3);  // consolidated, as no degree is given
}

/// Ground that falls by 1 in 4 from 4 m at x = 0 to -1 m at x = 20 m.
StixStage sloping_ground(Real start, Real end)
{
  StixStage stage = clay_on_sand();
  stage.layers[0].outline = {{0.0, 4.0}, {20.0, -1.0}, {20.0, -6.0}, {0.0, -6.0}};
  stage.loads = {{.label = "road", .start = start, .end = end, .magnitude = 20e3, .spread = 45.0}};
  return stage;
}

TEST(StixSection, TheDepthBelowALoadCountsFromTheMeanOfTheGroundAtItsEnds)
{
  const StixProject project = project_of({sloping_ground(4.0, 8.0)});  // 3 and 2 m
  EXPECT_DOUBLE_EQ(place_in(project, {4.0, 0.0}).load_stress, 20e3 * 4.0 / (4.0 + 2.0 * 2.5));
  EXPECT_DOUBLE_EQ(place_in(project, {8.0, 0.0}).load_stress, 20e3 * 4.0 / (4.0 + 2.0 * 2.5));
  EXPECT_DOUBLE_EQ(place_in(project, {6.0, 2.4}).load_stress, 20e3 * 4.0 / (4.0 + 2.0 * 0.1));
}

TEST(StixSection, ALoadWithAnEndBeyondTheSectionTakesTheGroundOfItsOtherEnd)
{
  const StixProject project = project_of({sloping_ground(16.0, 24.0)});  // 0 m at x = 16
  EXPECT_DOUBLE_EQ(place_in(project, {18.0, -2.0}).load_stress, 20e3 * 8.0 / (8.0 + 2.0 * 2.0));
}

TEST(StixSection, AddsTheLoadThatIsNotConsolidatedToThePorePressureBelowTheWater)
{
  StixStage stage = clay_on_sand();
  stage.loads = {{.label = "road", .start = 8.0, .end = 12.0, .magnitude = 13e3, .consolidation = {{"clay", 10.0}}}};
  const StixProject project = project_of({stage});
  EXPECT_DOUBLE_EQ(place_in(project, in_clay).pore_pressure, 30e3 + 11.7e3);
  EXPECT_EQ(place_in(project, {10.0, -0.5}).pore_pressure, 0.0);
  EXPECT_DOUBLE_EQ(place_in(project, {10.0, -8.0}).pore_pressure, 70e3);  // no degree for the sand: consolidated
}

StixStatePoint state_point(StixPreload preload)
{
  return {.id = "1", .label = "", .layer = "clay", .place = {2.0, -3.0}, .preload = preload};  // sigma' 27 kPa there
}

TEST(StixSection, TakesThePopOfAStatePointInItsWholeLayer)
{
  StixStage stage = clay_on_sand();
  stage.state_points = {state_point({.pop = {.value = 8e3}})};
  const StixPlace clay = place_in(project_of({stage}), in_clay);
  EXPECT_DOUBLE_EQ(clay.yield_stress, 41e3);
  EXPECT_NEAR(clay.su, 0.25 * 33e3 * std::pow(41.0 / 33.0, 0.8), 1e-9);
  EXPECT_DOUBLE_EQ(place_in(project_of({stage}), {10.0, -8.0}).yield_stress, 65e3);  // the sand has no state
}

TEST(StixSection, TurnsOcrAndYieldStressIntoPopAtTheStatePoint)
{
  StixStage stage = clay_on_sand();
  stage.state_points = {state_point({.kind = StixPreload::Kind::yield_stress, .yield_stress = 50e3})};
  EXPECT_DOUBLE_EQ(place_in(project_of({stage}), in_clay).yield_stress, 33e3 + 23e3);
  stage.state_points = {state_point({.kind = StixPreload::Kind::yield_stress, .yield_stress = 5e3})};
  EXPECT_DOUBLE_EQ(place_in(project_of({stage}), in_clay).yield_stress, 33e3);  // never less than zero
  stage.state_points = {state_point({.kind = StixPreload::Kind::ocr, .ocr = 2.0})};
  EXPECT_DOUBLE_EQ(place_in(project_of({stage}), in_clay).yield_stress, 33e3 + 27e3);
}

TEST(StixSection, InterpolatesPopAlongAndBetweenStateLines)
{
  StixStage stage = clay_on_sand();
  const auto value = [](Real x, Real above, Real below) {
    return StixStateLine::Value{.x = x, .above = {.pop = {.value = above}}, .below = {.pop = {.value = below}}};
  };
  stage.state_lines = {{.line = {{0.0, -5.0}}, .values = {value(0.0, 20e3, 7e3), value(20.0, 40e3, 7e3)}},
      {.line = {{0.0, -2.0}}, .values = {value(3.0, 5e3, 12e3)}}};
  const StixProject project = project_of({stage});
  const auto pop = [&](Real z) {
    const StixPlace place = place_in(project, {10.0, z});
    return place.yield_stress - place.effective_stress;
  };
  EXPECT_NEAR(pop(-1.5), 5e3, 1e-9);                         // above the first line
  EXPECT_NEAR(pop(-3.0), 12e3 + (30e3 - 12e3) / 3.0, 1e-9);  // from 12 below the first to 30 above the second
  EXPECT_NEAR(pop(-5.5), 7e3, 1e-9);                         // below the last
  StixStage with_point = stage;
  with_point.state_points = {state_point({.pop = {.value = 1e3}})};
  const StixPlace place = place_in(project_of({with_point}), {10.0, -3.0});
  EXPECT_NEAR(place.yield_stress - place.effective_stress, 1e3, 1e-9);  // a point comes before the lines
}

TEST(StixSection, RemembersTheLargestYieldStressOfAllStages)
{
  StixStage daily = clay_on_sand(), high = clay_on_sand();
  daily.state_points = {state_point({.pop = {.value = 8e3}})};
  high.water.head_lines[0].line = {{0.0, 2.0}};  // sigma' 24 kPa
  const StixPlace clay = place_in(project_of({daily, high}), in_clay);
  EXPECT_DOUBLE_EQ(clay.effective_stress, 24e3);
  EXPECT_DOUBLE_EQ(clay.yield_stress, 41e3);
  EXPECT_NEAR(clay.su, 0.25 * 24e3 * std::pow(41.0 / 24.0, 0.8), 1e-9);
}

TEST(StixSection, MakesClayUnderANewEmbankmentNormallyConsolidated)
{
  StixStage daily = clay_on_sand(), built = clay_on_sand();
  daily.state_points = {state_point({.pop = {.value = 8e3}})};
  built.layers.push_back(box_layer("new", {0.0, 0.0}, {20.0, 3.0}, 0));  // 54 kPa
  const StixPlace clay = place_in(project_of({daily, built}), in_clay);
  EXPECT_DOUBLE_EQ(clay.yield_stress, 87e3);
  EXPECT_DOUBLE_EQ(clay.effective_stress, 87e3);
  EXPECT_DOUBLE_EQ(place_in(project_of({daily, built}), {10.0, 1.0}).yield_stress, 36e3);  // no ground in stage 1
}

TEST(StixSection, RemembersTheGroundThatAnEarlierStageHad)
{
  StixStage high = clay_on_sand(), dug = clay_on_sand();
  high.layers.push_back(box_layer("old", {0.0, 0.0}, {20.0, 3.0}, 0));  // 54 kPa, over the 33 kPa of clay
  dug.excavations = {{{0.0, -2.0}, {20.0, -2.0}}};                      // 1 m of water on 2 m of clay: 10 + 32 - 30 kPa
  const StixPlace clay = place_in(project_of({high, dug}), in_clay);
  EXPECT_DOUBLE_EQ(clay.yield_stress, 87e3);
  EXPECT_DOUBLE_EQ(clay.effective_stress, 12e3);
}

TEST(StixSection, TakesDesignValuesOfStrengthAndOfPop)
{
  StixStage stage = clay_on_sand();
  stage.state_points = {
      state_point({.pop = {.value = 8e3, .mean = 15e3, .deviation = 3.5e3, .is_probabilistic = true}})};
  const StixPlace clay = place_in(project_of({stage}), in_clay, StixBasis::design);
  EXPECT_NEAR(clay.ratio, 0.225386, 5e-7);
  EXPECT_EQ(clay.exponent, 0.8);
  EXPECT_NEAR(clay.yield_stress, 43e3, 5.0);
}

TEST(StixSection, IsEmptyAboveTheGround)
{
  EXPECT_FALSE(StixSection(project_of({clay_on_sand()}), 0, 0, StixBasis::deterministic).at({10.0, 0.1}).has_value());
}

TEST(StixSection, RefusesLayersWithoutSoilOrWeight)
{
  StixProject project = project_of({clay_on_sand()});
  project.scenarios[0].stages[0].layers[1].soil.reset();
  const auto refused = [&] {
    return refusal<InputError>([&] { StixSection(project, 0, 0, StixBasis::deterministic); });
  };
  EXPECT_EQ(refused(),
      "hand.stix, scenario 1, stage 1: the layer `sand` (id sand) has no soil\n"
      "  Give it one in D-Stability.");
  project.scenarios[0].stages[0].layers[1].soil = 0;
  project.soils[0].weight_below = not_given;
  EXPECT_THAT(refused(), HasSubstr("the layer `sand` (id sand) has no weight\n  The soil `sand` has the unit weights "
                                   "18000 and nan N/m3."));
}

}  // namespace section_test
