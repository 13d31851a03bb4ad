// The books of a run, by hand, on a full cell of four points.
#include "simulation/ledger.hpp"

#include "simulation/setup.hpp"
#include "support/cases.hpp"
#include "support/simulations.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace terp {
namespace {

using Rows = PointRows<2>;

constexpr Real shear = 2.0e6, bulk = 2.0 * 2.0e6 * 1.48 / (3.0 * 0.04);  // of the clay [Pa]

/// Sets one row of one point.
void set(Simulation& s, int id, int row, Real value)
{
  test::edit_points(s.state, [&](const PointBlock<2>& block, Index lane) {
    if (static_cast<int>(block.row(Rows::id)[lane]) == id) block.row(row)[lane] = value;
  });
}

/// Four points of 0.25 m^2 with an audit that has begun.
Simulation books()
{
  Model model = build_model(test::clamped_cell("mpm_gp"), 1);
  State state = build_state(model);
  start_audit(model, state);
  return Simulation(std::move(model), std::move(state));
}

TEST(Ledger, EnergiesMassAndMomentumAreSumsOverThePoints)
{
  Simulation s = books();
  set(s, 0, Rows::v, 3.0);
  set(s, 1, Rows::v + 1, -2.0);
  set(s, 2, Rows::sigma + 3, 5000.0);
  for (int k = 0; k < 3; ++k) set(s, 3, Rows::sigma + k, -6000.0);
  const TableRow row = keep_ledger(s.model, s.state, s.work);
  const Real mass = 1990.0 * 0.25;
  EXPECT_NEAR(row["mass"], 4.0 * mass, 1e-9);
  EXPECT_NEAR(row["momentum_x"], 3.0 * mass, 1e-9);
  EXPECT_NEAR(row["momentum_y"], -2.0 * mass, 1e-9);
  EXPECT_NEAR(row["kinetic"], 0.5 * mass * (9.0 + 4.0), 1e-9);
  EXPECT_NEAR(row["elastic"], 0.25 * (5000.0 * 5000.0 / (2.0 * shear) + 6000.0 * 6000.0 / (2.0 * bulk)), 1e-12);
  EXPECT_EQ(row["v_max"], 3.0);
  EXPECT_NEAR(kinetic_and_elastic_energy(s.model, s.state), row["kinetic"] + row["elastic"], 1e-9);
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
  set(s, 0, Rows::v, 3.0);
  s.state.start_energy = 100.0;
  s.state.work = {.gravity = 700.0, .damping = -30.0, .boundary = -4.0, .plastic = 55.0};
  const TableRow row = keep_ledger(s.model, s.state, s.work);
  EXPECT_NEAR(row["numerical"], row["kinetic"] + row["elastic"] + 55.0 - 100.0 - (700.0 - 30.0 - 4.0), 1e-9);
  EXPECT_EQ(row["gravity_work"], 700.0);
  EXPECT_EQ(row["damping_work"], -30.0);
  EXPECT_EQ(row["boundary_work"], -4.0);
  EXPECT_EQ(row["plastic"], 55.0);
}

/// A block without weight that flies out through the right side.
Simulation leaving_block()
{
  Case c = test::free_box("mpm_gp", {3.0, 0.5}, {3.75, 1.0}, test::elastic(2e6, 0.3, 2000.0));
  c.sides = {test::side("right", SideKind::open)};
  c.bodies[0].velocity = {20.0, 0.0};
  Model model = build_model(c, 1);
  State state = build_state(model);
  test::edit_points(state, [](const PointBlock<2>& block, Index lane) { block.row(Rows::sigma + 3)[lane] = 3000.0; });
  state.start_energy = kinetic_and_elastic_energy(model, state);
  start_audit(model, state);
  return Simulation(std::move(model), std::move(state));
}

TEST(Ledger, EntersTheKineticAndElasticEnergyOfWhatLeft)
{
  Simulation s = leaving_block();
  EXPECT_EQ(keep_ledger(s.model, s.state, s.work)["left_energy"], 0.0);
  const auto before = test::points_by_id(s.state);
  while (s.state.left.empty()) s.step();
  Real energy = 0.0;
  for (const LeftPoint& p : s.state.left) energy += 0.5 * p.mass * (p.v[0] * p.v[0] + p.v[1] * p.v[1]) + p.elastic;
  const LeftPoint& first = s.state.left.front();
  EXPECT_EQ(first.mass, before[static_cast<std::size_t>(first.id)].mass);
  EXPECT_GT(first.elastic, 0.0);
  const TableRow row = keep_ledger(s.model, s.state, s.work);
  EXPECT_DOUBLE_EQ(row["left_energy"], energy);
  EXPECT_NEAR(row["numerical"], row["kinetic"] + row["elastic"] + row["left_energy"] - s.state.start_energy, 1e-9);
  EXPECT_NEAR(kinetic_and_elastic_energy(s.model, s.state), row["kinetic"] + row["elastic"] + row["left_energy"], 1e-6);
}

TEST(Ledger, TheBooksBalanceWhenAllHasLeft)
{
  Simulation s = leaving_block();
  while (s.state.points.n_points() > 0) s.step();
  const TableRow row = keep_ledger(s.model, s.state, s.work);
  EXPECT_EQ(row["kinetic"] + row["elastic"], 0.0);
  EXPECT_NEAR(row["left_energy"], s.state.start_energy, 1e-3 * s.state.start_energy);
  EXPECT_NEAR(row["numerical"], 0.0, 1e-3 * s.state.start_energy);
}

TEST(Ledger, TheBooksBalanceWhileSoilLeavesThroughAnOpenSide)
{
  Case c = test::column("mpm_gp", 0.25);
  c.mesh.size = {9.0, 3.0};
  c.sides[1].kind = SideKind::open;
  Simulation s(c);
  s.state.start_energy = kinetic_and_elastic_energy(s.model, s.state);
  start_audit(s.model, s.state);
  while (s.state.time < 2.0) s.step();
  const TableRow row = keep_ledger(s.model, s.state, s.work);
  EXPECT_GT(row["left"], 100);
  EXPECT_GT(row["left_energy"], 0.05 * row["gravity_work"]);
  EXPECT_LT(std::abs(row["numerical"]), 0.02 * row["gravity_work"]);
}

TEST(Ledger, TheSpeedThat999InAThousandPointsDoNotExceedLeavesOutTheFastest)
{
  Simulation s(test::column("mpm_gp"));  // 1600 points
  start_audit(s.model, s.state);
  test::edit_points(
      s.state, [](const PointBlock<2>& block, Index lane) { block.row(Rows::v)[lane] = -block.row(Rows::id)[lane]; });
  const TableRow row = keep_ledger(s.model, s.state, s.work);
  EXPECT_EQ(row["v_max"], 1599.0);
  EXPECT_EQ(row["v_999"], 1597.0);
  EXPECT_EQ(s.state.largest_v_999, 1597.0);
}

TEST(Ledger, EachRowEntersTheCrest)
{
  Simulation s(test::column("mpm_gp"));
  start_audit(s.model, s.state);
  s.state.time = 0.25;
  const TableRow row = keep_ledger(s.model, s.state, s.work);
  EXPECT_EQ(row["crest_x"], 8.0);
  EXPECT_NEAR(row["front_x"], 7.95, 1e-12);
  EXPECT_TRUE(std::isnan(row["front_left_x"]) && std::isnan(row["crest_left_x"]));  // a wall
  ASSERT_EQ(s.state.slopes.size(), 1);
  const CrestHistory& crest = s.state.slopes[0].crest;
  EXPECT_EQ(crest.time, std::vector<Real>{0.25});
  EXPECT_EQ(crest.x, std::vector<Real>{8.0});
  EXPECT_EQ(crest.kinetic, std::vector<Real>{row["kinetic_nodal"]});
}

std::int64_t count(const std::vector<bool>& flags) { return std::count(flags.begin(), flags.end(), true); }

TEST(Audit, RisingPlasticStrainIsNoViolation)
{
  Simulation s = books();
  for (const Real eps : {0.01, 0.02, 0.02}) {
    set(s, 1, Rows::state, eps);
    keep_ledger(s.model, s.state, s.work);
  }
  EXPECT_EQ(count(s.state.audit.fell), 0);
  EXPECT_EQ(count(s.state.audit.rose), 0);
  EXPECT_EQ(s.state.audit.last_eps_eq_p[1], 0.02);
}

TEST(Audit, APointWhosePlasticStrainFellIsMarkedForGood)
{
  Simulation s = books();
  for (const Real eps : {0.01, 0.009, 0.03}) {
    set(s, 1, Rows::state, eps);
    keep_ledger(s.model, s.state, s.work);
  }
  EXPECT_EQ(s.state.audit.fell, (std::vector<bool>{false, true, false, false}));
  EXPECT_EQ(s.state.audit.rose, (std::vector<bool>{false, true, false, false}));  // its strength rose with it
}

TEST(Audit, RoundOffIsNoViolation)
{
  Simulation s = books();
  for (const Real eps : {0.01, 0.01 * (1.0 - 1e-13)}) {
    set(s, 1, Rows::state, eps);
    keep_ledger(s.model, s.state, s.work);
  }
  EXPECT_EQ(count(s.state.audit.fell), 0);
}

TEST(Audit, AColumnViolatesItsHistoryInMixedAndNotInGp)
{
  for (const char* scheme : {"mpm_gp", "mpm_mixed"}) {
    Simulation s(test::column(scheme));
    start_audit(s.model, s.state);
    while (s.state.time < 1.0) {
      s.step(3);
      keep_ledger(s.model, s.state, s.work);
    }
    const bool mixed = scheme == std::string("mpm_mixed");
    EXPECT_EQ(count(s.state.audit.fell) > 10, mixed) << scheme;
    EXPECT_EQ(count(s.state.audit.rose) > 10, mixed) << scheme;
    if (!mixed) {
      EXPECT_EQ(count(s.state.audit.fell), 0);
      EXPECT_EQ(count(s.state.audit.rose), 0);
    }
  }
}

TEST(Ledger, TheSoftenedShareIsByVolumeAndHalfTheStrength)
{
  Simulation s = books();
  set(s, 0, Rows::state, 0.06);   // S_u = 2.3 kPa of 8 kPa
  set(s, 1, Rows::state, 0.021);  // 4.1 kPa
  set(s, 0, Rows::volume, 0.15);
  EXPECT_NEAR(softened_fraction(s.model, s.state), 0.15 / 0.9, 1e-15);
}

TEST(Ledger, AMaterialWithoutStrengthNeverSoftens)
{
  Simulation s(test::free_box("mpm_gp", {1.0, 0.5}, {1.5, 1.0}, test::elastic(1e6, 0.3, 2000.0)));
  EXPECT_EQ(softened_fraction(s.model, s.state), 0.0);
  start_audit(s.model, s.state);
  keep_ledger(s.model, s.state, s.work);
  EXPECT_EQ(count(s.state.audit.fell) + count(s.state.audit.rose), 0);
}

TEST(Ledger, TheLargestSpeedsAreThoseOfPointsHoweverTheyAreStored)
{
  Case c = test::column("mpm_gp", 0.25);
  c.bodies[0].velocity = {3.0, 0.0};
  Simulation s(c);
  start_audit(s.model, s.state);
  s.step(150);  // blocks with lanes of points that went
  std::vector<Real> speeds;
  for (const auto& p : test::points_by_id(s.state)) speeds.push_back(std::sqrt(p.v[0] * p.v[0] + p.v[1] * p.v[1]));
  std::sort(speeds.begin(), speeds.end());
  const TableRow row = keep_ledger(s.model, s.state, s.work);
  EXPECT_EQ(row["v_max"], speeds.back());
  EXPECT_EQ(row["v_999"], speeds[static_cast<std::size_t>(0.999 * static_cast<double>(speeds.size() - 1))]);
}

}  // namespace
}  // namespace terp
