// The one file that includes Eigen. Without vectors, threads and fused products the order of its sums is that of its
// text, so that a run starts with the same bits on every machine.

#define EIGEN_DONT_VECTORIZE
#define EIGEN_DONT_PARALLELIZE
#define EIGEN_MPL2_ONLY

#include "math/sparse_cholesky.hpp"

#include <cmath>
#include <eigen3/Eigen/SparseCholesky>

namespace terp {

using Vector = Eigen::Map<const Eigen::VectorXd>;

struct SparseCholesky::Factor {
  Eigen::SparseMatrix<Real> matrix;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<Real>, Eigen::Lower> of;
};

static bool has_places_of(const Eigen::SparseMatrix<Real>& a, const Eigen::SparseMatrix<Real>& b)
{
  return a.rows() == b.rows() && a.nonZeros() == b.nonZeros() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.rows() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

SparseCholesky::SparseCholesky() : factor_(std::make_unique<Factor>()) {}

void SparseCholesky::factor(Index n, const std::vector<MatrixEntry>& entries)
{
  std::vector<Eigen::Triplet<Real>> lower;
  lower.reserve(entries.size());
  bool is_finite = true;  // Eigen takes a pivot that is no number for a good one
  for (const MatrixEntry& e : entries) {
    is_finite = is_finite && std::isfinite(e.value);
    if (e.row >= e.column) lower.emplace_back(e.row, e.column, e.value);
  }
  Eigen::SparseMatrix<Real> matrix(n, n);
  matrix.setFromTriplets(lower.begin(), lower.end());
  const bool is_known = has_places_of(factor_->matrix, matrix);
  factor_->matrix = std::move(matrix);
  if (!is_known) factor_->of.analyzePattern(factor_->matrix);
  factor_->of.factorize(factor_->matrix);
  factored_ = is_finite && factor_->of.info() == Eigen::Success;
}

SparseCholesky::~SparseCholesky() = default;

void SparseCholesky::solve(std::span<const Real> b, std::span<Real> x) const
{
  const Eigen::VectorXd solution = factor_->of.solve(Vector(b.data(), static_cast<Eigen::Index>(b.size())));
  std::copy(solution.begin(), solution.end(), x.begin());
}

}  // namespace terp
