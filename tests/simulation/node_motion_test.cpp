#include "simulation/node_motion.hpp"
#include "support/simulations.hpp"

namespace node_motion_test {

/// Sets the velocities of all points: f(x).
template <class F>
void set_velocities(State& state, F&& f)
{
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const Vec<2> v = f(Vec<2>{block.row(Rows::x)[lane], block.row(Rows::x + 1)[lane]});
    for (int d = 0; d < 2; ++d) block.row(Rows::v + d)[lane] = v[d];
  });
}

TEST(NodalKineticEnergy, OfAMovingBodyIsThatOfItsPoints)
{
  Simulation s(column("mpm_gp"));
  set_velocities(s.state, [](Vec<2>) { return Vec<2>{3.0, -4.0}; });
  const Real mass = 16.0 * s.model.largest_density;
  EXPECT_NEAR(kinetic_energy(map_motion(s.model, s.state)), 0.5 * mass * 25.0, 1e-9 * mass);
}

TEST(NodalKineticEnergy, DoesNotSeeWhatPointsOfACellMoveAgainstEachOther)
{
  Simulation s(column("mpm_gp"));
  constexpr std::array<Real, 5> noise{
      -1.0, 2.0, 0.0, -2.0, 1.0};  // of five points in a row: no sum and no first moment
  set_velocities(s.state, [&](Vec<2> x) {
    return Vec<2>{noise[static_cast<std::size_t>(10.0 * x[0]) % 5], 0.0};
  });  // cells of 0.5 m
  const TableRow ledger = keep_ledger(s.model, s.state, s.work);
  EXPECT_GT(ledger["kinetic"], 1e4);
  EXPECT_LT(ledger["kinetic_nodal"], 1e-12 * ledger["kinetic"]);
}

TEST(NodalKineticEnergy, OfALedgerRowIsThatAtTheStartOfTheLastStepAndAtMostThatOfThePoints)
{
  Simulation s(column("mpm_gp"));
  s.step(200);
  const Real before = kinetic_energy(map_motion(s.model, s.state));
  make_steps(s);
  const TableRow row = keep_ledger(s.model, s.state, s.work);
  EXPECT_NEAR(row["kinetic_nodal"], before, 1e-12 * before);
  EXPECT_GT(row["kinetic_nodal"], 0.5 * row["kinetic"]);
  EXPECT_LE(row["kinetic_nodal"], row["kinetic"] * (1.0 + 1e-12));
}

}  // namespace node_motion_test
