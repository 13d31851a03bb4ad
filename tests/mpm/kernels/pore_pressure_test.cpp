#include "mpm/kernels/pore_pressure.hpp"
#include "mpm/step/cell_passes.hpp"
#include "model/water/nodal_water.hpp"
#include "mpm/step/node_passes.hpp"
#include "mpm/step/workspace.hpp"
#include "support/meshes.hpp"
#include "support/verification.hpp"

namespace pore_pressure_test {

constexpr Index n_cells = 6;
constexpr Real h = 0.5, a = 3.0e3, b = 500.0, c = -900.0;  // p = a + b x + c y [Pa]

/// Every cell full of points of one material, in water with a linear pressure.
Case block_in_water(const std::string& scheme, Drainage drainage)
{
  Case description = free_box(scheme, {0.0, 0.0}, {n_cells * h, n_cells * h}, elastic(3.0e6, 0.3, 1700.0));
  description.materials[0].drainage = drainage;
  description.bodies[0].points_per_cell = {4, 4};
  description.water.start.formula = [](Vec<2> x, Real) { return a + b * x[0] + c * x[1]; };
  return description;
}

Mesh<2> distorted(std::uint64_t seed) { return distorted_rectangle(n_cells, n_cells, h, 0.35, seed); }

/// int N_i dV [m^2], shape [n_nodes].
std::vector<Real> shares_of_nodes(const Mesh<2>& mesh)
{
  std::vector<Real> share(mesh.nodes.size(), 0.0);
  for (Index e = 0; e < mesh.n_cells(); ++e)
    for (int g = 0; g < 4; ++g) {
      const auto N = Quad4::shape_functions(Quad4::gauss_place(g));
      for (int i = 0; i < 4; ++i) share[mesh.cells[e][i]] += N[i] * mesh.geometry(e).gauss_volume[g];
    }
  return share;
}

bool is_inner(Vec<2> x) { return std::min(x[0], x[1]) > 1e-9 && std::max(x[0], x[1]) < n_cells * h - 1e-9; }

class PoreForce : public TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(SchemesWithGaussPoints, PoreForce, testing::Values("mpm_mixed", "mpm_gp"));

TEST_P(PoreForce, OnUndrainedSoilIsThePressureOnItsSurfaceAndNothingInside)
{
  Simulation s =
      simulate_on(distorted_rectangle(n_cells, n_cells, h, 0.0, 1), block_in_water(GetParam(), Drainage::undrained));
  make_steps(s, 1);
  Vec<2> left{0.0, 0.0};
  for (Index i = 0; i < s.model.mesh->n_nodes(); ++i) {
    const Vec<2> x = s.model.mesh->nodes[i], force = s.work.outer[outer_water].node[i];
    if (is_inner(x)) {
      EXPECT_NEAR(force[0], 0.0, 1e-10 * a * h);
      EXPECT_NEAR(force[1], 0.0, 1e-10 * a * h);
    }
    if (x[0] < 1e-9) left = {left[0] + force[0], left[1] + force[1]};
  }
  // Over the nodes of the left side: p on that side to the right; half of the last edge of bottom and top pushes up and
  // down, with the pressure in its middle.
  const Real side = n_cells * h, end = h / 2.0;
  EXPECT_NEAR(left[0], (a + c * side / 2.0) * side, 1e-10 * a * side);
  EXPECT_NEAR(left[1], end * (a + b * h / 2.0) - end * (a + b * h / 2.0 + c * side), 1e-10 * a * side);
}

/// Exact on parallelograms. In twisted cells the mean place of points has no mean of xi eta. Overlapping shares lie in
/// local coordinates and reach into cells of another shape: on these cells they miss by 2e-3 p h.
TEST_P(PoreForce, BalancesTheStressOfStillWaterOnAnyMesh)
{
  constexpr Real twist = 1e-4;  // of p h, what would not matter; a wrong sign or operator gives 1e-2 and more
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Case description = block_in_water(GetParam(), Drainage::undrained);
    description.method.shares = Shares::point;
    Simulation s = simulate_on(distorted(seed), description);
    edit_points(s.state, [](const PointBlock<2>& block, Index lane) {
      for (int k = 0; k < 3; ++k)
        block.row(Rows::sigma + k)[lane] = -(a + b * block.row(Rows::x)[lane] + c * block.row(Rows::x + 1)[lane]);
    });
    make_steps(s, 1);
    const std::vector<Real> share = shares_of_nodes(*s.model.mesh);
    for (std::size_t i = 0; i < share.size(); ++i) {
      EXPECT_NEAR(s.work.node[i].internal[0] + s.work.outer[outer_water].node[i][0], -b * share[i], twist * a * h);
      EXPECT_NEAR(s.work.node[i].internal[1] + s.work.outer[outer_water].node[i][1], -c * share[i], twist * a * h);
    }
  }
}

