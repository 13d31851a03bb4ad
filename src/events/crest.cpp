#include "events/crest.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real crest_tolerance = 0.05;    // of the surface height [m]
constexpr Real settled_for = 0.3;         // the crest has not moved for this long [s]
constexpr Real retreat = 0.1;             // that counts as a failure [m]
constexpr Real round_off = 1e-9;          // of crest places, which are whole columns [m]

}  // namespace

CrestHistory start_crest_history(const PointBlocks<2>& points, Real left, Real right, Real column_width)
{
  CrestHistory crest;
  crest.columns = {left, column_width, static_cast<Index>(std::ceil((right - left) / column_width - 1e-9))};
  crest.initial_heights = surface_heights(points, crest.columns);
  return crest;
}

Real find_crest(const CrestHistory& crest, const PointBlocks<2>& points)
{
  const auto heights = surface_heights(points, crest.columns);
  Index k = 0;
  const auto stands = [&](Index c) {
    return std::isfinite(crest.initial_heights[c]) && std::abs(heights[c] - crest.initial_heights[c]) <= crest_tolerance;
  };
  while (k < crest.columns.n && stands(k)) ++k;
  return crest.columns.left + k * crest.columns.width;
}

std::optional<Real> second_failure_time(const CrestHistory& crest)
{
  const auto& x = crest.x;
  const auto& t = crest.time;
  std::size_t k = 0;
  while (k < x.size() && x[k] > x[0] - retreat + round_off) ++k;  // the first slide has begun
  std::size_t settled = k;
  while (settled < x.size() && !(t[settled] - t[k] >= settled_for - round_off)) {
    ++settled;
    if (settled < x.size() && x[settled] < x[k] - round_off) k = settled;  // still retreating
  }
  for (std::size_t later = settled; later < x.size(); ++later) {
    if (x[later] > x[k] - retreat + round_off) continue;
    while (x[later - 1] < x[k] - round_off) --later;  // back to where this retreat began
    return t[later];
  }
  return std::nullopt;
}

}  // namespace terp
