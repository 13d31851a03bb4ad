#include "model/water/carried_water.hpp"
#include "model/water/nodal_water.hpp"
#include "support/simulations.hpp"

namespace carried_water_test {

constexpr Real gamma_w = 10.0e3;

/// Boxes of elastic soil in a mesh of 16 m x 6 m, cells of 0.5 m.
Case boxes_in_water(const std::vector<std::array<Vec<2>, 2>>& boxes, std::vector<Vec<2>> phreatic_line)
{
  Case c;
  c.name = "boxes";
  c.scheme = "mpm_gp";
  c.mesh.size = {16.0, 6.0};
  c.mesh.cell = {0.5, 0.5};
  c.materials = {elastic(2e6, 0.3, 2000.0)};
  c.time.end = 1.0;
  for (const auto& [low, high] : boxes) c.bodies.push_back(body("rock", low, high));
  c.forces.gravity = {0.0, -9.81};
  c.water.unit_weight = gamma_w;
  c.water.start.phreatic_line = std::move(phreatic_line);
  return c;
}

/// Pressure at the node at a place, after the soil was seen as it was drawn, then twice where `place` puts it [Pa].
Real pressure_after(const Case& c, const std::function<Vec<2>(Vec<2>)>& place, Vec<2> node)
{
  Simulation s(c);
  look_at_soil(s.model, s.state);
  draw_points(s, place);
  for (int k = 0; k < 2; ++k) {
    if (s.state.with.water) s.state.step = s.state.with.water->next;
    look_at_soil(s.model, s.state);
  }
  const PorePressure pore = water_at(s.model, s.state);
  for (Index i = 0; i < s.model.mesh->n_nodes(); ++i)
    if (std::hypot(s.model.mesh->nodes[i][0] - node[0], s.model.mesh->nodes[i][1] - node[1]) < 1e-9)
      return pore.unlimited[static_cast<std::size_t>(i)];
  return std::nan("");
}

Vec<2> unmoved(Vec<2> x) { return x; }

/// How far points of 0.1 m that keep their size reach above soil squeezed to a part of its height [m].
Real reach(Real part) { return 0.5 * 0.1 * (1.0 - part); }

TEST(CarriedWater, SoilThatHasNotMovedHasTheWaterOfTheLines)
{
  Case c = boxes_in_water({{{{0.0, 0.0}, {16.0, 3.0}}}}, {{0.0, 4.0}, {16.0, 1.0}});
  c.sides = {side("left", SideKind::roller), side("right", SideKind::roller), side("bottom", SideKind::roller)};
  Case fixed = c;
  fixed.water.follow_soil = false;
  Simulation s(c), other(fixed);
  s.step(50), other.step(50);
  EXPECT_EQ(carried_water(s.state), nullptr);
  EXPECT_FALSE(other.state.with.water);
  EXPECT_EQ(water_at(s.model, s.state).unlimited, water_at(other.model, other.state).unlimited);
}

TEST(CarriedWater, TheTableGoesWithTheSoil)
{
  const Case c =
      boxes_in_water({{{{4.0, 0.0}, {12.0, 4.0}}}}, {{0.0, -1.0}, {4.0, -1.0}, {4.0, 3.0}, {12.0, 1.0}, {12.0, -1.0}});
  const auto slide = [](Vec<2> x) { return Vec<2>{x[0] + 2.0, x[1]}; };
  EXPECT_NEAR(pressure_after(c, unmoved, {8.0, 1.0}), gamma_w * 1.0, 1e-9);
  EXPECT_NEAR(pressure_after(c, slide, {10.0, 1.0}), gamma_w * 1.0, 0.01 * gamma_w);
  EXPECT_NEAR(pressure_after(c, slide, {8.0, 1.0}), gamma_w * 1.5, 0.01 * gamma_w);
}

TEST(CarriedWater, AWetBodyThatSettlesIsWetToItsSurface)
{
  const Case c = boxes_in_water({{{{0.0, 0.0}, {16.0, 4.0}}}}, {{0.0, 4.0}});
  const auto squeeze = [](Vec<2> x) { return Vec<2>{x[0], 0.75 * x[1]}; };
  EXPECT_NEAR(pressure_after(c, squeeze, {8.0, 1.0}), gamma_w * (2.0 + reach(0.75)), 1e-6);
}

TEST(CarriedWater, AGapOnLandIsEmptyAndOneBesideTheRiverIsFull)
{
  // The river stands on 1 m of soil at the left; the line runs through both boxes.
  const std::vector<std::array<Vec<2>, 2>> boxes{
      {{{0.0, 0.0}, {4.0, 1.0}}}, {{{4.0, 0.0}, {8.0, 4.0}}}, {{{8.0, 0.0}, {12.0, 4.0}}}};
  const Case c = boxes_in_water(boxes, {{0.0, 3.0}, {12.0, 3.0}, {12.0, -1.0}});
  const auto open_right = [](Vec<2> x) { return Vec<2>{x[0] > 8.0 ? x[0] + 2.0 : x[0], x[1]}; };
  const auto open_left = [](Vec<2> x) { return Vec<2>{x[0] > 4.0 ? x[0] + 2.0 : x[0], x[1]}; };
  EXPECT_LE(pressure_after(c, open_right, {9.0, 1.0}), 0.0);
  EXPECT_NEAR(pressure_after(c, open_left, {5.0, 1.0}), gamma_w * 2.0, 1e-6);
  Case fixed = c;
  fixed.water.follow_soil = false;
  EXPECT_NEAR(pressure_after(fixed, open_right, {9.0, 1.0}), gamma_w * 2.0, 1e-9);
}

TEST(CarriedWater, TheRiverEndsAtTheHighestGroundThatIsLeft)
{
  const Case c = boxes_in_water({{{{0.0, 0.0}, {4.0, 1.0}}}, {{{4.0, 0.0}, {8.0, 4.0}}}, {{{8.0, 0.0}, {16.0, 1.0}}}},
      {{0.0, 3.0}, {4.0, 3.0}, {8.0, 0.0}});
  // The dike has come down to 2 m, below the river at 3 m: water that would flow over it is not simulated.
  const auto lower = [](Vec<2> x) { return Vec<2>{x[0], x[0] > 4.0 && x[0] < 8.0 ? 0.5 * x[1] : x[1]}; };
  EXPECT_NEAR(pressure_after(c, lower, {2.0, 1.0}), gamma_w * 2.0, 1e-6);
  EXPECT_LE(pressure_after(c, lower, {12.0, 1.0}), 1e-6);
  // The highest ground that is left lies below what was drawn as the river: behind it there is none.
  Case wide = c;
  wide.water.start.phreatic_line = {{0.0, 3.0}, {7.0, 3.0}, {8.0, 0.0}};
  wide.bodies[1].polygon = {{4.0, 0.0}, {8.0, 0.0}, {8.0, 4.0}, {7.0, 4.0}, {4.0, 1.0}};
  const auto slid = [](Vec<2> x) { return Vec<2>{x[0], x[0] > 5.0 && x[0] < 8.0 ? 0.2 * x[1] : x[1]}; };
  EXPECT_NEAR(pressure_after(wide, slid, {4.0, 1.0}), gamma_w * 2.0, 0.01 * gamma_w);
  EXPECT_LE(pressure_after(wide, slid, {6.0, 2.5}), 0.0);
  EXPECT_NEAR(pressure_after(wide, unmoved, {5.5, 2.5}), gamma_w * 0.5, 1e-6);
}

TEST(CarriedWater, TheWeightThatCapsTheWaterIsThatOfTheSoilAsItLies)
{
  Case c = boxes_in_water({{{{0.0, 0.0}, {16.0, 2.0}}}}, {{0.0, 0.5}});
  c.water.start.head_lines = {{"aquifer", {{0.0, 9.0}}}};
  c.water.start.reference_lines = {{{{0.0, 0.25}}, "aquifer", "aquifer"}};
  const auto thin = [](Vec<2> x) { return Vec<2>{x[0], x[0] > 6.0 && x[0] < 10.0 ? 0.5 * x[1] : x[1]}; };
  const Real weight = 2000.0 * 9.81;  // of a metre [Pa]
  EXPECT_NEAR(pressure_after(c, unmoved, {8.0, 0.0}), 2.0 * weight, 1e-6);
  EXPECT_NEAR(pressure_after(c, thin, {8.0, 0.0}), weight * (1.0 + reach(0.5)), 1e-6);
}

/// A bank of weak soil that flows, wet to its surface.
Case flowing_bank()
{
  Case c = boxes_in_water({{{{0.0, 0.0}, {5.0, 4.0}}}}, {{0.0, 4.0}, {5.0, 4.0}, {5.5, 0.0}});
  c.materials = {clay({.su_peak = 3e3, .su_residual = 3e3})};
  c.bodies[0].material = c.materials[0].name;
  c.sides = {side("left", SideKind::roller), side("right", SideKind::roller), side("bottom", SideKind::roller)};
  c.time.end = 0.8;
  return c;
}

TEST(CarriedWater, HasTheSameBitsOnThreadsAndAfterACheckpoint)
{
  expect_same_bits(flowing_bank(), {2, 3}, {0.4, 0.61});
}

TEST(CarriedWater, OfAComputedFlowHasTheSameBitsToo)
{
  Case c = flowing_bank();
  c.water.start.phreatic_line.clear();
  c.water.kind = WaterKind::seepage;
  c.water.start.seepage.boundary = {{"", SectionSide::left, -1.0, 4.0, {{0.0, 3.5}}, 0.0}};
  c.materials[0].permeability = {1e-5, 1e-5};
  Simulation s(c);
  s.step(s.model.n_steps);
  ASSERT_NE(carried_water(s.state), nullptr);
  ASSERT_FALSE(s.state.with.water->last.head.empty());
  for (std::size_t i = 0; i < s.model.mesh->nodes.size(); ++i) {
    if (s.model.mesh->nodes[i][1] > 1.0) continue;
    EXPECT_GT(s.state.with.water->last.head[i], -0.6);  // half a cell below the base: no soil
    EXPECT_LT(s.state.with.water->last.head[i], 3.51);
  }
  expect_same_bits(c, {2, 3}, {0.4, 0.61});
}

}  // namespace carried_water_test
