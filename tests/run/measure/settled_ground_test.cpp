#include "run/measure/settled_ground.hpp"
#include "mpm/step/stage.hpp"
#include "run/measure/flood_dike.hpp"

#include <limits>

namespace settled_ground_test {

constexpr GroundLeft resolution{0.006, 0.02, 1.0};

/// The look, counted from 1, at which ground with these heights has settled; 0: at none.
int settles_at(const std::vector<Real>& heights)
{
  SettledGround ground;
  for (std::size_t k = 0; k < heights.size(); ++k)
    if (ground.enter({heights[k], 0.0, 100.0}, resolution)) return static_cast<int>(k) + 1;
  return 0;
}

TEST(SettledGround, SettlesOnceAWholeSwingPassesWithoutAChange)
{
  ASSERT_EQ(RestMarks::n, 4) << "the series below have five looks in a swing, its ends included";
  EXPECT_EQ(settles_at({3.6, 3.6, 3.6, 3.6}), 0) << "three quarters of a swing";
  EXPECT_EQ(settles_at({3.6, 3.6, 3.6, 3.6, 3.6}), 5);
  EXPECT_EQ(settles_at({5.0, 4.2, 3.7, 3.604, 3.602, 3.6, 3.6, 3.6, 3.6}), 8) << "from 3.604 m on";
  EXPECT_EQ(settles_at({5.0, 4.2, 3.7, 3.61, 3.602, 3.6, 3.6, 3.6, 3.6}), 9) << "from 3.602 m on";
}

TEST(SettledGround, DoesNotSettleInAPauseThatIsShorterThanASwing)
{
  std::vector<Real> steps;
  for (int step = 0; step < 6; ++step)
    for (int look = 0; look < 4; ++look) steps.push_back(4.0 - 0.1 * step);
  EXPECT_EQ(settles_at(steps), 0);
  steps.push_back(steps.back());  // the last pause is a swing
  EXPECT_EQ(settles_at(steps), static_cast<int>(steps.size()));
}

TEST(SettledGround, DoesNotSettleWhileItCreepsByMoreThanItsResolutionInASwing)
{
  std::vector<Real> slow, fast;
  for (int look = 0; look < 40; ++look) slow.push_back(4.0 - 0.0014 * look), fast.push_back(4.0 - 0.0016 * look);
  EXPECT_EQ(settles_at(slow), 5);
  EXPECT_EQ(settles_at(fast), 0);
}

TEST(SettledGround, SeesAHeightThatComesBackWithinASwing)
{
  EXPECT_EQ(settles_at({3.6, 3.6, 3.5, 3.6, 3.6}), 0);
  EXPECT_EQ(settles_at({3.6, 3.6, 3.5, 3.6, 3.6, 3.6, 3.6}), 0);
  EXPECT_EQ(settles_at({3.6, 3.6, 3.5, 3.6, 3.6, 3.6, 3.6, 3.6}), 8);
}

TEST(SettledGround, WaitsForWidthAndVolumeToo)
{
  for (Real GroundLeft::*number : {&GroundLeft::width, &GroundLeft::moved}) {
    SettledGround ground;
    GroundLeft left{3.6, 2.0, 100.0};
    for (int look = 0; look < 20; ++look) {
      left.*number += 0.3 * resolution.*number;
      EXPECT_FALSE(ground.enter(left, resolution)) << look;
    }
  }
}

TEST(SettledGround, OfWhichNothingIsLeftHasSettled)
{
  constexpr Real none = -std::numeric_limits<Real>::infinity();
  EXPECT_EQ(settles_at({none, none, none, none, none}), 5);
  EXPECT_EQ(settles_at({3.0, none, none, none, none}), 0);
}

TEST(SettledGround, GoesOnFromWhatASavedRunHadSeen)
{
  SettledGround ground, resumed;
  for (int look = 0; look < 4; ++look) ground.enter({3.6, 1.0, 50.0}, resolution);
  resumed.set_values(ground.values());
  EXPECT_TRUE(resumed.enter({3.6, 1.0, 50.0}, resolution));
  EXPECT_FALSE(SettledGround().enter({3.6, 1.0, 50.0}, resolution));
}

TEST(SettledGround, IsKnownOnSmallerCellsMoreClosely)
{
  const GroundLeft coarse = resolution_of({3.6, 0.0, 270.0}, 1.0), fine = resolution_of({3.6, 0.0, 270.0}, 0.5);
  EXPECT_NEAR(fine.height, 0.006, 1e-12);
  EXPECT_NEAR(coarse.height, 0.012, 1e-12);
  EXPECT_NEAR(fine.moved, 2.7, 1e-12);
  EXPECT_NEAR(resolution_of({3.6, 0.0, 0.0}, 0.5).moved, 0.25, 1e-12) << "a cell at least";
}

/// The dike of flood_dike.hpp, whose soil is weak: it comes down below the water.
Case failing()
{
  Case c = dike();
  c.materials[0].parameters = clay({.su_peak = 12e3, .su_residual = 6e3}).parameters;
  c.flood.given = true;
  c.forces.local_damping = 0.1;
  c.mesh.size = {40.0, 8.0};
  for (BodyCase& soil : c.bodies) soil.points_per_cell = {2, 2};
  c.initial.stress = InitialStress::k0;
  c.initial.k0 = 0.6;
  c.output.ledger_every = 0.05;
  c.time.until = Until::verdict;
  c.time.end = c.time.at_most = 20.0;
  return c;
}

TEST(Verdict, EndsARunThatFloodsOnceWhatIsLeftHasSettled)
{
  Simulation early(failing(), 1, all_followers());
  early.run();
  ASSERT_EQ(early.state.stages_done.size(), 1u);
  const StageRecord& record = early.state.stages_done[0];
  const FloodSummary known = *summarise(early.model, early.state).flood;
  EXPECT_EQ(known.verdict, FloodVerdict::floods);
  EXPECT_FALSE(known.still_moves);
  EXPECT_GE(record.known_for, 0.5);
  EXPECT_LT(record.end, 15.0);
  EXPECT_GT(record.end, *known.first_time_below + record.known_for) << "it waits for a swing";
  Case to_end = failing();
  to_end.time.until = Until::end;
  Simulation late(to_end, 1, all_followers());
  late.run();
  const Summary a = summarise(early.model, early.state), b = summarise(late.model, late.state);
  const Real cell = 0.5;
  const GroundLeft error = resolution_of({b.flood->residual_height, b.flood->width_at_level, b.moved_volume}, cell);
  EXPECT_EQ(known.verdict, b.flood->verdict);
  EXPECT_EQ(known.first_time_below, b.flood->first_time_below);
  EXPECT_NEAR(known.residual_height, b.flood->residual_height, error.height);
  EXPECT_NEAR(known.width_at_level, b.flood->width_at_level, error.width);
  EXPECT_NEAR(a.moved_volume, b.moved_volume, error.moved);
}

TEST(Verdict, EndsARunWhoseGroundHoldsOnceHardlyAnyOfItMoves)
{
  Case c = failing();
  c.materials[0].parameters = clay({.su_peak = 60e3, .su_residual = 60e3}).parameters;
  Simulation s(c, 1, all_followers());
  s.run();
  ASSERT_EQ(s.state.stages_done.size(), 1u);
  EXPECT_TRUE(s.state.stages_done[0].at_rest);
  EXPECT_GE(s.state.stages_done[0].known_for, 0.5);
  EXPECT_LT(s.state.time, 15.0);
  EXPECT_NE(summarise(s.model, s.state).flood->verdict, FloodVerdict::moving);
  EXPECT_THAT(why_known(s.state.stages_done[0]), StartsWith("the answer is known: hardly any ground moved for "));
}

TEST(Verdict, IsNotKnownWhileSomethingIsStillToChange)
{
  Case c = failing();
  c.materials[0].parameters = clay({.su_peak = 60e3, .su_residual = 60e3}).parameters;
  c.loads = {{.name = "late", .from = 19.0, .to = 21.0, .pressure = 1e3, .start = 8.0, .ramp = 1.0}};
  Simulation s(c, 1, all_followers());
  s.run();
  EXPECT_GT(s.state.time, 9.0);
}

TEST(Verdict, EndsInTheSameBitsAfterACheckpoint)
{
  Case c = failing();
  Simulation once(c, 1, all_followers());
  once.run();
  const Real end = once.state.time;
  for (const Real time : {0.3, end - 0.4, end - 0.1}) {
    Simulation first(c, 1, all_followers()), second(c, 1, all_followers());
    first.run(never_stop, time);
    second.restore(first.save());
    second.run();
    EXPECT_EQ(first_difference(once.save(), second.save()), "") << time;
  }
}

}  // namespace settled_ground_test
