#include "run/loop/follower.hpp"
#include "support/simulations.hpp"

namespace sides_test {

/// A box that flies to the right at 10 m/s, 1 m from the side; cells of 0.25 m, points 0.025 m inside its face.
Case flying_box()
{
  Case c = free_box("mpm_gp", {2.0, 0.0}, {3.0, 1.0});
  c.bodies[0].velocity = {10.0, 0.0};
  return c;
}

std::vector<ReachedSide> run_until(Real time, Simulation& s)
{
  while (s.state.time < time) {
    make_steps(s);
    keep_ledger(s.model, s.state, s.work);
  }
  return summarise(s.model, s.state).reached_sides;
}

TEST(ReachedSides, TheFirstPointInACellAtTheSideIsNoted)
{
  Simulation s = followed(flying_box());
  EXPECT_TRUE(summarise(s.model, s.state).reached_sides.empty());  // the bottom has soil from the start
  EXPECT_TRUE(run_until(0.070, s).empty());                        // 0.75 m + 0.025 m to go
  const auto reached = run_until(0.085, s);
  ASSERT_EQ(reached.size(), 1u);
  EXPECT_EQ(reached[0].side, "right");
  EXPECT_NEAR(reached[0].time, 0.0775, 0.0775 * 0.01 + s.model.dt);
  EXPECT_EQ(run_until(0.095, s)[0].time, reached[0].time);
}

/// Ground of 0.5 m, two cells, to the right side, and a box of four cells that slides over it against that side.
std::vector<ReachedSide> after_a_slide_over_ground(SideKind kind, Real until)
{
  Case c = free_box("mpm_gp", {0.0, 0.0}, {4.0, 0.5});
  c.bodies.push_back(body(c.bodies[0].material.c_str(), {2.0, 0.5}, {3.0, 1.5}));
  c.bodies[1].velocity = {10.0, 0.0};
  c.sides.push_back(side("right", kind));
  Simulation s = followed(c);
  return run_until(until, s);
}

TEST(ReachedSides, SoilThatRisesWhereSoilLayFromTheStartIsNoted)
{
  EXPECT_TRUE(after_a_slide_over_ground(SideKind::roller, 0.070).empty());
  const auto reached = after_a_slide_over_ground(SideKind::roller, 0.085);
  ASSERT_EQ(reached.size(), 1u);
  EXPECT_EQ(reached[0].side, "right");
  EXPECT_TRUE(reached[0].rose);
  EXPECT_NEAR(reached[0].time, 0.0775, 0.0775 * 0.05);
  EXPECT_TRUE(after_a_slide_over_ground(SideKind::contact_bilateral, 0.085).empty());  // a wall of the problem
}

TEST(ReachedSides, SoilThatHeavesByACellIsNotToldNorIsWhatSpreadsAlongTheBottom)
{
  Case c = free_box("mpm_gp", {0.0, 0.0}, {4.0, 0.5});
  c.bodies.push_back(
      body(c.bodies[0].material.c_str(), {2.75, 0.5}, {3.75, 0.75}));  // one cell high, beside the last one
  c.bodies[1].velocity = {10.0, 0.0};
  Simulation s = followed(c);
  EXPECT_TRUE(run_until(0.005, s).empty());
  Index last = 0;
  for (const Point& p : points_by_id(s.state))
    if (p.x[0] > 3.75 && p.x[1] > 0.5) ++last;
  EXPECT_GT(last, 0);  // and soil is there
}

TEST(ReachedSides, AnOpenSideIsNone)
{
  Case c = flying_box();
  c.sides.push_back(side("right", SideKind::open));
  Simulation s = followed(c);
  EXPECT_TRUE(run_until(0.085, s).empty());
}

TEST(ReachedSides, AreKeptInCheckpoints)
{
  Simulation s = followed(flying_box());
  run_until(0.085, s);
  const State back = restore(s.model, make_image(s.state));
  ASSERT_EQ(summarise(s.model, back).reached_sides.size(), 1u);
  EXPECT_EQ(summarise(s.model, back).reached_sides[0].time, summarise(s.model, s.state).reached_sides[0].time);
}

}  // namespace sides_test
