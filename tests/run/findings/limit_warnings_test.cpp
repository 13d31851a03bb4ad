#include "run/findings/limit_warnings.hpp"
#include "support/simulations.hpp"

namespace limit_warnings_test {

std::vector<Problem> limits_of(const Case& c) { return warnings_from(find_known_limits, c); }

/// Firm soil of 4 m by 1 m on cells of 0.25 m, on it a cover of softer clay; gravity pulls along both.
Case covered(Real thickness)
{
  Case c = free_box("mpm_gp", {0.0, 0.0}, {4.0, 1.0}, elastic(2e6, 0.3, 2000.0));
  c.mesh.size = {4.0, 4.0};
  c.forces.gravity = {3.0, -9.0};
  c.materials.push_back(clay({.su_residual = 8e3}));
  c.bodies.push_back(body("clay", {0.0, 1.0}, {4.0, 1.0 + thickness}));
  return c;
}

TEST(LimitWarnings, ACoverOfFewCellsIsTold)
{
  EXPECT_THAT(limits_of(covered(0.5)),
      ElementsAre(told("material.\"clay\"", "`clay` is a cover on stronger soil, 0.5 m thick on cells of 0.25 m",
          "Such a cover slides too slowly, or not at all: two cells "
          "take some 1.5 times its strength. Give cells of at most 0.062 m.\n"
          "More: docs/limits.md#4-a-mesh-carries-more-than-the-soil")));
  Case level = covered(0.5);
  level.forces.gravity = {0.0, -9.0};
  EXPECT_THAT(limits_of(level), IsEmpty());
  Case fine = covered(0.5);
  fine.mesh.cell = {0.0625, 0.0625};
  EXPECT_THAT(limits_of(fine), IsEmpty());
}

TEST(LimitWarnings, ALayerOfLessThanTwoCellsIsTold)
{
  const auto between = [](Real thickness) {
    Case c = covered(thickness);
    c.forces.gravity = {0.0, -9.0};
    c.bodies.push_back(body("rock", {0.0, 1.0 + thickness}, {4.0, 2.0 + thickness}));
    return limits_of(c);
  };
  EXPECT_THAT(between(0.375),
      ElementsAre(told("material.\"clay\"", "`clay` is a layer in stronger soil, 0.38 m thick on cells of 0.25 m",
          HasSubstr("Slip along it takes more than its strength"))));
  EXPECT_THAT(between(0.5), IsEmpty());
}

TEST(LimitWarnings, TwoPointsAlongACellAreFewForSoilThatFlows)
{
  Case c = column("mpm_gp");
  EXPECT_THAT(limits_of(c), IsEmpty());
  c.bodies[0].points_per_cell = {4, 2};
  EXPECT_THAT(
      limits_of(c), ElementsAre(told("body[0].points_per_cell", "body 0 has few points per cell for soil that flows",
                        "Got 4 x 2. Where it flows far, points leave gaps in their cells, and it comes farther than "
                        "with more. Give 3 "
                        "or 4.\nMore: docs/limits.md#12-few-points-per-cell")));
  c.materials[0] = clay({.su_residual = 8e3});  // does not soften
  EXPECT_THAT(limits_of(c), IsEmpty());
  c.materials[0] = {
      "clay", "newtonian_fluid", 1000.0, find_material("newtonian_fluid")->complete(std::vector<Real>{2e6, 1.0})};
  EXPECT_EQ(limits_of(c).size(), 1u);
}

TEST(LimitWarnings, AFootingOfFewCellsIsTold)
{
  Case c = column("mpm_gp");
  c.footings = {{.name = "plate", .low = {2.0, 2.0}, .high = {4.0, 2.5}, .velocity = {0.0, -0.01}}};
  EXPECT_THAT(limits_of(c), ElementsAre(told("footing[0].box", "the footing `plate` is 4 cells wide",
                                "Its load comes out some 25 % too large. Give cells of at most 0.25 m below it.\n"
                                "More: docs/limits.md#8-sides-contact-and-footings")));
  c.mesh.cell = {0.25, 0.25};
  EXPECT_THAT(limits_of(c), IsEmpty());
  c.mesh.cell = {0.5, 0.5};
  c.footings[0].low[0] = 0.0;  // at the left side: one half of 8 m
  EXPECT_THAT(limits_of(c), IsEmpty());
  c.footings[0].low[0] = 2.0, c.footings[0].velocity = {0.01, 0.0};  // drags
  EXPECT_THAT(limits_of(c), IsEmpty());
}

}  // namespace limit_warnings_test
