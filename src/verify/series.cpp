// A curve is linear between its samples, and crossings are found on these lines. Comparisons are written so that a
// value of NaN is neither a crossing nor an arrival. Means, sums, extremes and errors become NaN with it.

#include "verify/series.hpp"

#include "math/nan.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace terp {
namespace {

Real time_of_value(const Series& s, std::size_t k, Real value, Real a, Real b)
{
  return s.time[k] + (s.time[k + 1] - s.time[k]) * (value - a) / (b - a);
}

}  // namespace

Series cut(const Series& series, Real from, Real to)
{
  Series part;
  for (std::size_t k = 0; k < series.time.size(); ++k) {
    if (series.time[k] < from || series.time[k] > to) continue;
    part.time.push_back(series.time[k]);
    part.value.push_back(series.value[k]);
    if (!series.reference.empty()) part.reference.push_back(series.reference[k]);
  }
  return part;
}

bool covers(const Series& s, Real time)
{
  if (s.time.empty()) return false;
  const Real round_off = 1e-9 * std::max(std::abs(s.time.front()), std::abs(s.time.back()));
  return time >= s.time.front() - round_off && time <= s.time.back() + round_off;
}

Real value_at(const Series& s, Real time)
{
  if (!covers(s, time)) return nan;
  const auto after = std::lower_bound(s.time.begin(), s.time.end(), time);
  if (after == s.time.begin()) return s.value.front();
  if (after == s.time.end()) return s.value.back();
  const auto k = static_cast<std::size_t>(after - s.time.begin());
  const Real part = (time - s.time[k - 1]) / (s.time[k] - s.time[k - 1]);
  return s.value[k - 1] + part * (s.value[k] - s.value[k - 1]);
}

Real period_of(const Series& s)
{
  Real first = nan, last = nan;
  int n = 0;
  for (std::size_t k = 0; k + 1 < s.time.size(); ++k) {
    if (!(s.value[k] < 0.0 && s.value[k + 1] >= 0.0)) continue;
    last = time_of_value(s, k, 0.0, s.value[k], s.value[k + 1]);
    if (n++ == 0) first = last;
  }
  return n < 2 ? nan : (last - first) / (n - 1);
}

Real arrival_of(const Series& s, Real threshold)
{
  for (std::size_t k = 0; k < s.time.size(); ++k) {
    if (!(std::abs(s.value[k]) >= threshold)) continue;
    return k == 0 ? s.time[0] : time_of_value(s, k - 1, threshold, std::abs(s.value[k - 1]), std::abs(s.value[k]));
  }
  return nan;
}

Real reduce_values(const std::vector<Real>& values, const std::vector<Real>& reference, Reduce reduce, Real scale)
{
  if (values.empty()) return nan;
  const auto n = static_cast<Real>(values.size());
  const bool all_are = std::ranges::none_of(values, [](Real v) { return std::isnan(v); });
  Real square = 0.0, largest = 0.0;
  for (std::size_t k = 0; k < reference.size(); ++k) {
    const Real error = std::abs(values[k] - reference[k]) / scale;
    square += error * error;
    largest = error > largest || std::isnan(error) ? error : largest;
  }
  switch (reduce) {
    case Reduce::rms_error: return std::sqrt(square / n);
    case Reduce::max_error: return largest;
    case Reduce::mean: return std::accumulate(values.begin(), values.end(), 0.0) / n;
    case Reduce::sum: return std::accumulate(values.begin(), values.end(), 0.0);
    case Reduce::max: return !all_are ? nan : *std::ranges::max_element(values);
    case Reduce::min: return !all_are ? nan : *std::ranges::min_element(values);
    case Reduce::last: return values.back();
    default: return nan;
  }
}

}  // namespace terp
