#include "model/soils/strength_profile.hpp"
#include "run/loop/simulation.hpp"
#include "support/cases.hpp"

namespace strength_profile_test {

Case two_layers()
{
  Case c = column("mpm_gp");
  c.mesh.size = {16.0, 3.0};
  c.forces.gravity = {0.0, -9.81};
  c.water.start.phreatic_line = {{0.0, 1.0}};
  MaterialCase peat = c.materials[0];
  peat.name = "peat";
  peat.density = 1100.0;
  peat.fields = {{2, [](Vec<2> x) { return 4e3 + 1e3 * x[1]; }}};
  c.materials.push_back(peat);
  c.bodies = {body("peat", {0.0, 0.0}, {8.0, 1.0}), body("clay", {0.0, 1.0}, {8.0, 2.0})};
  return c;
}

TEST(StrengthProfile, HasARowForEachCellFromTheTopDown)
{
  const Simulation s(two_layers());
  const auto rows = strength_profile(s.model, s.state, 3.2);
  ASSERT_EQ(rows.size(), 4u) << "cells of 0.5 m";
  const Real clay = 9.81 * s.model.description.materials[0].density;
  for (const ProfileRow& row : rows) {
    const Real y = row.x[1], in_peat = std::max(1.0 - y, 0.0);
    EXPECT_NEAR(row.x[0], 3.2, 0.1);
    EXPECT_NEAR(row.depth, 2.0 - y, 1e-12);
    EXPECT_NEAR(row.pore, 9810.0 * in_peat, 1e-9);
    EXPECT_NEAR(row.stress, clay * std::min(2.0 - y, 1.0) + (9.81 * 1100.0 - 9810.0) * in_peat, 1e-8);
    EXPECT_EQ(row.material, in_peat > 0.0 ? "peat" : "clay");
    EXPECT_EQ(row.shear, 2e6);
    ASSERT_EQ(row.strengths.size(), 1u);
    EXPECT_EQ(row.strengths[0].name, "su_peak");
    EXPECT_DOUBLE_EQ(row.strengths[0].value, in_peat > 0.0 ? 4e3 + 1e3 * y : 8e3);
  }
  EXPECT_GT(rows[0].x[1], rows[1].x[1]);
  EXPECT_TRUE(strength_profile(s.model, s.state, 9.0).empty()) << "no soil there";
}

TEST(StrengthProfile, HasTheStressInTheWaterOfTheLastStageAndTheYieldStress)
{
  Case c = two_layers();
  c.materials[1].fields[0].needs.yield_stress = [](const PlaceInSoil& at) { return 30e3 - 1e3 * at.x[1]; };
  c.water.situations = {{.name = "high", .phreatic_line = {{0.0, 2.0}}}};
  StageCase stage;
  stage.name = "flood", stage.water = "high", stage.duration = 4.0;
  c.stages = {stage};
  c.stages[0].changed = std::make_shared<const Case>(c);
  c.time.end = 4.0;
  const Simulation s(c);
  for (const ProfileRow& row : strength_profile(s.model, s.state, 3.2)) {
    const Real y = row.x[1], below = std::max(1.0 - y, 0.0);
    EXPECT_NEAR(row.stress - row.last_stress, 9810.0 * (2.0 - y - below), 1e-6);
    EXPECT_EQ(std::isnan(row.yield_stress), row.material == "clay");
    if (row.material == "peat") {
      EXPECT_DOUBLE_EQ(row.yield_stress, 30e3 - 1e3 * y);
    }
  }
}

TEST(StrengthProfile, KeepsTheEndsAndTheChangesOfMaterialWhenThinned)
{
  std::vector<ProfileRow> rows(20);
  for (std::size_t k = 0; k < rows.size(); ++k)
    rows[k].x[1] = -1.0 * static_cast<Real>(k), rows[k].material = k < 7 ? "a" : "b";
  std::vector<Real> y;
  for (const ProfileRow& row : thinned(rows, 4)) y.push_back(-row.x[1]);
  EXPECT_THAT(y, ElementsAre(0, 5, 6, 7, 10, 15, 19));
}

TEST(StrengthProfile, StandsAtTheHighestGroundAndAtTheQuarters)
{
  Case c = two_layers();
  c.bodies[1] = body("clay", {2.0, 1.0}, {3.0, 2.0});
  const Simulation s(c);
  const auto lines = usual_profiles(s.model, s.state);
  ASSERT_EQ(lines.size(), 2u) << "2 m and 2.5 m are as good as one";
  EXPECT_NEAR(lines[1], 6.0, 0.1);
}

}  // namespace strength_profile_test
