// Runs are sorted from fine to coarse first, so callers may give them in any order. The last two differences decide the
// trend. As p tends to 0 their quotient tends to log r_32/log r_21: below that no positive order exists. Above it the
// right side of the equation grows with p, so bisection finds the only root. With equal ratios p is known in closed
// form.

#include "math/convergence.hpp"

#include "math/nan.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace terp {
namespace {

std::vector<std::pair<Real, Real>> from_fine_to_coarse(const std::vector<Real>& x, const std::vector<Real>& y)
{
  std::vector<std::pair<Real, Real>> runs;
  for (std::size_t k = 0; k < x.size(); ++k) runs.emplace_back(x[k], y[k]);
  std::ranges::sort(runs);
  return runs;
}

/// p > 0 of quotient = r21^p (r32^p - 1)/(r21^p - 1), whose right side grows with p from log r32/log r21.
Real order_of(Real quotient, Real r21, Real r32)
{
  constexpr Real same_ratio = 1e-9, most = 64.0;
  if (std::abs(r21 - r32) <= same_ratio * r21) return std::log(quotient) / std::log(r21);
  const auto right_side = [&](Real p) {
    return std::pow(r21, p) * std::expm1(p * std::log(r32)) / std::expm1(p * std::log(r21));
  };
  Real low = 0.0, high = most;
  for (int k = 0; k < 100; ++k) {
    const Real middle = 0.5 * (low + high);
    (right_side(middle) < quotient ? low : high) = middle;
  }
  return high;
}

}  // namespace

RefinementEstimate estimate_limit(const std::vector<Real>& x, const std::vector<Real>& y)
{
  RefinementEstimate estimate{Trend::unknown, nan, nan, nan};
  if (x.size() < 3) return estimate;
  const auto runs = from_fine_to_coarse(x, y);
  const Real last = runs[1].second - runs[0].second, before = runs[2].second - runs[1].second;
  const Real r21 = runs[1].first / runs[0].first, r32 = runs[2].first / runs[1].first;
  const auto rest_with = [&](Real p) { return -last / (std::pow(r21, p) - 1.0); };
  if (last == 0.0) {
    estimate.trend = Trend::unchanged;
    estimate.uncertainty = 0.0;
  } else if (before / last < 0.0) {
    estimate.trend = Trend::oscillating;
    estimate.uncertainty = 0.5 * std::max(std::abs(last), std::abs(before));
  } else if (!(before / last > std::log(r32) / std::log(r21))) {  // p <= 0
    estimate.trend = Trend::diverging;
    estimate.uncertainty = safety_of_bounded_order * std::abs(rest_with(least_order));
  } else {
    estimate.trend = Trend::monotone;
    estimate.order = order_of(before / last, r21, r32);
    const Real rest = rest_with(std::clamp(estimate.order, least_order, most_order));
    estimate.limit = runs[0].second + rest;
    estimate.uncertainty = (estimate.order_is_usable() ? safety_of_limit : safety_of_bounded_order) * std::abs(rest);
  }
  return estimate;
}

}  // namespace terp
