#include "study/distribution.hpp"

#include "base/errors.hpp"
#include "simulation/gaussian_field.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/math/distributions/extreme_value.hpp>
#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

namespace bm = boost::math;

Real lognormal_quantile(const Distribution& d, Real p)
{
  const Real cov = d.sd / d.mean, variance = std::log1p(cov * cov);
  return bm::quantile(bm::lognormal(std::log(d.mean) - 0.5 * variance, std::sqrt(variance)), p);
}

Real truncated_quantile(const Distribution& d, Real p)
{
  const Real below = normal_probability((d.lowest - d.mean) / d.sd),
             up_to = normal_probability((d.highest - d.mean) / d.sd);
  const Real inside = std::clamp(below + p * (up_to - below), 1e-300, 1.0 - 0x1.0p-53);
  return std::clamp(d.mean + d.sd * normal_quantile(inside), d.lowest, d.highest);
}

/// mean = location + gamma scale, sd = pi scale / sqrt(6).
Real gumbel_quantile(const Distribution& d, Real p)
{
  const Real scale = d.sd * std::sqrt(6.0) / bm::constants::pi<Real>();
  return bm::quantile(bm::extreme_value(d.mean - bm::constants::euler<Real>() * scale, scale), p);
}

Real table_quantile(const Distribution& d, Real p)
{
  const auto after = std::ranges::find_if(d.table, [p](const Vec<2>& row) { return row[0] >= p; });
  TERP_ASSERT(after != d.table.end());
  if (after == d.table.begin()) return (*after)[1];
  const Vec<2>&a = *(after - 1), &b = *after;
  return a[1] + (b[1] - a[1]) * (p - a[0]) / (b[0] - a[0]);
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
      {gumbel, "gumbel", {"mean", "spread"}, {}, "of largest values, as a year's highest water"},
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
    case DistributionKind::lognormal: return lognormal_quantile(*this, p);
    case DistributionKind::truncated_normal: return truncated_quantile(*this, p);
    case DistributionKind::uniform: return lowest + p * (highest - lowest);
    case DistributionKind::gumbel: return gumbel_quantile(*this, p);
    case DistributionKind::quantiles: return table_quantile(*this, p);
  }
  return mean;
}

}  // namespace terp
