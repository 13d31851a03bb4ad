// Correlations between random numbers, as a matrix and its Cholesky factor.
#pragma once

#include "math/types.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace terp {

/// A square matrix, row by row.
struct SquareMatrix {
  std::size_t n = 0;
  std::vector<Real> values = {};  ///< shape [n, n]

  static SquareMatrix unit(std::size_t n);
  Real& at(std::size_t i, std::size_t j) { return values[i * n + j]; }
  Real at(std::size_t i, std::size_t j) const { return values[i * n + j]; }
};

/// Two numbers whose correlation does not go with those before.
struct ContradictingPair {
  std::size_t a = 0, b = 0;
};

struct CholeskyResult {
  SquareMatrix factor;                          ///< lower, C = L L^T
  std::optional<ContradictingPair> fault = {};  ///< C is not positive definite
};
/// correlations: symmetric, ones on the diagonal. A row that fails is blamed on its largest correlation.
CholeskyResult cholesky(const SquareMatrix& correlations);

/// L z.
std::vector<Real> times(const SquareMatrix& lower, const std::vector<Real>& z);

}  // namespace terp
