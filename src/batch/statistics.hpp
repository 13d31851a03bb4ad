// What can be said of a probability and of a dependence from a sample.
#pragma once

#include "math/types.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace terp {

/// Where a probability lies.
struct Bounds {
  Real low = 0.0, high = 1.0;
};

/// Bounds on the probability of an event that came k times out of n, two-sided: Clopper & Pearson, Biometrika 26 (1934)
/// 404-413. They hold the probability in at least that share of all samples, whatever n. n = 0: 0 to 1.
Bounds clopper_pearson(std::int64_t k, std::int64_t n, Real confidence);
/// The same where events and n are no whole numbers, as those of a sample with the same variance are.
Bounds clopper_pearson_of(Real events, Real n, Real confidence);

/// Rank correlation of two samples, ties with their mean rank (Spearman 1904); none where one is constant, or of fewer
/// than three.
std::optional<Real> spearman(const std::vector<Real>& a, const std::vector<Real>& b);

}  // namespace terp
