// Symmetric positive definite equations K x = b with few numbers in each row: factored once, solved many times.
// The factor is that of Eigen; the same bits on any machine.
#pragma once

#include "math/types.hpp"

#include <memory>
#include <span>
#include <vector>

namespace terp {

struct MatrixEntry {
  Index row, column;
  Real value;
};

class SparseCholesky {
 public:
  SparseCholesky();
  SparseCholesky(Index n, const std::vector<MatrixEntry>& entries) : SparseCholesky() { factor(n, entries); }
  ~SparseCholesky();

  /// n: unknowns. Entries at the same place add up; those above the diagonal are not looked at. A matrix with entries
  /// at the places of the one before has its order of elimination.
  void factor(Index n, const std::vector<MatrixEntry>& entries);

  /// False: the matrix is not positive definite, or holds a number that is not finite.
  bool is_factored() const { return factored_; }
  /// b, x: shape [n]; they may be the same array.
  void solve(std::span<const Real> b, std::span<Real> x) const;

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
  bool factored_ = false;
};

}  // namespace terp