TEST_P(PoreForce, OnDrainedSoilIsThePullOfTheGradient)
{
  Simulation s = simulate_on(distorted(4), block_in_water(GetParam(), Drainage::drained));
  make_steps(s, 1);
  const std::vector<Real> share = shares_of_nodes(*s.model.mesh);
  for (std::size_t i = 0; i < share.size(); ++i) {
    EXPECT_NEAR(s.work.outer[outer_water].node[i][0], -b * share[i], 1e-10 * a * h);
    EXPECT_NEAR(s.work.outer[outer_water].node[i][1], -c * share[i], 1e-10 * a * h);
  }
}

/// Soil that has opened to twice its volume holds as much more water, which carries its own weight.
TEST_P(PoreForce, OnDrainedSoilDoesNotGrowAsTheSoilOpens)
{
  Case c = block_in_water(GetParam(), Drainage::drained);
  c.bodies[0] = body("elastic", {0.3 * h, 0.3 * h}, {1.3 * h, 1.3 * h});
  c.bodies[0].points_per_cell = {4, 4};
  c.bodies[0].material = c.materials[0].name;
  const auto pull = [&c](Real opened) {
    Simulation s = simulate_on(distorted(4), c);
    edit_points(s.state, [opened](const PointBlock<2>& block, Index lane) { block.row(Rows::volume)[lane] *= opened; });
    make_steps(s, 1);
    Vec<2> sum{0.0, 0.0};
    for (const Vec<2>& force : s.work.outer[outer_water].node) sum = {sum[0] + force[0], sum[1] + force[1]};
    return sum;
  };
  const Vec<2> first = pull(1.0), opened = pull(1.05);
  for (int d = 0; d < 2; ++d) EXPECT_NEAR(opened[d], first[d], 1e-3 * std::abs(first[d])) << d;
}

/// In cells that the surface cuts still water takes a part of the weight at each node, however high it stands above the
/// ground: a submerged section is the dry one with submerged weight.
TEST_P(PoreForce, OfStillWaterIsAPartOfTheWeightWhereTheSurfaceCutsCells)
{
  for (const Real above : {0.0, 0.1 * h, 3.0}) {
    Case c = block_in_water(GetParam(), Drainage::drained);
    const Real top = 4.2 * h;
    c.bodies[0] = body("elastic", {0.0, 0.0}, {n_cells * h, top});
    c.bodies[0].points_per_cell = {4, 4};
    c.bodies[0].material = c.materials[0].name;
    c.method.volume_change = VolumeChange::soil;
    c.water.start.formula = [=](Vec<2> x, Real) { return 9810.0 * (top + above - x[1]); };
    Simulation s = simulate_on(distorted(6), c);
    make_steps(s, 1);
    int n = 0;
    for (Index i = 0; i < s.model.mesh->n_nodes(); ++i) {
      if (s.model.mesh->nodes[i][1] < 4.6 * h || !(s.work.node[i].mass > 0.0)) continue;
      const Real lift = 9810.0 / 1700.0 * s.work.node[i].mass;
      EXPECT_NEAR(s.work.outer[outer_water].node[i][1], lift, 1e-9 * lift) << above;
      ++n;
    }
    EXPECT_GT(n, 4);
  }
}

TEST(PoreForceOfPoints, HaveTheSameSumOnDrainedSoil)
{
  Simulation s = simulate_on(distorted(5), block_in_water("standard_mpm", Drainage::drained));
  make_steps(s, 1);
  Vec<2> sum{0.0, 0.0};
  for (const Vec<2>& force : s.work.outer[outer_water].node) sum = {sum[0] + force[0], sum[1] + force[1]};
  const Real area = n_cells * h * n_cells * h;
  EXPECT_NEAR(sum[0], -b * area, 2e-3 * std::abs(b) * area);  // volumes of points in distorted cells
  EXPECT_NEAR(sum[1], -c * area, 2e-3 * std::abs(c) * area);
}

}  // namespace pore_pressure_test
