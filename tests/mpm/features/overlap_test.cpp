#include "mpm/features/overlap.hpp"
#include "mpm/step/workspace.hpp"
#include "mpm/features/patch_values.hpp"
#include "support/simulations.hpp"

namespace overlap_test {

struct Overlap : TestWithParam<std::string> {
  static Case with_overlap(Case c)
  {
    c.method.shares = Shares::overlap;
    return c;
  }
  Case column() const { return with_overlap(terp::test::column(GetParam(), 0.25)); }
};
INSTANTIATE_TEST_SUITE_P(
    EveryScheme, Overlap, testing::Values("mpm_gp", "mpm_mixed"), [](const auto& scheme) { return scheme.param; });

/// An elastic column between rollers, in equilibrium on cells that it does not fill: points reach into the next cell.
/// Values that were handed back as they are would diffuse from cell to cell: here up to 3.7 kPa in 3 s.
TEST_P(Overlap, ReachingIntoTheNextCellMovesNoPressureAtRest)
{
  Case c = with_overlap(column_without_softening(GetParam(), 0.25));
  c.materials[0] = elastic(1.0e6, 0.4, 1990.0);
  c.materials[0].name = "clay";
  c.mesh.size = {1.0, 2.5};
  c.bodies[0] = body("clay", {0.0, 0.0}, {1.0, 2.0});
  c.forces.local_damping = 0.5;
  c.time.end = 6.0;
  Simulation s(c);
  s.advance_to(3.0);
  const auto before = points_by_id(s.state);
  s.advance_to(6.0);
  const auto after = points_by_id(s.state);
  bool reaches = false;
  for (std::size_t k = 0; k < before.size(); ++k) {
    const auto pressure = [](const Point& p) { return (p.sigma[0] + p.sigma[1] + p.sigma[2]) / 3.0; };
    EXPECT_NEAR(pressure(after[k]), pressure(before[k]), 1e-3);  // of up to 30 kPa
    reaches |= std::abs(after[k].local[1]) > 0.81;
  }
  EXPECT_TRUE(reaches);
}

/// Nodes that move with a linear velocity strain every point alike, at a border between cells too.
TEST_P(Overlap, CarriesASpeedWithoutForces)
{
  Case c = with_overlap(free_box(GetParam(), {0.55, 0.55}, {1.55, 1.3}));
  c.bodies[0].velocity = {1.0, 0.3};
  c.time.end = 0.5;
  Simulation s(c);
  const Vec<2> before = momentum(s.state);
  s.run();
  const Vec<2> after = momentum(s.state);
  for (int d = 0; d < 2; ++d) EXPECT_NEAR(after[d], before[d], 1e-12 * std::abs(before[0]));
  for (const auto& p : points_by_id(s.state)) {
    EXPECT_NEAR(p.v[0], 1.0, 1e-11);
    for (const Real stress : p.sigma) EXPECT_NEAR(stress, 0.0, 1e-6);
  }
}

TEST_P(Overlap, KeepsTheBalanceOfEnergyOfACollapse)
{
  Case c = column();
  c.time.end = 1.0;
  Simulation s(c);
  s.run();
  EXPECT_LT(summarise(s.model, s.state).energy_balance_error, 0.02);
}

/// Which blocks reach into each other is kept from step to step while no block is made or left. Two soils that mix have
/// new ones in cells that held the other soil already.
TEST_P(Overlap, FindsPartnersAnewWhereverABlockIsMadeOrLeft)
{
  Case c = column();
  c.materials.push_back(c.materials[0]);
  c.materials[1].name = "upper";
  c.bodies = {body("clay", {0.0, 0.0}, {8.0, 1.1}), body("upper", {0.0, 1.1}, {8.0, 2.0})};
  Simulation kept(c), anew(c);
  Index most = 0;
  for (int k = 0; k < 40; ++k) {
    for (int step = 0; step < 20; ++step) {
      kept.step();
      anew.work.with.overlap->patches.partners.clear();
      anew.step();
    }
    most = std::max(most, kept.state.points.n_blocks());
    ASSERT_EQ(first_difference(kept.save(), anew.save()), "") << k;
  }
  EXPECT_GT(most, Simulation(c).state.points.n_blocks());
}

/// What drives the strength never falls, in MPM-Mixed too: the points take what the law adds, and no mean of the cell.
TEST_P(Overlap, LowersNoPlasticStrain)
{
  Case c = column();
  c.time.end = 1.0;
  Simulation s(c);
  auto before = points_by_id(s.state);
  for (Real t = 0.05; t < 1.0; t += 0.05) {
    s.advance_to(t);
    const auto now = points_by_id(s.state);
    for (std::size_t k = 0; k < now.size(); ++k) EXPECT_GE(now[k].eps_eq_p(), before[k].eps_eq_p());
    before = now;
  }
}

/// Points that added up the changes at Gauss points, without the mean of their sub-cell, would go to three times the
/// strength. With it a Gauss point on the yield surface is a mean of points around the surface.
TEST_P(Overlap, KeepsThePointsNearTheYieldSurface)
{
  Case c = with_overlap(column_without_softening(GetParam(), 0.25));
  c.time.end = 1.5;
  Simulation s(c);
  s.run();
  std::vector<Real> shear;
  for (const auto& p : points_by_id(s.state)) shear.push_back(std::hypot(0.5 * (p.sigma[0] - p.sigma[1]), p.sigma[3]));
  std::ranges::sort(shear);
  const Real su = 8.0e3;
  EXPECT_NEAR(shear[shear.size() / 2], su, 0.01 * su);
  EXPECT_LT(shear[shear.size() * 99 / 100], 1.2 * su);
  EXPECT_LT(shear.back(), 1.7 * su);
}

}  // namespace overlap_test
