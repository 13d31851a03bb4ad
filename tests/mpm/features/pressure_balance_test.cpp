#include "mpm/features/balance.hpp"
#include "mpm/features/pressure_balance.hpp"

#include "mpm/step/workspace.hpp"
#include "support/blocks.hpp"
#include "support/meshes.hpp"
#include "support/verification.hpp"

namespace pressure_balance_test {

Case with_slope(Case c)
{
  c.method.strain_shares = StrainShares::transposed;
  c.method.volume_change = VolumeChange::soil;
  c.method.pressure = Pressure::balanced;
  return c;
}

/// Level ground of weak clay in distorted cells that its surface cuts, in equilibrium with its weight.
Case level_clay(const std::string& scheme)
{
  Case c = with_slope(free_box(
      scheme, {0.0, 0.0}, {10.0, 3.5}, clay({.shear_modulus = 2.0e5, .su_peak = 300.0, .su_residual = 300.0})));
  c.bodies[0].points_per_cell = {4, 4};
  c.forces.gravity = {0.0, -9.81};
  c.initial.stress = InitialStress::k0;
  c.initial.k0 = 1.0;
  c.sides = {side("left", SideKind::roller), side("right", SideKind::roller), side("bottom", SideKind::fixed)};
  c.time.end = 2.0;
  return c;
}

Real largest_kinetic_energy(Simulation& s)
{
  Real most = 0.0;
  while (s.state.time < s.model.description.time.end) {
    s.step(20);
    most = std::max(most, keep_ledger(s.model, s.state, s.work)["kinetic"]);
  }
  return most;
}

TEST(PressureBalance, LevelClayStaysLevelInDistortedCells)
{
  for (const char* scheme : {"mpm_gp", "mpm_mixed"})
    for (const Shares shares : {Shares::overlap, Shares::point}) {
      Case c = level_clay(scheme);
      c.method.shares = shares;
      Simulation s = simulate_on(distorted_rectangle(10, 4, 1.0, 0.25, 11), c);
      EXPECT_LT(largest_kinetic_energy(s), 0.5) << scheme;
      EXPECT_EQ(s.state.work.plastic, 0.0) << scheme;
    }
  Case flat = level_clay("mpm_gp");
  flat.method.pressure = Pressure::constant;
  Simulation flows = simulate_on(distorted_rectangle(10, 4, 1.0, 0.25, 11), flat);
  EXPECT_GT(largest_kinetic_energy(flows), 10.0);
}

/// A border that no soil knows of: the same clay under two names.
TEST(PressureBalance, TwoClaysOfOneKindStayLevelAsOne)
{
  for (const char* scheme : {"mpm_gp", "mpm_mixed"}) {
    Case c = level_clay(scheme);
    c.materials.push_back(c.materials[0]);
    c.materials[1].name = "lower";
    c.bodies.push_back(c.bodies[0]);
    c.bodies[0].polygon = {{0.0, 1.4}, {10.0, 1.7}, {10.0, 3.5}, {0.0, 3.5}};
    c.bodies[1].polygon = {{0.0, 0.0}, {10.0, 0.0}, {10.0, 1.7}, {0.0, 1.4}};
    c.bodies[1].material = "lower";
    Simulation s = simulate_on(distorted_rectangle(10, 4, 1.0, 0.35, 11), c);
    EXPECT_LT(largest_kinetic_energy(s), 1.0) << scheme;
    EXPECT_EQ(s.state.work.plastic, 0.0) << scheme;
  }
}

/// A body that falls has no stress, whatever its cells: the slope follows the acceleration of the same step.
TEST(PressureBalance, AFallingBlockIsNotStrained)
{
  for (const char* scheme : {"mpm_gp", "mpm_mixed"}) {
    Case c = with_slope(free_box(scheme, {1.3, 3.1}, {5.4, 7.2}, elastic(2.0e5, 0.48, 1800.0)));
    c.bodies[0].points_per_cell = {4, 4};
    c.forces.gravity = {0.0, -9.81};
    c.time.end = 0.5;
    Simulation s = simulate_on(distorted_rectangle(14, 16, 0.5, 0.2, 12), c);
    s.run();
    const TableRow row = keep_ledger(s.model, s.state, s.work);
    EXPECT_LT(row["elastic"], 1e-5) << scheme;  // 30 J with a = 0
    EXPECT_NEAR(row["momentum_y"], -9.81 * row["time"] * row["mass"], 1e-11 * row["mass"]) << scheme;
  }
}

/// Force and moment of the slope of a block are zero in any cell, filled or not, as is its work in a swell that is the
/// same everywhere: that is the work of the constant part.
TEST(PressureBalance, HasNeitherResultantNorMomentNorWorkInASwell)
{
  const Mesh<2> mesh = distorted_rectangle(3, 3, 1.0, 0.3, 13);
  const Index cell = 4;
  PointBlocks<2> points(mesh.n_cells(), 0);
  Random random(14);
  for (int k = 0; k < 11; ++k)
    add_point(mesh, cell,
        {.local = {random.between(-1.0, 1.0), random.between(-1.0, 1.0)}, .volume = random.between(0.02, 0.06)},
        points);
  points.update_occupied();
  std::vector<CornerSums<Quad4>> corners(1);
  const CellGroup<Quad4> group{points.occupied(), mesh, points, corners, {}, {}};
  PerGauss<Quad4, Pack> weight;
  for (Pack& of_gauss : weight) of_gauss = Pack(random.between(0.1, 0.3));
  const auto by_gauss = moment_of_gauss_points(group, geometry_of(group), weight);
  const BlockMoment by_points = moment_of_points(
      mesh.geometry(cell), only_block(points, cell), 0.5, {0.1, -0.2}, mesh.geometry(cell).centre_gradient);
  for (const bool of_points : {false, true})
    for (int e = 0; e < 2; ++e) {
      const auto force = [&](int i, int d) { return of_points ? by_points[i][d][e] : by_gauss[i][d][e][0]; };
      Real moment = 0.0, swell = 0.0, largest = 0.0;
      Vec<2> sum{0.0, 0.0};
      for (int i = 0; i < 4; ++i) {
        const Vec<2> x = mesh.nodes[mesh.cells[cell][i]];
        moment += x[0] * force(i, 1) - x[1] * force(i, 0);
        swell += x[0] * force(i, 0) + x[1] * force(i, 1);
        for (int d = 0; d < 2; ++d) {
          sum[d] += force(i, d);
          largest = std::max(largest, std::abs(force(i, d)));
        }
      }
      for (int d = 0; d < 2; ++d) EXPECT_NEAR(sum[d], 0.0, 1e-14);
      EXPECT_NEAR(moment, 0.0, 1e-13);
      EXPECT_NEAR(swell, 0.0, 1e-13);
      EXPECT_GT(largest, 1e-3);
    }
}

/// Inside, soil that yields by its pressure would stand by strength that is not there.
TEST(PressureBalance, OfSoilWhoseStrengthFollowsThePressureActsAtTheSurfaceAlone)
{
  Case c = level_clay("mpm_gp");
  const auto count_cells = [&](bool at_surface) {
    Simulation s = simulate_on(distorted_rectangle(10, 4, 1.0, 0.25, 11), c);
    s.step(1);
    int n = 0;
    for (std::size_t slot = 0; slot < s.state.points.occupied().size(); ++slot) {
      const bool upper = s.model.mesh->centres[s.state.points.occupied()[slot]][1] > 3.0;
      n += upper == at_surface && s.work.with.balance->cells[slot].moment[0] != CellBalance::Matrix{};
    }
    return n;
  };
  EXPECT_EQ(count_cells(true), 10);
  EXPECT_EQ(count_cells(false), 30);
  const std::vector<Real> sand{2.0e5, 0.3, 1.0e3, 30.0};
  c.materials[0] = {c.materials[0].name, "mohr_coulomb", 1800.0, find_material("mohr_coulomb")->complete(sand)};
  EXPECT_EQ(count_cells(true), 10);
  EXPECT_EQ(count_cells(false), 0);
}

TEST(PressureBalance, SoilWithoutFrictionIgnoresThePressure)
{
  Case c = level_clay("mpm_gp");
  const auto ignores = [&](Real friction) {
    const std::vector<Real> values{2.0e5, 0.48, 300.0, friction};
    c.materials[0] = {c.materials[0].name, "mohr_coulomb", 1800.0, find_material("mohr_coulomb")->complete(values)};
    return build_model(c, 1).materials[0].ignores_pressure;
  };
  EXPECT_TRUE(ignores(0.0));
  EXPECT_FALSE(ignores(1.0));
}

TEST(PressureBalance, LawsSayWhetherTheirStrengthFollowsThePressure)
{
  for (const char* law : {"tresca_softening", "ngi_adp", "newtonian_fluid", "linear_elastic"})
    EXPECT_TRUE(find_material(law)->ignores_pressure) << law;
  for (const char* law : {"mohr_coulomb", "modified_cam_clay"})
    EXPECT_FALSE(find_material(law)->ignores_pressure) << law;
}

/// Waves of a stiff body are faster than any slide: the slope does not follow them, or it would feed them.
TEST(PressureBalance, FeedsNoSwingingCantilever)
{
  Case c = with_slope(free_box("mpm_gp", {0.0, 1.0}, {4.0, 1.5}, elastic(5.0e7, 0.0, 1000.0)));
  c.mesh.size = {4.5, 2.0};
  c.mesh.cell = {0.125, 0.125};
  c.bodies[0].points_per_cell = {2, 2};
  c.forces.gravity = {0.0, -9.81};
  c.sides = {side("left", SideKind::fixed)};
  c.time.end = 1.3;
  Simulation s(c);
  s.run();
  EXPECT_LT(std::abs(s.state.work.outer[outer_balance]), 0.05 * 500.0);  // 500 J: the largest work of gravity
}

}  // namespace pressure_balance_test
