#include "model/soils/overburden.hpp"
#include "support/simulations.hpp"

namespace overburden_test {

constexpr Real g = 9.81, gamma_w = 10.0e3;

/// 1 m of rock (2000 kg/m^3) under 0.5 m of a soil of 1700 kg/m^3 below the phreatic line, 1500 above it.
Case two_layers()
{
  Case c = free_box("mpm_gp", {0.0, 0.0}, {4.0, 1.0}, elastic(2e6, 0.3, 2000.0));
  for (const auto& [zone, density] : {std::pair(Zone::below, 1700.0), std::pair(Zone::above, 1500.0)}) {
    MaterialCase soil = elastic(2e6, 0.3, density);
    soil.name = zone == Zone::below ? "soil below" : "soil above";
    soil.soil = "soil";
    soil.zone = zone;
    c.materials.push_back(soil);
  }
  c.bodies.push_back(body("soil", {0.0, 1.0}, {4.0, 1.5}));
  c.forces.gravity = {0.0, -g};
  c.water.unit_weight = gamma_w;
  c.water.start.phreatic_line = {{0.0, 1.25}, {4.0, 1.25}};
  return c;
}

TEST(Overburden, WithoutWaterIsTheWeightOfTheSoilAbove)
{
  Case c = free_box("mpm_gp", {0.0, 0.0}, {4.0, 1.0}, elastic(2e6, 0.3, 2000.0));
  c.forces.gravity = {0.0, -g};
  const Model model = build_model(c, 1);
  const Overburden overburden(model);
  EXPECT_TRUE(overburden.is_known());
  EXPECT_DOUBLE_EQ(overburden.effective({1.0, 0.25}, c.water.start), 2000.0 * g * 0.75);
  EXPECT_EQ(overburden.ground(1.0), 1.0);
  EXPECT_EQ(overburden.ground(5.0), std::nullopt);
}

TEST(Overburden, TakesTheDensityBelowAndAboveThePhreaticLine)
{
  const Case c = two_layers();
  const Model model = build_model(c, 1);
  const Overburden overburden(model);
  const Real soil = g * (1500.0 * 0.25 + 1700.0 * 0.25 + 2000.0 * 0.5);
  EXPECT_DOUBLE_EQ(overburden.total({1.0, 0.5}, c.water.start), soil);
  EXPECT_DOUBLE_EQ(overburden.pore_pressure({1.0, 0.5}, c.water.start), gamma_w * 0.75);
  EXPECT_DOUBLE_EQ(overburden.effective({1.0, 0.5}, c.water.start), soil - gamma_w * 0.75);
  EXPECT_EQ(overburden.pore_pressure({1.0, 1.4}, c.water.start), 0.0);
}

TEST(Overburden, CarriesTheFreeWaterOfAnySituation)
{
  Case c = two_layers();
  WaterSituation& high = c.water.situations.emplace_back();
  high.phreatic_line = {{0.0, 3.5}};
  const Model model = build_model(c, 1);
  const Overburden overburden(model);
  const Real soil = g * (1500.0 * 0.25 + 1700.0 * 0.25 + 2000.0 * 0.5);  // densities are those of the start
  EXPECT_DOUBLE_EQ(overburden.total({1.0, 0.5}, high), soil + gamma_w * 2.0);
  EXPECT_DOUBLE_EQ(overburden.effective({1.0, 0.5}, high), soil + gamma_w * 2.0 - gamma_w * 3.0);
  EXPECT_DOUBLE_EQ(overburden.total({1.0, 2.0}, high), gamma_w * 1.5);  // in the free water
  EXPECT_DOUBLE_EQ(overburden.effective({1.0, 2.0}, high), 0.0);
}

TEST(Overburden, CutsThePorePressureToTheWeightAbove)
{
  Case c = two_layers();
  c.water.start.head_lines = {{"aquifer", {{0.0, 6.0}}}};
  c.water.start.reference_lines = {{{{0.0, 0.75}}, "aquifer", "aquifer"}};
  const Model model = build_model(c, 1);
  const Overburden overburden(model);
  const Real total = overburden.total({1.0, 0.5}, c.water.start);
  EXPECT_LT(total, gamma_w * 5.5);
  EXPECT_DOUBLE_EQ(overburden.pore_pressure({1.0, 0.5}, c.water.start), total);
  EXPECT_EQ(overburden.effective({1.0, 0.5}, c.water.start), 0.0);
}

TEST(Overburden, CarriesTheLoadsOfTheStartWhereTheyStand)
{
  Case c = two_layers();
  WaterSituation& artesian = c.water.situations.emplace_back();
  artesian.phreatic_line = {{0.0, 9.0}};
  c.loads = {{.name = "q", .from = 0.0, .to = 2.0, .pressure = 30e3},
      {.name = "later", .from = 0.0, .to = 4.0, .pressure = 90e3, .start = 1.0}};
  const Model model = build_model(c, 1);
  const Overburden overburden(model);
  const Real soil = g * (1500.0 * 0.25 + 1700.0 * 0.25 + 2000.0 * 0.5);
  EXPECT_DOUBLE_EQ(overburden.total({1.0, 0.5}, c.water.start), soil + 30e3);
  EXPECT_DOUBLE_EQ(overburden.total({3.0, 0.5}, c.water.start), soil);
  EXPECT_DOUBLE_EQ(overburden.effective({1.0, 0.5}, c.water.start), soil + 30e3 - gamma_w * 0.75);
  EXPECT_DOUBLE_EQ(overburden.total({1.0, 2.0}, c.water.start), 0.0);  // above the ground
  EXPECT_DOUBLE_EQ(Overburden(model, 2.0).total({1.0, 0.5}, c.water.start), soil / g * 2.0 + 30e3);
}

}  // namespace overburden_test
