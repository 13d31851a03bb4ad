// Paper Sec. 4.2: in MPM-Mixed softening spreads over the element, in MPM-GP it stays where it happened.
#include "mpm/points/surface.hpp"
#include "support/simulations.hpp"

namespace history_test {

/// Plastic strain of two points of equal volume in one sub-cell, alone in their cell, after a step without strain.
std::vector<Real> eps_eq_p_after_one_step(const char* scheme, const std::vector<Real>& before)
{
  Case c = clamped_cell(scheme);
  c.bodies[0] = body("clay", {0.5, 0.5}, {1.0, 0.75});
  c.bodies[0].points_per_cell = {4, 4};
  Simulation s(c);
  EXPECT_EQ(s.state.points.n_points(), 2);
  edit_points(s.state, [&](const PointBlock<2>& block, Index lane) {
    block.row(Rows::state)[lane] = before[static_cast<std::size_t>(block.row(Rows::id)[lane])];
  });
  s.step();
  std::vector<Real> after;
  for (const Point& p : points_by_id(s.state)) after.push_back(p.eps_eq_p());
  return after;
}

TEST(History, MixedSpreadsSofteningToTheNeighbour)
{
  EXPECT_THAT(eps_eq_p_after_one_step("mpm_mixed", {0.00, 0.06}), Pointwise(DoubleEq(), {0.03, 0.03}));
}

TEST(History, GpAndStandardMpmLeaveTheNeighbourAlone)
{
  for (const char* scheme : {"mpm_gp", "standard_mpm"})
    EXPECT_EQ(eps_eq_p_after_one_step(scheme, {0.00, 0.06}), (std::vector<Real>{0.00, 0.06})) << scheme;
}

/// How often a point's plastic strain fell from one step to the next while the softening column slides for 1 s.
std::int64_t count_falls(const char* scheme)
{
  Simulation s(column(scheme));
  std::int64_t falls = 0;
  std::vector<Point> before = points_by_id(s.state);
  while (s.state.time < 1.0) {
    s.step();
    const std::vector<Point> after = points_by_id(s.state);
    for (std::size_t p = 0; p < after.size(); ++p) falls += after[p].eps_eq_p() < before[p].eps_eq_p();
    before = after;
  }
  EXPECT_GT(extent_in_x(*s.model.mesh, s.state.points)[1], 9.0);  // it did slide, through cells
  return falls;
}

TEST(History, GpNeverLowersThePlasticStrainOfAPoint) { EXPECT_EQ(count_falls("mpm_gp"), 0); }

TEST(History, MixedLowersThePlasticStrainOfPointsThatMoveAmongFresherOnes) { EXPECT_GT(count_falls("mpm_mixed"), 100); }

TEST(History, WithoutSofteningTheSchemesSlideAlike)
{
  Simulation gp(column_without_softening("mpm_gp", 0.25)), mixed(column_without_softening("mpm_mixed", 0.25));
  for (const Real time : {1.0, 2.0}) {
    while (gp.state.time < time) gp.step();
    while (mixed.state.time < time) mixed.step();
    EXPECT_NEAR(
        extent_in_x(*gp.model.mesh, gp.state.points)[1], extent_in_x(*mixed.model.mesh, mixed.state.points)[1], 0.1)
        << time << " s";
    EXPECT_GT(extent_in_x(*gp.model.mesh, gp.state.points)[1], 8.0 + time);
  }
}

TEST(History, WithSofteningTheLargestPlasticStrainIsLowerInMixed)
{
  const auto largest = [](const char* scheme) {
    Simulation s(column(scheme, 0.25));
    while (s.state.time < 1.0) s.step();
    Real eps = 0.0;
    for (const Point& p : points_by_id(s.state)) eps = std::max(eps, p.eps_eq_p());
    return eps;
  };
  EXPECT_GE(largest("mpm_gp"), 1.15 * largest("mpm_mixed"));
}

}  // namespace history_test
