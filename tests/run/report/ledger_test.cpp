#include "support/simulations.hpp"

namespace ledger_test {

constexpr Real shear = 2.0e6, bulk = 2.0 * 2.0e6 * 1.48 / (3.0 * 0.04);  // of the clay [Pa]

/// Four points of 0.25 m^2.
Simulation books() { return followed(clamped_cell("mpm_gp")); }

TEST(Ledger, EnergiesMassAndMomentumAreSumsOverThePoints)
{
  Simulation s = books();
  set_value(s.state, 0, Rows::v, 3.0);
  set_value(s.state, 1, Rows::v + 1, -2.0);
  set_value(s.state, 2, Rows::sigma + 3, 5000.0);
  for (int k = 0; k < 3; ++k) set_value(s.state, 3, Rows::sigma + k, -6000.0);
  const TableRow row = keep_ledger(s.model, s.state, s.work);
  const Real mass = 1990.0 * 0.25;
  EXPECT_NEAR(row["mass"], 4.0 * mass, 1e-9);
  EXPECT_NEAR(row["momentum_x"], 3.0 * mass, 1e-9);
  EXPECT_NEAR(row["momentum_y"], -2.0 * mass, 1e-9);
  EXPECT_NEAR(row["kinetic"], 0.5 * mass * (9.0 + 4.0), 1e-9);
  EXPECT_NEAR(row["elastic"], 0.25 * (5000.0 * 5000.0 / (2.0 * shear) + 6000.0 * 6000.0 / (2.0 * bulk)), 1e-12);
  EXPECT_EQ(row["v_max"], 3.0);
  EXPECT_NEAR(kinetic_and_stored_energy(s.model, s.state), row["kinetic"] + row["elastic"], 1e-9);
}

TEST(Ledger, AFluidStoresPressureAndNoShear)
{
  const auto fluid = find_material("newtonian_fluid")->make(std::vector<Real>{2e6, 50.0, 0.0});
  EXPECT_NEAR(elastic_energy(fluid->moduli(), {-3000.0, -3000.0, -3000.0, 40.0}, 0.5),
      0.5 * 3000.0 * 3000.0 / (2.0 * 2e6), 1e-12);
}

TEST(Ledger, TheDifferenceOfTheBooksIsWhatWorksDoNotExplain)
{
  Simulation s = books();
  set_value(s.state, 0, Rows::v, 3.0);
  s.state.start_energy = 100.0;
  s.state.work = {.gravity = 700.0, .damping = -30.0, .boundary = -4.0, .clamps = 2.0, .plastic = 55.0, .slip = 7.0};
  const TableRow row = keep_ledger(s.model, s.state, s.work);
  EXPECT_NEAR(
      row["numerical"], row["kinetic"] + row["elastic"] + 55.0 + 7.0 - 100.0 - (700.0 - 30.0 - 4.0 + 2.0), 1e-9);
  EXPECT_EQ(row["gravity_work"], 700.0);
  EXPECT_EQ(row["damping_work"], -30.0);
  EXPECT_EQ(row["boundary_work"], -4.0);
  EXPECT_EQ(row["clamp_work"], 2.0);
  EXPECT_EQ(row["plastic"], 55.0);
  EXPECT_EQ(row["slip_work"], 7.0);
}

// Both of them follow from the points alone: elastic soil has begun the step with the stress of its end less C d_eps.
TEST(Ledger, TransferAndPressureResetAreThoseOfThePoints)
{
  for (const char* scheme : {"standard_mpm", "mpm_mixed", "mpm_gp"})
    for (const Shares shares : {Shares::point, Shares::overlap}) {
      Case c = column(scheme, 0.5);
      c.materials[0] = elastic(shear, 0.3, 1990.0);
      c.bodies[0].material = c.materials[0].name;
      c.method.shares = shares;
      Simulation s(c);
      make_steps(s, 40);
      const Real K = s.model.materials[0].law->bulk_modulus();
      const WorkTotals w = s.state.work;
      const auto before = points_by_id(s.state);
      make_steps(s, 1);
      const auto after = points_by_id(s.state);
      Real taken = 0.0, reset = 0.0;
      for (std::size_t p = 0; p < after.size(); ++p) {
        std::array<Real, 4> d_eps, start;
        for (std::size_t k = 0; k < 4; ++k) d_eps[k] = after[p].strain[k] - before[p].strain[k];
        const Real volumetric = d_eps[0] + d_eps[1] + d_eps[2];
        const auto mean = [](const std::array<Real, 4>& a) { return (a[0] + a[1] + a[2]) / 3.0; };
        for (std::size_t k = 0; k < 4; ++k)
          start[k] = after[p].sigma[k] - 2.0 * shear * (d_eps[k] - (k < 3 ? volumetric / 3.0 : 0.0)) -
                     (k < 3 ? K * volumetric : 0.0);
        // with shares that overlap MPM-Mixed sets the deviator, too, when it is known
        if (scheme == std::string("mpm_mixed") && shares == Shares::overlap) start = before[p].sigma;
        const Real pressure = mean(after[p].sigma) - K * volumetric;
        reset += before[p].volume * (pressure * pressure - mean(before[p].sigma) * mean(before[p].sigma)) / (2.0 * K);
        for (std::size_t k = 0; k < 4; ++k) taken += before[p].volume * (k < 3 ? 1.0 : 2.0) * start[k] * d_eps[k];
      }
      SCOPED_TRACE(fmt::format("{} {}", scheme, shares == Shares::overlap ? "overlap" : "point"));
      EXPECT_GT(std::abs(taken), 5.0);
      EXPECT_NEAR(s.state.work.taken - w.taken, taken, 1e-8 * std::abs(taken));
      EXPECT_NEAR(s.state.work.reset - w.reset, reset, 1e-8 * std::abs(taken));
      const TableRow row = keep_ledger(s.model, s.state, s.work);
      EXPECT_EQ(row["transfer"], s.state.work.taken + s.state.work.internal);
      EXPECT_EQ(row["pressure_reset"], s.state.work.reset);
      if (scheme == std::string("standard_mpm"))
        EXPECT_NEAR(row["transfer"], 0.0, 1e-9 * s.state.work.taken);
      else
        EXPECT_NE(reset, 0.0);
    }
}

TEST(Ledger, WithWeightsOfThePointsNothingIsLostBetweenNodesAndPoints)  // decision 0004
{
  for (const char* scheme : {"mpm_mixed", "mpm_gp"}) {
    Case c = column(scheme, 0.5);
    c.method.weights = Weights::summed;
    c.method.shares = Shares::point;
    Simulation s(c);
    make_steps(s, 100);
    EXPECT_NEAR(s.state.work.transfer(), 0.0, 1e-9 * s.state.work.taken) << scheme;
    EXPECT_LT(s.state.work.reset, 0.0) << scheme;
  }
}

TEST(Ledger, WhatPicTakesIsWorkOfRelaxation)
{
  Case c = column("mpm_gp", 0.25);
  c.method.flip = 0.9;
  Simulation s(c);
  make_steps(s, 100);
  const TableRow row = keep_ledger(s.model, s.state, s.work);
  EXPECT_LT(row["relaxation_work"], -0.05 * row["gravity_work"]);
  EXPECT_LT(std::abs(row["numerical"]), 0.05 * row["gravity_work"]);
}

/// A block without weight that flies out through the right side.
Simulation leaving_block()
{
  Case c = free_box("mpm_gp", {3.0, 0.5}, {3.75, 1.0}, elastic(2e6, 0.3, 2000.0));
  c.sides = {side("right", SideKind::open)};
  c.bodies[0].velocity = {20.0, 0.0};
  Model model = build_model(c, 1);
  State state = build_state(model);
  edit_points(state, [](const PointBlock<2>& block, Index lane) { block.row(Rows::sigma + 3)[lane] = 3000.0; });
  state.start_energy = kinetic_and_stored_energy(model, state);
  return Simulation(std::move(model), std::move(state));
}

TEST(Ledger, EntersTheKineticAndElasticEnergyOfWhatLeft)
{
  Simulation s = leaving_block();
  EXPECT_EQ(keep_ledger(s.model, s.state, s.work)["left_energy"], 0.0);
  const auto before = points_by_id(s.state);
  while (s.state.left.empty()) make_steps(s);
  Real energy = 0.0;
  for (const LeftPoint& p : s.state.left) energy += 0.5 * p.mass * (p.v[0] * p.v[0] + p.v[1] * p.v[1]) + p.elastic;
  const LeftPoint& first = s.state.left.front();
  EXPECT_EQ(first.mass, before[static_cast<std::size_t>(first.id)].mass);
  EXPECT_GT(first.elastic, 0.0);
  const TableRow row = keep_ledger(s.model, s.state, s.work);
  EXPECT_DOUBLE_EQ(row["left_energy"], energy);
  EXPECT_NEAR(row["numerical"], row["kinetic"] + row["elastic"] + row["left_energy"] - s.state.start_energy, 1e-9);
  EXPECT_NEAR(kinetic_and_stored_energy(s.model, s.state), row["kinetic"] + row["elastic"] + row["left_energy"], 1e-6);
}

TEST(Ledger, TheBooksBalanceWhenAllHasLeft)
{
  Simulation s = leaving_block();
  while (s.state.points.n_points() > 0) make_steps(s);
  const TableRow row = keep_ledger(s.model, s.state, s.work);
  EXPECT_EQ(row["kinetic"] + row["elastic"], 0.0);
  EXPECT_NEAR(row["left_energy"], s.state.start_energy, 1e-3 * s.state.start_energy);
  EXPECT_NEAR(row["numerical"], 0.0, 1e-3 * s.state.start_energy);
}

TEST(Ledger, TheBooksBalanceWhileSoilLeavesThroughAnOpenSide)
{
  Case c = column("mpm_gp", 0.25);
  c.mesh.size = {9.0, 3.0};
  c.sides[1].kind = SideKind::open;
  Simulation s = followed(c);
  s.state.start_energy = kinetic_and_stored_energy(s.model, s.state);
  while (s.state.time < 2.0) make_steps(s);
  const TableRow row = keep_ledger(s.model, s.state, s.work);
  EXPECT_GT(row["left"], 100);
  EXPECT_GT(row["left_energy"], 0.05 * row["gravity_work"]);
  EXPECT_LT(std::abs(row["numerical"]), 0.02 * row["gravity_work"]);
}

TEST(Ledger, TheSpeedThat999InAThousandPointsDoNotExceedLeavesOutTheFastest)
{
  Simulation s = followed(column("mpm_gp"));  // 1600 points
  edit_points(
      s.state, [](const PointBlock<2>& block, Index lane) { block.row(Rows::v)[lane] = -block.row(Rows::id)[lane]; });
  const TableRow row = keep_ledger(s.model, s.state, s.work);
  EXPECT_EQ(row["v_max"], 1599.0);
  EXPECT_EQ(row["v_999"], 1597.0);
  EXPECT_EQ(s.state.largest_v_999, 1597.0);
}

TEST(Ledger, EachRowEntersTheCrest)
{
  Simulation s = followed(column("mpm_gp"));
  s.state.time = 0.25;
  const TableRow row = keep_ledger(s.model, s.state, s.work);
  EXPECT_EQ(row["crest_x"], 8.0);
  EXPECT_NEAR(row["front_x"], 7.95, 1e-12);
  EXPECT_TRUE(std::isnan(row["front_left_x"]) && std::isnan(row["crest_left_x"]));  // a wall
  const std::string slope = "followers/slopes/slope_0/";
  EXPECT_EQ(array_of(s.state, slope + "time"), std::vector<Real>{0.25});
  EXPECT_EQ(array_of(s.state, slope + "crest"), std::vector<Real>{8.0});
  EXPECT_EQ(array_of(s.state, slope + "kinetic"), std::vector<Real>{row["kinetic_nodal"]});
}

TEST(Ledger, TheLargestSpeedsAreThoseOfPointsHoweverTheyAreStored)
{
  Case c = column("mpm_gp", 0.25);
  c.bodies[0].velocity = {3.0, 0.0};
  Simulation s = followed(c);
  make_steps(s, 150);  // blocks with lanes of points that went
  std::vector<Real> speeds;
  for (const auto& p : points_by_id(s.state)) speeds.push_back(std::sqrt(p.v[0] * p.v[0] + p.v[1] * p.v[1]));
  std::sort(speeds.begin(), speeds.end());
  const TableRow row = keep_ledger(s.model, s.state, s.work);
  EXPECT_EQ(row["v_max"], speeds.back());
  EXPECT_EQ(row["v_999"], speeds[static_cast<std::size_t>(0.999 * static_cast<double>(speeds.size() - 1))]);
}

}  // namespace ledger_test
