// The node passes by hand, on one cell with one point in its middle: each corner has a quarter of its mass.
#include "mpm/step/node_passes.hpp"
#include "mpm/step/workspace.hpp"
#include "support/simulations.hpp"

namespace node_passes_test {

constexpr Real quarter = 1990.0 / 4.0;  // mass of a node [kg per m]
constexpr Real dt = 1e-3;

/// One point of 1 m^2 in a cell of 1 m x 1 m.
Simulation one_point(
    Vec<2> v, Vec<2> gravity, const Damping& damping = {}, const std::vector<SideCondition>& sides = {})
{
  Case c = clamped_cell("mpm_gp");
  c.bodies[0].points_per_cell = {1, 1};
  c.method.pressure = Pressure::constant;  // else sweeps leave a part of the acceleration
  c.bodies[0].velocity = v;
  c.forces.gravity = gravity;
  c.forces.local_damping = damping.local;
  c.forces.viscous_damping = damping.viscous;
  c.sides = sides;
  Model model = build_model(c, 1);
  model.dt = dt;
  State state = build_state(model);
  return Simulation(std::move(model), std::move(state));
}

TEST(NodePasses, GravityAndDampingAccelerateANode)
{
  Simulation s = one_point({2.0, -3.0}, {1.0, -10.0}, {.local = 0.2, .viscous = 5.0});
  make_steps(s);
  const NodeValues& node = s.work.node[0];
  EXPECT_DOUBLE_EQ(node.mass, quarter);
  EXPECT_NEAR(node.damping[0], quarter * (-0.2 * 1.0 - 5.0 * 2.0), 1e-9);
  EXPECT_NEAR(node.damping[1], quarter * (0.2 * 10.0 + 5.0 * 3.0), 1e-9);
  EXPECT_NEAR(node.dv[0], dt * (1.0 - 0.2 - 10.0), 1e-15);
  EXPECT_NEAR(node.dv[1], dt * (-10.0 + 2.0 + 15.0), 1e-15);
}

TEST(NodePasses, TheInternalForceAcceleratesANode)
{
  Simulation s = one_point({0.0, 0.0}, {0.0, 0.0});
  edit_points(s.state, [](const PointBlock<2>& block, Index lane) {
    for (int k = 0; k < 3; ++k) block.row(Rows::sigma + k)[lane] = -6000.0;
  });
  make_steps(s);
  // Corner 0 of a unit square under pressure: -p/2 in both directions away from the cell.
  for (int d = 0; d < 2; ++d) {
    EXPECT_NEAR(s.work.node[0].internal[d], -3000.0, 1e-9);
    EXPECT_NEAR(s.work.node[0].dv[d], -3000.0 / quarter * dt, 1e-12);
  }
}

TEST(NodePasses, ARollerGivesTheForceThatStopsTheNode)
{
  Simulation s = one_point({2.0, -3.0}, {0.0, -10.0}, {}, {side("bottom", SideKind::roller)});
  make_steps(s);
  const NodeValues& held = s.work.node[0];
  EXPECT_NEAR(held.boundary[1], quarter * (3.0 + 10.0 * dt) / dt, 1e-6);
  EXPECT_NEAR(held.boundary[0], 0.0, 1e-9);
  EXPECT_EQ(held.v[1], 0.0);
  EXPECT_NEAR(s.work.node[2].boundary[1], 0.0, 1e-9);
  EXPECT_LT(s.work.node[2].v[1], -1.0);  // free, and moved by the point
}

TEST(NodePasses, AContactActsAlongItselfBeforeTheRemapOnly)
{
  SideCondition base = side("bottom", SideKind::contact_bilateral);
  base.adhesion = 1000.0;
  Simulation s = one_point({2.0, 0.0}, {0.0, 0.0}, {}, {base});
  make_steps(s);
  const Real slowed = 1000.0 * 0.5 * dt / quarter;  // a L_i dt / m_i at the two nodes of the base
  EXPECT_NEAR(s.work.node[0].dv[0], -slowed, 1e-15);
  // The point loses half of it (two of four nodes), and the remapped node has the point's velocity.
  EXPECT_NEAR(points_by_id(s.state)[0].v[0], 2.0 - 0.5 * slowed, 1e-15);
  EXPECT_NEAR(s.work.node[0].v[0], 2.0 - 0.5 * slowed, 1e-15);
}

TEST(NodePasses, TheWorksOfAStepAreForcesTimesTheMotionOfTheirNodes)
{
  SideCondition base = side("bottom", SideKind::contact_bilateral);
  base.adhesion = 1000.0;
  Simulation s = one_point({2.0, 0.0}, {3.0, 0.0}, {.local = 0.1}, {base});
  make_steps(s);
  const Real path = points_by_id(s.state)[0].v[0] * dt;  // of all four nodes [m]
  EXPECT_NEAR(s.state.work.boundary, -1000.0 * 1.0 * path, 1e-12);
  EXPECT_NEAR(s.state.work.gravity, 1990.0 * 3.0 * path, 1e-12);
  EXPECT_NEAR(
      s.state.work.damping, -0.1 * (1990.0 * 3.0 - 1000.0 * 1.0) * path, 1e-12);  // of what the base does not carry
}

TEST(NodePasses, NodesLighterThanTheLimitAreNotAcceleratedButMoveWithTheirPoints)
{
  Simulation s = one_point({2.0, 0.0}, {0.0, -10.0});
  s.model.method.small_mass = 0.26;  // of rho V_e: just above the quarter that each node has
  make_steps(s);
  for (const Index i : s.work.active_nodes) {
    EXPECT_EQ(s.work.node[i].v, (Vec<2>{2.0, 0.0}));
    EXPECT_EQ(s.work.node[i].dv, (Vec<2>{0.0, 0.0}));
  }
  EXPECT_EQ(s.state.work.gravity, 0.0);
  Simulation heavier = one_point({2.0, 0.0}, {0.0, -10.0});
  heavier.model.method.small_mass = 0.24;
  make_steps(heavier);
  EXPECT_LT(heavier.work.node[0].dv[1], 0.0);
}

/// Four cells with one point each, all at the local coordinate xi or eta = `place`, moving along that side.
Simulation block_on_sides(const std::string& scheme, int across, Real place)
{
  Case c = free_box(scheme, {1.0, 0.5}, {1.5, 1.0}, elastic(2e6, 0.3, 2000.0));
  c.bodies[0].points_per_cell = {1, 1};
  c.bodies[0].velocity[1 - across] = 0.7;
  Model model = build_model(c, 1);
  State state = build_state(model);
  edit_points(state, [&](const PointBlock<2>& block, Index lane) {
    block.row(Rows::x + across)[lane] = model.mesh->centres[block.cell][across] + 0.125 * place;
    block.row(Rows::xi + across)[lane] = place;
  });
  return Simulation(std::move(model), std::move(state));
}

TEST(NodePasses, ABlockWhosePointsLieOnCellSidesTranslatesWithoutStress)
{
  for (const char* scheme : {"standard_mpm", "mpm_mixed", "mpm_gp"})
    for (const int across : {0, 1})
      for (const Real place : {-1.0, std::nextafter(-1.0, 0.0), -1.0 + 1e-12, std::nextafter(1.0, 0.0)}) {
        Simulation s = block_on_sides(scheme, across, place);
        make_steps(s, 10);
        for (const Point& p : points_by_id(s.state)) {
          EXPECT_NEAR(p.v[across], 0.0, 1e-12);
          EXPECT_NEAR(p.v[1 - across], 0.7, 1e-12);
          for (const Real sigma : p.sigma) EXPECT_NEAR(sigma, 0.0, 1e-6) << scheme << ' ' << place;
        }
      }
}

TEST(NodePasses, TheOutOfBalanceRatioIsThatOfTheForces)
{
  Simulation falling = one_point({0.0, 0.0}, {0.0, -10.0});
  make_steps(falling);
  EXPECT_NEAR(falling.work.unbalanced_ratio, 1.0, 1e-14);  // free fall: m a = m g
  Simulation held = one_point({0.0, 0.0}, {0.0, -10.0}, {}, {side("bottom", SideKind::fixed)});
  make_steps(held);
  EXPECT_NEAR(held.work.unbalanced_ratio, 0.5, 1e-14);  // two of the four nodes
}

TEST(NodePasses, AVelocityThatIsNotANumberIsNoticed)
{
  Simulation s = one_point({NAN, 0.0}, {0.0, 0.0});
  make_steps(s);
  EXPECT_FALSE(s.work.finite);
}

}  // namespace node_passes_test
