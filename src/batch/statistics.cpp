// Binomial bounds are quantiles of the beta distribution, which also exist where counts are no whole numbers. With no
// event the lower bound is 0, and with nothing else the upper one is 1. The rank correlation is that of Pearson for the
// ranks, because the shorter formula of Spearman is wrong where values are equal.

#include "batch/statistics.hpp"

#include "math/errors.hpp"

#include <boost/math/special_functions/beta.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace terp {
namespace {

/// From 1; equal values share their mean rank.
std::vector<Real> ranks_of(const std::vector<Real>& values)
{
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<Real> ranks(values.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t last = first;
    while (last + 1 < order.size() && values[order[last + 1]] == values[order[first]]) ++last;
    for (std::size_t k = first; k <= last; ++k) ranks[order[k]] = 0.5 * static_cast<Real>(first + last) + 1.0;
    first = last + 1;
  }
  return ranks;
}

}  // namespace

Bounds clopper_pearson(std::int64_t k, std::int64_t n, Real confidence)
{
  TERP_ASSERT(k >= 0 && k <= n);
  return clopper_pearson_of(static_cast<Real>(k), static_cast<Real>(n), confidence);
}

Bounds clopper_pearson_of(Real events, Real n, Real confidence)
{
  const Real tail = 0.5 * (1.0 - confidence), others = n - events;
  Bounds bounds;
  if (events > 0.0) bounds.low = boost::math::ibeta_inv(events, others + 1.0, tail);
  if (others > 0.0) bounds.high = boost::math::ibeta_inv(events + 1.0, others, 1.0 - tail);
  return bounds;
}

std::optional<Real> spearman(const std::vector<Real>& a, const std::vector<Real>& b)
{
  TERP_ASSERT(a.size() == b.size());
  if (a.size() < 3) return std::nullopt;
  const std::vector<Real> x = ranks_of(a), y = ranks_of(b);
  const Real mean = 0.5 * (static_cast<Real>(a.size()) + 1.0);
  Real xy = 0.0, xx = 0.0, yy = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    xy += (x[k] - mean) * (y[k] - mean);
    xx += (x[k] - mean) * (x[k] - mean);
    yy += (y[k] - mean) * (y[k] - mean);
  }
  if (xx == 0.0 || yy == 0.0) return std::nullopt;
  return xy / std::sqrt(xx * yy);
}

}  // namespace terp
