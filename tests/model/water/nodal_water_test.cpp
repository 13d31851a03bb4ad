#include "model/water/nodal_water.hpp"
#include "support/simulations.hpp"

namespace nodal_water_test {

constexpr Real gamma_w = 10.0e3;

/// 1 m of soil in a mesh of 2 m, cells of 0.25 m, water to 1.5 m.
Case wet_box()
{
  Case c = free_box("mpm_gp", {0.0, 0.0}, {4.0, 1.0}, elastic(2e6, 0.3, 2000.0));
  c.forces.gravity = {0.0, -9.81};
  c.water.unit_weight = gamma_w;
  c.water.start.phreatic_line = {{0.0, 1.5}};
  return c;
}

/// The same over water that would lift the soil.
Case lifted_box()
{
  Case c = wet_box();
  c.water.start.head_lines = {{"aquifer", {{0.0, 9.0}}}};
  c.water.start.reference_lines = {{{{0.0, 0.6}}, "aquifer", "aquifer"}};
  return c;
}

/// Pressure at the node at a place [Pa].
Real at(const Model& model, const std::vector<Real>& values, Vec<2> x)
{
  for (Index i = 0; i < model.mesh->n_nodes(); ++i)
    if (std::hypot(model.mesh->nodes[i][0] - x[0], model.mesh->nodes[i][1] - x[1]) < 1e-9) return values[i];
  return std::nan("");
}

std::vector<Index> all_nodes(const Model& model)
{
  std::vector<Index> all(static_cast<std::size_t>(model.mesh->n_nodes()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

TEST(NodalWater, ASituationIsReachedLinearlyAndStays)
{
  Case c = wet_box();
  WaterSituation& high = c.water.situations.emplace_back();
  high.time = 4.0;
  high.phreatic_line = {{0.0, 3.5}};
  const Model model = build_model(c, 1);
  for (const auto& [time, level] :
      {std::pair(0.0, 1.5), std::pair(1.0, 2.0), std::pair(4.0, 3.5), std::pair(9.0, 3.5)}) {
    const PorePressure pore = water_at(model, time);
    EXPECT_DOUBLE_EQ(at(model, pore.pressure, {1.0, 0.5}), gamma_w * (level - 0.5)) << time;
    EXPECT_DOUBLE_EQ(at(model, pore.pressure, {1.0, 1.75}), gamma_w * std::max(level - 1.75, 0.0)) << time;
  }
  EXPECT_TRUE(water_at(model, 0.0).suction.empty());
}

TEST(NodalWater, IsCutToTheWeightOfSoilAndFreeWaterAbove)
{
  const Case c = lifted_box();
  const Model model = build_model(c, 1);
  const PorePressure pore = water_at(model, 0.0);
  EXPECT_DOUBLE_EQ(at(model, pore.pressure, {1.0, 0.5}), 2000.0 * 9.81 * 0.5 + gamma_w * 0.5);
  EXPECT_DOUBLE_EQ(at(model, pore.pressure, {1.0, 0.75}), gamma_w * 0.75);
  const CappedWater capped = model.nodal_water->find_capped(all_nodes(model));
  EXPECT_EQ(capped.n, 3 * 17);  // rows at 0, 0.25 and 0.5 m
  EXPECT_NEAR(capped.where[1], 0.5, 1e-9);
  EXPECT_DOUBLE_EQ(capped.most, gamma_w * 8.5 - 2000.0 * 9.81 * 0.5 - gamma_w * 0.5);
}

TEST(NodalWater, IsCutToTheWeightOfTheLoadsOfItsTime)
{
  Case c = lifted_box();
  c.loads = {{.name = "q", .from = 0.5, .to = 1.5, .pressure = 20e3},
      {.name = "later", .from = 0.5, .to = 1.5, .pressure = 8e3, .start = 1.0, .ramp = 1.0}};
  const Model model = build_model(c, 1);
  const Real weight = 2000.0 * 9.81 * 0.5 + gamma_w * 0.5;
  EXPECT_DOUBLE_EQ(at(model, water_at(model, 0.0).pressure, {1.0, 0.5}), weight + 20e3);
  EXPECT_DOUBLE_EQ(at(model, water_at(model, 1.5).pressure, {1.0, 0.5}), weight + 24e3);
  EXPECT_DOUBLE_EQ(at(model, water_at(model, 1.5).pressure, {2.0, 0.5}), weight);
  EXPECT_DOUBLE_EQ(model.nodal_water->find_capped(all_nodes(model)).most, gamma_w * 8.5 - weight);  // beside the load
}

TEST(NodalWater, SuctionHasItsOwnLimit)
{
  Case c = wet_box();
  c.water.start.phreatic_line = {{0.0, 0.5}};
  c.water.suction = 2.0e3;
  const Model model = build_model(c, 1);
  const PorePressure pore = water_at(model, 0.0);
  EXPECT_EQ(at(model, pore.pressure, {1.0, 0.75}), 0.0);
  EXPECT_DOUBLE_EQ(at(model, pore.suction, {1.0, 0.5}), 0.0);
  EXPECT_DOUBLE_EQ(at(model, pore.suction, {1.0, 0.75}), 2.0e3);
}

TEST(NodalWater, AFormulaOfTimeIsRenewedInEveryStep)
{
  Case c = wet_box();
  c.water.start = {};
  c.water.start.formula = [](Vec<2> x, Real t) { return 500.0 * (2.0 - x[1]) * t; };
  c.water.start.formula_changes = true;
  c.forces.gravity = {0.0, 0.0};  // no weight, and so no limit
  const Model model = build_model(c, 1);
  for (const Real time : {0.0, 0.25, 2.0}) {
    const PorePressure pore = water_at(model, time);
    EXPECT_DOUBLE_EQ(at(model, pore.pressure, {1.0, 0.5}), 750.0 * time);
  }
}

TEST(NodalWater, APointHasThePressureOfItsPlace)
{
  Simulation s(wet_box());
  const PorePressure pore = water_at(s.model, 0.0);
  for_each_point(s.state.points, [&](const PointBlock<2>& block, Index lane) {
    EXPECT_NEAR(pore_pressure_at(s.model, pore, block, lane), gamma_w * (1.5 - block.row(Rows::x + 1)[lane]), 1e-8);
  });
}

}  // namespace nodal_water_test
