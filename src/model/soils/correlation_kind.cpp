// How it thinks: a Matern correlation of order 3/2 or 5/2 is that of a process whose derivatives up to the first or
// second one make it Markov (Hartikainen & Sarkka, Kalman filtering of Gaussian processes, MLSP 2010). With lengths in
// 1/lambda all roots of its system matrix F are -1. So exp(F a) = exp(-a) (I + a N + a^2 N^2/2) with N = F + I ends
// there. The Gaussian correlation has no such form: exp(-pi d^2) is the kernel exp(-2 pi d^2) times itself, convolved.

#include "model/soils/correlation_kind.hpp"

#include "math/functions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace terp {
namespace {

using Matrix = LineChain::Matrix;
constexpr std::size_t n_max = LineChain::most_states;
constexpr Real pi = std::numbers::pi;

Matrix product(const Matrix& a, const Matrix& b)
{
  Matrix c{};
  for (std::size_t i = 0; i < n_max; ++i)
    for (std::size_t j = 0; j < n_max; ++j)
      for (std::size_t k = 0; k < n_max; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}

Matrix transposed(const Matrix& a)
{
  Matrix b{};
  for (std::size_t i = 0; i < n_max; ++i)
    for (std::size_t j = 0; j < n_max; ++j) b[i][j] = a[j][i];
  return b;
}

/// Lower triangular L with L L^T = C, of the first n rows.
Matrix cholesky_of(const Matrix& c, std::size_t n)
{
  Matrix l{};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      Real sum = c[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= l[i][k] * l[j][k];
      l[i][j] = i == j ? std::sqrt(sum) : sum / l[j][j];
    }
  return l;
}

/// f: system matrix, covariance: of the states, both in lengths of 1/lambda; a: lambda times the spacing.
LineChain chain_of(std::size_t n, const Matrix& f, const Matrix& covariance, Real a)
{
  Matrix nilpotent = f;
  for (std::size_t i = 0; i < n; ++i) nilpotent[i][i] += 1.0;
  const Matrix square = product(nilpotent, nilpotent);
  LineChain chain{.n_states = n};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      chain.step[i][j] = exponential(-a) * ((i == j ? 1.0 : 0.0) + a * nilpotent[i][j] + 0.5 * a * a * square[i][j]);
  Matrix left = product(product(chain.step, covariance), transposed(chain.step));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) left[i][j] = covariance[i][j] - left[i][j];
  chain.noise = cholesky_of(left, n);
  chain.start = cholesky_of(covariance, n);
  return chain;
}

LineChain markov_chain(Real spacing)
{
  LineChain chain;
  const Real ratio = exponential(-2.0 * spacing);
  chain.step[0][0] = ratio;
  chain.noise[0][0] = std::sqrt(1.0 - ratio * ratio);
  chain.start[0][0] = 1.0;
  return chain;
}

// lambda theta = 4 and 16/3, as the integral of rho over the whole line is 4/lambda and 16/(3 lambda).
constexpr Real lambda_3_2 = 4.0, lambda_5_2 = 16.0 / 3.0;

LineChain chain_3_2(Real spacing)
{
  return chain_of(2, {{{0, 1, 0}, {-1, -2, 0}, {}}}, {{{1, 0, 0}, {0, 1, 0}, {}}}, lambda_3_2 * spacing);
}

LineChain chain_5_2(Real spacing)
{
  constexpr Real third = 1.0 / 3.0;
  return chain_of(3, {{{0, 1, 0}, {0, 0, 1}, {-1, -3, -3}}}, {{{1, 0, -third}, {0, third, 0}, {-third, 0, 1}}},
      lambda_5_2 * spacing);
}

Real markov_variance(Real length)
{
  const Real x = 2.0 * length;
  return 2.0 / (x * x) * (x + std::exp(-x) - 1.0);
}

Real variance_3_2(Real length)
{
  const Real x = lambda_3_2 * length;
  return 2.0 / (x * x) * (2.0 * x - 3.0 + (3.0 + x) * std::exp(-x));
}

Real variance_5_2(Real length)
{
  const Real x = lambda_5_2 * length;
  return 2.0 / (x * x) * (8.0 * x / 3.0 - 5.0 + (5.0 + 7.0 * x / 3.0 + x * x / 3.0) * std::exp(-x));
}

Real gaussian_variance(Real length)
{
  const Real square = pi * length * length;
  return std::erf(std::sqrt(square)) / length + (std::exp(-square) - 1.0) / square;
}

const CorrelationKind kinds[] = {
    {"markov", "exp(-2 d/theta), rough", [](Real d) { return std::exp(-2.0 * d); }, markov_variance, markov_chain},
    {"matern_3_2", "(1 + a) exp(-a), a = 4 d/theta, with a slope",
        [](Real d) { return (1.0 + lambda_3_2 * d) * std::exp(-lambda_3_2 * d); }, variance_3_2, chain_3_2},
    {"matern_5_2", "(1 + a + a^2/3) exp(-a), a = 16/3 d/theta, with a curvature",
        [](Real d) {
          const Real a = lambda_5_2 * d;
          return (1.0 + a + a * a / 3.0) * std::exp(-a);
        },
        variance_5_2, chain_5_2},
    {"gaussian", "exp(-pi d^2/theta^2), smooth", [](Real d) { return std::exp(-pi * d * d); }, gaussian_variance,
        nullptr, [](Real d) { return exponential(-2.0 * pi * d * d); }},
};

}  // namespace

std::span<const CorrelationKind> correlation_kinds() { return kinds; }

std::vector<Real> moving_average(const CorrelationKind& kind, Real spacing)
{
  constexpr Real least = 1e-10;
  std::vector<Real> half;
  for (Real value = kind.kernel(0.0); value >= least; value = kind.kernel(spacing * static_cast<Real>(half.size())))
    half.push_back(value);
  Real squares = half[0] * half[0];
  for (std::size_t k = 1; k < half.size(); ++k) squares += 2.0 * half[k] * half[k];
  std::vector<Real> weights(2 * half.size() - 1);
  for (std::size_t k = 0; k < half.size(); ++k)
    weights[half.size() - 1 - k] = weights[half.size() - 1 + k] = half[k] / std::sqrt(squares);
  return weights;
}

std::vector<Real> rho_of_nodes(const CorrelationKind& kind, Real spacing, std::size_t n)
{
  std::vector<Real> rho(n, 0.0);
  if (kind.chain == nullptr) {
    const std::vector<Real> weights = moving_average(kind, spacing);
    for (std::size_t k = 0; k < std::min(n, weights.size()); ++k)
      for (std::size_t i = k; i < weights.size(); ++i) rho[k] += weights[i - k] * weights[i];
    return rho;
  }
  const LineChain chain = kind.chain(spacing);
  std::array<Real, n_max> covariance{};  // of all states with the value where it begins
  for (std::size_t a = 0; a < chain.n_states; ++a) covariance[a] = chain.start[a][0] * chain.start[0][0];
  for (Real& value : rho) {
    value = covariance[0];
    std::array<Real, n_max> next{};
    for (std::size_t a = 0; a < chain.n_states; ++a)
      for (std::size_t b = 0; b < chain.n_states; ++b) next[a] += chain.step[a][b] * covariance[b];
    covariance = next;
  }
  return rho;
}

}  // namespace terp
