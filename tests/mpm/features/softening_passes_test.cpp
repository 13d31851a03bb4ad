#include "mpm/features/softening_passes.hpp"

#include "mpm/step/workspace.hpp"
#include "support/simulations.hpp"

namespace softening_passes_test {

Case softening_column(const char* scheme, Real length = 0.5, Real cell = 0.25)
{
  Case c = column(scheme, cell);
  c.materials[0].softening = {.length = length};
  c.bodies[0].velocity = {2.0, 0.0};  // points change cell from the first steps on, and soften
  return c;
}

std::vector<Real> by_id(const Simulation& s, const char* name)
{
  return row_by_id(s.state, std::ranges::find(s.model.rows.entries(), name, &RowInfo::name)->first);
}

/// Of a row times the volume now, less what it was before, by id; empty: 0.
Real sum_of(const Simulation& s, const char* name, const std::vector<Real>& before = {})
{
  const std::vector<Real> now = by_id(s, name), volume = row_by_id(s.state, Rows::volume);
  Real sum = 0.0;
  for (std::size_t id = 0; id < now.size(); ++id) sum += volume[id] * (now[id] - (before.empty() ? 0.0 : before[id]));
  return sum;
}

void expect_nothing_is_lost(const char* scheme, Shares shares)
{
  Case c = softening_column(scheme);
  c.method.shares = shares;
  c.materials[0].softening.over_nonlocal = 1.0;  // then the nonlocal strain is the mean alone
  Simulation s(c);
  for (int n = 0; n < 40; ++n) {
    const std::vector<Real> before = by_id(s, "eps_nonlocal");
    s.step();
    const Real given = sum_of(s, "softening_increment") * 3.0 / 50.0;
    EXPECT_NEAR(sum_of(s, "eps_nonlocal", before), given, 1e-9 * (1e-9 + given)) << n;
  }
  EXPECT_GT(sum_of(s, "eps_nonlocal"), 0.0);
}

TEST(SofteningPasses, SpreadWhatSoftenedAndLoseNothing)
{
  expect_nothing_is_lost("mpm_gp", Shares::point);
  expect_nothing_is_lost("mpm_gp", Shares::overlap);
}

TEST(SofteningPasses, MixedWithSharesThatOverlapGivesTheIncrementOfTheStep)
{
  Case c = softening_column("mpm_mixed");
  c.method.shares = Shares::overlap;
  c.forces.gravity = {0.0, 0.0};
  c.bodies[0].velocity = {0.0, 0.0};  // at rest: no step softens anything
  Simulation s(c);
  edit_points(s.state, [&](const PointBlock<2>& block, Index lane) {
    block.row(s.model.materials[0].increment_row)[lane] = 0.01 * (lane % 3);
  });
  s.step();
  for (const Real z : by_id(s, "softening_increment")) EXPECT_EQ(z, 0.0);
}

TEST(SofteningPasses, TheDriverNeverFallsAndTheStrengthNeverRises)
{
  Simulation s = followed(softening_column("mpm_gp"));
  keep_ledger(s.model, s.state, s.work);
  for (int n = 0; n < 30; ++n) {
    make_steps(s, 10);
    keep_ledger(s.model, s.state, s.work);
  }
  EXPECT_EQ(flags_set(s.state, "followers/history_audit/fell"), 0);
  EXPECT_EQ(flags_set(s.state, "followers/history_audit/rose"), 0);
  EXPECT_GT(sum_of(s, "eps_softening"), 0.0);
}

TEST(SofteningPasses, CostNothingWithoutALength)
{
  const Simulation off(column("mpm_gp", 0.25));
  EXPECT_FALSE(off.model.with.softening);
  EXPECT_EQ(off.model.rows.n_rows(), Rows::state + 1);
  EXPECT_FALSE(off.work.with.softening);
  EXPECT_EQ(Simulation(softening_column("mpm_gp")).model.rows.n_rows(), Rows::state + 4);
}

TEST(SofteningPasses, ReachCellsWithinTheirSubStepsAndTwoMore)
{
  Simulation s(softening_column("mpm_gp"));
  const std::vector<Index>& cells = s.state.points.occupied();
  const int rings = s.model.with.softening->diffusion.n_substeps + 2;
  const auto middle = [&](Index cell) { return s.model.mesh->centres[cell]; };
  const std::size_t seed = cells.size() / 3;
  std::ranges::fill(s.work.with.softening->cell_softens, 0);
  EXPECT_FALSE(find_reach_of_softening(s.model, s.state, s.work));
  s.work.with.softening->cell_softens[seed] = 1;
  ASSERT_TRUE(find_reach_of_softening(s.model, s.state, s.work));
  const auto rings_from_seed = [&](Vec<2> x) {
    const Vec<2> from = middle(cells[seed]);
    return std::max(std::abs(x[0] - from[0]), std::abs(x[1] - from[1])) / 0.25;
  };
  for (Index cell = 0; cell < s.model.mesh->n_cells(); ++cell)
    EXPECT_EQ(s.work.with.softening->reach.has_cell[cell] != 0, rings_from_seed(middle(cell)) < rings + 0.1) << cell;
  for (Index i = 0; i < s.model.mesh->n_nodes(); ++i)  // those whose cells are all reached
    EXPECT_EQ(s.work.with.softening->reach.has_node[i] != 0, rings_from_seed(s.model.mesh->nodes[i]) < rings - 0.4)
        << i;
}

/// Two boxes of soil on a mesh of 0.25 m; in the left one all points have softened by 1 in this step.
Simulation two_boxes(Real from, const MaterialCase& right)
{
  MaterialCase left = clay();
  left.softening = {.length = 1.0, .over_nonlocal = 1.0};
  Case c = free_box("mpm_gp", {0.0, 0.0}, {1.0, 2.0}, left);
  MaterialCase other = right;
  other.name = "other";
  c.materials.push_back(other);
  c.bodies.push_back(body("other", {from, 0.0}, {from + 1.0, 2.0}));
  return Simulation(c);
}

/// The largest driver in the right box after the left one has softened.
Real softening_of_the_right(Simulation& s)
{
  const Index row = s.model.materials[0].increment_row;
  edit_points(s.state, [&](const PointBlock<2>& block, Index lane) {
    block.row(row)[lane] = block.material == 0 ? 1.0 : s.model.materials[1].increment_row < 0 ? 0.0 : -0.0;
  });
  std::ranges::fill(s.work.with.softening->reach.has_cell, 1);
  NodeSpread& spread = s.work.with.softening->spread;
  const NodeDiffusion& diffusion = s.model.with.softening->diffusion;
  for (std::size_t k = 0; k < s.state.points.occupied().size(); ++k)
    collect_softening(s.model, s.state.points, s.state.points.occupied()[k], s.work.with.softening->corners[k]);
  for (const Index i : s.work.active_nodes) gather_softening(s.model, s.state, i, *s.work.with.softening);
  for (Index g = 0; g < diffusion.n_groups(); ++g) set_rates(diffusion, g, spread);
  for (int n = 0; n < diffusion.n_substeps; ++n) {
    for (Index g = 0; g < diffusion.n_groups(); ++g) spread_nodes(diffusion, g, spread);
    std::swap(spread.value, spread.next);
  }
  for (const Index cell : s.state.points.occupied()) soften_points(s.model, s.state.points, cell, spread.value);
  Real most = 0.0;
  const int driver = row - 1;
  for_each_point(s.state.points, [&](const PointBlock<2>& block, Index lane) {
    if (block.material == 1) most = std::max(most, block.row(driver)[lane]);
  });
  return most;
}

TEST(SofteningPasses, SoilThatTouchesSoftensAndSoilBeyondAGapDoesNot)
{
  MaterialCase same = clay();
  same.softening = {.length = 1.0, .over_nonlocal = 1.0};
  Simulation touching = two_boxes(1.0, same);
  EXPECT_GT(softening_of_the_right(touching), 0.3 * 3.0 / 50.0);
  Simulation apart = two_boxes(1.5, same);  // two cells of 0.25 m
  EXPECT_EQ(softening_of_the_right(apart), 0.0);
}

TEST(SofteningPasses, SoilThatDoesNotTakePartDilutesNothing)
{
  MaterialCase without = clay();
  Simulation s = two_boxes(1.0, without);
  EXPECT_EQ(softening_of_the_right(s), 0.0);
  // All that softens did so by the same amount: its mean is that amount, up to the border.
  const int driver = s.model.materials[0].increment_row - 1;
  for_each_point(s.state.points, [&](const PointBlock<2>& block, Index lane) {
    if (block.material != 0) return;
    EXPECT_NEAR(block.row(driver)[lane], 3.0 / 50.0, 1e-12);
  });
}

TEST(SofteningPasses, SpreadThePartOfSofteningBetweenSoilsOfOtherRates)
{
  MaterialCase brittle = clay({.eta = 100.0});
  brittle.softening = {.length = 1.0, .over_nonlocal = 1.0};
  MaterialCase same = clay();
  same.softening = brittle.softening;
  Simulation one = two_boxes(1.0, same), other = two_boxes(1.0, brittle);
  EXPECT_NEAR(softening_of_the_right(other), 0.5 * softening_of_the_right(one), 1e-12);
}

}  // namespace softening_passes_test
