#include "math/sparse_cholesky.hpp"
#include "support/test.hpp"

namespace sparse_cholesky_test {

/// Springs of stiffness 1 in a row, the first one held: K of n masses.
std::vector<MatrixEntry> springs(Index n)
{
  std::vector<MatrixEntry> entries;
  for (Index k = 0; k < n; ++k) {
    entries.push_back({k, k, 1.0});
    if (k > 0) entries.insert(entries.end(), {{k - 1, k - 1, 1.0}, {k, k - 1, -1.0}, {k - 1, k, -1.0}});
  }
  return entries;
}

TEST(SparseCholesky, SolvesARowOfSprings)
{
  const SparseCholesky row(4, springs(4));
  ASSERT_TRUE(row.is_factored());
  std::vector<Real> x(4);
  row.solve(std::vector<Real>{0.0, 0.0, 0.0, 2.0}, x);  // pulled at its end: each spring longer by 2
  EXPECT_THAT(
      x, ElementsAre(DoubleNear(2.0, 1e-14), DoubleNear(4.0, 1e-14), DoubleNear(6.0, 1e-14), DoubleNear(8.0, 1e-14)));
  row.solve(x, x);  // in place
  EXPECT_NEAR(x[0], 20.0, 1e-13);
}

TEST(SparseCholesky, SaysWhereThereIsNoFactor)
{
  std::vector<MatrixEntry> entries = springs(3);
  entries.push_back({0, 0, -1.0});  // the row is loose
  EXPECT_FALSE(SparseCholesky(3, entries).is_factored());
  entries.push_back({1, 1, std::numeric_limits<Real>::quiet_NaN()});
  EXPECT_FALSE(SparseCholesky(3, entries).is_factored());
}

}  // namespace sparse_cholesky_test
