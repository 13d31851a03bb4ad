// Finds the factor between standing and failing by trials. Knows nothing of soil.
#pragma once

#include "run/stability/trial.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace terp {

/// Least and greatest factor that is tried; width of the bracket at which a search may end.
inline constexpr Real least_factor = 0.01, greatest_factor = 100.0, least_tolerance = 1e-4, greatest_tolerance = 1.0;

struct BisectionOptions {
  std::optional<Real> from, to;  ///< where to look first: a factor believed to stand, one believed to fail
  Real tolerance = 0.02;         ///< width of the bracket at which the search ends, and as a part of its lower end:
  Real relative_tolerance = std::numeric_limits<Real>::infinity();

  Real width_at(Real factor) const { return std::min(tolerance, relative_tolerance * factor); }
};

struct Bisection {
  std::optional<Real> stable;      ///< largest factor that stood, below all that did not
  std::optional<Real> not_stable;  ///< smallest factor that did not stand, if any
  std::optional<Real> failed;      ///< smallest factor that failed, if any; between, trials are undecided
  std::vector<Trial> trials;       ///< in order of time
  /// Both ends were found.
  bool found() const { return stable.has_value() && not_stable.has_value(); }
  /// Between standing and failing; where nothing failed, up to the largest factor that crept.
  std::optional<Real> highest() const;
};

/// The next factor to try; none: the search has ended. First between the largest that stood and the smallest that did
/// not; then, if that one was undecided, beyond it for one that fails, and between the two.
std::optional<Real> next_factor(const Bisection& so_far, const BisectionOptions& options);

/// Trials still to come, at a guess.
int trials_left(const Bisection& so_far, const BisectionOptions& options);

void enter(Trial trial, Bisection& bisection);

}  // namespace terp
