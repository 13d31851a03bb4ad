#include "run/loop/state.hpp"
#include "support/simulations.hpp"

namespace state_test {

TEST(State, CountsThePointsOfTheStart)
{
  EXPECT_EQ(State{}.n_ids(), 0);
  EXPECT_EQ(Simulation(free_box("mpm_gp", {1.0, 0.5}, {1.5, 1.0})).state.n_ids(), 100);
}

TEST(State, PointsThatLeaveKeepTheirIds)
{
  Case c = free_box("mpm_gp", {3.25, 0.5}, {3.75, 1.0});
  c.bodies[0].velocity = {8.0, 0.0};  // to the side at x = 4 m
  c.sides = {side("right", SideKind::open)};
  Simulation simulation(c);
  for (int k = 0; k < 500 && simulation.state.left.empty(); ++k) simulation.step();
  ASSERT_FALSE(simulation.state.left.empty());
  EXPECT_EQ(simulation.state.n_ids(), 100);
  EXPECT_EQ(points_by_id(simulation.state).size() + simulation.state.left.size(), 100u);
}

}  // namespace state_test
