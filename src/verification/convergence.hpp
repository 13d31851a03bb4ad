// Results of several runs with refined cells or steps: order of convergence, and the limit to which they tend.
#pragma once

#include "base/types.hpp"

#include <vector>

namespace terp {

/// Slope of the straight line through (log x, log y) with the least squares [-]; NaN with fewer than two different x.
Real log_slope(const std::vector<Real>& x, const std::vector<Real>& y);

/// Order at which y tends to an unknown limit: slope of log |differences of successive y| over log x, refined by one
/// factor [-].
Real observed_order(const std::vector<Real>& x, const std::vector<Real>& y);

/// Safety factor on the distance from a limit extrapolated from three runs (P. J. Roache, J. Fluids Eng. 116 (1994)
/// 405-413).
inline constexpr Real safety_of_limit = 1.25;

/// Limit of y as x tends to 0, and its uncertainty.
struct Limit {
  Real value, uncertainty;
};

/// Richardson's extrapolation of the three finest runs with their observed order, and the grid convergence index,
/// safety_of_limit |y_1 - y_2|/(r^p - 1), as its uncertainty. The order is taken to be at least 1/2 and at most 2; NaN
/// with fewer than three runs, or where the differences do not fall.
Limit extrapolate(const std::vector<Real>& x, const std::vector<Real>& y);

}  // namespace terp
