#include "verification/convergence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace terp {
namespace {

constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

std::vector<std::pair<Real, Real>> from_fine_to_coarse(const std::vector<Real>& x, const std::vector<Real>& y)
{
  std::vector<std::pair<Real, Real>> runs;
  for (std::size_t k = 0; k < x.size(); ++k) runs.emplace_back(x[k], y[k]);
  std::ranges::sort(runs);
  return runs;
}

}  // namespace

Real log_slope(const std::vector<Real>& x, const std::vector<Real>& y)
{
  Real mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0;
  const auto n = static_cast<Real>(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) mean_x += std::log(x[k]) / n, mean_y += std::log(y[k]) / n;
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += std::pow(std::log(x[k]) - mean_x, 2);
    xy += (std::log(x[k]) - mean_x) * (std::log(y[k]) - mean_y);
  }
  return xx > 0.0 ? xy / xx : nan;
}

Real observed_order(const std::vector<Real>& x, const std::vector<Real>& y)
{
  const auto runs = from_fine_to_coarse(x, y);
  std::vector<Real> sizes, steps;
  for (std::size_t k = 0; k + 1 < runs.size(); ++k)
    sizes.push_back(runs[k].first), steps.push_back(std::abs(runs[k + 1].second - runs[k].second));
  return log_slope(sizes, steps);
}

Limit extrapolate(const std::vector<Real>& x, const std::vector<Real>& y)
{
  constexpr Real least_order = 0.5, most_order = 2.0;
  if (x.size() < 3) return {nan, nan};
  const auto runs = from_fine_to_coarse(x, y);
  const Real last = runs[0].second - runs[1].second, before = runs[1].second - runs[2].second;
  if (!(last / before < 1.0 && last / before >= 0.0)) return {nan, nan};
  const Real ratio = runs[1].first / runs[0].first;
  const Real order = std::clamp(std::log(before / last) / std::log(ratio), least_order, most_order);
  const Real rest = last / (std::pow(ratio, order) - 1.0);
  return {runs[0].second + rest, safety_of_limit * std::abs(rest)};
}

}  // namespace terp
