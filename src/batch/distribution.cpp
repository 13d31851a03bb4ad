// Where a distribution is given by mean and standard deviation, each call makes its parameters from them. A truncated
// distribution is the normal one with probabilities between those of its two limits. Its quantile keeps the probability
// between 0 and 1, so that it stays finite far in a tail. Values of a table may be equal; each search ends at two rows
// that differ, so nothing is divided by zero.

#include "batch/distribution.hpp"

#include "math/errors.hpp"
#include "model/soils/gaussian_field.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/math/distributions/extreme_value.hpp>
#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

namespace bm = boost::math;

bm::lognormal lognormal(const Distribution& d)
{
  const Real cov = d.sd / d.mean, variance = std::log1p(cov * cov);
  return {std::log(d.mean) - 0.5 * variance, std::sqrt(variance)};
}

Real normal_up_to(const Distribution& d, Real x) { return normal_probability((x - d.mean) / d.sd); }

Real truncated_quantile(const Distribution& d, Real p)
{
  const Real below = normal_up_to(d, d.lowest), up_to = normal_up_to(d, d.highest);
  const Real inside = std::clamp(below + p * (up_to - below), 1e-300, 1.0 - 0x1.0p-53);
  return std::clamp(d.mean + d.sd * normal_quantile(inside), d.lowest, d.highest);
}

/// mean = location + gamma scale, sd = pi scale / sqrt(6).
bm::extreme_value gumbel(const Distribution& d)
{
  const Real scale = d.sd * std::sqrt(6.0) / bm::constants::pi<Real>();
  return {d.mean - bm::constants::euler<Real>() * scale, scale};
}

Real table_quantile(const Distribution& d, Real p)
{
  const auto after = std::ranges::find_if(d.table, [p](const Vec<2>& row) { return row[0] >= p; });
  TERP_ASSERT(after != d.table.end());
  if (after == d.table.begin()) return (*after)[1];
  const Vec<2>&a = *(after - 1), &b = *after;
  return a[1] + (b[1] - a[1]) * (p - a[0]) / (b[0] - a[0]);
}

Real table_probability(const Distribution& d, Real x)
{
  const auto after = std::ranges::find_if(d.table, [x](const Vec<2>& row) { return row[1] > x; });
  if (after == d.table.end()) return 1.0;
  if (after == d.table.begin()) return 0.0;
  const Vec<2>&a = *(after - 1), &b = *after;
  return a[0] + (b[0] - a[0]) * (x - a[1]) / (b[1] - a[1]);
}

}  // namespace

const std::vector<DistributionInfo>& all_distributions()
{
  using enum DistributionKind;
  static const std::vector<DistributionInfo> all = {
      {normal, "normal", {"mean", "spread"}, {}, "symmetric; of a strength only where it is narrow"},
      {lognormal, "lognormal", {"mean", "spread"}, {}, "positive; the usual one of strengths"},
      {truncated_normal, "truncated_normal", {"mean", "spread"}, {"lowest", "highest"},
          "a normal one, of mean and sd before it is cut off, without what lies beyond lowest and highest"},
      {uniform, "uniform", {"lowest", "highest"}, {}, "all values between two are equally probable"},
      {gumbel, "gumbel", {"mean", "spread"}, {"location", "decimation_height"},
          "of largest values, as a year's highest water; by `mean` and `sd` or `cov`, or by `location` and "
          "`decimation_height`"},
      {quantiles, "quantiles", {"table"}, {}, "[[probability, value], ...] from 0 to 1, linear between"},
  };
  return all;
}

Real normal_probability(Real z)
{
  if (std::isinf(z)) return z < 0.0 ? 0.0 : 1.0;
  return bm::cdf(bm::normal(), z);
}

Real Distribution::quantile(Real p) const
{
  switch (kind) {
    case DistributionKind::normal: return mean + sd * normal_quantile(p);
    case DistributionKind::lognormal: return bm::quantile(lognormal(*this), p);
    case DistributionKind::truncated_normal: return truncated_quantile(*this, p);
    case DistributionKind::uniform: return lowest + p * (highest - lowest);
    case DistributionKind::gumbel: return bm::quantile(gumbel(*this), p);
    case DistributionKind::quantiles: return table_quantile(*this, p);
  }
  return mean;
}

Real Distribution::probability(Real x) const
{
  switch (kind) {
    case DistributionKind::normal: return normal_up_to(*this, x);
    case DistributionKind::lognormal: return x > 0.0 ? bm::cdf(lognormal(*this), x) : 0.0;
    case DistributionKind::truncated_normal: {
      const Real below = normal_up_to(*this, lowest), up_to = normal_up_to(*this, highest);
      return std::clamp((normal_up_to(*this, x) - below) / (up_to - below), 0.0, 1.0);
    }
    case DistributionKind::uniform: return std::clamp((x - lowest) / (highest - lowest), 0.0, 1.0);
    case DistributionKind::gumbel: return bm::cdf(gumbel(*this), x);
    case DistributionKind::quantiles: return table_probability(*this, x);
  }
  return 0.0;
}

Distribution gumbel_of(Real location, Real decimation_height)
{
  const Real scale = decimation_height / bm::constants::ln_ten<Real>();
  return {.kind = DistributionKind::gumbel,
      .mean = location + bm::constants::euler<Real>() * scale,
      .sd = bm::constants::pi<Real>() * scale / std::sqrt(6.0)};
}

}  // namespace terp
