// Distributions of a random number, by what an engineer knows of it: mean and standard deviation, bounds, quantiles.
// Not for: random fields (model/soils/gaussian_field), nor for how a study file writes them (read_distribution).
#pragma once

#include "math/types.hpp"

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace terp {

enum class DistributionKind { normal, lognormal, truncated_normal, uniform, gumbel, quantiles };

struct Distribution {
  DistributionKind kind = DistributionKind::normal;
  Real mean = 0.0, sd = 0.0;  ///< of truncated_normal: before it is cut off
  Real lowest = -std::numeric_limits<Real>::infinity(), highest = std::numeric_limits<Real>::infinity();
  std::vector<Vec<2>> table = {};  ///< of quantiles: (probability, value), both ascending, from 0 to 1

  /// The value that is not exceeded with probability p, 0 < p < 1.
  Real quantile(Real p) const;
  /// The probability that x is not exceeded.
  Real probability(Real x) const;
};

struct DistributionInfo {
  DistributionKind kind;
  std::string_view name;                 ///< in the study file
  std::vector<std::string_view> needed;  ///< keys; "spread": sd or cov
  std::vector<std::string_view> optional;
  std::string_view meaning;
};
/// In the order of the enum.
const std::vector<DistributionInfo>& all_distributions();

/// Gumbel's distribution by its location, the value that is most probable, and its decimation height: the rise for
/// which large values become ten times rarer.
Distribution gumbel_of(Real location, Real decimation_height);

/// Phi(z) of the standard normal distribution.
Real normal_probability(Real z);

}  // namespace terp
