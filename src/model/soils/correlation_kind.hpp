// How the values of a random field at two places go together: the kinds of correlation, and what makes each of them on
// the nodes of one line. docs/probability.md. Not for: the field over the section (model/soils/gaussian_field).
#pragma once

#include "math/types.hpp"

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace terp {

/// A stationary Gauss-Markov chain over the nodes of a line: s_(i+1) = A s_i + L w, with independent standard normal w.
/// The value is s[0], of variance one; the further states are its derivatives.
struct LineChain {
  static constexpr std::size_t most_states = 3;
  using Matrix = std::array<std::array<Real, most_states>, most_states>;

  std::size_t n_states = 1;
  Matrix step{}, noise{}, start{};  ///< A; L, lower triangular; the same of the first node, start start^T = covariance
};

/// Distances are in scales of fluctuation: the integral of rho over the whole line is one.
struct CorrelationKind {
  std::string_view name, meaning;
  Real (*rho)(Real distance);
  Real (*variance_of_mean)(Real length);  ///< of the mean over a length (Vanmarcke, Random fields, 1983)
  /// Of nodes that far apart; none: the field is a moving average, by `kernel`.
  LineChain (*chain)(Real spacing);
  Real (*kernel)(Real distance) = nullptr;
};

/// The first one is that of a field which does not say.
std::span<const CorrelationKind> correlation_kinds();

/// Weights of a moving average over 2 n + 1 nodes that far apart, squares adding up to one. What is left out beyond
/// both ends is below 1e-10 of the middle.
std::vector<Real> moving_average(const CorrelationKind& kind, Real spacing);

/// rho of nodes k = 0 ... n - 1 spacings apart, as the chain or the moving average makes it.
std::vector<Real> rho_of_nodes(const CorrelationKind& kind, Real spacing, std::size_t n);

}  // namespace terp
