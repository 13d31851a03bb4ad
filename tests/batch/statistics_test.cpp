// Bounds and rank correlations against those of another program (SciPy 1.10).
#include "batch/statistics.hpp"

#include "support/test.hpp"

namespace statistics_test {

TEST(Statistics, BoundsOfClopperAndPearson)
{
  const auto expect = [](std::int64_t k, std::int64_t n, Real low, Real high) {
    const Bounds bounds = clopper_pearson(k, n, 0.95);
    EXPECT_NEAR(bounds.low, low, 1e-12) << k << " of " << n;
    EXPECT_NEAR(bounds.high, high, 1e-12) << k << " of " << n;
  };
  expect(0, 20, 0.0, 0.1684334709830853);
  expect(3, 50, 0.01254858783533406, 0.16548194660377288);
  expect(12, 100, 0.06356890256115931, 0.20023568361996882);
  expect(100, 100, 0.9637833073548235, 1.0);
  expect(0, 0, 0.0, 1.0);
}

TEST(Statistics, BoundsOfASampleThatIsNoWholeNumber)
{
  const Bounds three = clopper_pearson(3, 50, 0.95), four = clopper_pearson(4, 50, 0.95),
               between = clopper_pearson_of(3.5, 50.0, 0.95);
  EXPECT_EQ(clopper_pearson_of(3.0, 50.0, 0.95).high, three.high);
  EXPECT_GT(between.low, three.low);
  EXPECT_LT(between.low, four.low);
  EXPECT_GT(between.high, three.high);
  EXPECT_LT(between.high, four.high);
  EXPECT_EQ(clopper_pearson_of(0.0, 2.5, 0.95).low, 0.0);
}

// The rule `cov` ends a study with the r-th event, or at n realisations. The share of studies whose bounds hold P is a
// finite sum: the r-th event comes at m with probability C(m - 1, r - 1) P^r (1 - P)^(m - r).
TEST(Statistics, BoundsHoldWhereTheLastEventEndsTheStudy)
{
  constexpr std::int64_t r = 11, most = 400;  // cov = 0.3
  const auto holds = [](std::int64_t k, std::int64_t n, Real p) {
    const Bounds b = clopper_pearson(k, n, 0.95);
    return b.low <= p && p <= b.high;
  };
  const auto binomial = [](std::int64_t k, std::int64_t n, Real p) {
    const auto x = static_cast<Real>(k), m = static_cast<Real>(n);
    return std::exp(std::lgamma(m + 1.0) - std::lgamma(x + 1.0) - std::lgamma(m - x + 1.0) + x * std::log(p) +
                    (m - x) * std::log1p(-p));
  };
  for (Real p = 0.004; p < 0.95; p *= 1.13) {
    Real all = 0.0, held = 0.0;
    const auto take = [&](std::int64_t k, std::int64_t n, Real probability) {
      all += probability;
      if (holds(k, n, p)) held += probability;
    };
    for (std::int64_t m = r; m <= most; ++m) take(r, m, binomial(r - 1, m - 1, p) * p);
    for (std::int64_t k = 0; k < r; ++k) take(k, most, binomial(k, most, p));
    EXPECT_NEAR(all, 1.0, 1e-9);
    EXPECT_GE(held, 0.95) << p;
  }
}

TEST(Statistics, RankCorrelation)
{
  EXPECT_NEAR(*spearman({1, 2, 3, 4, 5, 6}, {0, 0, 1, 0, 1, 1}), 0.6831300510639732, 1e-14) << "ties";
  EXPECT_NEAR(*spearman({3, 1, 4, 1, 5, 9, 2, 6}, {2, 7, 1, 8, 2, 8, 1, 8}), 0.19885368120992467, 1e-14);
  EXPECT_FALSE(spearman({1, 2, 3}, {4, 4, 4}));
  EXPECT_FALSE(spearman({1, 2}, {3, 4}));
}

}  // namespace statistics_test
