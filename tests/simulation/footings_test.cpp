// What a footing meets: momentum and energy that it gives, the rows it leaves, and who warns of it.
#include "simulation/footings.hpp"

#include "simulation/ledger.hpp"
#include "simulation/run.hpp"
#include "simulation/setup.hpp"
#include "simulation/setup_warnings.hpp"
#include "simulation/state_image.hpp"
#include "support/cases.hpp"
#include "support/simulations.hpp"

#include <cmath>

#include <gmock/gmock.h>

namespace terp {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A free block of clay, 2 m x 1 m, that a footing of 1 m width pushes down; cells of 0.25 m.
Case pushed(const char* scheme, FootingContact contact = FootingContact::rough)
{
  Case c = test::free_box(scheme, {1.0, 0.5}, {3.0, 1.5});
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

class FootingInEveryScheme : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Footings, FootingInEveryScheme, testing::Values("standard_mpm", "mpm_mixed", "mpm_gp"));

TEST_P(FootingInEveryScheme, TheReactionIsTheMomentumThatTheSoilTakes)
{
  Simulation s(pushed(GetParam()));
  test::make_steps(s, 200);
  const Vec<2> p = test::momentum(s.state), impulse = s.state.footings[0].impulse;
  EXPECT_LT(p[1], -10.0);  // of 3980 kg
  EXPECT_NEAR(impulse[1], -p[1], 1e-9 * std::abs(p[1]));
  EXPECT_NEAR(impulse[0], -p[0], 1e-9 * std::abs(p[1]));
}

TEST_P(FootingInEveryScheme, ItsWorkIsAllThatBoundariesDoHere)
{
  Simulation s(pushed(GetParam()));
  test::make_steps(s, 200);
  EXPECT_GT(s.state.footings[0].work, 1.0);
  EXPECT_NEAR(s.state.footings[0].work, s.state.work.boundary, 1e-9 * s.state.work.boundary);
}

TEST(Footings, ASmoothOneLetsTheSoilSpreadUnderIt)
{
  const auto reaction_across = [](FootingContact contact) {
    Case c = pushed("mpm_mixed", contact);
    c.footings[0].low[0] = 2.0;  // on one half: the soil under it moves to the left
    Simulation s(c);
    test::make_steps(s, 100);
    return s.state.footings[0].impulse;
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
  Simulation s(c);
  test::make_steps(s, 100);
  EXPECT_EQ(s.state.work.damping, 0.0);
  const Vec<2> p = test::momentum(s.state);
  EXPECT_NEAR(p[1], 1990.0 * 2.0 * s.work.footings[0].velocity[1], 1e-6);
  EXPECT_NEAR(s.state.footings[0].impulse[1], -p[1] - 1990.0 * 2.0 * 9.81 * s.state.time,
      1e-6);  // it carries the weight: pulled down
}

TEST(Footings, ARowHoldsTheMeanSinceTheRowBefore)
{
  Simulation s(pushed("mpm_gp"));
  EXPECT_EQ(keep_footings(s.model, s.state)[0]["reaction_y"], 0.0);
  test::make_steps(s, 50);
  const Real p = test::momentum(s.state)[1], t = s.state.time;
  TableRow row = keep_footings(s.model, s.state).at(0);
  EXPECT_EQ(row.text, "plate");
  EXPECT_NEAR(row["reaction_y"], -p / t, 1e-9 * std::abs(p / t));
  EXPECT_EQ(row["displacement_y"], s.model.footings[0].displacement(t)[1]);
  EXPECT_EQ(row["work"], s.state.footings[0].work);
  test::make_steps(s, 30);
  row = keep_footings(s.model, s.state).at(0);
  EXPECT_NEAR(row["reaction_y"], -(test::momentum(s.state)[1] - p) / (s.state.time - t), 1e-7 * std::abs(p / t));
  EXPECT_DOUBLE_EQ(s.state.footings[0].largest, std::max(-p / t, row["reaction_y"]));
  const Summary summary = summarise(s.model, s.state);
  ASSERT_EQ(summary.footings.size(), 1u);
  EXPECT_EQ(summary.footings[0].reaction[1], row["reaction_y"]);
  EXPECT_EQ(summary.footings[0].largest, s.state.footings[0].largest);
}

TEST(Footings, SurviveInACheckpoint)
{
  Simulation s(pushed("mpm_gp"));
  start_audit(s.model, s.state);  // sizes what a checkpoint holds
  test::make_steps(s, 20);
  keep_footings(s.model, s.state);
  test::make_steps(s, 5);
  const State back = restore(s.model, make_image(s.state));
  EXPECT_EQ(test::first_difference(make_image(s.state), make_image(back)), "");
  const FootingMeter &a = s.state.footings[0], &b = back.footings.at(0);
  EXPECT_THAT((std::array{b.impulse[1], b.since, b.reaction[1], b.largest, b.work}),
      ElementsAre(a.impulse[1], a.since, a.reaction[1], a.largest, a.work));
  EXPECT_NE(a.impulse[1], 0.0);
}

TEST(Footings, GiveTheSameBitsOnAnyNumberOfThreads)
{
  const auto meter = [](int threads) {
    Case c = pushed("mpm_gp");
    c.mesh.cell = {0.1, 0.1};
    Simulation s(c, threads);
    test::make_steps(s, 60);
    return s.state.footings[0].impulse;
  };
  EXPECT_EQ(meter(1), meter(3));
}

TEST(Footings, AreAwayWhileTheSoilSettles)
{
  Simulation s(pushed("mpm_gp"));
  s.work.settling = true;
  test::make_steps(s, 5);
  EXPECT_TRUE(s.work.footings.empty());
  EXPECT_EQ(test::momentum(s.state)[1], 0.0);
}

std::string warnings_of(const Case& c)
{
  Model model = build_model(c, 1);
  const State state = build_state(model);
  std::string text;
  for (const Problem& p : find_warnings(model, state)) text += p.key + ": " + p.what + "\n" + p.detail + "\n";
  return text;
}

TEST(Footings, OneThatTouchesNoSoilIsToldOf)
{
  Case c = pushed("mpm_gp");
  EXPECT_EQ(warnings_of(c), "");
  c.footings[0].low[1] = 1.6;
  EXPECT_THAT(warnings_of(c), HasSubstr("footing[0].box: the footing `plate` touches no soil\nNo node of a cell with "
                                        "soil lies in its box at t = 0."));
}

TEST(Footings, OneThatMovesOutOfWhatItHoldsIsToldOf)
{
  Case c = pushed("mpm_gp");
  c.time.end = 4.0;
  EXPECT_THAT(warnings_of(c), HasSubstr("footing[0].box: the footing `plate` moves out of the soil that it holds\nIt "
                                        "comes 0.798 m far; the nodes at its "
                                        "front leave it at its back after 0.5 m. Make the box larger."));
}

}  // namespace
}  // namespace terp
