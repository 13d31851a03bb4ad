// How fast it diffuses a state that moves: ledger, `transport`.
#include "support/simulations.hpp"

namespace mpm_mixed_test {

/// Two points on top of each other in each sub-cell of a full clamped cell, the second with three times the volume.
/// Stress and state of the pair in sub-cell g: 100 (g + 1) and 500 (g + 1), times one factor for each component.
constexpr std::array<Real, 4> factor{-3.0, -1.0, -2.0, 0.5};

/// averaging: of the state variables, in place of what their law declares.
std::vector<Point> points_after_one_step(std::optional<Averaging> averaging = {})
{
  Case c = clamped_cell("mpm_mixed");
  c.bodies[0].points_per_cell = {4, 2};
  Simulation s(c);
  MaterialType law = *s.model.materials[0].type;
  std::vector<StateInfo> variables(law.state.begin(), law.state.end());
  for (StateInfo& variable : variables) variable.averaging = averaging.value_or(variable.averaging);
  law.state = variables;
  s.model.materials[0].type = &law;
  edit_points(s.state, [&](const PointBlock<2>& block, Index lane) {
    const bool second = static_cast<int>(block.row(Rows::id)[lane]) % 2 == 1;
    const int g = (block.row(Rows::xi)[lane] > 0.0) + 2 * (block.row(Rows::xi + 1)[lane] > 0.0);
    const Real value = (second ? 500.0 : 100.0) * (g + 1);
    block.row(Rows::volume)[lane] = second ? 0.1875 : 0.0625;
    for (int k = 0; k < 4; ++k) block.row(Rows::sigma + k)[lane] = factor[k] * value;
    block.row(Rows::state)[lane] = 1e-5 * value;
  });
  s.step();
  return points_by_id(s.state);
}

int sub_cell_of(const Point& p) { return (p.local[0] > 0.0) + 2 * (p.local[1] > 0.0); }

/// Volume-weighted mean of a pair: (100 + 3 * 500) / 4 times g + 1.
Real mean_of(int g) { return 400.0 * (g + 1); }

TEST(MpmMixed, PointsOfASubCellTakeItsMeanDeviatorAndThePressureOfTheCell)
{
  for (const Point& p : points_after_one_step()) {
    const Real own = mean_of(sub_cell_of(p)), cell = 1000.0;  // means of `value`
    const Real pressure_factor = -2.0;                        // (-3 - 1 - 2) / 3
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(p.sigma[k], (factor[k] - pressure_factor) * own + pressure_factor * cell, 1e-9);
    EXPECT_NEAR(p.sigma[3], factor[3] * own, 1e-9);
  }
}

TEST(MpmMixed, ThePlasticStrainIsAveragedOverTheCellAsItsLawDeclares)
{
  for (const Point& p : points_after_one_step()) EXPECT_NEAR(p.eps_eq_p(), 1e-5 * 1000.0, 1e-16);
}

TEST(MpmMixed, AStateThatItsLawKeepsBySubCellTakesTheMeanThere)
{
  for (const Point& p : points_after_one_step(Averaging::sub_cell))
    EXPECT_NEAR(p.eps_eq_p(), 1e-5 * mean_of(sub_cell_of(p)), 1e-16);
}

}  // namespace mpm_mixed_test
