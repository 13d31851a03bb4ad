#include "model/loads/loads.hpp"
#include "mpm/features/loads.hpp"
#include "support/simulations.hpp"

namespace loads_test {

/// A free block of elastic soil, 2 m x 1 m, with a load on a part of it; cells of 0.25 m.
Case loaded(const std::string& scheme, MethodOptions method = {})
{
  Case c = free_box(scheme, {1.0, 0.5}, {3.0, 1.5}, elastic(2e6, 0.3, 2000.0));
  c.time.end = 1.0;
  c.method.shares = method.shares;
  c.loads = {{.name = "strip", .from = 1.37, .to = 2.21, .pressure = 7e3}};
  return c;
}

struct Carried {
  Real width = 0.0, moment = 0.0;
  Index n = 0;
};

Carried carried_by(const State& state, int row)
{
  Carried sum;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const Real width = block.row(row)[lane];
    sum.width += width;
    sum.moment += width * block.row(Rows::x)[lane];
    sum.n += width > 0.0;
  });
  return sum;
}

TEST(Loads, TheSharesHaveTheSumAndTheFirstMomentOfTheStretch)
{
  const Simulation s(loaded("mpm_gp"));
  const Carried sum = carried_by(s.state, loads_of(s.model)[0].row);
  EXPECT_NEAR(sum.width, 0.84, 1e-15);
  EXPECT_NEAR(sum.moment / sum.width, 1.79, 1e-15);
  EXPECT_EQ(sum.n, 19);  // points lie 0.05 m apart: 17 within it, and one beside each end
}

TEST(Loads, OfUnequalPointsHaveThemToo)
{
  Case c = loaded("mpm_gp");
  c.bodies.push_back(c.bodies[0]);
  c.bodies[0].polygon = {{1.0, 0.5}, {2.0, 0.5}, {2.0, 1.5}, {1.0, 1.5}};
  c.bodies[1].polygon = {{2.0, 0.5}, {3.0, 0.5}, {3.0, 1.5}, {2.0, 1.5}};
  c.bodies[1].points_per_cell = {2, 2};
  const Simulation s(c);
  const Carried sum = carried_by(s.state, loads_of(s.model)[0].row);
  EXPECT_NEAR(sum.width, 0.84, 1e-15);
  EXPECT_NEAR(sum.moment / sum.width, 1.79, 1e-15);
}

class LoadInEveryScheme : public TestWithParam<std::tuple<const char*, Shares>> {};
INSTANTIATE_TEST_SUITE_P(Loads, LoadInEveryScheme,
    testing::Combine(
        testing::Values("standard_mpm", "mpm_mixed", "mpm_gp"), testing::Values(Shares::point, Shares::overlap)));

TEST_P(LoadInEveryScheme, GivesItsImpulseToTheSoilToRoundOff)
{
  Simulation s(loaded(std::get<0>(GetParam()), {.shares = std::get<1>(GetParam())}));
  make_steps(s, 100);
  const Vec<2> p = momentum(s.state);
  EXPECT_NEAR(p[1], -7e3 * 0.84 * s.state.time, 1e-12 * 7e3 * s.state.time);
  EXPECT_NEAR(p[0], 0.0, 1e-10 * std::abs(p[1]));
}

TEST_P(LoadInEveryScheme, AForceOnEachPointHasThePlaceOfThePointAndTheMiddleOfTheStep)
{
  Case c = loaded(std::get<0>(GetParam()), {.shares = std::get<1>(GetParam())});
  c.loads.clear();
  c.forces.body.at = [](Vec<2> x, Vec<2> x_initial, Real time) -> Vec<2> {
    return {3.0 * time + 5.0 * (x[0] - x_initial[0]), -9.81 * x_initial[1]};
  };
  Simulation s(c);
  Real mass = 0.0, moment = 0.0;
  for (const Point& p : points_by_id(s.state)) mass += p.mass, moment += p.mass * p.x[1];
  make_steps(s, 1);
  const Real dt = s.model.dt;
  EXPECT_NEAR(momentum(s.state)[0], mass * 3.0 * 0.5 * dt * dt, 1e-12 * mass * dt);
  EXPECT_NEAR(momentum(s.state)[1], -9.81 * moment * dt, 1e-12 * moment * dt);
  EXPECT_GT(s.state.work.outer[outer_load], 0.0);
}

