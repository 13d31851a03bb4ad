// Bounds and rank correlations against those of another program (SciPy 1.10).
#include "study/statistics.hpp"

#include "support/test.hpp"

namespace {

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

TEST(Statistics, RankCorrelation)
{
  EXPECT_NEAR(*spearman({1, 2, 3, 4, 5, 6}, {0, 0, 1, 0, 1, 1}), 0.6831300510639732, 1e-14) << "ties";
  EXPECT_NEAR(*spearman({3, 1, 4, 1, 5, 9, 2, 6}, {2, 7, 1, 8, 2, 8, 1, 8}), 0.19885368120992467, 1e-14);
  EXPECT_FALSE(spearman({1, 2, 3}, {4, 4, 4}));
  EXPECT_FALSE(spearman({1, 2}, {3, 4}));
}

}  // namespace
