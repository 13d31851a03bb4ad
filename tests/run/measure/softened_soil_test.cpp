#include "run/loop/follower.hpp"
#include "support/simulations.hpp"

namespace softened_soil_test {

/// Four points of 0.25 m^2.
Simulation four_points() { return followed(clamped_cell("mpm_gp")); }

Real softened(Simulation& s)
{
  for (const ActiveFollower& active : s.state.followers) active.follower->frame(s.model, s.state);
  return summarise(s.model, s.state).softened_fraction.back().second;
}

TEST(SoftenedSoil, TheSoftenedShareIsByVolumeAndHalfOfTheDrop)
{
  Simulation s = four_points();  // from 8 to 2 kPa: half of the drop is done at 5 kPa, at a strain of ln 2 / 50
  set_value(s.state, 0, Rows::state, 0.0140);
  set_value(s.state, 1, Rows::state, 0.0138);
  set_value(s.state, 0, Rows::volume, 0.15);
  EXPECT_NEAR(softened(s), 0.15 / 0.9, 1e-15);
}

TEST(SoftenedSoil, SoilThatKeepsMoreThanHalfOfItsStrengthSoftensToo)
{
  Case c = clamped_cell("mpm_gp");
  c.materials = {clay({.su_residual = 4.5e3})};  // 0.56 of the peak, as with a sensitivity of 1.8
  Simulation s = followed(c);
  set_value(s.state, 0, Rows::state, 1.0);
  EXPECT_NEAR(softened(s), 0.25, 1e-15);
}

TEST(SoftenedSoil, SoilWithoutADropNeverSoftens)
{
  Case c = clamped_cell("mpm_gp");
  c.materials = {clay({.su_residual = 8.0e3})};
  Simulation s = followed(c);
  set_value(s.state, 0, Rows::state, 1.0);
  EXPECT_EQ(softened(s), 0.0);
}

TEST(SoftenedSoil, AMaterialWithoutStrengthNeverSoftens)
{
  Simulation s = followed(free_box("mpm_gp", {1.0, 0.5}, {1.5, 1.0}, elastic(1e6, 0.3, 2000.0)));
  EXPECT_EQ(softened(s), 0.0);
  keep_ledger(s.model, s.state, s.work);
  EXPECT_EQ(flags_set(s.state, "followers/history_audit/rose"), 0);
}

}  // namespace softened_soil_test
