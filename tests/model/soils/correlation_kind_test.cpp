#include "model/soils/correlation_kind.hpp"

#include "support/test.hpp"

namespace correlation_kind_test {

constexpr Real spacing = 0.125;

/// Simpson's rule.
template <class F>
Real integral(F f, Real from, Real to)
{
  constexpr int n = 4000;
  const Real h = (to - from) / n;
  Real sum = f(from) + f(to);
  for (int k = 1; k < n; ++k) sum += (k % 2 == 1 ? 4.0 : 2.0) * f(from + k * h);
  return sum * h / 3.0;
}

TEST(CorrelationKind, TheScaleOfFluctuationIsTheIntegralOverTheWholeLine)
{
  for (const CorrelationKind& kind : correlation_kinds()) {
    EXPECT_EQ(kind.rho(0.0), 1.0) << kind.name;
    EXPECT_NEAR(2.0 * integral(kind.rho, 0.0, 20.0), 1.0, 1e-9) << kind.name;
  }
}

// Matern, by its general form with the Bessel function of the second kind: 2^(1-nu)/Gamma(nu) (lambda d)^nu K_nu.
TEST(CorrelationKind, TheKindsAreWhatTheyAreCalled)
{
  const auto rho = [](std::string_view name, Real d) {
    return std::ranges::find(correlation_kinds(), name, &CorrelationKind::name)->rho(d);
  };
  EXPECT_NEAR(rho("markov", 0.3), std::exp(-0.6), 1e-15);
  EXPECT_NEAR(rho("gaussian", 0.3), std::exp(-0.09 * std::numbers::pi), 1e-15);
  for (const auto& [name, nu] : {std::pair{"markov", 0.5}, {"matern_3_2", 1.5}, {"matern_5_2", 2.5}}) {
    // theta lambda = 2 sqrt(pi) Gamma(nu + 1/2)/Gamma(nu)
    const Real lambda = 2.0 * std::sqrt(std::numbers::pi) * std::tgamma(nu + 0.5) / std::tgamma(nu), x = 0.3 * lambda;
    EXPECT_NEAR(
        rho(name, 0.3), std::pow(2.0, 1.0 - nu) / std::tgamma(nu) * std::pow(x, nu) * std::cyl_bessel_k(nu, x), 1e-12)
        << name;
  }
}

TEST(CorrelationKind, TheVarianceOfAMeanIsTheIntegralOfTheCorrelation)
{
  for (const CorrelationKind& kind : correlation_kinds())
    for (const Real length : {0.25, 1.0, 7.0})
      EXPECT_NEAR(kind.variance_of_mean(length),
          2.0 / (length * length) * integral([&](Real t) { return (length - t) * kind.rho(t); }, 0.0, length), 1e-9)
          << kind.name << " over " << length;
}

TEST(CorrelationKind, ChainsAndAveragesHaveTheCorrelationAtAllNodes)
{
  for (const CorrelationKind& kind : correlation_kinds()) {
    const std::vector<Real> rho = rho_of_nodes(kind, spacing, 40);
    for (std::size_t k = 0; k < rho.size(); ++k)
      EXPECT_NEAR(rho[k], kind.rho(spacing * static_cast<Real>(k)), kind.chain != nullptr ? 1e-14 : 2e-9)
          << kind.name << " at node " << k;
  }
}

TEST(CorrelationKind, AChainKeepsItsCovariance)
{
  for (const CorrelationKind& kind : correlation_kinds()) {
    if (kind.chain == nullptr) continue;
    const LineChain chain = kind.chain(spacing);
    const auto square = [](const LineChain::Matrix& m, std::size_t a, std::size_t b) {
      Real sum = 0.0;
      for (std::size_t k = 0; k < LineChain::most_states; ++k) sum += m[a][k] * m[b][k];
      return sum;
    };
    for (std::size_t a = 0; a < chain.n_states; ++a)
      for (std::size_t b = 0; b < chain.n_states; ++b) {
        Real next = square(chain.noise, a, b);
        for (std::size_t i = 0; i < chain.n_states; ++i)
          for (std::size_t j = 0; j < chain.n_states; ++j)
            next += chain.step[a][i] * square(chain.start, i, j) * chain.step[b][j];
        EXPECT_NEAR(next, square(chain.start, a, b), 1e-14) << kind.name << ' ' << a << ' ' << b;
      }
  }
}

TEST(CorrelationKind, AMovingAverageEndsWhereItsWeightsAreNothing)
{
  const std::vector<Real> weights = moving_average(correlation_kinds().back(), spacing);
  ASSERT_EQ(weights.size(), 31U) << "15 nodes on both sides: exp(-2 pi (16/8)^2) is 1.2e-11";
  Real squares = 0.0;
  for (const Real weight : weights) squares += weight * weight;
  EXPECT_NEAR(squares, 1.0, 1e-14);
  EXPECT_LT(weights.front(), 1e-9 * weights[15]);
}

}  // namespace correlation_kind_test
