// Random fields against closed forms. Tolerances are four standard errors of the sample.
#include "simulation/gaussian_field.hpp"

#include "support/test.hpp"

#include <cmath>
#include <numeric>

namespace {

GaussianFieldCase field_of(std::uint32_t realisation)
{
  return {.seed = 7, .realisation = realisation, .scale = {10.0, 0.5}, .low = {-2.0, -3.0}, .high = {8.0, 1.0}};
}

constexpr int n_samples = 4000;

/// Mean over realisations of f(field).
template <class F>
Real mean_of(F f, int n = n_samples)
{
  Real sum = 0.0;
  for (int k = 0; k < n; ++k) sum += f(GaussianField(field_of(static_cast<std::uint32_t>(k))));
  return sum / n;
}

TEST(GaussianField, NormalQuantilesAreThoseOfTables)
{
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-14);
  EXPECT_NEAR(normal_quantile(0.3), -0.5244005127080409, 1e-14);
  EXPECT_NEAR(normal_quantile(1e-3), -3.090232306167813, 1e-14);
  EXPECT_NEAR(normal_quantile(1e-10), -6.361340902404056, 1e-13);
  EXPECT_EQ(normal_quantile(0.5), 0.0);
}

TEST(GaussianField, MeanVarianceAndCorrelationAreThoseOfTheMarkovField)
{
  const Vec<2> a{0.0, -1.0};
  EXPECT_NEAR(mean_of([&](const auto& g) { return g.at(a); }), 0.0, 4.0 / std::sqrt(n_samples));
  EXPECT_NEAR(mean_of([&](const auto& g) { return g.at(a) * g.at(a); }), 1.0, 4.0 * std::sqrt(2.0 / n_samples));
  struct {
    Vec<2> b;
    Real rho;
  } const pairs[] = {{{5.0, -1.0}, std::exp(-1.0)}, {{0.0, -0.5}, std::exp(-2.0)}, {{-1.25, -0.9375}, std::exp(-0.5)},
      {{2.5, -1.25}, std::exp(-1.5)}};  // places of nodes: multiples of 1.25 m and 0.0625 m
  for (const auto& [b, rho] : pairs)
    EXPECT_NEAR(mean_of([&, b = b](const auto& g) { return g.at(a) * g.at(b); }), rho,
        4.0 * std::sqrt((1.0 + rho * rho) / n_samples));
}

// Variance of the mean over a height T: theta^2/(2 T^2) (2 T/theta + exp(-2 T/theta) - 1) (Vanmarcke 1983, 5.1).
TEST(GaussianField, AveragesHaveTheVarianceOfTheContinuousField)
{
  const Real height = 2.0, ratio = 2.0 * height / 0.5,
             expected = 2.0 / (ratio * ratio) * (ratio + std::exp(-ratio) - 1.0);
  const Real found = mean_of([&](const auto& g) {
    Real sum = 0.0;
    constexpr int n = 64;
    for (int k = 0; k < n; ++k) sum += g.at({3.0, -2.5 + height * (k + 0.5) / n});
    return sum / n * sum / n;
  });
  EXPECT_NEAR(found, expected, (4.0 * std::sqrt(2.0 / n_samples) + 0.01) * expected) << "0.01: eight nodes per theta";
}

TEST(GaussianField, NeitherTheBoxNorWhatWasMadeBeforeChangesAValue)
{
  GaussianFieldCase small = field_of(3), large = field_of(3);
  small.low = {1.0, -2.0}, small.high = {2.0, -1.0};
  large.low = {-30.0, -9.0}, large.high = {40.0, 5.0};
  const GaussianField a(small), b(large);
  for (const Vec<2> x : {Vec<2>{1.0, -2.0}, {1.5, -1.3}, {2.0, -1.0}}) EXPECT_EQ(a.at(x), b.at(x));
  EXPECT_TRUE(std::isnan(a.at({2.1, -1.5})));
  EXPECT_NE(GaussianField(field_of(4)).at({1.5, -1.3}), GaussianField(field_of(3)).at({1.5, -1.3}));
}

TEST(GaussianField, MixedFieldsHaveTheCorrelationOfTheirWeights)
{
  const Real found = mean_of([](const GaussianField& g) {
    static std::uint32_t k = 0;
    GaussianFieldCase other = field_of(k++);
    other.parts = {{0, 0.6}, {1, 0.8}};
    return g.at({0.0, -1.0}) * GaussianField(other).at({0.0, -1.0});
  });
  EXPECT_NEAR(found, 0.6, 4.0 * std::sqrt(1.36 / n_samples));
}

TEST(GaussianField, KnownValuesAreMetAndTheVarianceGrowsAwayFromThem)
{
  const auto conditioned = [](int k) {
    GaussianFieldCase field = field_of(static_cast<std::uint32_t>(k));
    field.known = {{{0.0, -1.0}, 1.5}, {{0.01, -1.0}, 1.7}, {{5.0, -1.0}, -0.5}};
    return GaussianField(field);
  };
  EXPECT_NEAR(conditioned(1).at({0.0, -1.0}), 1.6, 1e-12) << "two in one node count with their mean";
  EXPECT_NEAR(conditioned(2).at({5.0, -1.0}), -0.5, 1e-12);
  // Halfway on one line, rho = exp(-1/2) to both and r = exp(-1) between them: mean (1.6 - 0.5) rho/(1 + r),
  // variance 1 - 2 rho^2/(1 + r). At the nodes 2.5 m from both.
  const Real rho = std::exp(-0.5), r = std::exp(-1.0);
  Real sum = 0.0, squares = 0.0;
  for (int k = 0; k < n_samples; ++k) {
    const Real g = conditioned(k).at({2.5, -1.0});
    sum += g, squares += g * g;
  }
  const Real mean = sum / n_samples, variance = squares / n_samples - mean * mean,
             exact = 1.0 - 2.0 * rho * rho / (1.0 + r);
  EXPECT_NEAR(mean, 1.1 * rho / (1.0 + r), 4.0 * std::sqrt(exact / n_samples));
  EXPECT_NEAR(variance, exact, 4.0 * exact * std::sqrt(2.0 / n_samples));
}

TEST(GaussianField, MarginalsHaveMeanOneAndTheirCoefficientOfVariation)
{
  for (const auto marginal : {FieldMarginal::lognormal, FieldMarginal::normal}) {
    Real sum = 0.0, squares = 0.0;
    constexpr int n = 2000;  // Gauss-free: midpoints of equal probability
    for (int k = 0; k < n; ++k) {
      const Real y = value_over_mean(marginal, 0.2, normal_quantile((k + 0.5) / n));
      EXPECT_NEAR(score_of(marginal, 0.2, y), normal_quantile((k + 0.5) / n), 1e-12);
      sum += y, squares += y * y;
    }
    EXPECT_NEAR(sum / n, 1.0, 1e-3);
    EXPECT_NEAR(std::sqrt(squares / n - sum / n * sum / n), 0.2, 2e-3);
  }
  EXPECT_TRUE(std::isnan(score_of(FieldMarginal::lognormal, 0.2, -1.0)));
}

}  // namespace
