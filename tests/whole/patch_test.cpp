// Patch tests on strongly distorted quadrilaterals: constant strain is exact, constant stress gives no interior force,
// rigid motion gives no stress.
#include "mpm/step/workspace.hpp"
#include "soil/laws/elastic_constants.hpp"
#include "support/meshes.hpp"
#include "support/verification.hpp"

namespace patch_test {

constexpr Index n_cells = 6;
constexpr Real h = 0.5;  // [m]

/// A mesh with inner nodes moved by up to 35 % of h, every cell full of elastic points.
Simulation full_block(const std::string& scheme, std::uint64_t seed, ObjectiveRate rate = ObjectiveRate::none)
{
  Case c = free_box(scheme, {0.0, 0.0}, {n_cells * h, n_cells * h}, elastic(3.0e6, 0.3, 1700.0));
  c.method.objective_rate = rate;
  c.method.shares = Shares::point;
  return simulate_on(distorted_rectangle(n_cells, n_cells, h, 0.35, seed), c);
}

/// Gathers all cells and strains them by the affine field du = a x.
void strain_all_cells(Simulation& s, const std::array<Vec<2>, 2>& a)
{
  s.model.dt = 0x1p-10;  // so that du = v dt is exact
  s.model.find_forces(s.model, s.state, s.work);
  for (const Index i : s.work.active_nodes) {
    const Vec<2> x = s.model.mesh->nodes[i];
    for (int d = 0; d < 2; ++d) s.work.node[i].v[d] = (a[d][0] * x[0] + a[d][1] * x[1]) / s.model.dt;
  }
  s.model.strain(s.model, s.state, s.work);
}

class Patch : public TestWithParam<const Scheme*> {};
INSTANTIATE_TEST_SUITE_P(EveryScheme, Patch, ValuesIn(all_schemes().begin(), all_schemes().end()),
    [](const auto& scheme) { return std::string(scheme.param->name); });

TEST_P(Patch, ConstantStrainAndStressAreExact)
{
  const std::array<Vec<2>, 2> a{{{2.0e-3, -5.0e-3}, {7.0e-3, -4.0e-3}}};
  const Real shear = 3.0e6, lame = bulk_from_poisson(shear, 0.3) - 2.0 / 3.0 * shear, volumetric = -2.0e-3;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Simulation s = full_block(std::string(GetParam()->name), seed);
    strain_all_cells(s, a);
    for (const Point& p : points_by_id(s.state)) {
      EXPECT_NEAR(p.strain[0], 2.0e-3, 1e-15);
      EXPECT_NEAR(p.strain[1], -4.0e-3, 1e-15);
      EXPECT_NEAR(p.strain[2], 0.0, 1e-15);
      EXPECT_NEAR(p.strain[3], 1.0e-3, 1e-15);
      EXPECT_NEAR(p.sigma[0], lame * volumetric + 2.0 * shear * 2.0e-3, 1e-12 * 12000.0);
      EXPECT_NEAR(p.sigma[1], lame * volumetric - 2.0 * shear * 4.0e-3, 1e-12 * 24000.0);
      EXPECT_NEAR(p.sigma[3], 2.0 * shear * 1.0e-3, 1e-12 * 6000.0);
    }
  }
}

TEST_P(Patch, RotationGivesNoStrainAndOnlyTurnsTheStress)
{
  const Real angle = 1.0e-4;
  Simulation s = full_block(std::string(GetParam()->name), 7, ObjectiveRate::jaumann);
  edit_points(s.state, [](const PointBlock<2>& block, Index lane) {
    block.row(Rows::sigma)[lane] = -8000.0;
    block.row(Rows::sigma + 1)[lane] = -20000.0;
    block.row(Rows::sigma + 2)[lane] = -5000.0;
  });
  strain_all_cells(s, {{{0.0, -angle}, {angle, 0.0}}});
  for (const Point& p : points_by_id(s.state)) {
    for (const Real e : p.strain) EXPECT_NEAR(e, 0.0, 1e-16);
    EXPECT_NEAR(p.sigma[0], -8000.0, 1e-9);
    EXPECT_NEAR(p.sigma[1], -20000.0, 1e-9);
    EXPECT_NEAR(p.sigma[3], angle * 12000.0, 1e-9);  // (sigma_xx - sigma_yy) times the angle, first order
  }
}

/// Largest force at an inner node over the largest at any node, for one stress in all points, whose volumes are uneven:
/// in each cell more lies to the left than to the right.
Real interior_force_share(const std::string& scheme, std::uint64_t seed)
{
  Simulation s = full_block(scheme, seed);
  edit_points(s.state, [](const PointBlock<2>& block, Index lane) {
    const Real stress[] = {-9.0e3, -21.0e3, -14.0e3, 5.0e3};
    for (int k = 0; k < 4; ++k) block.row(Rows::sigma + k)[lane] = stress[k];
    block.row(Rows::volume)[lane] *= lane % 5 < 2 ? 1.3 : 0.8;
  });
  strain_all_cells(s, {});
  std::vector<Vec<2>> force(s.model.mesh->nodes.size(), Vec<2>{0.0, 0.0});
  for (std::size_t slot = 0; slot < s.state.points.occupied().size(); ++slot)
    for (int i = 0; i < 4; ++i)
      for (int d = 0; d < 2; ++d)
        force[s.model.mesh->cells[s.state.points.occupied()[slot]][i]][d] += s.work.corners[slot].internal_force[d][i];
  Real inner = 0.0, all = 0.0;
  for (std::size_t i = 0; i < force.size(); ++i) {
    const Vec<2> x = s.model.mesh->nodes[i];
    const bool is_inner = x[0] > 1e-9 && x[0] < n_cells * h - 1e-9 && x[1] > 1e-9 && x[1] < n_cells * h - 1e-9;
    const Real size = std::hypot(force[i][0], force[i][1]);
    all = std::max(all, size);
    if (is_inner) inner = std::max(inner, size);
  }
  return inner / all;
}

TEST(PatchForces, ConstantStressGivesNoInteriorForceWithGaussIntegration)
{
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    EXPECT_LT(interior_force_share("mpm_gp", seed), 1e-13);
    EXPECT_LT(interior_force_share("mpm_mixed", seed), 1e-13);
  }
}

TEST(PatchForces, IntegrationAtThePointsLeavesInteriorForces)  // the control: what Gauss integration is there for
{
  EXPECT_GT(interior_force_share("standard_mpm", 1), 1e-3);
}

}  // namespace patch_test
