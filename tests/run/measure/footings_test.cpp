#include "model/loads/footings.hpp"
#include "mpm/features/footings.hpp"
#include "mpm/features/search.hpp"
#include "support/simulations.hpp"

namespace footings_test {

struct Meter {
  Vec<2> impulse;
  Real since;
  Vec<2> reaction;
  Real largest, work;
};

Meter meter_of(const State& state)
{
  const auto v = array_of(state, "followers/footings/meters");
  return {{v.at(0), v[1]}, v[2], {v[3], v[4]}, v[5], v[6]};
}

TableRow keep_row(Simulation& s) { return rows_of(s, "footings").at(0); }

/// A free block of clay, 2 m x 1 m, that a footing of 1 m width pushes down; cells of 0.25 m.
Case pushed(const char* scheme, FootingContact contact = FootingContact::rough)
{
  Case c = free_box(scheme, {1.0, 0.5}, {3.0, 1.5});
  c.time.end = 0.5;
  FootingCase f;
  f.name = "plate";
  f.low = {1.5, 1.5}, f.high = {2.5, 2.0};
  f.velocity = {0.0, -0.2};
  f.ramp = 0.02;
  f.contact = contact;
  c.footings = {f};
  return c;
}

class FootingInEveryScheme : public TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Footings, FootingInEveryScheme, testing::Values("standard_mpm", "mpm_mixed", "mpm_gp"));

TEST_P(FootingInEveryScheme, TheReactionIsTheMomentumThatTheSoilTakes)
{
  Simulation s = followed(pushed(GetParam()));
  make_steps(s, 200);
  const Vec<2> p = momentum(s.state), impulse = meter_of(s.state).impulse;
  EXPECT_LT(p[1], -10.0);  // of 3980 kg
  EXPECT_NEAR(impulse[1], -p[1], 1e-9 * std::abs(p[1]));
  EXPECT_NEAR(impulse[0], -p[0], 1e-9 * std::abs(p[1]));
}

TEST_P(FootingInEveryScheme, ItsWorkIsAllThatBoundariesDoHere)
{
  Simulation s = followed(pushed(GetParam()));
  make_steps(s, 200);
  EXPECT_GT(meter_of(s.state).work, 1.0);
  EXPECT_NEAR(meter_of(s.state).work, s.state.work.boundary, 1e-9 * s.state.work.boundary);
}

TEST(Footings, ASmoothOneLetsTheSoilSpreadUnderIt)
{
  const auto reaction_across = [](FootingContact contact) {
    Case c = pushed("mpm_mixed", contact);
    c.footings[0].low[0] = 2.0;  // on one half: the soil under it moves to the left
    Simulation s = followed(c);
    make_steps(s, 100);
    return meter_of(s.state).impulse;
  };
  EXPECT_EQ(reaction_across(FootingContact::smooth)[0], 0.0);
  EXPECT_GT(std::abs(reaction_across(FootingContact::rough)[0]), 1e-3 * reaction_across(FootingContact::rough)[1]);
}

TEST(Footings, DampingDoesNotPushWhatAFootingHolds)
{
  Case c = pushed("mpm_mixed");
  c.footings[0].low = {0.5, 0.0}, c.footings[0].high = {3.5, 2.0};  // all soil
  c.forces.local_damping = 0.7;
  c.forces.gravity = {0.0, -9.81};
  Simulation s = followed(c);
  make_steps(s, 100);
  EXPECT_EQ(s.state.work.damping, 0.0);
  const Vec<2> p = momentum(s.state);
  EXPECT_NEAR(p[1], 1990.0 * 2.0 * s.work.with.footings->placed[0].velocity[1], 1e-6);
  EXPECT_NEAR(meter_of(s.state).impulse[1], -p[1] - 1990.0 * 2.0 * 9.81 * s.state.time,
      1e-6);  // it carries the weight: pulled down
}

TEST(Footings, ARowHoldsTheMeanSinceTheRowBefore)
{
  Simulation s = followed(pushed("mpm_gp"));
  EXPECT_EQ(keep_row(s)["reaction_y"], 0.0);
  make_steps(s, 50);
  const Real p = momentum(s.state)[1], t = s.state.time;
  TableRow row = keep_row(s);
  EXPECT_EQ(row.text, "plate");
  EXPECT_NEAR(row["reaction_y"], -p / t, 1e-9 * std::abs(p / t));
  EXPECT_EQ(row["displacement_y"], footings_of(s.model)[0].displacement(t)[1]);
  EXPECT_EQ(row["work"], meter_of(s.state).work);
  make_steps(s, 30);
  row = keep_row(s);
  EXPECT_NEAR(row["reaction_y"], -(momentum(s.state)[1] - p) / (s.state.time - t), 1e-7 * std::abs(p / t));
  EXPECT_DOUBLE_EQ(meter_of(s.state).largest, std::max(-p / t, row["reaction_y"]));
  const Summary summary = summarise(s.model, s.state);
  ASSERT_EQ(summary.footings.size(), 1u);
  EXPECT_EQ(summary.footings[0].reaction[1], row["reaction_y"]);
  EXPECT_EQ(summary.footings[0].largest, meter_of(s.state).largest);
}

TEST(Footings, SurviveInACheckpoint)
{
  Simulation s = followed(pushed("mpm_gp"));
  make_steps(s, 20);
  keep_row(s);
  make_steps(s, 5);
  const State back = restore(s.model, make_image(s.state));
  EXPECT_EQ(first_difference(make_image(s.state), make_image(back)), "");
  const Meter a = meter_of(s.state), b = meter_of(back);
  EXPECT_THAT((std::array{b.impulse[1], b.since, b.reaction[1], b.largest, b.work}),
      ElementsAre(a.impulse[1], a.since, a.reaction[1], a.largest, a.work));
  EXPECT_NE(a.impulse[1], 0.0);
}

TEST(Footings, AreAwayWhileTheSoilSettles)
{
  Simulation s = followed(pushed("mpm_gp"));
  begin_search(s.model.damping.local, s.work).share = 1.0;
  make_steps(s, 5);
  EXPECT_TRUE(s.work.with.footings->placed.empty());
  EXPECT_EQ(momentum(s.state)[1], 0.0);
}

}  // namespace footings_test
