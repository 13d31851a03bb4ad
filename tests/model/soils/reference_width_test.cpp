#include "model/soils/reference_width.hpp"

#include "support/simulations.hpp"

namespace reference_width_test {

MaterialCase layer_of_clay(Real reference_width)
{
  MaterialCase material = clay({.eta = 50.0});
  material.softening.reference_width = reference_width;
  return material;
}

/// A layer of clay, one cell of width h high and 4 m long, on a fixed base below an elastic block whose top is pushed.
Case shear_layer(const std::string& scheme, Real h, Real reference_width)
{
  Case c = free_box(scheme, {1.0, 0.0}, {5.0, h}, layer_of_clay(reference_width));
  c.materials.push_back(elastic(2e7, 0.3, 2000.0));
  c.mesh.size = {6.0, 0.8};
  c.mesh.cell = {h, h};
  c.bodies.push_back(body("rock", {1.0, h}, {5.0, 0.8}));
  for (BodyCase& b : c.bodies) b.points_per_cell = {2, 2};
  c.sides = {side("bottom", SideKind::fixed), side("top", SideKind::velocity)};
  c.sides[1].velocity = {0.05, 0.0};
  c.time.end = 0.8;
  return c;
}

/// Energy per area that the layer takes above its residual strength [J/m^2].
Real energy_of_layer(const std::string& scheme, Real h, Real reference_width)
{
  Simulation s(shear_layer(scheme, h, reference_width));
  s.run();
  Real strain = 0.0;  // sum of eps_eq_p times volume [m^2]
  for (const Point& p : points_by_id(s.state))
    if (p.material == 0) strain += p.eps_eq_p() * p.volume;
  EXPECT_GT(strain / 4.0, 0.01) << "slip is " << 2.0 * strain / 4.0 << " m";
  return (s.state.work.plastic - 2.0 * 2e3 * strain) / 4.0;
}

TEST(ReferenceWidth, AShearLayerOfOneCellTakesTheSameEnergyOnTwoMeshes)
{
  const Real reference = 0.1, expected = 2.0 * reference * (8e3 - 2e3) / 50.0;
  for (const char* scheme : {"mpm_gp", "mpm_mixed"}) {
    const Real coarse = energy_of_layer(scheme, 0.2, reference), fine = energy_of_layer(scheme, 0.1, reference);
    EXPECT_NEAR(fine, coarse, 0.02 * coarse) << scheme;
    EXPECT_NEAR(coarse, expected, 0.03 * expected) << scheme;
    EXPECT_GT(energy_of_layer(scheme, 0.2, 0.2), 1.8 * coarse) << "the test sees the width";
  }
}

Case graded(const std::string& scheme, Real reference_width)
{
  Case c = free_box(scheme, {0.0, 0.0}, {4.0, 2.0}, layer_of_clay(reference_width));
  c.mesh.kind = MeshKind::graded;
  c.mesh.cells = {8, 4};
  c.mesh.grading = {3.0, 1.0};
  return c;
}

TEST(ReferenceWidth, IsOfTheCellInWhichAPointLiesNow)
{
  for (const char* scheme : {"mpm_gp", "mpm_mixed"}) {
    Case c = graded(scheme, 0.2);
    c.bodies[0] = body("clay", {1.2, 0.5}, {2.4, 1.5});
    c.bodies[0].velocity_at = [](Vec<2> x) -> Vec<2> { return {3.0 * (x[1] - 0.7), 0.0}; };
    Simulation s(c);
    const int eps = row_of(s.model.materials[0], Role::plastic_strain);
    const int softening = row_of(s.model.materials[0], Role::softening);
    s.step(3);
    int moved = 0;
    std::vector<Real> before_eps(s.state.points.n_points()), before(s.state.points.n_points());
    std::vector<Index> cell(s.state.points.n_points());
    for (int step = 0; step < 200; ++step) {
      for_each_point(s.state.points, [&](const PointBlock<2>& block, Index lane) {
        const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
        before_eps[id] = block.row(eps)[lane], before[id] = block.row(softening)[lane];
        moved += step > 0 && cell[id] != block.cell;
        cell[id] = block.cell;
      });
      s.step();
      if (scheme == std::string("mpm_mixed")) continue;  // its points take means
      for_each_point(s.state.points, [&](const PointBlock<2>& block, Index lane) {
        const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
        const Real h = std::sqrt(s.model.mesh->geometry(cell[id]).volume);
        ASSERT_NEAR(block.row(softening)[lane] - before[id], h / 0.2 * (block.row(eps)[lane] - before_eps[id]), 1e-13);
      });
    }
    EXPECT_GT(moved, 0) << scheme;
    EXPECT_GT(std::accumulate(before.begin(), before.end(), 0.0), 0.1) << scheme;
  }
}

TEST(ReferenceWidth, WithoutItNothingIsKept)
{
  const Model model = build_model(column("mpm_gp"), 1);
  EXPECT_TRUE(model.materials[0].softening_scale.empty());
  EXPECT_EQ(row_of(model.materials[0], Role::softening), -1);
}

std::vector<Problem> told_of(const Case& c)
{
  try {
    return warnings_from(find_wide_cells, c);
  } catch (const InputError& error) {
    return error.problems();
  }
}

TEST(ReferenceWidth, ACellThatWouldSnapBackIsRefused)  // 1.5 G t_ref / (eta (S_p - S_r)) = 10 t_ref
{
  Case c = column("mpm_gp", 0.5);
  c.materials[0].softening.reference_width = 0.0501;
  EXPECT_THAT(told_of(c), IsEmpty());
  c.materials[0].softening.reference_width = 0.04;
  EXPECT_THAT(told_of(c),
      ElementsAre(told("material.\"clay\".softening.reference_width",
          "a cell is too wide for the reference width: it would snap back",
          "Cells with this soil measure up to 0.5 m (square root of the area): softening there is 12.5 times as steep "
          "as given.\nAllowed: cells of at most 0.4 m with this width, or a width of at least 0.05 m with these "
          "cells.\nA smaller shape factor or a stiffer soil serves too.")));
}

TEST(ReferenceWidth, WideCellsThatSoilMayComeToAreDoubted)
{
  Case c = graded("mpm_gp", 0.048);
  c.bodies[0] = body("clay", {0.0, 0.0}, {1.0, 2.0});
  EXPECT_THAT(told_of(c), ElementsAre(told("material.\"clay\".softening.reference_width",
                              "soil may come to cells too wide for the reference width")));
}

}  // namespace reference_width_test
