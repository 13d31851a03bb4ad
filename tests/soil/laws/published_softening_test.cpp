// The factors of docs/softening_laws.md: a law with a published form's numbers converted follows the published curve.
#include "soil/laws/probe.hpp"

#include <functional>

namespace published_softening_test {

constexpr Real G = 50e6, peak = 20e3, residual = 4e3;  // stiff, so that elastic strain is small beside plastic

Probe clay(Real eta) { return {*find_material("tresca_softening"), {G, 0.48, peak, residual, eta}}; }

/// tau of simple shear against the plastic engineering shear strain that has been reached, gamma - tau/G.
void expect_curve(Probe point, Real last_gamma, const std::function<Real(Real)>& published)
{
  Real gamma = 0.0;
  const int steps = 4000;
  for (int k = 0; k < steps; ++k) {
    gamma += last_gamma / steps;
    point.strain({{0.0, 0.0, 0.0, 0.5 * last_gamma / steps}});  // the tensor has half the engineering shear strain
    const Real expected = point.plastic_work > 0.0 ? published(gamma - point.sigma[3] / G) : G * gamma;
    ASSERT_NEAR(point.sigma[3], expected, 1e-7 * peak) << gamma;
  }
  EXPECT_GT(point.plastic_work, 0.0);
}

Real falling(Real left) { return residual + (peak - residual) * left; }

TEST(PublishedSoftening, OfTheEngineeringShearStrainHasTwiceItsShapeFactor)
{
  const Real a = 12.0;  // exp(-a gamma_p)
  expect_curve(clay(2.0 * a), 0.5, [&](Real gamma) { return falling(std::exp(-a * gamma)); });
}

TEST(PublishedSoftening, OfEinavAndRandolphHasSixOverTheStrainOf95Percent)
{
  const Real xi_95 = 12.0, sensitivity = 5.0;  // (d_rem + (1 - d_rem) exp(-3 xi/xi_95)) s_u0, xi = sum |d_gamma_p|
  const Real d_rem = 1.0 / sensitivity;
  expect_curve(
      clay(6.0 / xi_95), 20.0, [&](Real xi) { return peak * (d_rem + (1.0 - d_rem) * std::exp(-3.0 * xi / xi_95)); });
}

TEST(PublishedSoftening, OfDeyOverASlipHasSixTimesTheBandOverTheSlip)
{
  const Real delta_95 = 0.045, band = 0.5;  // m; slip = band * gamma_p
  expect_curve(
      clay(6.0 * band / delta_95), 0.4, [&](Real gamma) { return falling(std::exp(-3.0 * band * gamma / delta_95)); });
}

Real von_mises(const Stress& e) { return std::sqrt(2.0 / 3.0 * double_dot(e, e)); }

TEST(PublishedSoftening, OfVonMisesHasTwoOverRootThreeOfItsShapeFactor)
{
  const Real a = 12.0, root_3 = std::numbers::sqrt3;
  expect_curve(clay(2.0 / root_3 * a), 0.5, [&](Real gamma) {
    return falling(std::exp(-a * von_mises({{0.0, 0.0, 0.0, 0.5 * gamma}})));
  });
  Probe triaxial = clay(2.0 / root_3 * a);  // the axial strain is its own measure of von Mises
  Real axial = 0.0;
  for (int k = 0; k < 1000; ++k) {
    axial += 2e-4;
    triaxial.strain({{1e-4, -2e-4, 1e-4, 0.0}});
    const Real q = triaxial.sigma[0] - triaxial.sigma[1], plastic = axial - q / (3.0 * G);
    const Real expected = triaxial.plastic_work > 0.0 ? falling(std::exp(-a * plastic)) : 1.5 * G * axial;
    ASSERT_NEAR(0.5 * q, expected, 1e-7 * peak);
  }
  EXPECT_NEAR(triaxial.state[0], std::sqrt(0.75) * (axial - (triaxial.sigma[0] - triaxial.sigma[1]) / (3.0 * G)), 1e-9);
}

TEST(PublishedSoftening, AlongAStraightLineHasTheSameEnergyWithFourAndTheSameFirstSlopeWithTwo)
{
  const Real gamma_r = 0.25;  // of the engineering plastic shear strain, peak to residual
  Probe point = clay(4.0 / gamma_r);
  const Real step = 5e-6;  // of gamma/2
  Real energy = 0.0;
  for (int k = 0; k < 200000; ++k) {
    const Real before = point.state[0];
    point.strain({{0.0, 0.0, 0.0, step}});
    energy += (point.sigma[3] - residual) * 2.0 * (point.state[0] - before);
  }
  EXPECT_NEAR(energy, 0.5 * (peak - residual) * gamma_r, 2e-3 * energy);  // [J/m^3]

  Probe slope = clay(2.0 / gamma_r);
  slope.state[0] = 1e-6;
  EXPECT_NEAR((peak - slope.derived(0)) / 2e-6, (peak - residual) / gamma_r, 1e-4 * (peak - residual) / gamma_r);
}

TEST(PublishedSoftening, ThroughOneMeasuredPointHasTheLogarithmOfWhatIsLeft)
{
  Probe point = clay(-std::log(1.0 - 0.7) / 0.02);
  point.state[0] = 0.02;  // 70 % of the fall at eps_eq_p = 2 %
  EXPECT_NEAR(point.derived(0), falling(0.3), 1e-9);
}

TEST(PublishedSoftening, RateOfEinavAndRandolphHasHalfTheirReferenceRate)
{
  const Real mu = 0.12, gamma_ref = 3e-6;  // 1 + mu log10(max(gamma', gamma_ref)/gamma_ref)
  for (const Real rate : {0.01, 2.0}) {
    Probe point(*find_material("tresca_softening"), {G, 0.48, peak, peak, 0.0, peak, 0.0, mu, 0.5 * gamma_ref});
    point.dt = 1e-4 / rate;
    for (int k = 0; k < 1000; ++k) point.strain({{0.0, 0.0, 0.0, 0.5 * rate * point.dt}});
    EXPECT_NEAR(point.sigma[3], peak * (1.0 + mu * std::log10(std::max(rate, gamma_ref) / gamma_ref)), 1e-6 * peak);
  }
}

}  // namespace published_softening_test
