#include "run/report/slip_planes.hpp"
#include "run/loop/simulation.hpp"
#include "support/cases.hpp"

namespace slip_planes_test {

TEST(SlipPlanes, AreNamedWithWhatIsKnownOfThem)
{
  SlipPlaneCase plane;
  plane.name = "flood";
  EXPECT_EQ(words_of(plane), "flood");
  plane.method = "Bishop", plane.factor_of_safety = 1.0043;
  EXPECT_EQ(words_of(plane), "flood, Bishop, 1.004");
}

TEST(SlipPlanes, TheirStrengthStandsBesideThatOfTheNearestPoint)
{
  Case c = column("mpm_gp");
  const Real su = c.materials[0].parameters[2];
  MaterialCase sand = elastic(2e6, 0.3, 1900.0);
  sand.name = "sand";
  c.materials.push_back(sand);
  c.bodies = {body("sand", {0.0, 0.0}, {8.0, 1.0}), body("clay", {0.0, 1.0}, {8.0, 2.0})};
  SlipPlaneCase plane;
  plane.su = {{{2.0, 1.5}, su}, {{4.0, 1.5}, 2.0 * su}, {{4.0, 0.5}, su}};  // the last one lies in the sand
  for (const Real divided : {1.0, 1.25}) {
    c.at_strength = divided;
    const Simulation simulation(c, 1);
    const StrengthComparison beside = compare_strength(simulation.model, simulation.state, plane);
    EXPECT_EQ(beside.n, 2u);
    EXPECT_EQ(beside.n_all, 3u);
    EXPECT_NEAR(beside.mean, 0.75, 1e-12);
    EXPECT_NEAR(beside.low, 0.5, 1e-12);
    EXPECT_EQ(beside.x_low, (Vec<2>{4.0, 1.5}));
    EXPECT_NEAR(beside.high, 1.0, 1e-12);
  }
}

}  // namespace slip_planes_test
