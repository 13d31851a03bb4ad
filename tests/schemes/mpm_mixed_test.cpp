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

/// Variance of the plastic strain along x about its centre [m^2].
Real variance(const State& state)
{
  Real sum = 0.0, first = 0.0, second = 0.0;
  for (const Point& p : points_by_id(state)) {
    sum += p.eps_eq_p();
    first += p.eps_eq_p() * p.x[0];
    second += p.eps_eq_p() * p.x[0] * p.x[0];
  }
  return second / sum - (first / sum) * (first / sum);
}

/// A bar that moves along x with a bell of plastic strain in it, far from its ends. Weights are the points' own
/// volumes, with which the mean over a cell keeps the sum of the state.
Simulation make_moving_bar(Index n)
{
  Case c = free_box("mpm_mixed", {0.0, 0.25}, {10.0, 0.75});
  c.method.shares = Shares::point;  // with overlapping ones the state stays with its point
  c.mesh.size = {20.0, 1.0};
  c.method.weights = Weights::summed;
  c.bodies[0].points_per_cell = {n, n};
  c.bodies[0].velocity = {4.7123, 0.0};
  Model model = build_model(c, 1);
  State state = build_state(model);
  edit_points(state, [](const PointBlock<2>& block, Index lane) {
    const Real distance = (block.row(Rows::x)[lane] - 5.0) / 0.6;
    block.row(Rows::state)[lane] = 0.05 * std::exp(-0.5 * distance * distance);
  });
  return Simulation(std::move(model), std::move(state));
}

TEST(MpmMixed, InRigidTranslationAStateDiffusesLikeFirstOrderUpwind)
{
  for (const Index n : {3, 5}) {
    Simulation s = make_moving_bar(n);
    s.step();  // the first averaging, before anything has moved, is not part of the law
    const Real start = variance(s.state), time = s.state.time;
    s.step(700);
    const Real path = 4.7123 * (s.state.time - time), h = 0.25;
    ASSERT_GT(path, 12.0 * h);
    const Real expected = (1.0 - 1.0 / n) * h * path;
    EXPECT_NEAR(variance(s.state) - start, expected, 0.05 * expected) << n << " points per direction";
  }
}

TEST(MpmMixed, DiffusionMovesTheSumOfTheStateWithTheSoil)
{
  Simulation s = make_moving_bar(5);
  const auto sum_and_centre = [&] {
    Real sum = 0.0, first = 0.0;
    for (const Point& p : points_by_id(s.state)) {
      sum += p.volume * p.eps_eq_p();
      first += p.volume * p.eps_eq_p() * p.x[0];
    }
    return std::pair(sum, first / sum);
  };
  const auto [sum, centre] = sum_and_centre();
  s.step(700);
  const auto [sum_after, centre_after] = sum_and_centre();
  EXPECT_NEAR(sum_after, sum, 1e-12 * sum);
  EXPECT_NEAR(centre_after, centre + 4.7123 * s.state.time, 0.001);
}

}  // namespace mpm_mixed_test
