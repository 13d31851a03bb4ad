// From a case with permeabilities to the pressure at a place.
#include "model/seepage/computed_water.hpp"
#include "model/seepage/seepage_results.hpp"
#include "model/parts/setup.hpp"
#include "model/water/water_pressure.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "support/cases.hpp"

namespace computed_water_test {

/// A dam of 10 m by 12 m: river 10 m, pond of 2 m on land 20 m wide behind it.
Case dam(Real cell = 0.5)
{
  Case c;
  c.name = "dam";
  c.scheme = "mpm_gp";
  c.mesh.size = {30.0, 13.0};
  c.mesh.cell = {cell, cell};
  c.materials = {elastic(2e6, 0.3, 2000.0)};
  c.materials[0].permeability = {1e-5, 1e-5};
  c.bodies = {body("rock", {10.0, 0.0}, {20.0, 12.0})};
  c.time.end = 1.0;
  c.forces.gravity = {0.0, -9.81};
  c.water.kind = WaterKind::seepage;
  c.water.start.seepage.river = RiverCase{SectionSide::left, 10.0};
  c.water.start.seepage.ponds = {{"polder", 20.0, 30.0, 2.0}};
  return c;
}

SharedMesh mesh_of(const Case& c) { return std::make_shared<const Mesh<2>>(build_mesh(c)); }

TEST(ComputedWater, ADamOfACaseLetsThroughWhatDupuitSays)
{
  const Case c = dam();
  const SharedMesh mesh = mesh_of(c);
  const SeepageSection section = seepage_section(c, mesh);
  const ComputedWater water = compute_water(*mesh, section, c.water.start.seepage, {.band = 0.25}, "water");
  EXPECT_THAT(names_of_parts(c.water.start.seepage), ElementsAre("seepage faces", "river", "polder"));
  EXPECT_NEAR(water.flow.outflow[1], -4.8e-5, 3e-3 * 4.8e-5);
  EXPECT_NEAR(water.flow.outflow[0] + water.flow.outflow[2], 4.8e-5, 3e-3 * 4.8e-5);
  EXPECT_GT(water.flow.outflow[0], 0.2e-5);  // above the polder water comes out of the face
}

TEST(ComputedWater, BecomesTheHeadsAndTheLineOfItsSituation)
{
  const Model model = build_model(dam(), 1);
  const WaterCase& water = model.description.water;
  EXPECT_NEAR(elevation_at(water.start.phreatic_line, 0.0), 10.0, 1e-9);  // of the free water
  EXPECT_NEAR(elevation_at(water.start.phreatic_line, 10.0), 10.0, 0.05);
  const Real inside = elevation_at(water.start.phreatic_line, 15.0);
  EXPECT_GT(inside, 6.0);
  EXPECT_LT(inside, 9.5);
  EXPECT_NEAR(water_pressure(water, water.start, {10.5, 1.0}, 0.0), 9810.0 * 8.9, 9810.0 * 0.4);
  EXPECT_EQ(water_pressure(water, water.start, {15.0, 11.0}, 0.0), 0.0);
  EXPECT_LT(unlimited_pressure(water, water.start, {15.0, 11.0}, 0.0), -1e3);  // drier than that
}

TEST(ComputedWater, IsThatOfStagesAndOfTheGroundTooWhoseStandingWaterStays)
{
  Case c = dam();
  c.water.situations = {c.water.start};
  c.water.situations[0].name = "low";
  c.water.situations[0].seepage.river->level = 8.0;
  StageCase stage;
  stage.changed = std::make_shared<const Case>(c);
  c.stages = {stage};
  c.ground_of = std::make_shared<const Case>(c);
  c.water.standing = 1;
  const Case solved = with_computed_water(c, mesh_of(c));
  const Case &of_stage = *solved.stages[0].changed, &ground = *solved.ground_of, &its_stage = *ground.stages[0].changed;
  for (const Case* of : {&solved, &of_stage, &ground, &its_stage}) {
    EXPECT_NEAR(water_pressure(of->water, of->water.start, {10.5, 1.0}, 0.0), 9810.0 * 8.9, 9810.0 * 0.4);
    EXPECT_NEAR(water_pressure(of->water, of->water.situations[0], {10.5, 1.0}, 0.0), 9810.0 * 6.9, 9810.0 * 0.4);
  }
  EXPECT_FALSE(ground.water.standing);
  EXPECT_EQ(solved.water.standing, 1u);
}

TEST(ComputedWater, EverySoilNeedsAPermeability)
{
  Case c = dam();
  c.materials[0].permeability = {};
  EXPECT_THAT(test::refusal<InputError>([&] { build_model(c, 1); }), HasSubstr("`rock` has no permeability"));
}

TEST(ComputedWater, ASideWithoutSoilIsRefused)
{
  Case c = dam();
  c.water.start.seepage.boundary = {{"", SectionSide::left, 12.5, 13.0, {{0.0, 1.0}}, 0.0}};
  EXPECT_THAT(
      test::refusal<InputError>([&] { build_model(c, 1); }), HasSubstr("no soil lies at this part of the side"));
}

/// Flow through the sand dike of free_surface_test, 6 m of water on the left.
Real flow_through(const std::vector<Polygon>& bodies)
{
  Case c = dam();
  c.mesh.size = {60.0, 8.0};
  c.water.start.seepage.ponds.clear();
  c.water.start.seepage.river = RiverCase{SectionSide::left, 6.0};
  const BodyCase like = c.bodies[0];
  c.bodies.clear();
  for (const Polygon& polygon : bodies) c.bodies.push_back(like), c.bodies.back().polygon = polygon;
  const SharedMesh mesh = mesh_of(c);
  return compute_water(*mesh, seepage_section(c, mesh), c.water.start.seepage, {.band = 0.25}, "water").flow.outflow[0];
}

TEST(ComputedWater, AHairlineGapBetweenBodiesHoldsNoRiver)
{
  const Real exact = 0.6486e-5;
  for (const Real gap : {0.0, 1e-7, 1e-5, 1e-3}) {
    const Polygon subsoil{{0.0, 0.0}, {60.0, 0.0}, {60.0, 2.0}, {0.0, 2.0}},
        dike{{13.0, 2.0 + gap}, {47.0, 2.0 + gap}, {32.0, 7.0}, {28.0, 7.0}};
    EXPECT_NEAR(flow_through({subsoil, dike}), exact, 0.01 * exact) << gap;
  }
}

TEST(ComputedWater, TheRiverStandsBelowAWallThatLeansOverIt)
{
  const auto quay = [](Real lean) {
    return flow_through({{{0.0, 0.0}, {60.0, 0.0}, {60.0, 2.0}, {40.0, 2.0}, {40.0, 7.0}, {20.0 - lean, 7.0},
        {20.0, 2.0}, {0.0, 2.0}}});
  };
  EXPECT_NEAR(quay(0.02), quay(0.0), 0.01 * quay(0.0));
  EXPECT_NEAR(quay(0.3), quay(0.0), 0.02 * quay(0.0));
}

TEST(ComputedWater, LayersWhoseBorderRunsThroughCellsAreExactAtAnyRatio)
{
  for (const Real ratio : {2.0, 5.0, 9.0, 1e5}) {
    Case c = dam(1.0);
    c.mesh.origin = {0.0, -0.5}, c.mesh.size = {4.0, 11.0};
    c.materials.push_back(c.materials[0]);
    c.materials[1].name = "clay";
    c.materials[1].permeability = {1e-5 / ratio, 1e-5 / ratio};
    c.bodies = {body("rock", {0.0, 0.0}, {4.0, 5.0}), body("clay", {0.0, 5.0}, {4.0, 8.0})};
    c.water.start.seepage = {};
    c.water.start.seepage.ponds = {{"lake", 0.0, 4.0, 9.0}};
    c.water.start.seepage.boundary = {{"base", SectionSide::bottom, 0.0, 4.0, {{0.0, 6.0}}, 0.0}};
    const SharedMesh mesh = mesh_of(c);
    const ComputedWater water =
        compute_water(*mesh, seepage_section(c, mesh), c.water.start.seepage, {.band = 0.5}, "water");
    const Real exact = 4.0 * 3.0 / (5.0 / 1e-5 + 3.0 * ratio / 1e-5);
    EXPECT_NEAR(water.flow.outflow[2], exact, 0.01 * exact) << ratio;
  }
}

TEST(ComputedWater, UpliftIsThatOfTheHeadBelowTheCoverWhereverItsBaseLiesInTheCells)
{
  // Water rises through 3 m of clay from sand with a head of 9 m: p = 9.81 (9 - 5) kPa, stress 3 x 19.62 kPa.
  for (const Real lower : {0.0, 0.5, 0.3}) {
    Case c = dam(1.0);
    c.mesh.origin = {0.0, -lower}, c.mesh.size = {6.0, 11.0};
    c.materials.push_back(c.materials[0]);
    c.materials[1].name = "clay";
    c.materials[1].permeability = {1e-8, 1e-8};
    c.bodies = {body("rock", {0.0, 0.0}, {6.0, 5.0}), body("clay", {0.0, 5.0}, {6.0, 8.0})};
    c.water.start.seepage = {};
    c.water.start.seepage.boundary = {{"base", SectionSide::bottom, 0.0, 6.0, {{0.0, 9.0}}, 0.0}};
    const Model model = build_model(c, 1);
    const SeepageSection section = seepage_section(c, model.mesh);
    for (const UpliftPlace& place : uplift_over_land(model, section, model.description.water.start)) {
      EXPECT_NEAR(place.x[1], 5.0, 1e-9) << lower;
      EXPECT_NEAR(place.factor(), 3.0 * 2000.0 * 9.81 / (9810.0 * 4.0), 0.005) << lower;
      EXPECT_NEAR(place.gradient, 1.0 / 3.0, 0.005) << lower;
    }
  }
}

TEST(ComputedWater, AnAquiferThatGoesOnHasTheHeadOfItsLeakageLength)
{
  // 10 m of sand below 2 m of clay; the first mode decays by 45.10 m, so that the end at 30 m has 2 exp(-x/45.1).
  Case c = dam(1.0);
  c.mesh.origin = {0.0, -12.0}, c.mesh.size = {30.0, 14.0};
  c.materials.push_back(c.materials[0]);
  c.materials[1].name = "clay";
  c.materials[0].permeability = {1e-4, 1e-4}, c.materials[1].permeability = {1e-6, 1e-6};
  c.bodies[0].polygon = {{0.0, -12.0}, {30.0, -12.0}, {30.0, -2.0}, {0.0, -2.0}};
  c.bodies.push_back(c.bodies[0]);
  c.bodies[1].material = "clay";
  c.bodies[1].polygon = {{0.0, -2.0}, {30.0, -2.0}, {30.0, 0.0}, {0.0, 0.0}};
  c.water.start.seepage = {};
  c.water.start.seepage.ponds = {{"polder", 0.0, 30.0, 1e-9}};
  c.water.start.seepage.boundary = {{"river", SectionSide::left, -12.0, -2.0, {{0.0, 2.0}}, 0.0},
      {"land", SectionSide::right, -12.0, -2.0, {{0.0, 0.0}}, 44.72}};
  const SharedMesh mesh = mesh_of(c);
  const ComputedWater water =
      compute_water(*mesh, seepage_section(c, mesh), c.water.start.seepage, {.band = 0.5}, "water");
  EXPECT_NEAR(*head_at(*mesh, water.flow.heads, {20.0, -7.0}), 2.0 * std::exp(-20.0 / 45.09), 5e-3);
}

}  // namespace computed_water_test
