#include "run/report/mesh_frame.hpp"
#include "support/simulations.hpp"

namespace mesh_frame_test {

struct Totals {
  Real mass = 0.0, momentum_x = 0.0, pressure = 0.0;  ///< the last: sum of tr(sigma)/3 Omega_p
};

Totals of_points(const State& state)
{
  Totals t;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index p) {
    t.mass += block.row(Rows::mass)[p];
    t.momentum_x += block.row(Rows::mass)[p] * block.row(Rows::v)[p];
    t.pressure += (block.row(Rows::sigma)[p] + block.row(Rows::sigma + 1)[p] + block.row(Rows::sigma + 2)[p]) / 3.0 *
                  block.row(Rows::volume)[p];
  });
  return t;
}

TEST(MeshFrame, NodesHoldTheMassAndMomentumOfThePoints)
{
  Case c = column("mpm_gp");
  c.bodies[0].velocity = {3.0, 0.5};
  Simulation s(c);
  s.step(50);
  const MeshFrame frame = make_mesh_frame(s.model, s.state);
  EXPECT_EQ(frame.time, s.state.time);
  EXPECT_EQ(frame.step, 50);
  Totals t;
  for (std::size_t i = 0; i < frame.mass.size(); ++i) {
    t.mass += frame.mass[i];
    t.momentum_x += frame.mass[i] * frame.velocity[2 * i];
  }
  const Totals wanted = of_points(s.state);
  EXPECT_NEAR(t.mass, wanted.mass, 1e-12 * wanted.mass);
  EXPECT_NEAR(t.momentum_x, wanted.momentum_x, 1e-12 * std::abs(wanted.momentum_x));
}

TEST(MeshFrame, CellsHoldTheMeanPressureOfTheirSoilAndNoneWithoutSoil)
{
  Simulation s(column("mpm_gp"));
  s.step(50);
  const MeshFrame frame = make_mesh_frame(s.model, s.state);
  std::vector<Real> volume(frame.pressure.size());
  for_each_point(s.state.points, [&](const PointBlock<2>& block, Index p) {
    volume[static_cast<std::size_t>(block.cell)] += block.row(Rows::volume)[p];
  });
  Real total = 0.0;
  for (std::size_t cell = 0; cell < volume.size(); ++cell) {
    EXPECT_EQ(std::isnan(frame.pressure[cell]), volume[cell] == 0.0);
    if (volume[cell] > 0.0) total += frame.pressure[cell] * volume[cell];
  }
  const Real wanted = of_points(s.state).pressure;
  EXPECT_LT(wanted, 0.0);  // compression
  EXPECT_NEAR(total, wanted, 1e-12 * std::abs(wanted));
}

TEST(MeshFrame, ABodyInUniformMotionGivesItsVelocityToEveryNodeItTouchesAndItsEnergy)
{
  Case c = column("mpm_gp");
  c.bodies[0].velocity = {3.0, 0.5};
  const Simulation s(c);
  const MeshFrame frame = make_mesh_frame(s.model, s.state);
  for (std::size_t i = 0; i < frame.mass.size(); ++i) {
    EXPECT_NEAR(frame.velocity[2 * i], frame.mass[i] > 0.0 ? 3.0 : 0.0, 1e-14);
    EXPECT_NEAR(frame.velocity[2 * i + 1], frame.mass[i] > 0.0 ? 0.5 : 0.0, 1e-14);
  }
  const Real mass = 16.0 * s.model.largest_density;
  EXPECT_NEAR(kinetic_energy(frame), 0.5 * mass * 9.25, 1e-9 * mass);
}

TEST(NodalKineticEnergy, DoesNotSeeWhatPointsOfACellMoveAgainstEachOther)
{
  Simulation s(column("mpm_gp"));
  constexpr std::array<Real, 5> noise{
      -1.0, 2.0, 0.0, -2.0, 1.0};  // of five points in a row: no sum and no first moment
  for_each_point(s.state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto column_of_points = static_cast<std::size_t>(10.0 * block.row(Rows::x)[lane]);  // cells of 0.5 m
    block.row(Rows::v)[lane] = noise[column_of_points % 5];
    block.row(Rows::v + 1)[lane] = 0.0;
  });
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

}  // namespace mesh_frame_test
