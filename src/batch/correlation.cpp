#include "batch/correlation.hpp"

#include <cmath>

namespace terp {

SquareMatrix SquareMatrix::unit(std::size_t n)
{
  SquareMatrix matrix{n, std::vector<Real>(n * n, 0.0)};
  for (std::size_t i = 0; i < n; ++i) matrix.at(i, i) = 1.0;
  return matrix;
}

CholeskyResult cholesky(const SquareMatrix& c)
{
  constexpr Real least = 1e-10;  // of a pivot: below, a number follows from those before, up to round-off
  CholeskyResult result{.factor = {c.n, std::vector<Real>(c.n * c.n, 0.0)}};
  SquareMatrix& l = result.factor;
  for (std::size_t i = 0; i < c.n; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      Real sum = c.at(i, j);
      for (std::size_t k = 0; k < j; ++k) sum -= l.at(i, k) * l.at(j, k);
      if (i == j && !(sum > least)) {
        ContradictingPair pair{0, i};
        for (std::size_t k = 1; k < i; ++k)
          if (std::abs(c.at(i, k)) > std::abs(c.at(i, pair.a))) pair.a = k;
        result.fault = pair;
        return result;
      }
      l.at(i, j) = i == j ? std::sqrt(sum) : sum / l.at(j, j);
    }
  return result;
}

std::vector<Real> times(const SquareMatrix& lower, const std::vector<Real>& z)
{
  std::vector<Real> y(lower.n, 0.0);
  for (std::size_t i = 0; i < lower.n; ++i)
    for (std::size_t j = 0; j <= i; ++j) y[i] += lower.at(i, j) * z[j];
  return y;
}

}  // namespace terp
