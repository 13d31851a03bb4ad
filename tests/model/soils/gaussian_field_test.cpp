// Random fields against closed forms. Tolerances are four standard errors of the sample.
#include "model/soils/gaussian_field.hpp"

#include "math/errors.hpp"

#include "support/test.hpp"

namespace gaussian_field_test {

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

TEST(GaussianField, AveragesHaveTheVarianceOfTheContinuousField)
{
  for (const CorrelationKind& kind : correlation_kinds()) {
    const Real height = 2.0, expected = kind.variance_of_mean(height / 0.5);
    Real found = 0.0;
    for (int s = 0; s < n_samples; ++s) {
      GaussianFieldCase field = field_of(static_cast<std::uint32_t>(s));
      field.low[0] = field.high[0] = 3.0, field.correlation = &kind;
      const GaussianField g(field);
      Real sum = 0.0;
      constexpr int n = 64;
      for (int k = 0; k < n; ++k) sum += g.at({3.0, -2.5 + height * (k + 0.5) / n});
      found += sum / n * sum / n / n_samples;
    }
    EXPECT_NEAR(found, expected, (4.0 * std::sqrt(2.0 / n_samples) + 0.01) * expected)
        << kind.name << "; 0.01: eight nodes per theta";
  }
}

/// Places on both sides of x = y = 0, where chains begin; lags along x, along y and along a diagonal.
TEST(GaussianField, EachKindHasItsCorrelationAcrossTheOrigin)
{
  for (const CorrelationKind& kind : correlation_kinds()) {
    const Vec<2> places[] = {{-1.25, -0.125}, {1.25, -0.125}, {5.0, -0.125}, {-1.25, 0.125}, {-1.25, 0.25},
        {2.5, 0.125}, {8.75, -0.125}};  // of nodes
    constexpr std::size_t n = std::size(places);
    std::array<Real, n> means{};
    std::array<std::array<Real, n>, n> products{};
    for (int k = 0; k < n_samples; ++k) {
      GaussianFieldCase field = field_of(static_cast<std::uint32_t>(k));
      field.low = {-1.25, -0.125}, field.high = {8.75, 0.25}, field.correlation = &kind;
      const GaussianField g(field);
      for (std::size_t a = 0; a < n; ++a) {
        means[a] += g.at(places[a]) / n_samples;
        for (std::size_t b = 0; b <= a; ++b) products[a][b] += g.at(places[a]) * g.at(places[b]) / n_samples;
      }
    }
    for (std::size_t a = 0; a < n; ++a) {
      EXPECT_NEAR(means[a], 0.0, 4.0 / std::sqrt(n_samples)) << kind.name;
      for (std::size_t b = 0; b <= a; ++b) {
        const Real rho = kind.rho(std::abs(places[a][0] - places[b][0]) / 10.0) *
                         kind.rho(std::abs(places[a][1] - places[b][1]) / 0.5);
        EXPECT_NEAR(products[a][b], rho, 4.0 * std::sqrt((1.0 + rho * rho) / n_samples))
            << kind.name << " between places " << a << " and " << b;
      }
    }
  }
}

TEST(GaussianField, NeitherTheBoxNorWhatWasMadeBeforeChangesAValue)
{
  for (const CorrelationKind& kind : correlation_kinds()) {
    GaussianFieldCase small = field_of(3), large = field_of(3), other = field_of(4);
    small.correlation = large.correlation = other.correlation = &kind;
    small.low = {1.0, -2.0}, small.high = {2.0, -1.0};
    large.low = {-30.0, -9.0}, large.high = {40.0, 5.0};
    const GaussianField a(small), b(large);
    for (const Vec<2> x : {Vec<2>{1.0, -2.0}, {1.5, -1.3}, {2.0, -1.0}}) EXPECT_EQ(a.at(x), b.at(x)) << kind.name;
    EXPECT_TRUE(std::isnan(a.at({2.1, -1.5})));
    EXPECT_NE(GaussianField(other).at({1.5, -1.3}), GaussianField(field_of(3)).at({1.5, -1.3}));
  }
}

// Values of the program before fields had kinds.
TEST(GaussianField, AFieldThatDoesNotSayIsMarkovToTheBit)
{
  const GaussianField g(field_of(3));
  EXPECT_EQ(g.at({-2.0, -3.0}), 0x1.9f5e91ea9a0d7p-1);
  EXPECT_EQ(g.at({8.0, 1.0}), -0x1.be58ad096dad4p+0);
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
  for (const CorrelationKind& kind : correlation_kinds()) {
    const auto conditioned = [&](int k) {
      GaussianFieldCase field = field_of(static_cast<std::uint32_t>(k));
      field.known = {{{0.0, -1.0}, 1.5}, {{0.01, -1.0}, 1.7}, {{5.0, -1.0}, -0.5}};
      field.low = {0.0, -1.0}, field.high = {5.0, -1.0}, field.correlation = &kind;
      return GaussianField(field);
    };
    EXPECT_NEAR(conditioned(1).at({0.0, -1.0}), 1.6, 1e-8) << "two in one node count with their mean";
    EXPECT_NEAR(conditioned(2).at({5.0, -1.0}), -0.5, 1e-8);
    // Halfway, rho to both and r between them: mean (1.6 - 0.5) rho/(1 + r), variance 1 - 2 rho^2/(1 + r).
    const Real rho = kind.rho(0.25), r = kind.rho(0.5);
    Real sum = 0.0, squares = 0.0;
    for (int k = 0; k < n_samples; ++k) {
      const Real g = conditioned(k).at({2.5, -1.0});
      sum += g, squares += g * g;
    }
    const Real mean = sum / n_samples, variance = squares / n_samples - mean * mean,
               exact = 1.0 - 2.0 * rho * rho / (1.0 + r);
    EXPECT_NEAR(mean, 1.1 * rho / (1.0 + r), 4.0 * std::sqrt(exact / n_samples)) << kind.name;
    EXPECT_NEAR(variance, exact, 4.0 * exact * std::sqrt(2.0 / n_samples)) << kind.name;
  }
}

TEST(GaussianField, KnownValuesThatASmoothFieldCannotHaveAreRefused)
{
  GaussianFieldCase field = field_of(1);
  const auto message = [&] { return refusal<RunError>([&] { return GaussianField(field); }); };
  for (int k = 0; k < 6; ++k) field.known.push_back({{1.25 * k - 1.25, -1.0}, 0.1 * k});
  for (const CorrelationKind& kind : correlation_kinds()) {
    field.correlation = &kind;
    EXPECT_EQ(message(), "") << "values that go together, on neighbouring nodes";
    EXPECT_NEAR(GaussianField(field).at({2.5, -1.0}), 0.3, 1e-8);
  }
  field.known[3].score = -0.5;
  EXPECT_EQ(message(),
      "In a field so smooth the one at (2.5, -1) m follows from those around it, and contradicts them.\n"
      "Leave some out, or take a correlation that is less smooth.");
  field.correlation = correlation_kinds().data();
  EXPECT_EQ(message(), "") << "a Markov field may jump";
  field.correlation = &correlation_kinds().back();
  field.known.clear();
  field.high[0] = 20.0;
  for (int k = 0; k < 196; ++k) field.known.push_back({{1.25 * (k % 14), -1.0 + 0.0625 * (k / 14)}, 0.0});
  EXPECT_THAT(message(), HasSubstr("m follows from those around it.\nLeave"));
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

}  // namespace gaussian_field_test