TEST(Loads, FollowTheSoilThatCarriesThem)
{
  Case c = loaded("mpm_gp");
  c.bodies[0].velocity = {1.0, 0.0};
  Simulation s = followed(c);
  s.advance_to(0.3);
  const auto rows = rows_of(s, "loads");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].text, "strip");
  EXPECT_NEAR(rows[0]["x"], 1.79 + s.state.time, 0.02);  // the block begins to turn
  EXPECT_NEAR(rows[0]["force"], 7e3 * 0.84, 1e-9);
  EXPECT_NEAR(rows[0]["width"], 0.84, 1e-12);
}

TEST(Loads, OnTheSameGroundAdd)
{
  Case two = loaded("mpm_gp"), one = two;
  two.loads[0].pressure = 3e3;
  two.loads.push_back(two.loads[0]);
  two.loads[1].name = "other", two.loads[1].pressure = 4e3;
  Simulation a(two), b(one);
  make_steps(a, 50), make_steps(b, 50);
  EXPECT_NEAR(momentum(a.state)[1], momentum(b.state)[1], 1e-12 * std::abs(momentum(b.state)[1]));
}

TEST(Loads, ForATimeAreThereOnlyThen)
{
  Case c = loaded("mpm_gp");
  c.loads[0].start = 0.1, c.loads[0].end = 0.2;
  Simulation s = followed(c);
  s.advance_to(0.1 - 2.0 * s.model.dt);
  EXPECT_EQ(momentum(s.state)[1], 0.0);
  EXPECT_TRUE(rows_of(s, "loads").empty());
  s.advance_to(0.5);
  EXPECT_NEAR(momentum(s.state)[1], -7e3 * 0.84 * 0.1, 7e3 * 0.84 * 2.0 * s.model.dt);
}

TEST(Loads, TakeTheirPlaceOnTheGroundWhereItIsWhenTheyBegin)
{
  Case c = loaded("mpm_gp");
  c.bodies[0].velocity = {1.0, 0.0};
  c.loads[0].start = 0.3;
  Simulation s = followed(c);
  s.advance_to(0.3 + 2.0 * s.model.dt);
  const auto rows = rows_of(s, "loads");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_NEAR(rows[0]["x"], 1.79, 0.02);  // it moves on by 0.01 m
}

TEST(Loads, StopTheRunWhereTheGroundHasGone)
{
  Case c = loaded("mpm_gp");
  c.bodies[0].velocity = {2.0, 0.0};
  c.loads[0].start = 0.4;
  EXPECT_THAT([&] { Simulation(c).advance_to(0.5); },
      testing::ThrowsMessage<RunError>(HasSubstr("there is no ground under the load `strip`, which begins now")));
}

TEST(Loads, WithoutGroundAreRefused)
{
  Case c = loaded("mpm_gp");
  c.loads[0].to = 3.5;
  EXPECT_THAT(problems_of([&] { Simulation{c}; }),
      ElementsAre(told("load[0].from", "there is no ground under the load `strip`",
          HasSubstr("It stands on x = 1.37 to 3.5 m; from 3.1 to 3.5 m there is no soil. The soil reaches from x = "
                    "1.025 to 2.975 m.\nMove `from` and `to` onto the soil"))));
}

TEST(Loads, AddToTheOverburdenOfK0)
{
  Case c = loaded("mpm_gp");
  c.forces.gravity = {0.0, -10.0};
  c.initial.stress = InitialStress::k0;
  c.initial.k0 = 0.5;
  const Simulation s(c);
  for (const Point& p : points_by_id(s.state)) {
    const Real q = p.x[0] >= 1.37 && p.x[0] <= 2.21 ? 7e3 : 0.0;
    EXPECT_NEAR(p.sigma[1], -(2000.0 * 10.0 * (1.5 - p.x[1]) + q), 1e-6);
    EXPECT_NEAR(p.sigma[0], 0.5 * p.sigma[1], 1e-6);
  }
}

}  // namespace loads_test
