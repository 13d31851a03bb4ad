#include "support/random.hpp"
#include "support/simulations.hpp"

namespace mpm_gp_test {

constexpr std::array<Real, 4> pressure{
    -900.0, 300.0, 1500.0, -1300.0};  // tr(sigma)/3 of the four points, mean -100 [Pa]

Real pressure_of(const Point& p) { return (p.sigma[0] + p.sigma[1] + p.sigma[2]) / 3.0; }

/// A full cell of four points with unlike stresses, in a step in which nothing deforms.
TEST(MpmGp, APointTakesThePressureOfItsCellAndKeepsItsDeviator)
{
  Simulation s(clamped_cell("mpm_gp"));
  edit_points(s.state, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<int>(block.row(Rows::id)[lane]);
    const std::array<Real, 4> deviator{100.0 * id, 50.0 - 20.0 * id, -50.0 - 80.0 * id, 70.0 + id};
    for (int k = 0; k < 4; ++k) block.row(Rows::sigma + k)[lane] = deviator[k] + (k < 3 ? pressure[id] : 0.0);
    block.row(Rows::state)[lane] = 0.001 * id;
  });
  const auto before = points_by_id(s.state);
  s.step();
  const auto after = points_by_id(s.state);
  for (std::size_t p = 0; p < 4; ++p) {
    EXPECT_NEAR(pressure_of(after[p]), -100.0, 1e-10);
    for (int k = 0; k < 4; ++k)
      EXPECT_NEAR(after[p].sigma[k] - (k < 3 ? -100.0 : 0.0), before[p].sigma[k] - (k < 3 ? pressure[p] : 0.0), 1e-10);
    EXPECT_EQ(after[p].eps_eq_p(), before[p].eps_eq_p());
  }
}

/// Gives every point a plastic strain of its own, by id.
void scatter_state(Simulation& s)
{
  Random random(7);
  std::vector<Real> eps(static_cast<std::size_t>(s.state.points.n_points()));
  for (Real& e : eps) e = random.between(0.0, 0.1);
  edit_points(s.state, [&](const PointBlock<2>& block, Index lane) {
    block.row(Rows::state)[lane] = eps[static_cast<std::size_t>(block.row(Rows::id)[lane])];
  });
}

TEST(MpmGp, InRigidTranslationEveryStateIsCarriedExactly)
{
  Case c = free_box("mpm_gp", {0.5, 0.25}, {1.5, 1.0});
  c.bodies[0].velocity = {3.1459, 1.2877};  // no point ever lies on a side to round-off: see MethodOptions::small_mass
  Simulation s(c);
  scatter_state(s);
  const auto before = points_by_id(s.state);
  while (s.state.time < 0.5) s.step();  // six cells to the right, two up
  const auto after = points_by_id(s.state);
  for (std::size_t p = 0; p < before.size(); ++p) {
    EXPECT_EQ(after[p].eps_eq_p(), before[p].eps_eq_p());
    EXPECT_NE(after[p].cell, before[p].cell);
    for (int d = 0; d < 2; ++d) EXPECT_NEAR(after[p].x[d], before[p].x[d] + before[p].v[d] * s.state.time, 1e-12);
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(after[p].strain[k], 0.0, 1e-12);
  }
}

}  // namespace mpm_gp_test
