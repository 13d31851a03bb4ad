// Excess pressure of elastic soil: with K_w/n its motion is that of soil that stores total stress and has the undrained
// Poisson's ratio, whatever the scheme and the mesh, and on its way from cell to cell.
#include "mpm/features/search.hpp"
#include "mpm/features/excess_pressure.hpp"
#include "support/meshes.hpp"
#include "support/verification.hpp"

namespace excess_pressure_test {

struct Way {
  std::string scheme;
  Shares shares;
};

Case flying_block(const Way& way, Real poisson_ratio, Drainage drainage)
{
  Case c = free_box(way.scheme, {0.3, 0.15}, {2.2, 2.4}, elastic(2.0e5, poisson_ratio, 1700.0));
  c.mesh.size = {4.0, 3.0};
  c.materials[0].drainage = drainage;
  c.materials[0].undrained_poisson_ratio = 0.48;
  c.bodies[0].points_per_cell = {4, 4};
  c.bodies[0].velocity_at = [](Vec<2> x) { return Vec<2>{1.0 + 0.6 * x[1] * x[1], 0.5 - 0.7 * std::sin(x[0])}; };
  c.forces.gravity = {0.0, -9.81};
  c.method.shares = way.shares;
  c.time.end = 0.2;
  return c;
}

class ExcessPressure : public TestWithParam<Way> {};
INSTANTIATE_TEST_SUITE_P(EveryScheme, ExcessPressure,
    testing::Values(Way{"standard_mpm", Shares::point}, Way{"mpm_mixed", Shares::point},
        Way{"mpm_mixed", Shares::overlap}, Way{"mpm_gp", Shares::point}, Way{"mpm_gp", Shares::overlap}));

/// What the soil stores is the same, in its grains alone or in grains and water.
void expect_equal_energies(Simulation& total, Simulation& effective)
{
  const TableRow a = keep_ledger(total.model, total.state, total.work);
  const TableRow b = keep_ledger(effective.model, effective.state, effective.work);
  const Real scale = a["elastic"];
  EXPECT_GT(b["pore_elastic"], 0.01 * scale);
  EXPECT_EQ(b["water_work"], 0.0);
  EXPECT_NEAR(b["elastic"] + b["pore_elastic"], scale, 1e-6 * scale);
  for (const char* column : {"kinetic", "pressure_reset", "numerical"})
    EXPECT_NEAR(b[column], a[column], 1e-6 * scale) << column;
  for (const char* column : {"transfer", "unexplained"})  // mpm_mixed with overlap takes u with the weights of its rows
    EXPECT_NEAR(b[column], a[column], 5e-3 * scale) << column;
  EXPECT_NEAR(kinetic_and_stored_energy(effective.model, effective.state),
      b["kinetic"] + b["elastic"] + b["pore_elastic"], 1e-9 * scale);
}

TEST_P(ExcessPressure, AndEffectiveStressMoveSoilAsTotalStressOfTheUndrainedStiffness)
{
  const auto mesh = [] { return distorted_rectangle(8, 8, 0.4, 0.3, 7); };
  Simulation total = simulate_on(mesh(), flying_block(GetParam(), 0.48, Drainage::undrained));
  Simulation effective = simulate_on(mesh(), flying_block(GetParam(), 0.2, Drainage::undrained_effective));
  EXPECT_NEAR(effective.model.dt, total.model.dt, 1e-12 * total.model.dt);
  make_steps(total, total.model.n_steps);
  make_steps(effective, total.model.n_steps);
  const int row = effective.model.materials[0].excess_row;
  ASSERT_GE(row, 0);
  expect_equal_energies(total, effective);
  const std::vector<Real> excess = row_by_id(effective.state, row);
  Real largest = 0.0;
  for (const Real u : excess) largest = std::max(largest, std::abs(u));
  EXPECT_GT(largest, 1.0e4);
  const auto a = points_by_id(total.state), b = points_by_id(effective.state);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t p = 0; p < a.size(); ++p) {
    for (int d = 0; d < 2; ++d) {
      EXPECT_NEAR(b[p].x[d], a[p].x[d], 1e-9) << p;
      EXPECT_NEAR(b[p].v[d], a[p].v[d], 1e-7) << p;
    }
    for (int k = 0; k < 4; ++k)
      EXPECT_NEAR(b[p].sigma[k] - (k < 3 ? excess[p] : 0.0), a[p].sigma[k], 1e-6 * largest) << p;
  }
}

TEST(ExcessPressureOfABlock, IsNoneWhileTheSearchForEquilibriumGoesOn)
{
  Simulation s(flying_block({"mpm_gp", Shares::point}, 0.2, Drainage::undrained_effective));
  begin_search(s.model.damping.local, s.work).share = 1.0;
  make_steps(s, 20);
  const int row = s.model.materials[0].excess_row;
  for_each_point(s.state.points, [&](const PointBlock<2>& block, Index lane) { EXPECT_EQ(block.row(row)[lane], 0.0); });
}

TEST(ExcessPressureOfABlock, TakesItsStiffnessFromTheUndrainedPoissonRatioOrAsItIsGiven)
{
  Case c = flying_block({"mpm_gp", Shares::point}, 0.2, Drainage::undrained_effective);
  // K = 2 G (1 + nu) / (3 (1 - 2 nu)): 2e5 * 2 * 1.48 / 0.12 - 2e5 * 2 * 1.2 / 1.8
  EXPECT_NEAR(Simulation(c).model.materials[0].water_stiffness, 4.933333333e6 - 2.666666667e5, 1.0);
  c.materials[0].water_stiffness = 7.0e6;
  EXPECT_EQ(Simulation(c).model.materials[0].water_stiffness, 7.0e6);
  c.materials[0].drainage = Drainage::drained;
  EXPECT_EQ(Simulation(c).model.materials[0].water_stiffness, 0.0);
  EXPECT_EQ(Simulation(c).model.materials[0].excess_row, -1);
}

}  // namespace excess_pressure_test
