// What averages and the pressure of the cell make of a stress is back inside the yield surface after each step.
#include "soil/laws/probe.hpp"
#include "support/simulations.hpp"

namespace admissible_state_test {

class EveryScheme : public TestWithParam<const char*> {};

constexpr Real degree = std::numbers::pi / 180.0;

/// Frictional soil that softens [Pa, deg]: c 5 to 0.5 kPa, phi 30 to 22, psi 8 to 0.
const MaterialCase sand{"clay", "mohr_coulomb", 1990.0,
    {2e6, 0.3, 5e3, 30.0, 8.0, std::numeric_limits<Real>::infinity(), 0.5e3, 22.0, 0.0, 50.0}};

/// How far a point lies outside the surface of its own strain, over the size of its stress.
Real excess_of(const Point& point)
{
  const Real decay = std::exp(-50.0 * point.values[0]), c = 0.5e3 + 4.5e3 * decay, phi = (22.0 + 8.0 * decay) * degree;
  const auto s = sorted_principal(Stress{point.sigma});
  const Real by_shear = s[0] - s[2] + (s[0] + s[2]) * std::sin(phi) - 2.0 * c * std::cos(phi);
  return std::max(by_shear, s[0] - c / std::tan(phi)) / (c + std::abs(s[2]));
}

TEST_P(EveryScheme, EndsEveryStepInsideTheYieldSurfaceOfSofteningFrictionalSoil)
{
  Case c = column(GetParam());
  c.materials = {sand};
  Simulation s(c);
  Real worst = -1.0, largest_strain = 0.0;
  for (int part = 0; part < 20; ++part) {
    s.step(20);
    for (const Point& point : points_by_id(s.state)) {
      worst = std::max(worst, excess_of(point));
      largest_strain = std::max(largest_strain, point.eps_eq_p());
      ASSERT_GE(point.values[0], 0.0);
      ASSERT_GE(point.values[1], 0.0) << "opening";
      ASSERT_GT(point.volume, 0.0);
    }
  }
  EXPECT_LT(worst, 1e-10);
  EXPECT_GT(worst, -1e-6) << "no point yields: the test tests nothing";
  EXPECT_GT(largest_strain, 0.2);
}

INSTANTIATE_TEST_SUITE_P(Schemes, EveryScheme, testing::Values("mpm_mixed", "mpm_gp", "standard_mpm"),
    [](const auto& info) { return std::string(info.param); });

}  // namespace admissible_state_test
