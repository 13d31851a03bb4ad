#include "events/crest.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real crest_tolerance = 0.05;  // of the surface height [m]
constexpr Real settled_for = 0.3;       // the crest has not retreated by more than it may for this long [s]
constexpr Real settled_retreat = 0.05;  // what it may, in heights of the first surface [-]
constexpr Real slide_retreat = 0.25;    // retreat that counts as a slide, in heights of the first surface [-]
constexpr Real round_off = 1e-9;        // of crest places, which are whole columns [m]

/// Height of the first surface over the lowest point [m].
Real first_height(const CrestHistory& crest)
{
  Real highest = 0.0;
  for (const Real h : crest.initial_heights)
    if (std::isfinite(h)) highest = std::max(highest, h - crest.base);
  return highest;
}

/// How far a crest that has settled may retreat, and in what time: a column at least, which of a wide column takes longer.
struct Rest {
  Real length;  ///< [m]
  Real time;    ///< [s]
};

Rest rest_of(const CrestHistory& crest)
{
  const Real length = settled_retreat * first_height(crest), width = crest.columns.width;
  return width <= length ? Rest{length, settled_for} : Rest{width, settled_for * width / length};
}

/// First row whose crest stays at rest; the number of rows if there is none.
std::size_t find_settled(const CrestHistory& crest, std::size_t k)
{
  const Rest rest = rest_of(crest);
  const auto& t = crest.time;
  for (std::size_t end = k; k < t.size(); ++k) {
    end = k;
    while (end < t.size() && crest.x[end] >= crest.x[k] - rest.length - round_off && t[end] - t[k] < rest.time - round_off) ++end;
    if (end == t.size()) return end;
    if (crest.x[end] >= crest.x[k] - rest.length - round_off) return end;
  }
  return k;
}

/// First row after k by which the crest has retreated by `length` within `settled_for`: a slide, not creep.
std::size_t find_slide(const CrestHistory& crest, std::size_t k, Real length)
{
  for (std::size_t end = k; end < crest.x.size(); ++end) {
    while (crest.time[end] - crest.time[k] > settled_for + round_off) ++k;
    for (std::size_t from = k; from < end; ++from)
      if (crest.x[end] <= crest.x[from] - length + round_off) return end;
  }
  return crest.x.size();
}

/// First row from k on whose crest lies at or left of x.
std::size_t find_retreat(const CrestHistory& crest, std::size_t k, Real x)
{
  while (k < crest.x.size() && crest.x[k] > x + round_off) ++k;
  return k;
}

/// Retreat of the crest that counts as a slide: a quarter of the height of the first surface, at least two columns [m].
Real slide_length(const CrestHistory& crest) { return std::max(slide_retreat * first_height(crest), 2.0 * crest.columns.width); }

}  // namespace

CrestHistory start_crest_history(const PointBlocks<2>& points, Real left, Real right, Real column_width)
{
  CrestHistory crest;
  crest.columns = {left, column_width, static_cast<Index>(std::ceil((right - left) / column_width - 1e-9))};
  crest.initial_heights = surface_heights(points, crest.columns);
  crest.base = lowest(points);
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
  if (x.empty()) return std::nullopt;
  const std::size_t first_slide = find_retreat(crest, 0, x[0] - slide_length(crest));
  const std::size_t settled = find_settled(crest, first_slide);
  if (settled == x.size()) return std::nullopt;
  std::size_t second = find_slide(crest, settled, slide_length(crest));
  if (second == x.size()) return std::nullopt;
  while (second > settled && x[second - 1] < x[settled] - rest_of(crest).length - round_off) --second;  // where it began
  return crest.time[second];
}

}  // namespace terp
