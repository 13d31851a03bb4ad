// One number from a curve over time.
#pragma once

#include "verify/expected.hpp"

#include <vector>

namespace terp {

/// A measured curve; reference: at the same times, or empty.
struct Series {
  std::vector<Real> time;  ///< [s], ascending
  std::vector<Real> value, reference;
};

/// The part from `from` to `to` [s].
Series cut(const Series& series, Real from, Real to);

/// True if the time [s] lies between the first sample and the last.
bool covers(const Series& series, Real time);

/// Linear between the samples; NaN outside.
Real value_at(const Series& series, Real time);

/// Mean time between upward crossings of zero, the first and the last interpolated [s]; NaN with fewer than two.
Real period_of(const Series& series);

/// When |value| first reaches the threshold, interpolated [s]; NaN if never.
Real arrival_of(const Series& series, Real threshold);

/// Means, sums and extremes; root mean square and largest error against the reference, over `scale`. NaN for reductions
/// that need the times.
Real reduce_values(const std::vector<Real>& values, const std::vector<Real>& reference, Reduce reduce, Real scale);

}  // namespace terp
